#lang racket/base
;; Marble made of Perlin noise, as in Ray Tracing: The Next Week, between its two ingredients.
;; raco raytrace scenes/perlin-spheres.rkt -o perlin-spheres.png
(require raytrace)

(provide world camera settings)

(define black (Float3 0 0 0))
(define white (Float3 1 1 1))

(define (ball z radius texture)
  (Sphere (Float3 0 radius z) radius #:material (Lambertian texture)))

(define world
  (World (list (Sphere (Float3 0 -1000 0) 1000 #:material (Lambertian (Marble black white)))
               (ball 0 2 (Marble black white))
               ;; smooth noise, and the magnitude of noise summed over seven octaves
               (ball 3.4 1 (Noise black white 4))
               (ball -3.4 1 (Turbulence black white 2)))
         '()
         (GradientSky (Float3 1 1 1) (Float3 0.5 0.7 1))))

(define camera
  (Camera-look-at (Float3 13 2 3) (Float3 0 1.2 0) #:vertical-field-of-view-degrees 24))

(define settings (hash 'size '(400 225) 'samples 64))
