#lang typed/racket/base
;; The public names in typed code: each is a type, a constructor that takes any reals, and a match
;; pattern; and a tracer written against them in the article's manner sees what the library sees.
(require racket/match typed/rackunit raytrace)

(: nearest (-> World Ray Intersection))
(define (nearest world ray)
  (for/fold ([best : Intersection (Intersection-empty)])
            ([sphere : Sphere (in-list (World-spheres world))])
    (define try (Sphere-intersect sphere ray))
    (if (< (Intersection-t try) (Intersection-t best)) try best)))

(: ambient (-> World Float3 Float3 Flonum))
(define (ambient world point normal)
  (define start (Float3-add point (Float3-scale-by-scalar normal EPSILON)))
  (define total
    (for/fold ([sum : Flonum 0.0]) ([k (in-range WORLD-AMBIENT-SAMPLES)])
      (define direction (Float3-random-hemisphere-direction normal #:index k))
      (define hit (nearest world (Ray start direction)))
      (+ sum (min 1.0 (/ (Intersection-t hit) WORLD-MAX-OCCLUSION-DISTANCE)))))
  (/ total WORLD-AMBIENT-SAMPLES))

(module+ test
  (define world
    (World (list (Sphere (Float3 0 0 0) 1 (Float3 1 0 0)) (Sphere (Float3 0 2.5 0) 1/2))
           (DistantLight (Float3 0 1 0) (Float3 1 1 1))
           (Float3 0.4 0.6 1)))
  (define ray (Ray (Float3 0.1 0.2 5) (Float3 0 0 -1)))

  (test-case "constructors take any reals and match"
    (check-equal? (match (Float3 1 1/2 2.0) [(Float3 x y z) (list x y z)]) '(1.0 0.5 2.0))
    (check-equal? (match (Sphere (Float3 1 2 3) 4 (Float3 1 1 1)) [(Sphere p r _) (list p r)])
                  (list (Float3 1 2 3) 4.0))
    (check-equal? (map Float3 '(1 2) '(3 4) '(5 6)) (list (Float3 1 3 5) (Float3 2 4 6))))

  (test-case "a scan over the article's functions finds the world's nearest hit"
    (check-equal? (nearest world ray) (World-nearest-hit world ray))
    (check-true (> (Intersection-t (World-nearest-hit world (Ray (Float3 0 9 5) (Float3 0 0 -1))))
                   1e299)))

  (test-case "the article's ambient percentage, up to the choice of directions"
    ;; 64 well-spread samples each: both within 0.01 of the integral of this smooth case
    (define at (Float3 0 1 0))
    (define up (Float3 0 1 0))
    (check-= (ambient world at up) (World-get-ambient-percent world at up) 0.02))

  (test-case "a ray that hits nothing sees the background"
    (check-equal? (World-ray-trace world (Ray (Float3 0 0 5) (Float3 0 0 1)))
                  (World-background-color world)))

  (test-case "the colour at the nearest hit is the ray's"
    (check-equal? (World-get-color-at world ray (World-nearest-hit world ray))
                  (World-ray-trace world ray))))
