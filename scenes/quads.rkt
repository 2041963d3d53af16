#lang racket/base
;; Five quads around the view, as in Ray Tracing: The Next Week.
;; raco raytrace scenes/quads.rkt -o quads.png
(require raytrace)

(provide world camera settings)

(define (quad corner edge-u edge-v color) (Quad corner edge-u edge-v (Lambertian color)))

(define world
  (World (list (quad (Float3 -3 -2 5) (Float3 0 0 -4) (Float3 0 4 0) (Float3 1 0.2 0.2))
               (quad (Float3 -2 -2 0) (Float3 4 0 0) (Float3 0 4 0) (Float3 0.2 1 0.2))
               (quad (Float3 3 -2 1) (Float3 0 0 4) (Float3 0 4 0) (Float3 0.2 0.2 1))
               (quad (Float3 -2 3 1) (Float3 4 0 0) (Float3 0 0 4) (Float3 1 0.5 0))
               (quad (Float3 -2 -3 5) (Float3 4 0 0) (Float3 0 0 -4) (Float3 0.2 0.8 0.8)))
         '()
         (Float3 0.7 0.8 1)))

(define camera
  (Camera-look-at (Float3 0 0 9) (Float3 0 0 0) #:vertical-field-of-view-degrees 80))

(define settings (hash 'size '(400 400) 'samples 64))
