#lang racket/base
;; The weekend's spheres while the matte ones bounce, as in Ray Tracing: The Next Week.
;; raco raytrace scenes/bouncing-spheres.rkt -o bouncing-spheres.png
(require raytrace "parts/random.rkt" (prefix-in weekend: "weekend.rkt"))

(provide world camera settings)

(define checker (Checker (Float3 0.2 0.3 0.1) (Float3 0.9 0.9 0.9) 0.32))

(define ground (Sphere (Float3 0 -1000 0) 1000 #:material (Lambertian checker)))

(define (bouncing sphere k)
  (if (and (Lambertian? (Sphere-material sphere)) (< (Sphere-radius sphere) 0.5))
      (Moving sphere (Transform-identity) (Transform-translate 0 (random-between 0 0.5 k) 0))
      sphere))

(define world
  (World (cons ground
               (for/list ([sphere (cdr (World-shapes weekend:world))] [k (in-naturals)])
                 (bouncing sphere k)))
         '()
         (World-background weekend:world)))

(define camera weekend:camera)

(define settings (hash 'size '(400 225) 'samples 64))
