#lang racket/base
;; RoughDielectric through its kernel: furnace from both sides, chi-square, reciprocity, grazing.

(module+ test
  (require rackunit racket/flonum racket/math
           "support.rkt" "properties.rkt" "chi-square.rkt"
           "../../private/base/float3.rkt" "../../private/material/kernel.rkt"
           "../../private/material/dielectric.rkt" "../../private/material/energy.rkt"
           "../../private/material/rough-dielectric.rkt")

  (define stress? (getenv "RAYTRACE_STRESS"))
  (define (glass roughness [ior 1.5]) (make-bench (make-RoughDielectric ior roughness)))
  (define SIDES '(#f #t))
  (define (finite-weight? w) (for/and ([x (in-flvector w)]) (<= 0.0 x 100.0)))

  ;; mean weight and its standard error
  (define (furnace b count)
    (define-values (sum squares good?)
      (for/fold ([sum 0.0] [squares 0.0] [good? #t]) ([k (in-range count)])
        (draw! b 5 k)
        (define w (sampled-weight b))
        (define x (flvector-ref w 0))
        (values (+ sum x) (+ squares (* x x)) (and good? (finite-weight? w)))))
    (check-true good?)
    (define mean (/ sum count))
    (values mean (sqrt (/ (max 0.0 (- (/ squares count) (* mean mean))) count))))

  ;; The kernel returns 1 - lost-energy by single scattering and its column of losses by the other
  ;; lobe; what is left is the column's error between nodes.
  (test-case "furnace: the column of losses, between nodes, within .0012 of the quadrature"
    (for* ([ior (if stress? '(1.05 1.1 1.33 1.5 2.42) '(1.1 1.5))] [eta (list ior (/ 1.0 ior))]
           [alpha '(0.003 0.01 0.03 0.1 0.4 1.0)])
      (define column (single-scattering-losses alpha eta))
      (define worst
        (for/fold ([worst 0.0]) ([k (in-range 60)])
          (define cosine (expt (/ (+ k 0.5) 60.0) 1.5))
          (define place (* 96 (loss-coordinate/function cosine alpha)))
          (define cell (inexact->exact (floor place)))
          (define t (- place cell))
          (max worst (abs (- (+ (* (- 1.0 t) (flvector-ref column cell))
                                (* t (flvector-ref column (+ cell 1))))
                             (lost-energy cosine alpha eta))))))
      (check-true (<= worst 0.0012) (format "eta ~a alpha ~a: ~a" eta alpha worst))))

  (test-case "furnace: 1 within .002 + 4.5 standard errors, roughness .01 to 1, ten angles, both sides"
    (define count (if stress? 262144 2048))
    (for* ([roughness '(1e-4 0.01 0.03 0.1 0.3 1.0)] [ior '(1.1 1.5)] [b (list (glass roughness ior))]
           [inside? SIDES])
      (define-values (total error)
        (for/fold ([total 0.0] [error 0.0]) ([degrees INCIDENCES])
          (face! b (direction-at NORMAL degrees 0.7) #:inside? inside?)
          (define-values (mean error-here) (furnace b count))
          (check-= mean 1.0 (+ 0.002 (* 4.5 error-here))
                   (format "roughness ~a, ior ~a, ~a degrees, inside ~a" roughness ior degrees inside?))
          (values (+ total mean) (+ error (* error-here error-here)))))
      ;; the ten angles together
      (check-= (/ total 10.0) 1.0 (+ 0.001 (* 0.45 (sqrt error)))
               (format "roughness ~a, inside ~a" roughness inside?))))

  (test-case "furnace: what evaluate returns, by quadrature, is 1 within .001"
    (for* ([roughness (if stress? '(0.1 0.3 1.0) '(0.3))] [inside? SIDES]
           [degrees (if stress? INCIDENCES '(50.0))])
      (define b (glass roughness))
      (face! b (direction-at NORMAL degrees) #:inside? inside?)
      (check-= (value-integral b 0) 1.0 0.001)))

  (test-case "S24: chi-square of 10^5 samples, level .01 for all; what the density lacks is lost"
    (define family '((0.1 60.0 #f) (0.3 0.0 #f) (0.3 50.0 #t) (1.0 75.0 #f)))
    (for ([member (in-list family)])
      (define-values (roughness degrees inside?) (apply values member))
      (define b (glass roughness))
      (face! b (direction-at NORMAL degrees 1.0) #:inside? inside?)
      (define result
        (chi-square-test
         (lambda (k)
           (draw! b k)
           (and (> (sampled-density b) 0.0) (to-local NORMAL (sampled-direction b))))
         (lambda (x y z) (local-density b x y z))
         (if stress? 1000000 100000)))
      (define p (chi-square-result-p result))
      (check-true (> p (sidak-level 0.01 (length family))) (format "~a: p = ~a" member p))
      (check-true (< 0.8 (chi-square-result-integral result) 1.0001))))

  (test-case "sample and evaluate agree, to 1e-9; what is lost has neither weight nor density"
    (for* ([roughness '(1e-4 0.01 0.2 1.0)] [degrees '(0.0 41.8 70.0 89.0)] [inside? SIDES])
      (define b (glass roughness))
      (face! b (direction-at NORMAL degrees) #:inside? inside?)
      (for ([k (in-range 200)])
        (draw! b k)
        (define-values (d density weight)
          (values (sampled-direction b) (sampled-density b) (flvector-ref (sampled-weight b) 0)))
        (cond
          [(> density 0.0)
           (check-= (dot d d) 1.0 1e-12)
           (evaluate! b d)
           (check-= (/ (sampled-density b) density) 1.0 1e-9)
           (check-= (/ (flvector-ref (sampled-weight b) 0) (* weight density)) 1.0 1e-9)]
          [else (check-equal? weight 0.0)]))))

  (test-case "reciprocity: n(o)^2 f(o, i) = n(i)^2 f(i, o), to 1e-9, also through the boundary"
    (define ior 1.5)
    (for ([roughness '(0.1 0.4 1.0)])
      (define b (glass roughness ior))
      ;; value over cosine, seen from out, which is on the inside or not
      (define (f out in out-inside? normal)
        (face! b out #:normal normal #:inside? out-inside?)
        (evaluate! b in)
        (/ (flvector-ref (sampled-weight b) 0) (abs (dot in normal))))
      (define below (flvector (- (flvector-ref NORMAL 0)) (- (flvector-ref NORMAL 1))
                              (- (flvector-ref NORMAL 2))))
      (define transmitted
        (for/sum ([k (in-range 300)])
          (define-values (a c) (values (random-direction NORMAL) (random-direction below)))
          (define there (f a c #f NORMAL))
          (define back (* ior ior (f c a #t below)))
          (check-= (/ there back) 1.0 1e-9)
          there))
      (check-true (> transmitted 0.0))
      (for ([inside? SIDES] [k (in-range 100)])
        (define-values (a c) (values (random-direction NORMAL) (random-direction NORMAL)))
        (check-= (/ (f a c inside? NORMAL) (f c a inside? NORMAL)) 1.0 1e-9))))

  (test-case "the part a clear boundary reflects, at roughness .001, within 5e-3 of Fresnel"
    (define b (glass 0.001))
    (for ([row '((0.0 #f 0.04) (75.0 #f 0.25306056299031965) (30.0 #t 0.055190167295375916)
                 (60.0 #t 1.0))])
      (face! b (direction-at NORMAL (car row)) #:inside? (cadr row))
      (define part
        (/ (for/sum ([k (in-range 4096)])
             (draw! b 3 k)
             (if (> (dot (sampled-direction b) NORMAL) 0.0) (flvector-ref (sampled-weight b) 0) 0.0))
           4096))
      (check-= part (caddr row) 5e-3)))

  (test-case "light fades inside by absorption and distance, as sampled and as evaluated, to 1e-12"
    (define-values (clear b)
      (values (glass 0.3)
              (make-bench (make-RoughDielectric 1.5 0.3 #:absorption (make-Float3 0 1 2)))))
    (for* ([inside? SIDES] [k (in-range 100)])
      (for ([bench (list clear b)])
        (face! bench (direction-at NORMAL 40.0) #:inside? inside? #:distance 0.7)
        (draw! bench k))
      (define (check-faded)
        (define-values (w full) (values (sampled-weight b) (flvector-ref (sampled-weight clear) 0)))
        (check-true (close? w (if inside?
                                  (list full (* full (exp -0.7)) (* full (exp -1.4)))
                                  (list full full full))
                            (* 1e-12 full))))
      (check-faded)
      (define d (sampled-direction b))
      (evaluate! clear d)
      (evaluate! b d)
      (check-faded)))

  (test-case "no NaN, no infinity, at grazing and for every roughness, from both sides"
    (define up (flvector 0.0 1.0 0.0))
    (for* ([roughness '(1e-4 1e-3 0.05 0.4 1.0)] [ior '(1.0001 1.5 2.42)] [b (list (glass roughness ior))]
           [inside? SIDES] [cosine '(1.0 1e-3 1e-5 1e-8 1e-16 0.0)])
      (define out (flvector (sqrt (- 1.0 (* cosine cosine))) cosine 0.0))
      (face! b out #:normal up #:inside? inside?)
      (for ([k (in-range 100)])
        (draw! b k)
        (check-true (finite-weight? (sampled-weight b))
                    (format "~a ~a ~a ~a: ~a" roughness ior cosine inside? (sampled-weight b)))
        (check-true (<= 0.0 (sampled-density b) 1e300)))
      (for* ([y '(1.0 1e-3 1e-9 0.0 -1e-16 -1e-3 -1.0)] [x '(1.0 -1.0)])
        (evaluate! b (flvector (* x (sqrt (- 1.0 (* y y)))) y 0.0))
        (check-true (<= 0.0 (flvector-ref (sampled-weight b) 0) 1e300)
                    (format "~a ~a ~a ~a ~a" roughness ior cosine y x))
        (check-true (<= 0.0 (sampled-density b) 1e300)))))

  (test-case "what the integrator is told, and what the constructor refuses"
    (define kernel (bench-kernel (glass 0.1)))
    (check-false (MaterialKernel-specular? kernel))
    (check-true (MaterialKernel-transmits? kernel))
    (for ([clear (list (glass 0) (glass 0.5 1.0))])
      (check-true (MaterialKernel-specular? (bench-kernel clear)))
      (check-true (MaterialKernel-transmits? (bench-kernel clear))))
    (check-exn #rx"RoughDielectric: expected a number from 0.0 to 1.0 as roughness, given -1"
               (lambda () (make-RoughDielectric 1.5 -1)))
    (check-exn #rx"RoughDielectric: expected a positive finite number as ior, given 0"
               (lambda () (make-RoughDielectric 0)))))
