#lang racket/base
;; Mirror, and Metal without fuzz, through their kernels.

(module+ test
  (require rackunit racket/flonum "support.rkt"
           "../../private/base/float3.rkt" "../../private/material/mirror.rkt"
           "../../private/material/metal.rkt" "../../private/material/kernel.rkt")

  (define tint (flvector 0.9 0.5 0.1))
  (define tinted (make-Float3 0.9 0.5 0.1))

  (for ([material (list (make-Mirror tinted) (make-Metal tinted) (make-Mirror))]
        [weight (list tint tint (flvector 1.0 1.0 1.0))])
    (define b (make-bench material))
    (check-true (MaterialKernel-specular? (bench-kernel b)))
    (check-false (MaterialKernel-transmits? (bench-kernel b)))
    (test-case "furnace: each sample exactly the tint; the mirrored direction to 1e-15"
      (for ([degrees INCIDENCES])
        (define out (direction-at NORMAL degrees 0.7))
        (face! b out)
        (draw! b 1)
        (check-equal? (sampled-weight b) weight)
        (check-true (specular-sample? b))
        (check-true (close? (sampled-direction b)
                            (for/list ([x (in-flvector (reflected out NORMAL))]) x) 1e-15))
        (check-= (dot (sampled-direction b) NORMAL) (dot out NORMAL) 1e-15)))
    (test-case "no density to evaluate"
      (face! b (direction-at NORMAL 30.0))
      (evaluate! b (reflected (direction-at NORMAL 30.0) NORMAL))
      (check-equal? (sampled-weight b) (flvector 0.0 0.0 0.0))
      (check-equal? (sampled-density b) 0.0)))

  (test-case "a shading normal turned away from the viewer gives way to the geometric one"
    (define b (make-bench (make-Mirror)))
    (define out (direction-at NORMAL 85.0))
    (face! b out #:shading-normal (direction-at NORMAL 20.0 3.141592653589793))
    (draw! b 1)
    (check-true (close? (sampled-direction b)
                        (for/list ([x (in-flvector (reflected out NORMAL))]) x) 1e-15)))

  (test-case "bad tints"
    (for ([bad (list (make-Float3 1.1 0 0) (make-Float3 -0.1 0 0) (make-Float3 +nan.0 0 0))])
      (check-exn #rx"^Mirror: expected a colour .* as color" (lambda () (make-Mirror bad)))
      (check-exn #rx"^Metal: .* as albedo" (lambda () (make-Metal bad))))))
