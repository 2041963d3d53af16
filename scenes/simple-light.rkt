#lang racket/base
;; Marble lit by a quad and a sphere that shine, as in Ray Tracing: The Next Week.
;; raco raytrace scenes/simple-light.rkt -o simple-light.png
(require raytrace)

(provide world camera settings)

(define marble (Lambertian (Marble (Float3 0 0 0) (Float3 1 1 1))))
(define light (Emitter (Float3 4 4 4) #:two-sided? #t))

(define world
  (World (list (Sphere (Float3 0 -1000 0) 1000 #:material marble)
               (Sphere (Float3 0 2 0) 2 #:material marble)
               (Sphere (Float3 0 7 0) 2 #:material light)
               (Quad (Float3 3 1 -2) (Float3 2 0 0) (Float3 0 2 0) light))
         '()
         (Float3 0 0 0)))

(define camera
  (Camera-look-at (Float3 26 3 6) (Float3 0 2 0) #:vertical-field-of-view-degrees 20))

(define settings (hash 'size '(400 225) 'samples 64))
