#lang racket/base
;; RoughConductor through its kernel: furnace, E08, chi-square, reciprocity, grazing angles.

(module+ test
  (require rackunit racket/flonum racket/math
           "support.rkt" "properties.rkt" "chi-square.rkt"
           "../../private/base/float3.rkt" "../../private/material/kernel.rkt"
           "../../private/material/energy.rkt" "../../private/material/rough-conductor.rkt")

  (define stress? (getenv "RAYTRACE_STRESS"))
  (define (white roughness) (make-bench (make-RoughConductor roughness)))
  (define ROUGHNESSES '(0.01 0.03 0.1 0.3 0.6 1.0))

  (define (finite-weight? w) (for/and ([x (in-flvector w)]) (<= 0.0 x 10.0)))

  (test-case "furnace: a white one returns 1 within .002, every roughness, ten angles, 2^12 samples"
    (define count (if stress? 65536 4096))
    (for* ([roughness (cons 1e-4 ROUGHNESSES)] [b (list (white roughness))]
           [degrees (append INCIDENCES '(89.9 89.99))])
      (face! b (direction-at NORMAL degrees 0.7))
      (define-values (sum good?)
        (for/fold ([sum 0.0] [good? #t]) ([k (in-range count)])
          (draw! b 5 k)
          (define w (sampled-weight b))
          (values (+ sum (flvector-ref w 1)) (and good? (finite-weight? w)))))
      (check-true good?)
      (check-= (/ sum count) 1.0 0.002 (format "roughness ~a, ~a degrees" roughness degrees))))

  (test-case "what evaluate returns of a white furnace, by quadrature: 1 within .0006"
    (for* ([roughness '(0.3)] [degrees (if stress? INCIDENCES '(75.0))])
      (define b (white roughness))
      (face! b (direction-at NORMAL degrees))
      (check-= (value-integral b 0) 1.0 0.0006)))

  (test-case "S24: chi-square of 10^5 samples, level .01 for all; the density sums to 1 (1e-4)"
    (define family '((0.05 60.0) (0.2 0.0) (0.4 80.0) (1.0 45.0)))
    (for ([member (in-list family)])
      (define-values (roughness degrees) (apply values member))
      (define b (white roughness))
      (face! b (direction-at NORMAL degrees 1.0))
      (define result
        (chi-square-test
         (lambda (k) (draw! b k) (to-local NORMAL (sampled-direction b)))
         (lambda (x y z) (local-density b x y z))
         (if stress? 1000000 100000)))
      (define p (chi-square-result-p result))
      (check-true (> p (sidak-level 0.01 (length family))) (format "~a: p = ~a" member p))
      (check-= (chi-square-result-integral result) 1.0 1e-4)))

  (test-case "sample and evaluate agree, to 1e-9"
    (for* ([roughness (list 1e-4 0.01 0.2 1.0)] [degrees '(0.0 50.0 85.0 89.999)])
      (define b (make-bench (gold roughness)))
      (face! b (direction-at NORMAL degrees))
      (check-consistency b 200)))

  (test-case "reciprocity, to 1e-12: white, coloured, and by complex index"
    (for* ([roughness '(0.02 0.2 1.0)]
           [material (list (make-RoughConductor roughness)
                           (make-RoughConductor roughness #:color (make-Float3 0.9 0.5 0.1))
                           (copper roughness))])
      (check-reciprocity (make-bench material) 200)))

  (test-case "E08: eta 2, k 4 at 0 and 60 degrees, smooth, to 1e-12; measured metals at the normal"
    (define (reflectance material degrees)
      (define b (make-bench material))
      (face! b (direction-at NORMAL degrees))
      (draw! b 0)
      (check-true (specular-sample? b))
      (check-true (close? (sampled-direction b)
                          (for/list ([x (in-flvector (reflected (direction-at NORMAL degrees) NORMAL))])
                            x)
                          1e-15))
      (for/list ([x (in-flvector (sampled-weight b))]) x))
    (define example
      (make-RoughConductor 0 #:eta (make-Float3 2 2 2) #:k (make-Float3 4 4 4)))
    (for ([r (reflectance example 0.0)]) (check-= r 0.68 1e-12))
    (for ([r (reflectance example 60.0)]) (check-= r 0.6565328500670229 1e-12))
    (check-equal? (reflectance (make-RoughConductor 0) 35.0) '(1.0 1.0 1.0))
    (check-equal? (reflectance (make-RoughConductor 0 #:color (make-Float3 0.5 0.25 0)) 0.0)
                  '(0.5 0.25 0.0)))

  (test-case "multiple scattering deepens a colour: against the sum over bounces, within .003"
    ;; a medium of index 1 is no surface at all
    (define nothing (make-RoughConductor 1 #:eta (make-Float3 1 1 1) #:k (make-Float3 0 0 0)))
    (define b (make-bench nothing))
    (face! b (direction-at NORMAL 30.0))
    (draw! b 0)
    (check-true (close? (sampled-weight b) '(0.0 0.0 0.0) 1e-20))
    (define f 0.5)
    (define tinted (make-bench (make-RoughConductor 1 #:color (make-Float3 1 f f))))
    (define count 20000)
    (define (mean b degrees component)
      (face! b (direction-at NORMAL degrees))
      (/ (for/fold ([sum 0.0]) ([k (in-range count)])
           (draw! b 3 k)
           (+ sum (flvector-ref (sampled-weight b) component)))
         count))
    ;; bounce k returns average (1 - average)^(k - 1) fa^k; Schlick's average fa of .5 is 11 / 21,
    ;; and single scattering reflects from .5 to .56 of its share
    (define average (GGX-average-albedo 1))
    (define fa (/ (+ (* 20.0 f) 1.0) 21.0))
    (for ([degrees '(0.0 60.0)])
      (define single (GGX-directional-albedo (cos (degrees->radians degrees)) 1))
      (define multiple
        (* (- 1.0 single) (/ (* fa fa average) (- 1.0 (* fa (- 1.0 average))))))
      (define found (mean tinted degrees 1))
      (check-true (< (+ (* f single) multiple -0.003) found (+ (* 0.56 single) multiple 0.003))
                  (format "~a degrees: ~a" degrees found))
      (check-= (mean tinted degrees 0) 1.0 0.002)))

  (test-case "no NaN, no infinity, no weight above 10, at grazing and for every roughness"
    (for* ([roughness '(1e-4 1e-3 0.05 0.4 1.0)] [cosine '(1e-3 1e-5 1e-8 1e-16 0.0)]
           [b (list (make-bench (silver roughness)))] [k (in-range 200)])
      (face! b (flvector (sqrt (- 1.0 (* cosine cosine))) cosine 0.0)
             #:normal (flvector 0.0 1.0 0.0))
      (draw! b k)
      (check-true (finite-weight? (sampled-weight b)) (format "~a ~a" roughness cosine))
      (check-true (<= 0.0 (sampled-density b) 1e300)))
    ;; evaluated at grazing, straight back, below, and along the mirrored direction
    (for* ([roughness '(1e-4 0.05 1.0)] [b (list (white roughness))]
           [y '(1.0 1e-3 1e-9 1e-16 0.0 -1e-16 -0.5 -1.0)] [x '(1.0 -1.0)] [oy '(1.0 0.5 1e-9 0.0)])
      (face! b (flvector (sqrt (- 1.0 (* oy oy))) oy 0.0) #:normal (flvector 0.0 1.0 0.0))
      (evaluate! b (flvector (* x (sqrt (- 1.0 (* y y)))) y 0.0))
      (for ([v (in-flvector (sampled-weight b))])
        (check-true (<= 0.0 v 1e300) (format "~a ~a ~a" roughness y oy)))
      (check-true (<= 0.0 (sampled-density b) 1e300))))

  (test-case "what the integrator is told, and what the constructor refuses"
    (check-false (MaterialKernel-specular? (bench-kernel (white 0.1))))
    (check-false (MaterialKernel-transmits? (bench-kernel (white 0.1))))
    (check-true (MaterialKernel-specular? (bench-kernel (white 0))))
    (check-equal? (make-RoughConductor 0.3) (make-RoughConductor 0.3 (make-Float3 1 1 1)))
    (check-equal? (RoughConductor-roughness (gold)) 0.1)
    (check-exn #rx"RoughConductor: expected a number from 0.0 to 1.0 as roughness, given 1.5"
               (lambda () (make-RoughConductor 1.5)))
    (check-exn #rx"RoughConductor: expected both of them and no color as eta and k"
               (lambda () (make-RoughConductor 0.5 #:eta (make-Float3 1 1 1))))
    (check-exn #rx"RoughConductor: expected a colour with components from 0 to 1 as color"
               (lambda () (make-RoughConductor 0.5 #:color (make-Float3 2 1 1))))))
