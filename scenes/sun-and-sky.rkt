#lang racket/base
;; A clear afternoon: the sun and its sky (Preetham) on polished and on rough things.
;; raco raytrace scenes/sun-and-sky.rkt -o sun-and-sky.png
(require raytrace)

(provide world camera settings)

(define towards-sun (Float3 -0.55 0.42 0.35))

(define paving (Plane (Float3 0 0 0) (Float3 0 1 0) (Lambertian (Float3 0.42 0.4 0.37))))
(define (ball x z radius material) (Sphere (Float3 x radius z) radius #:material material))

(define world
  (World (list paving
               (ball -2.3 0 1 (gold 0.12))
               (ball 0 -0.6 1.3 (Mirror (Float3 0.95 0.95 0.95)))
               (ball 2.4 0.2 1 (Plastic (Float3 0.75 0.12 0.08)))
               (ball 0.9 2 0.45 (Dielectric 1.5))
               (ball -0.8 2.2 0.35 (Lambertian (Float3 0.2 0.4 0.7))))
         (daylight-sun towards-sun)
         (daylight-sky towards-sun)))

(define camera
  (Camera-look-at (Float3 0.5 2 8.5) (Float3 0 1 0) #:vertical-field-of-view-degrees 32))

(define settings (hash 'size '(800 450) 'samples 64 'integrator 'path))
