#lang racket/base
;; K cases: how fast means over a sampler's points approach integrals, at 16, 64, 256, 1024 and 4096
;; points: relative RMSE over many seeds and the slope fitted on logarithmic axes. The number of
;; seeds leaves 3% of uncertainty in an RMSE and 0.01 in a slope, well below the tolerances.

(module+ test
  (require racket/list racket/math rackunit "../../main.rkt" "../statistics.rkt" "integrands.rkt")

  (define COUNTS '(16 64 256 1024 4096))
  (define REPEATS (stressed 500 4000))

  ;; The straight line nearest to the logarithms.
  (define (slope errors)
    (define-values (xs ys) (values (map log COUNTS) (map log errors)))
    (define middle (mean xs))
    (/ (for/sum ([x xs] [y ys]) (* (- x middle) y))
       (for/sum ([x xs]) (* (- x middle) (- x middle)))))

  ;; Of each sampler: for each integrand the five RMSE and the slope.
  (define measured
    (for/hash ([name '(independent stratified r2 owen-sobol)])
      (define rows (for/list ([n COUNTS]) (relative-errors name n REPEATS)))
      (values name
              (for/hash ([integrand INTEGRANDS] [k (in-naturals)])
                (define errors (for/list ([row rows]) (list-ref row k)))
                (values integrand (append errors (list (slope errors))))))))
  (define (found name integrand) (hash-ref (hash-ref measured name) integrand))

  ;; --- K10 ---

  ;; The truth table's figures: five RMSE and the slope. It has one set of seeds behind each.
  (define expected
    '(
      (independent
       (quarter-disk 0.2498 0.1237 0.06362 0.02963 0.01517  -0.507)
       (half-plane 0.2576 0.1249 0.0616 0.03143 0.01508  -0.509)
       (gauss 0.09503 0.0493 0.02445 0.01194 0.006003  -0.501)
       (bilinear 0.225 0.1081 0.05459 0.02771 0.0144  -0.495)
       (ambient-sphere-cosine 0.1939 0.09203 0.04687 0.02348 0.01165  -0.504)
       (ambient-sphere-uniform 0.1526 0.07935 0.04039 0.02104 0.01032  -0.484)
       (ceiling-uniform 0.05342 0.02667 0.01356 0.006959 0.003488  -0.491)
       (ceiling-cosine 0.06149 0.03073 0.01486 0.007853 0.003634  -0.506)
       (half-shadow 0.2523 0.126 0.06088 0.02816 0.01574  -0.508)
       (disk-light 0.03201 0.01553 0.007818 0.004027 0.001886  -0.506))
      (stratified
       (quarter-disk 0.09805 0.0407 0.01486 0.005201 0.001699  -0.733)
       (half-plane 0.1228 0.04553 0.01585 0.00554 0.002087  -0.740)
       (gauss 0.02361 0.006034 0.001506 0.0003718 9.494e-05  -0.997)
       (bilinear 0.05685 0.01425 0.003634 0.0009769 0.0002275  -0.990)
       (ambient-sphere-cosine 0.1197 0.04276 0.01482 0.0053 0.001857  -0.752)
       (ambient-sphere-uniform 0.1099 0.03539 0.01331 0.00482 0.001669  -0.748)
       (ceiling-uniform 0.01549 0.004189 0.001017 0.0002646 6.564e-05  -0.987)
       (ceiling-cosine 0.01509 0.003959 0.001042 0.000277 6.333e-05  -0.982)
       (half-shadow 0.002035 0.0005325 0.0001352 3.41e-05 9.243e-06  -0.977)
       (disk-light 0.01908 0.004934 0.001277 0.0003117 7.414e-05  -1.000))
      (r2
       (quarter-disk 0.1263 0.04504 0.01536 0.004675 0.001557  -0.798)
       (half-plane 0.1349 0.04141 0.007537 0.002757 0.0007113  -0.952)
       (gauss 0.0553 0.01572 0.00358 0.001133 0.0002983  -0.943)
       (bilinear 0.1396 0.0424 0.01285 0.003564 0.001082  -0.880)
       (ambient-sphere-cosine 0.07861 0.02642 0.009324 0.003399 0.001124  -0.761)
       (ambient-sphere-uniform 0.08369 0.02565 0.008888 0.002972 0.001042  -0.788)
       (ceiling-uniform 0.02981 0.008018 0.001217 0.0002914 7.86e-05  -1.096)
       (ceiling-cosine 0.03348 0.008708 0.0014 0.0003317 9.347e-05  -1.084)
       (half-shadow 0.05197 0.02297 0.005402 0.001074 0.0003275  -0.952)
       (disk-light 0.007193 0.002526 0.0005223 0.0001367 1.854e-05  -1.070))))

  (for* ([rows expected] [row (cdr rows)])
    (define-values (name integrand) (values (car rows) (car row)))
    (test-case (format "K10: ~a, ~a: RMSE within 1.25x, slope within 0.08" integrand name)
      (define errors (found name integrand))
      (for ([n COUNTS] [e errors] [right (cdr row)])
        (check-true (< (/ 1.0 1.25) (/ e right) 1.25)
                    (format "~a points: ~a, expected ~a" n e right)))
      (check-= (last errors) (last row) 0.08)))

  ;; --- S28 ---

  (define smooth '(gauss bilinear ceiling-uniform ceiling-cosine))
  (define edges '(quarter-disk half-plane ambient-sphere-cosine ambient-sphere-uniform))
  (define (check-slopes name integrands expected tolerance)
    (for ([integrand integrands])
      (check-= (last (found name integrand)) expected tolerance (format "~a ~a" name integrand))))

  (test-case "S28: independent -0.50 +- 0.03, stratified -0.75 +- 0.05 at edges and -1 +- 0.05"
    (check-slopes 'independent INTEGRANDS -0.50 0.03)
    (check-slopes 'stratified edges -0.75 0.05)
    (check-slopes 'stratified smooth -1.0 0.05))

  (test-case "S28: Owen-scrambled Sobol -1.45 +- 0.08, -0.74 +- 0.05 at edges"
    (check-slopes 'owen-sobol smooth -1.45 0.08)
    (check-slopes 'owen-sobol edges -0.74 0.05))

  ;; --- independent samples: sigma / sqrt(N) ---

  ;; The standard deviation of one sample relative to its mean, in closed form.
  (define (binary p) (sqrt (/ (- 1.0 p) p)))
  (define (relative square mean) (/ (sqrt (- square (* mean mean))) mean))
  (define deviations-of-one
    (hash 'quarter-disk 1.0
          'half-plane 1.0
          ;; the mean square is (sqrt(pi / 8) erf(sqrt(2)))^2
          'gauss (relative (sqr (* (sqrt (/ pi 8.0)) 0.9544997361036416)) (sqr 0.7468241328124271))
          'bilinear (relative 1/9 1/4)
          'ambient-sphere-cosine (binary (- 1.0 (/ (sqrt 0.5) 2.0)))
          'ambient-sphere-uniform (binary (sqrt 0.5))
          ;; C18 and C19 at k = 1/2
          'ceiling-uniform (/ 0.18251892022603297 0.8465735902799727)
          'ceiling-cosine (/ 0.1845903309493015 0.75)
          ;; the mean of (1 + c s)^-4 for s in [0, 1]
          'half-shadow (let ([c 1/64])
                         (relative (/ (- 1.0 (expt (+ 1.0 c) -3)) (* 6.0 c)) (/ 0.5 (+ 1.0 c))))
          'disk-light (relative (/ (- 1.0 (expt 1.25 -3)) 0.75) 0.8)))

  ;; five counts together have 5 x 500 errors: 1.4% of uncertainty
  (test-case "independent samples: sigma / sqrt(N) within 5%"
    (for ([(integrand sigma) deviations-of-one])
      (define ratios
        (for/list ([n COUNTS] [e (found 'independent integrand)]) (/ (* e (sqrt n)) sigma)))
      (check-= (sqrt (mean (map sqr ratios))) 1.0 0.05 (format "~a: ~a" integrand ratios))))

  ;; --- K01, K02: through the public function ---

  (define (means name n seeds f)
    (for/list ([seed seeds])
      (/ (for/fold ([sum 0.0]) ([index n])
           (define-values (u v) (sample-point name #:index index #:seed seed #:count n))
           (+ sum (f u v)))
         n)))

  (test-case "K01: pi by hit or miss with 16 independent points, sqrt(pi (4 - pi)) / 4 within 5%"
    (define estimates
      (means 'independent 16 1000 (lambda (u v) (if (< (+ (* u u) (* v v)) 1.0) 4.0 0.0))))
    (check-mean "pi" estimates pi 0.005)
    (check-= (/ (* 4.0 (standard-deviation estimates)) 1.642183367736324) 1.0 0.05))

  (test-case "K02: the quarter disk of radius sqrt(2 / pi) covers one half, by every sampler"
    (for ([name '(owen-sobol independent stratified r2)])
      (check-mean (format "~a" name)
                  (means name 16 500 (lambda (u v) (if (< (+ (* u u) (* v v)) (/ 2.0 pi)) 1.0 0.0)))
                  0.5 0.02)))

  ;; --- S29 ---

  (test-case "S29: every sampler's means are unbiased, 4 standard errors, and together (chi-square)"
    (define z
      (for*/list ([name '(owen-sobol independent stratified r2)] [k 4])
        (define estimates
          (means name 16 256
                 (list-ref (list (lambda (u v) (exp (- (+ (* u u) (* v v)))))
                                 (lambda (u v) (* u v))
                                 (lambda (u v) (if (< v u) 1.0 0.0))
                                 (lambda (u v) (min 1.0 (/ 0.5 (max u 1e-300)))))
                           k)))
        (define exact (list-ref (list (sqr 0.7468241328124271) 0.25 0.5 (/ (+ 1.0 (log 2.0)) 2.0)) k))
        (define off (/ (- (mean estimates) exact) (standard-error estimates)))
        (check-true (< (abs off) 4.0) (format "~a, integrand ~a: ~a" name k off))
        off))
    ;; the sum of 16 squares has mean 16 and standard deviation sqrt(32); 46 has p = 1e-4
    (check-true (< (for/sum ([x z]) (* x x)) 46.0))))
