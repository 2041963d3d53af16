#lang racket/base
;; Cosine and sine of parts of a turn in integers of 200 bits after the point: the reference for
;; points on circles.

(provide exact-turn)

(define BITS 200)
(define ONE (expt 2 BITS))
(define (times a b) (quotient (* a b) ONE))

;; pi by Machin's formula, 16 arctan(1/5) - 4 arctan(1/239).
(define PI
  (let ()
    (define (arctan-of-reciprocal n)
      (let loop ([power (quotient ONE n)] [k 1] [sign 1] [sum 0])
        (if (zero? power)
            sum
            (loop (quotient power (* n n)) (+ k 2) (- sign) (+ sum (* sign (quotient power k)))))))
    (- (* 16 (arctan-of-reciprocal 5)) (* 4 (arctan-of-reciprocal 239)))))

;; Taylor's series of cosine (from 1) and sine (from x).
(define (series first x start)
  (define xx (times x x))
  (let loop ([term first] [k start] [sum 0])
    (if (zero? term)
        sum
        (loop (quotient (- (times term xx)) (* (+ k 1) (+ k 2))) (+ k 2) (+ sum term)))))

;; exact-turn : an exact number v in [0, 1] -> cosine and sine of 2 pi v, exact numbers that are
;; right to 180 bits.
(define (exact-turn v)
  (define quarter (round (* 4 v)))
  (define x (times (* 2 PI) (floor (* ONE (- v (/ quarter 4))))))
  (define-values (c s) (values (/ (series ONE x 0) ONE) (/ (series x x 1) ONE)))
  (case (modulo quarter 4)
    [(0) (values c s)]
    [(1) (values (- s) c)]
    [(2) (values (- c) (- s))]
    [else (values s (- c))]))

(module+ test
  (require rackunit)
  (test-case "a twelfth and a sixth of a turn, and the circle's equation, to 2^-180"
    (define-values (c s) (exact-turn 1/12))
    (check-true (< (abs (- (* 4 c c) 3)) (expt 2 -180)))
    (check-true (< (abs (- s 1/2)) (expt 2 -180)))
    (for ([k 17])
      (define-values (c s) (exact-turn (/ k 17)))
      (check-true (< (abs (- (+ (* c c) (* s s)) 1)) (expt 2 -180))))
    (check-= (exact->inexact PI) (* 3.141592653589793 ONE) (* 3e-16 ONE))))
