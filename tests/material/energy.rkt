#lang racket/base
;; Energy that single scattering loses: D12, D13, the table against the quadrature, and the
;; quadrature against a plain Monte Carlo estimate that shares no code with it.

(module+ test
  (require rackunit racket/flonum racket/math "../../private/material/energy.rkt")

  ;; alpha, cosine, directional albedo
  (define D12 '((0.1 0.5 0.9692049844118066) (0.1 0.1 0.8834550018672095)
                (0.25 1.0 0.9158124302497551) (0.25 0.1 0.8916223518094919)
                (0.5 1.0 0.6878485151102389) (0.5 0.5 0.6982506969275508)
                (1.0 1.0 0.3068528194400558) (1.0 0.5 0.4506938556659469)
                (1.0 0.1 0.7602104727201667)))

  (test-case "D12: directional albedo, 2e-4 by quadrature and 5e-4 from the table"
    (for ([row (in-list D12)])
      (define-values (alpha cosine expected) (apply values row))
      (check-= (- 1.0 (lost-energy cosine alpha 0.0)) expected 2e-4)
      (check-= (GGX-directional-albedo cosine alpha) expected 5e-4)))

  (test-case "D13: average albedo at alpha 1, to 1e-4"
    (check-= (GGX-average-albedo 1.0) 0.40913709259595177 1e-4))

  (test-case "the table against the quadrature, between nodes of alpha and cosine: 5e-4"
    (define worst
      (for*/fold ([worst 0.0]) ([alpha '(1e-4 3e-4 1e-3 3e-3 0.01 0.03 0.07 0.2 0.45 0.7 0.93 1.0)]
                                [k (in-range 100)])
        (define cosine (expt (/ (+ k 0.5) 100.0) 2.0))
        (max worst (abs (- (GGX-directional-albedo cosine alpha)
                           (- 1.0 (lost-energy cosine alpha 0.0)))))))
    (check-true (<= worst 5e-4) (format "~a" worst)))

  (test-case "columns by node: their nodes, and no loss of digits where hardly anything is lost"
    (for ([alpha '(1e-4 0.01 0.3 1.0)])
      (for ([k (in-range 97)])
        (check-= (* 96 (loss-coordinate/function (node-cosine k alpha) alpha)) k 1e-9))
      (check-equal? (node-cosine 0 alpha) 0.0)
      (check-equal? (node-cosine 96 alpha) 1.0))
    ;; along the normal, and for alpha to 0: alpha^2 / 2 of the facets reflect below the surface
    ;; or are masked; the relative error of the table is a few per cent
    (for ([alpha '(1e-3 3e-3 0.01)])
      (check-= (/ (lost-energy 1.0 alpha 0.0) (* alpha alpha)) 1.0 0.08)
      (check-= (/ (flvector-ref (conductor-losses alpha) 96) (lost-energy 1.0 alpha 0.0)) 1.0 0.08)))

  ;; The loss at the surface by visible normals (Heitz, "Sampling the GGX Distribution of Visible
  ;; Normals", 2018) and Walter's and Snell's formulas; with its standard error.
  (define (estimated-loss cosine alpha eta count)
    (define generator (vector->pseudo-random-generator (vector 1 2 3 4 5 6)))
    (define sine (sqrt (- 1.0 (* cosine cosine))))
    (define (smith c) ; G1
      (/ 2.0 (+ 1.0 (sqrt (+ 1.0 (/ (* alpha alpha (- 1.0 (* c c))) (* c c)))))))
    (define (lambda-of c) (- (/ 1.0 (smith c)) 1.0))
    (define length (sqrt (+ (* alpha alpha sine sine) (* cosine cosine))))
    (define-values (vx vz) (values (/ (* alpha sine) length) (/ cosine length)))
    (define-values (sum squares)
      (for/fold ([sum 0.0] [squares 0.0]) ([k (in-range count)])
        (define radius (sqrt (random generator)))
        (define phi (* 2.0 pi (random generator)))
        (define t1 (* radius (cos phi)))
        (define s (* 0.5 (+ 1.0 vz)))
        (define t2 (+ (* (- 1.0 s) (sqrt (- 1.0 (* t1 t1)))) (* s (* radius (sin phi)))))
        (define t3 (sqrt (max 0.0 (- 1.0 (* t1 t1) (* t2 t2)))))
        ;; frame (0, 1, 0), (-vz, 0, vx), (vx, 0, vz) around the stretched direction
        (define-values (hx hy hz) (values (* alpha (- (* t3 vx) (* t2 vz))) (* alpha t1)
                                          (max 0.0 (+ (* t3 vz) (* t2 vx)))))
        (define h-length (sqrt (+ (* hx hx) (* hy hy) (* hz hz))))
        (define nz (/ hz h-length))
        (define c (min 1.0 (+ (* sine (/ hx h-length)) (* cosine nz))))
        (define refracted-squared (- 1.0 (/ (- 1.0 (* c c)) (* eta eta))))
        (define reflectance
          (cond
            [(<= refracted-squared 0.0) 1.0]
            [else
             (define t (sqrt refracted-squared))
             (/ (+ (sqr (/ (- c (* eta t)) (+ c (* eta t)))) (sqr (/ (- (* eta c) t) (+ (* eta c) t))))
                2.0)]))
        (define (kept z)
          (if (> z 0.0)
              (/ (+ 1.0 (lambda-of cosine)) (+ 1.0 (lambda-of cosine) (lambda-of z)))
              0.0))
        (define up (- (* 2.0 c nz) cosine))
        (define down
          (if (< reflectance 1.0)
              (- (/ cosine eta) (* nz (- (/ c eta) (sqrt refracted-squared))))
              0.0))
        (define lost
          (- 1.0 (+ (* reflectance (kept up)) (* (- 1.0 reflectance) (kept down)))))
        (values (+ sum lost) (+ squares (* lost lost)))))
    (define mean (/ sum count))
    (values mean (sqrt (/ (- (/ squares count) (* mean mean)) count))))

  (test-case "losses of reflecting and refracting boundaries, within 4.5 standard errors + 6e-4"
    (for* ([eta (list 1.1 1.5 (/ 1.0 1.5) (/ 1.0 1.1))] [alpha '(0.03 0.3 1.0)]
           [cosine '(0.02 0.4 0.74 1.0)])
      (define-values (mean error) (estimated-loss cosine alpha eta 8000))
      (check-= (lost-energy cosine alpha eta) mean (+ 6e-4 (* 4.5 error))
               (format "eta ~a alpha ~a cosine ~a: ~a" eta alpha cosine mean))))

  (test-case "Gauss-Legendre rules: exact for degree 2n - 1, to 1e-14"
    (for ([n '(1 2 5 12 32)])
      (define rule (gauss-legendre n))
      (for ([degree (in-range (* 2 n))])
        (check-= (for/fold ([sum 0.0]) ([k (in-range n)])
                   (+ sum (* (flvector-ref rule (+ 1 (* 2 k)))
                             (expt (flvector-ref rule (* 2 k)) degree))))
                 (/ 1.0 (+ degree 1.0)) 1e-14))))

  (test-case "averages by cosine, to 1e-14; arguments out of range are told"
    (check-= (average-over-cosine (lambda (c) 1.0)) 1.0 1e-14)
    (check-= (average-over-cosine (lambda (c) (* c c))) 0.5 1e-14)
    (check-exn #rx"GGX-directional-albedo: expected a number from 0.0 to 1.0 as cosine"
               (lambda () (GGX-directional-albedo 1.5 0.5)))
    (check-exn #rx"GGX-average-albedo: expected a number from 0.0001 to 1.0 as alpha"
               (lambda () (GGX-average-albedo 0)))))
