#lang racket/base
;; Noise: zero at whole points, between -1 and 1, smooth across cells, without mean; sums over
;; octaves; and the textures made of it by their formulas.
(module+ test
  (require rackunit racket/math raytrace "support.rkt")

  (random-seed 3)
  (define (somewhere [size 100]) (Float3 (spread size) (spread size) (spread size)))
  (define (spread size) (* size (- (* 2 (random)) 1)))

  (test-case "the same point has the same noise, another seed another"
    (for ([k 20])
      (define p (somewhere))
      (check-equal? (perlin-noise p) (perlin-noise p))
      (check-not-equal? (perlin-noise p) (perlin-noise p #:seed 1))))

  (test-case "0 at whole points; between -1 and 1; both signs, and above 0.7"
    (for ([k 50])
      (check-equal? (perlin-noise (Float3 (- (random 99) 50) (- (random 99) 50) k)) 0.0))
    (define-values (low high)
      (for/fold ([low 0.0] [high 0.0]) ([k 20000])
        (define n (perlin-noise (somewhere 1e4)))
        (values (min low n) (max high n))))
    (check-true (<= -1.0 low -0.7) (format "~a" low))
    (check-true (<= 0.7 high 1.0) (format "~a" high)))

  (test-case "continuous with its slope, across the borders of cells too"
    ;; steps of 1e-6: values within 4e-6 of each other, slopes within 1e-3
    (for* ([k 100] [axis 3])
      (define (at s)
        (define (near-border c a) (+ (if (= a axis) (- c (exact-round c)) 0.0) s))
        (perlin-noise (Float3 (if (= axis 0) (+ 3 s) 0.3)
                              (if (= axis 1) (+ -5 s) (* 0.01 k))
                              (if (= axis 2) (+ k s) 7.7))))
      (define-values (a b c) (values (at -1e-6) (at 0.0) (at 1e-6)))
      (check-= a b 4e-6)
      (check-= c b 4e-6)
      (check-= (/ (- b a) 1e-6) (/ (- c b) 1e-6) 1e-3)))

  (test-case "mean 0, over cells that share no corner: 4 standard errors"
    (define values
      (for*/list ([x 16] [y 16] [z 16])
        (perlin-noise (Float3 (+ 0.4 (* 2 x)) (+ 0.5 (* 2 y)) (+ 0.3 (* 2 z))))))
    (define mean (/ (apply + values) 4096))
    (define deviation (sqrt (/ (for/sum ([v values]) (sqr (- v mean))) 4095)))
    (check-true (< 0.1 deviation 0.5))
    (check-true (< (abs mean) (/ (* 4 deviation) 64))))

  (test-case "every octave adds half as much, twice as fine"
    (for ([k 20])
      (define p (somewhere))
      (define finest (- (perlin-noise p #:octaves 5) (perlin-noise p #:octaves 4)))
      (check-true (<= (abs finest) 1/16)))
    ;; at points whole after two doublings only two octaves are left
    (define quarter (Float3 1.25 -2.75 3.5))
    (check-= (perlin-noise quarter 7) (perlin-noise quarter 2) 1e-15)
    (check-equal? (perlin-turbulence quarter) (abs (perlin-noise quarter 7))))

  (define dark (Float3 0.1 0.2 0.3))
  (define light (Float3 0.9 0.7 0.5))
  (define (mixed s) (components (Float3-linear-interpolate dark light (max 0.0 (min 1.0 s)))))
  (define (check-formula texture formula)
    (define look (seen texture))
    (for ([k 50])
      (define-values (x y) (values (random) (random)))
      (check-true (same-color? (look x y) (mixed (formula (lambda (s) (Float3 (* s x) (* s y) 0)))) 1e-9))))

  (test-case "Noise, Turbulence and Marble by their formulas, to 1e-9"
    (check-formula (Noise dark light 5 #:seed 7)
                   (lambda (p) (* 0.5 (+ 1 (perlin-noise (p 5) 1 7)))))
    (check-formula (Noise dark light 5 #:octaves 3)
                   (lambda (p) (* 0.5 (+ 1 (/ (perlin-noise (p 5) 3) 1.75)))))
    (check-formula (Turbulence dark light 3) (lambda (p) (perlin-turbulence (p 3))))
    (check-formula (Marble dark light 2)
                   (lambda (p) (* 0.5 (+ 1 (sin (* 10 (perlin-turbulence (p 2)))))))))

  (test-case "marble's layers lie across z"
    (define (marble z)
      (define look (looker (Quad (Float3 0 0 z) (Float3 1 0 0) (Float3 0 1 0)
                                 (shining (Marble dark light 3 #:bands 2 #:disorder 0)))))
      (components (look 0.3 0.4)))
    (for ([z '(-0.7 0.1 0.45)])
      (check-true (same-color? (marble z) (mixed (* 0.5 (+ 1 (sin (* 6 z))))) 1e-12)))))
