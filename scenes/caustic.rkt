#lang racket/base
;; Light gathered by glass: a lamp through a glass ball and coloured glass.
;; raco raytrace scenes/caustic.rkt -o caustic.png
(require raytrace)

(provide world camera settings)

(define floor (Disk (Float3 0 0 0) (Float3 0 1 0) 60 (Lambertian (Float3 0.75 0.73 0.7))))
(define clear (Dielectric 1.5))
(define amber (Dielectric 1.5 #:absorption (Float3 0.08 0.45 1.6)))
(define green (Dielectric 1.6 #:absorption (Float3 1.1 0.15 0.7)))

(define world
  (World (list floor
               (Sphere (Float3 -1.6 1 0) 1 #:material clear)
               (Sphere (Float3 1.1 0.8 1.1) 0.8 #:material amber)
               (Torus (Float3 1.4 0.35 -1.6) (Float3 0 1 0) 1.1 0.35 green)
               (Sphere (Float3 -9 12 -6) 2.2 #:material (Emitter (Float3 32 30 27))))
         '()
         (Float3 0.04 0.045 0.06)))

(define camera
  (Camera-look-at (Float3 1.5 5.5 9) (Float3 0.3 0.3 0) #:vertical-field-of-view-degrees 34))

(define settings (hash 'size '(640 400) 'samples 256 'integrator 'path))
