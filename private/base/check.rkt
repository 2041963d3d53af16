#lang typed/racket/base
;; Checks the public constructors share. Every message is one line that names the constructor, the
;; argument and what was expected.
(require racket/flonum "fuse.rkt")

(provide check-albedo check-finite check-positive check-between check-point check-direction check-color
         check-count check-positive-or-infinite raise-expected)

;; Raises exn:fail:contract: "who: expected <expected> as <argument>, given <value>".
(: raise-expected (-> Symbol String String Any Nothing))
(define (raise-expected who argument expected value)
  (raise (exn:fail:contract
          (format "~a: expected ~a as ~a, given ~a" who expected argument (shortened value))
          (current-continuation-marks))))

;; What was given, cut where it would fill more than a line.
(: shortened (-> Any String))
(define (shortened value)
  (define text (format "~v" value))
  (if (> (string-length text) 100) (string-append (substring text 0 97) "...") text))

(: finite? (-> Flonum Boolean))
(define (finite? x) (fl< (flabs x) +inf.0))

(: check-finite (-> Symbol String Real Flonum))
(define (check-finite who argument value)
  (define x (real->double-flonum value))
  (if (finite? x) x (raise-expected who argument "a finite number" value)))

(: check-positive (-> Symbol String Real Flonum))
(define (check-positive who argument value)
  (define x (real->double-flonum value))
  (if (and (fl> x 0.0) (finite? x))
      x
      (raise-expected who argument "a positive finite number" value)))

(: check-between (-> Symbol String Real Flonum Flonum Flonum))
(define (check-between who argument value low high)
  (define x (real->double-flonum value))
  (if (and (fl>= x low) (fl<= x high))
      x
      (raise-expected who argument (format "a number from ~a to ~a" low high) value)))

(: check-count (-> Symbol String Integer Integer Integer Fixnum))
(define (check-count who argument value low high)
  (if (and (fixnum? value) (<= low value high))
      value
      (raise-expected who argument (format "a whole number from ~a to ~a" low high) value)))

(: check-point (-> Symbol String Float3 Float3))
(define (check-point who argument value)
  (if (and (finite? (Float3-x value)) (finite? (Float3-y value)) (finite? (Float3-z value)))
      value
      (raise-expected who argument "three finite coordinates" value)))

(: check-direction (-> Symbol String Float3 Float3))
(define (check-direction who argument value)
  (check-point who argument value)
  (if (and (fl= (Float3-x value) 0.0) (fl= (Float3-y value) 0.0) (fl= (Float3-z value) 0.0))
      (raise-expected who argument "a direction other than zero" value)
      value))

(: check-color (-> Symbol String Float3 Float3))
(define (check-color who argument value)
  (define (good? [x : Flonum]) (and (fl>= x 0.0) (finite? x)))
  (if (and (good? (Float3-x value)) (good? (Float3-y value)) (good? (Float3-z value)))
      value
      (raise-expected who argument "a linear RGB colour with finite components of at least 0"
                      value)))

(: check-positive-or-infinite (-> Symbol String Real Flonum))
(define (check-positive-or-infinite who argument value)
  (define x (real->double-flonum value))
  (if (fl> x 0.0) x (raise-expected who argument "a positive number, perhaps infinite" value)))

(: check-albedo (-> Symbol String Float3 Float3))
(define (check-albedo who argument value)
  (define (good? [x : Flonum]) (and (fl>= x 0.0) (fl<= x 1.0)))
  (if (and (good? (Float3-x value)) (good? (Float3-y value)) (good? (Float3-z value)))
      value
      (raise-expected who argument "a colour with components from 0 to 1" value)))
