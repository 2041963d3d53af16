#lang racket/base
;; Properties every material must have, checked through its kernel.
(require rackunit racket/flonum racket/math "support.rkt" "chi-square.rkt")

(provide check-consistency check-furnace check-reciprocity value-integral random-direction)

(define generator (vector->pseudo-random-generator (vector 6 5 4 3 2 1)))
(define (random-direction normal)
  (direction-at normal (radians->degrees (acos (random generator)))
                (* 2.0 pi (random generator))))

;; What sample says of its directions is what evaluate says of them: density, and weight times
;; density, to a relative 1e-9. The direction is a unit vector to 1e-12.
(define (check-consistency b count)
  (for ([k (in-range count)])
    (draw! b k)
    (unless (specular-sample? b)
      (define d (sampled-direction b))
      (define density (sampled-density b))
      (define weight (sampled-weight b))
      (check-true (> density 0.0))
      (check-= (dot d d) 1.0 1e-12)
      (evaluate! b d)
      (check-= (/ (sampled-density b) density) 1.0 1e-9)
      (for ([w (in-flvector weight)] [v (in-flvector (sampled-weight b))])
        (check-true (<= (abs (- v (* w density))) (* 1e-9 v)) (format "~a ~a" v (* w density)))))))

;; The mean weight is what the material is documented to reflect, each component given within 4.5
;; standard errors, and no weight is negative or NaN. Both for independent samples.
(define (check-furnace b count expected [message ""])
  (define-values (sums squares good)
    (for/fold ([sums '(0.0 0.0 0.0)] [squares '(0.0 0.0 0.0)] [good 0]) ([k (in-range count)])
      (draw! b k)
      (define w (for/list ([x (in-flvector (sampled-weight b))]) x))
      (values (map + sums w) (map + squares (map sqr w))
              (if (andmap (lambda (x) (<= 0.0 x 1e6)) w) (+ good 1) good))))
  (check-equal? good count (format "~a weights that are no weights" message))
  (for ([sum sums] [square squares] [e expected])
    (define mean (/ sum count))
    (define error (sqrt (/ (max 0.0 (- (/ square count) (sqr mean))) count)))
    (check-true (<= (abs (- mean e)) (+ (* 4.5 error) 1e-12))
                (format "~a mean ~a, expected ~a, standard error ~a" message mean e error))))

;; The light that samples with a density return, by quadrature of evaluate, of one component.
(define (value-integral b component)
  (density-integral (lambda (x y z) (local-value b component x y z))))

;; The value is the same with both directions exchanged, to a relative 1e-12.
(define (check-reciprocity b count)
  (define (value out in)
    (face! b out)
    (evaluate! b in)
    (for/list ([x (in-flvector (sampled-weight b))]) (/ x (dot in NORMAL))))
  (for ([k (in-range count)])
    (define-values (a c) (values (random-direction NORMAL) (random-direction NORMAL)))
    (for ([there (value a c)] [back (value c a)])
      (check-true (<= (abs (- there back)) (* 1e-12 there)) (format "~a ~a" there back)))))
