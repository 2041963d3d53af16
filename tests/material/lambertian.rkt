#lang racket/base
;; Lambertian through its kernel.

(module+ test
  (require rackunit racket/flonum racket/math "support.rkt" "properties.rkt"
           "../../private/base/float3.rkt" "../../private/material/lambertian.rkt")

  (define b (make-bench (make-Lambertian (make-Float3 1 0.5 0.25))))

  (test-case "furnace: every sample's weight is the albedo, exactly, at ten angles"
    (for* ([degrees INCIDENCES] [k (in-range 1000)])
      (face! b (direction-at NORMAL degrees))
      (draw! b k)
      (check-equal? (sampled-weight b) (flvector 1.0 0.5 0.25))
      (check-true (> (dot (sampled-direction b) NORMAL) 0.0))))

  (test-case "sample and evaluate agree"
    (face! b (direction-at NORMAL 50.0))
    (check-consistency b 1000))

  (test-case "value albedo / pi, to 1e-15, and nothing below the surface"
    (face! b (direction-at NORMAL 20.0))
    (evaluate! b (direction-at NORMAL 60.0 2.0))
    (check-true (close? (sampled-weight b) (list (/ 0.5 pi) (/ 0.25 pi) (/ 0.125 pi)) 1e-15))
    (evaluate! b (direction-at NORMAL 100.0))
    (check-equal? (sampled-weight b) (flvector 0.0 0.0 0.0))
    (check-equal? (sampled-density b) 0.0))

  (test-case "reciprocity" (check-reciprocity b 200)))
