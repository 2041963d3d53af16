#lang racket/base
;; A case of the stress suite, how many times it repeats, and what several of them measure with.

(provide (struct-out stress-case) amount ulps spacing rounded
         point numbers finite-numbers?
         seeded add subtract scale dot cross norm exact unit
         random-unit random-in-ball random-rotation)

(require (only-in "../statistics.rkt" seeded)
         (only-in "../shape/axial-checks.rkt" add subtract scale dot cross norm exact
                  random-unit random-in-ball random-rotation)
         (only-in "../shape/spawned-rays.rkt" unit)
         (only-in "../../main.rkt" Float3 Float3-x Float3-y Float3-z))

;; name and pass: what is printed, the pass number as text. run: a procedure of the size, 1 for the
;; full one, that returns what was measured as text and whether that passes.
(struct stress-case (name pass run))

;; So many repetitions of `full` at this size, `least` at least.
(define (amount full size [least 50]) (max least (inexact->exact (round (* full size)))))

;; The distance of a flonum to the next one away from zero.
(define (spacing x)
  (define bits (integer-bytes->integer (real->floating-point-bytes (abs x) 8) #f))
  (- (floating-point-bytes->real (integer->integer-bytes (+ bits 1) 8 #f)) (abs x)))

;; How far a flonum is from an exact number, in the spacing of flonums there; infinite for NaN.
(define (ulps found right)
  (if (< (abs found) +inf.0)
      (exact->inexact (/ (abs (- (inexact->exact found) right))
                         (inexact->exact (spacing (exact->inexact right)))))
      +inf.0))

;; A measured number with three digits.
(define (rounded x)
  (cond
    [(or (exact-integer? x) (zero? x) (not (< (abs x) +inf.0))) (number->string x)]
    [else
     (define power (expt 10 (- 2 (inexact->exact (floor (/ (log (abs x)) (log 10.0)))))))
     (number->string (exact->inexact (/ (round (* (inexact->exact x) power)) power)))]))

;; Points between lists of three numbers and the library's.
(define (point p) (apply Float3 p))
(define (numbers v) (list (Float3-x v) (Float3-y v) (Float3-z v)))

(define (finite-numbers? v) (for/and ([x (in-list (numbers v))]) (< (abs x) +inf.0)))
