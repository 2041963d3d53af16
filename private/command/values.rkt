#lang racket/base
;; What may be asked of a render, by a flag or by a scene's settings: each check returns the value
;; or raises one line that says what it was for, what was given and what is expected.
(provide check-size check-samples check-error check-seconds check-seed check-workers check-tile
         check-max-depth check-part check-crop check-name check-shading unexpected
         text->natural text->naturals text->positive text->part)

(define LONGEST-SIDE 100000)
(define MOST-PIXELS (expt 2 28))

;; unexpected : raises the line.
(define (unexpected what given expected)
  (raise-user-error (format "~a ~a: expected ~a" what given expected)))

;; given: how the value was written, for the line.
(define (check-size what given size)
  (unless (and (list? size) (= (length size) 2)
               (in-range? (car size) 1 LONGEST-SIDE) (in-range? (cadr size) 1 LONGEST-SIDE))
    (unexpected what given
                (format "WIDTHxHEIGHT, two whole numbers from 1 to ~a" LONGEST-SIDE)))
  size)

(define ((check-count low high) what given count)
  (unless (in-range? count low high)
    (unexpected what given (format "a whole number from ~a to ~a" low high)))
  count)

(define check-samples (check-count 1 1000000000))
(define ((check-positive most expected) what given value)
  (unless (and value (<= value most))
    (unexpected what given expected))
  value)

(define check-error
  (check-positive 10.0 "a positive number up to 10, such as 0.01 or 1%"))
(define check-seconds
  (check-positive 1e9 "a positive number of seconds, such as 60"))
(define check-seed (check-count 0 #xFFFFFFFF))
(define check-workers (check-count 1 1024))
(define check-tile (check-count 1 LONGEST-SIDE))
(define check-max-depth (check-count 0 1000000000))

;; part: a list of two numbers, the first of them from 1 to the second.
(define (check-part what given part)
  (unless (and (= (length part) 2) (in-range? (cadr part) 1 1000000) (in-range? (car part) 1 (cadr part)))
    (unexpected what given "I/N, two whole numbers with I from 1 to N and N at most 1000000"))
  part)

;; check-crop : (list x y width height) from text like "0,0,16,16", a part of the size, or #f for all
;; of it where text is #f. What is to be rendered must fit into memory.
(define (check-crop what text size)
  (define width (car size))
  (define height (cadr size))
  (define crop (and text (text->naturals text #rx",")))
  (when crop
    (unless (and (= (length crop) 4) (andmap values crop)
                 (in-range? (caddr crop) 1 (- width (car crop)))
                 (in-range? (cadddr crop) 1 (- height (cadr crop))))
      (unexpected what text (format "X,Y,WIDTH,HEIGHT, four whole numbers that tell a part of ~ax~a"
                                    width height))))
  (define-values (columns rows)
    (if crop (values (caddr crop) (cadddr crop)) (values width height)))
  (when (> (* columns rows) MOST-PIXELS)
    (unexpected "size" (format "~ax~a" columns rows)
                (format "at most ~a pixels; --crop renders a part" MOST-PIXELS)))
  crop)

;; name: a symbol that must be among names.
(define (check-name what name names)
  (unless (memq name names)
    (unexpected what name (format "one of ~a" (names->text names))))
  name)

;; shading: one of the names, or a list of them.
(define (check-shading what shading names)
  (define given (if (list? shading) shading (list shading)))
  (unless (and (pair? given) (andmap (lambda (name) (memq name names)) given))
    (unexpected what (if (and (list? shading) (andmap symbol? shading)) (names->text shading) shading)
                (format "one or more of ~a" (names->text names))))
  shading)

(define (names->text names)
  (apply string-append (symbol->string (car names))
         (for/list ([name (in-list (cdr names))]) (format ", ~a" name))))

(define (in-range? value low high)
  (and (exact-integer? value) (<= low value high)))

;; ----------------------------------------------------------------------------------------------

;; text->natural : the whole number that the digits stand for, or #f.
(define (text->natural text)
  (and (regexp-match? #px"^[0-9]{1,18}$" text) (string->number text 10)))

;; text->naturals : the list of what stands between the separators, #f for what is no number.
(define (text->naturals text separator)
  (map text->natural (regexp-split separator text)))

;; text->positive : the positive number in decimals, or #f.
(define (text->positive text)
  (define number
    (and (regexp-match? #px"^[0-9]{0,18}([.][0-9]{0,18})?(e-?[0-9]{1,2})?$" text)
         (string->number text 10)))
  (and number (positive? number) (exact->inexact number)))

;; text->part : the same, where 1% is 0.01.
(define (text->part text)
  (define percent (regexp-match #rx"^(.*)%$" text))
  (cond
    [percent (let ([number (text->positive (cadr percent))]) (and number (/ number 100.0)))]
    [else (text->positive text)]))
