#lang racket/base
;; Metal with fuzz through its kernel. Its distribution is tested in sampling.rkt.

(module+ test
  (require rackunit racket/flonum racket/math "support.rkt"
           "../../private/base/float3.rkt" "../../private/material/metal.rkt"
           "../../private/material/kernel.rkt")

  (define (bench-of fuzz) (make-bench (make-Metal (make-Float3 0.7 0.6 0.5) fuzz)))
  (define (absorbed? b) (equal? (sampled-weight b) (flvector 0.0 0.0 0.0)))

  (test-case "directions stay within asin(fuzz) of the mirrored one, to 1e-12, and above the surface"
    (define b (bench-of 0.5))
    (check-true (MaterialKernel-specular? (bench-kernel b)))
    (for ([degrees INCIDENCES])
      (define out (direction-at NORMAL degrees))
      (face! b out)
      (define nearest
        (for/fold ([nearest 1.0]) ([k (in-range 2000)])
          (draw! b k)
          (cond
            [(absorbed? b) nearest]
            [else
             (check-equal? (sampled-weight b) (flvector 0.7 0.6 0.5))
             (check-true (specular-sample? b))
             (define d (sampled-direction b))
             (check-= (dot d d) 1.0 1e-14)
             (check-true (> (dot d NORMAL) 0.0))
             (min nearest (dot d (reflected out NORMAL)))])))
      (check-true (>= nearest (- (cos (asin 0.5)) 1e-12)))
      ;; and the whole cone is used
      (check-true (<= nearest 0.9))))

  ;; the part of a ball of radius f around height c that is below 0
  (define (below c f)
    (define h (- f c))
    (if (> h 0.0) (/ (* h h (- (* 3.0 f) h)) (* 4.0 f f f)) 0.0))

  (test-case "the absorbed part is the ball's cap below the surface, within 4.5 standard errors"
    (for* ([fuzz (list 0.3 1.0)] [degrees INCIDENCES])
      (define b (bench-of fuzz))
      (face! b (direction-at NORMAL degrees))
      (define count 4096)
      (define lost (for/sum ([k (in-range count)]) (draw! b k) (if (absorbed? b) 1 0)))
      (define expected (below (cos (degrees->radians degrees)) fuzz))
      (check-true (<= (abs (- lost (* count expected)))
                      (+ 1e-9 (* 4.5 (sqrt (* count expected (- 1.0 expected))))))
                  (format "~a ~a: ~a of ~a" fuzz degrees lost (* count expected)))))

  (test-case "bad fuzz"
    (for ([bad (list -0.1 1.1 +nan.0)])
      (check-exn #rx"^Metal: expected a number from 0.0 to 1.0 as fuzz"
                 (lambda () (make-Metal (make-Float3 1 1 1) bad))))))
