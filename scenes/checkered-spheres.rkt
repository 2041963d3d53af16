#lang racket/base
;; Two checkered spheres, one upon the other, as in Ray Tracing: The Next Week.
;; raco raytrace scenes/checkered-spheres.rkt -o checkered-spheres.png
(require raytrace)

(provide world camera settings)

;; A checker in space: the cubes it is made of cut through the spheres.
(define checker (Checker (Float3 0.2 0.3 0.1) (Float3 0.9 0.9 0.9) 0.32))

(define world
  (World (list (Sphere (Float3 0 -10 0) 10 #:material (Lambertian checker))
               (Sphere (Float3 0 10 0) 10 #:material (Lambertian checker)))
         '()
         (GradientSky (Float3 1 1 1) (Float3 0.5 0.7 1))))

(define camera
  (Camera-look-at (Float3 13 2 3) (Float3 0 0 0) #:vertical-field-of-view-degrees 20))

(define settings (hash 'size '(400 225) 'samples 64))
