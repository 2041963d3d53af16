#lang racket/base
;; Spheres that shine: irradiance in closed form, directions and densities that agree, far, near
;; and inside.

(module+ test
  (require racket/list racket/match racket/math rackunit "../../main.rkt" "../statistics.rkt"
           "light-samples.rkt")

  (define uniform (seeded 1))
  (define (random-unit)
    (define v (Float3 (uniform -1.0 1.0) (uniform -1.0 1.0) (uniform -1.0 1.0)))
    (if (< 0.1 (Float3-length v) 1.0) (Float3-normalized v) (random-unit)))
  (define (scaled v s) (Float3-scale-by-scalar v s))
  (define origin (Float3 0 0 0))
  (define up (Float3 0 0 1))
  (define (light center radius [two-sided? #f])
    (World (list (Sphere center radius (Emitter (Float3 1 1 1) two-sided?)))))
  (define (estimates world point normal count)
    (for/list ([seed 16]) (light-irradiance world point normal count seed)))
  (define (at-cosine c distance)
    (Float3 (* distance (sqrt (- 1.0 (* c c)))) 0 (* distance c)))

  (test-case "A08, A09, A10: on, below and above the horizon, 4 standard errors, error below 1%"
    (for ([c '(0.0 -0.3 0.3)]
          [expected '(0.09058607370607955 0.011672369894608133 0.24729181891384264)])
      (check-mean (format "cosine ~a" c)
                  (estimates (light (at-cosine c 2.0) 1) origin up 4096) expected 0.01)))

  (test-case "wholly above the horizon: pi (R/d)^2 cos, error below 0.01%"
    (for* ([distance '(1.01 2.0 10.0 1e4 1e8)] [c '(1.0 0.995)])
      (check-mean (format "distance ~a" distance)
                  (estimates (light (at-cosine c distance) 1) origin up 4096)
                  (cond
                    [(or (= c 1.0) (> (* c distance) 1.0)) (* pi (/ 1.0 distance distance) c)]
                    [else 0.0])
                  1e-4)))

  (test-case "density: one over the solid angle to 1e-12, even at 10^8 radii; as sampled"
    (for ([k 200] [distance (in-cycle '(1.0001 1.5 3.0 100.0 1e5 1e8))])
      (define center (scaled (random-unit) distance))
      (define world (light center 1))
      (define s (sample-light world origin (uniform) (uniform)))
      (define d (apply Float3 (take s 3)))
      ;; 1 - cos = sin^2 / (1 + cos), in rational arithmetic but for the root
      (define sine-squared (/ 1 (let ([x (inexact->exact (Float3-length center))]) (* x x))))
      (define height (/ sine-squared (+ 1.0 (sqrt (exact->inexact (- 1 sine-squared))))))
      (check-= (* (last s) 2.0 pi height) 1.0 (if (< distance 1.01) 1e-10 1e-12))
      (check-equal? (light-density-toward world origin d) (last s))
      (for ([c (take (drop s 4) 3)]) (check-= (* c (last s)) 1.0 1e-15))
      (check-= (Float3-length d) 1.0 1e-15)))

  (test-case "directions end on the sphere where light-distance says, and fill the cone evenly"
    (for ([distance '(1.2 3.0 50.0)])
      (define center (Float3 0 0 distance))
      (define world (light center 1))
      (define rim (sqrt (- 1.0 (/ 1.0 distance distance))))
      (define all
        (for/list ([k 20000])
          (define s (sample-light world origin (uniform) (uniform)))
          (define point (scaled (apply Float3 (take s 3)) (fourth s)))
          (unless (< (abs (- (Float3-distance point center) 1.0)) (* 1e-9 distance))
            (fail (format "ends ~a from the centre" (Float3-distance point center))))
          (unless (>= (third s) (- rim 1e-15)) (fail "outside the cone"))
          s))
      (define (height s) (max 0.0 (/ (- 1.0 (third s)) (- 1.0 rim))))
      (define (turn s) (+ 0.5 (/ (atan (second s) (first s)) (* 2.0 pi))))
      (define z
        (uniform-deviate (for/list ([s all])
                           (/ (+ (floor (* 8.0 (min 0.999999 (height s)))) (min 0.999999 (turn s)))
                              8.0))
                         64))
      (check-true (< (abs z) 4.0) (format "distance ~a: deviate ~a" distance z))))

  (test-case "S31: inside a two-sided sphere the irradiance is pi wherever, whichever the normal"
    (for ([part '(0.0 0.3 0.9)])
      (define point (scaled (random-unit) part))
      (define world (light origin 1 #t))
      (check-mean (format "~a from the centre" part)
                  (estimates world point (random-unit) 8192) pi 0.02)
      (for ([k 200])
        (define s (sample-light world point (uniform) (uniform)))
        (define d (apply Float3 (take s 3)))
        (check-= (Float3-distance (Float3-add point (scaled d (fourth s))) origin) 1.0 1e-14)
        (check-= (/ (light-density-toward world point d) (last s)) 1.0 1e-9))))

  (test-case "S31: inside a one-sided sphere it is dark"
    (define s (sample-light (light origin 1) (Float3 0.1 0.2 0.3) 0.3 0.7))
    (check-equal? (drop s 4) '(0.0 0.0 0.0 0.0))
    (check-equal? (light-density-toward (light origin 1) (Float3 0.1 0.2 0.3) up) 0.0))

  (test-case "S31: on the sphere and just off it, irradiance pi cos, finite"
    (for* ([two-sided? '(#f #t)] [distance '(1.0 1.0000000000000002 1.000001)] [c '(1.0 0.6)])
      (define all
        (estimates (light (Float3 0 0 distance) 1 two-sided?) origin
                   (Float3 (sqrt (- 1.0 (* c c))) 0 c) 4096))
      ;; a hemisphere of light whose axis has that cosine to the normal: pi (1 + cos) / 2
      (define m (mean all))
      (check-true (and (= m m) (< m 10.0)))
      (check-= m (* pi 0.5 (+ 1.0 c)) 0.02
               (format "distance ~a, cosine ~a, two-sided ~a" distance c two-sided?)))))
