#lang racket/base
;; Fog at night: a row of columns, and a street lamp whose light is seen on its way.
;; raco raytrace scenes/fog.rkt -o fog.png
(require raytrace)

(provide world camera settings)

(define stone (Lambertian (Float3 0.5 0.47 0.43)))

(define (column x z)
  (Cylinder (Float3 x 0 z) (Float3 x 5 z) 0.3 stone))

(define columns
  (for*/list ([k 6] [x '(-2.2 2.2)])
    (column x (* -3 k))))

;; The lamp throws its light down through the fog between the second and third pair.
(define lamp
  (SpotLight (Float3 0 4.6 -4.5) (Float3 0 -1 0.12) (Float3 260 200 120)
             0.5 0.42))

(define glow (Sphere (Float3 0 2 -13) 0.4 #:material (Emitter (Float3 3 4 6))))

(define world
  (World (list* (Plane (Float3 0 0 0) (Float3 0 1 0) stone) glow columns)
         lamp
         (Float3 0.01 0.012 0.02)
         #:medium (Medium 0.04 (Float3 0.7 0.7 0.7) #:anisotropy 0.3)))

(define camera
  (Camera-look-at (Float3 0.6 1.5 6) (Float3 0 1.9 -6) #:vertical-field-of-view-degrees 42))

(define settings (hash 'size '(640 360) 'samples 64))
