#lang racket/base
;; The picture as it forms, drawn above the line of progress with half blocks: coarse at first, and fine
;; where there are samples.
(require "../image/image.rkt" "../image/terminal.rkt")

(provide draw-preview)

;; draw-preview : picture: a procedure that returns the picture so far. under: #f or a procedure from a
;; width to the coarse picture. Returns a procedure that draws again, with a text below, and returns how
;; many lines are above that text.
(define (draw-preview picture under)
  (define-values (rows columns) (terminal-size))
  (define width
    (let ([image (picture)])
      ;; as wide as fits, and as fits between the first line and the text
      (max 1 (min columns (Image-width image)
                  (quotient (* 2 (max 1 (- rows 2)) (Image-width image)) (Image-height image))))))
  (define coarse (and under (under width)))
  (define lines 0)
  (lambda (text)
    (define out (open-output-string))
    (write-string (if (zero? lines) "\r" (format "\r\e[~aA" lines)) out)
    (define drawn
      (Image-print-blocks (Image-shrink (picture) width #:under coarse) out #:columns width))
    (fprintf out "~a\e[K" text)
    (write-string (get-output-string out) (current-error-port))
    (flush-output (current-error-port))
    (set! lines drawn)
    drawn))

;; Rows and columns of the terminal at standard input, 24 and 80 where they are not known.
(define (terminal-size)
  (define in (current-input-port))
  (define stty (and (file-stream-port? in) (terminal-port? in) (find-executable-path "stty")))
  (define text
    (if stty
        (with-handlers ([exn:fail? (lambda (e) "")])
          (define-values (process out no-in err)
            (subprocess #f in #f stty "size"))
          (define line (read-line out))
          (close-input-port out)
          (close-input-port err)
          (if (string? line) line ""))
        ""))
  (define numbers (map string->number (regexp-match* #rx"[0-9]+" text)))
  (if (and (= (length numbers) 2) (andmap positive? numbers))
      (values (car numbers) (cadr numbers))
      (values 24 80)))
