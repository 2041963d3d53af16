#lang racket/base
;; Integral geometry: random lines of even density through convex bodies. The mean chord is 4 V / S,
;; the mean shadow S / 4 (Cauchy); within 4 standard errors of 20,000 lines.
(module+ test
  (require racket/math rackunit raytrace)

  (define LINES 20000)
  (define generator (vector->pseudo-random-generator (vector 11 22 33 44 55 66)))
  (define (uniform) (random generator))

  (define (random-direction)
    (define z (- 1 (* 2 (uniform))))
    (define turn (* 2 pi (uniform)))
    (define ring (sqrt (- 1 (* z z))))
    (Float3 (* ring (cos turn)) (* ring (sin turn)) z))

  ;; The length of the shape on a random line through the ball of a radius around the center; 0 where
  ;; it is missed. The line is walked from both ends, 3 radii away.
  (define (chord shape center radius)
    (define direction (random-direction))
    (define-values (u v) (perpendicular direction))
    (define-values (distance turn) (values (* radius (sqrt (uniform))) (* 2 pi (uniform))))
    (define middle
      (Float3-add center (Float3-add (Float3-scale-by-scalar u (* distance (cos turn)))
                                     (Float3-scale-by-scalar v (* distance (sin turn))))))
    (define reach (* 3 radius))
    (define (from sign)
      (define toward (Float3-scale-by-scalar direction sign))
      (Intersection-t
       (Shape-intersect shape
                        (Ray (Float3-subtract middle (Float3-scale-by-scalar toward reach))
                             toward))))
    (define ahead (from 1.0))
    (if (< ahead (* 2 reach)) (- (* 2 reach) ahead (from -1.0)) 0.0))

  (define (perpendicular w)
    (define u
      (Float3-normalized
       (Float3-cross w (if (> (abs (Float3-x w)) 0.9) (Float3 0 1 0) (Float3 1 0 0)))))
    (values u (Float3-cross w u)))

  (define (mean+error numbers)
    (define n (length numbers))
    (define mean (/ (apply + numbers) n))
    (values mean (sqrt (/ (for/sum ([v (in-list numbers)]) (sqr (- v mean))) (* n (- n 1))))))

  (define (chords shape center radius)
    (for/list ([k (in-range LINES)]) (chord shape center radius)))

  (define (check-mean-chord shape center radius expected)
    (define-values (mean error) (mean+error (filter positive? (chords shape center radius))))
    (check-= mean expected (* 4 error)))

  (define grey (Float3 0.5 0.5 0.5))
  (test-case "N01: the mean chord of a ball"
    (check-mean-chord (Sphere (Float3 1 2 3) 1 grey) (Float3 1 2 3) 1.0 4/3))
  (test-case "N02: of a box of 1 x 2 x 3"
    (check-mean-chord (Box (Float3 0 0 0) (Float3 1 2 3) grey) (Float3 0.5 1 1.5)
                      (/ (sqrt 14) 2) 24/22))
  (test-case "N05: the mean shadow of a unit cube"
    (define radius (/ (sqrt 3) 2))
    (define-values (share error)
      (mean+error
       (for/list ([c (in-list (chords (Box (Float3 0 0 0) (Float3 1 1 1) grey)
                                      (Float3 0.5 0.5 0.5) radius))])
         (if (positive? c) 1.0 0.0))))
    (define area (* pi radius radius))
    (check-= (* area share) 1.5 (* 4 area error))))
