#lang racket/base
;; ModifiedPhong through its kernel. Its distribution is tested in sampling.rkt.

(module+ test
  (require rackunit racket/flonum racket/math "support.rkt" "properties.rkt" "chi-square.rkt"
           "../../private/base/float3.rkt" "../../private/material/modified-phong.rkt"
           "../../private/material/kernel.rkt")

  (define (bench-of shininess)
    (make-bench (make-ModifiedPhong (make-Float3 0.5 0.2 0) (make-Float3 0.3 0.7 0.1) shininess)))
  (define white-highlight
    (make-bench (make-ModifiedPhong (make-Float3 0 0 0) (make-Float3 1 1 1) 30)))

  (test-case "value and density by hand, to 1e-14"
    (define b (bench-of 10))
    (define in (direction-at NORMAL 40.0 2.0))
    (define out (direction-at NORMAL 30.0))
    (face! b out)
    (evaluate! b in)
    (define c (dot in NORMAL))
    (define power (expt (max 0.0 (dot in (reflected out NORMAL))) 10.0))
    (check-true (close? (sampled-weight b)
                        (for/list ([kd '(0.5 0.2 0.0)] [ks '(0.3 0.7 0.1)])
                          (* c (+ (/ kd pi) (* ks (/ 12.0 (* 2.0 pi)) power))))
                        1e-14))
    (define highlight (* 0.7 (/ 12.0 11.0)))
    (define share (/ highlight (+ highlight 0.5)))
    (check-= (sampled-density b)
             (+ (* share (/ 11.0 (* 2.0 pi)) power) (* (- 1.0 share) (/ c pi))) 1e-14))

  (test-case "seen along the normal it reflects albedo + specular, to 1e-6"
    (for ([shininess '(0 5 100)])
      (define b (bench-of shininess))
      (face! b NORMAL)
      (for ([k 3] [expected '(0.8 0.9 0.1)])
        (check-= (value-integral b k) expected 1e-6))))

  (test-case "furnace at ten angles: what quadrature says, and never more than comes in"
    (for ([b (list (bench-of 20) white-highlight)] #:when #t [degrees INCIDENCES])
      (face! b (direction-at NORMAL degrees))
      (define expected (value-integral b 0))
      (check-true (<= expected (+ 1.0 1e-6)))
      (check-furnace b 16384 (list expected) degrees)))

  (test-case "the density integrates to 1 over all directions, to 1e-6"
    (for ([shininess '(0 1 50)] #:when #t [degrees '(0.0 45.0 80.0)])
      (define b (bench-of shininess))
      (face! b (direction-at NORMAL degrees))
      (check-= (density-integral (lambda (x y z) (local-density b x y z))) 1.0 1e-6)))

  (test-case "sample and evaluate agree, however sharp the highlight"
    (for ([shininess '(0 1 50 1e4 1e9)] #:when #t [degrees INCIDENCES])
      (define b (bench-of shininess))
      (face! b (direction-at NORMAL degrees))
      (check-consistency b 100)))

  (test-case "reciprocity" (check-reciprocity (bench-of 20) 200))

  (test-case "black absorbs"
    (define black (make-bench (make-ModifiedPhong (make-Float3 0 0 0) (make-Float3 0 0 0) 10)))
    (face! black NORMAL)
    (draw! black 1)
    (check-equal? (sampled-weight black) (flvector 0.0 0.0 0.0))
    (check-equal? (sampled-density black) 0.0))

  (test-case "bad arguments"
    (check-exn #rx"^ModifiedPhong: expected a colour that with albedo adds up to at most 1"
               (lambda () (make-ModifiedPhong (make-Float3 0.5 0.5 0.5) (make-Float3 0 0 0.6) 10)))
    (check-not-exn
     (lambda () (make-ModifiedPhong (make-Float3 0.9 0.7 0.57) (make-Float3 0.1 0.3 0.43) 10)))
    (check-exn #rx"^ModifiedPhong: .* as shininess"
               (lambda () (make-ModifiedPhong (make-Float3 0 0 0) (make-Float3 0 0 0) -1)))))
