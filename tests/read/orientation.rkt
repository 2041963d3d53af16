#lang racket/base
;; Signs of areas against exact rational arithmetic: no wrong sign is allowed.

(module+ test
  (require rackunit
           racket/flonum
           "../../private/read/orientation.rkt")

  (define random-source (make-pseudo-random-generator))
  (parameterize ([current-pseudo-random-generator random-source]) (random-seed 7))
  (define (uniform) (random random-source))

  (define (sign-exactly ax ay bx by cx cy)
    (define (minus p q) (- (inexact->exact p) (inexact->exact q)))
    (define determinant
      (- (* (minus ax cx) (minus by cy)) (* (minus ay cy) (minus bx cx))))
    (cond [(> determinant 0) 1] [(< determinant 0) -1] [else 0]))

  (test-case "5000 nearly collinear triples at scales from 1e-300 to 1e300"
    (for ([i (in-range 5000)])
      (define scale (vector-ref #(1e-300 1e-160 1.0 1e9 1e160 1e300) (modulo i 6)))
      (define-values (ax ay bx by) (values (uniform) (uniform) (uniform) (uniform)))
      (define t (* 3.0 (uniform)))
      (define numbers
        (for/list ([x (in-list (list ax ay bx by
                                     (fl+ ax (fl* t (fl- bx ax))) (fl+ ay (fl* t (fl- by ay)))))])
          (fl* scale x)))
      (check-eqv? (apply orientation numbers) (apply sign-exactly numbers))))

  (test-case "differences that overflow"
    (check-eqv? (orientation -1.7e308 -1.7e308 1.7e308 -1.7e308 0.0 1.7e308) 1)
    (check-eqv? (orientation -1.7e308 -1.7e308 1.7e308 1.7e308 0.0 0.0) 0))

  (test-case "zero area in space"
    (define (zero? . numbers) (zero-area? (apply flvector numbers) 0 1 2))
    (check-true (zero? 0.0 0.0 0.0 1.0 2.0 3.0 2.0 4.0 6.0))
    (check-true (zero? 0.1 0.1 0.1 0.2 0.2 0.2 0.7 0.7 0.7))
    (check-true (zero? 1.0 2.0 3.0 1.0 2.0 3.0 5.0 5.0 5.0))
    (check-false (zero? 0.0 0.0 0.0 1.0 2.0 3.0 2.0 4.0 6.000000000000001))
    (check-false (zero? 0.0 0.0 0.0 1e-200 0.0 0.0 0.0 1e-200 0.0))
    (check-false (zero? 0.0 0.0 0.0 0.0 0.0 4.9e-324 0.0 4.9e-324 0.0))
    (check-false (zero? 1e300 0.0 0.0 -1e300 0.0 0.0 0.0 1e308 1e308))))
