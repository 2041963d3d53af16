#lang racket/base
;; Four metals by their measured indices, from polished at the front to dull at the back.
;; raco raytrace scenes/metals.rkt -o metals.png
(require raytrace)

(provide world camera settings)

(define balls
  (for*/list ([(metal column) (in-indexed (list gold copper silver aluminium))]
              [(roughness row) (in-indexed '(0.0 0.15 0.35))])
    (Sphere (Float3 (* 2.3 (- column 1.5)) 1 (* -2.4 row)) 1 #:material (metal roughness))))

(define table (Disk (Float3 0 0 0) (Float3 0 1 0) 40 (Lambertian (Float3 0.18 0.19 0.21))))
(define (softbox corner edge-u edge-v radiance) 
  (Quad corner edge-u edge-v (Emitter radiance #:two-sided? #t)))

(define world
  (World (list* table
                (softbox (Float3 -7 6 5) (Float3 5 0 2) (Float3 0 3 -1.5) (Float3 9 9 9))
                (softbox (Float3 4 8 -8) (Float3 4 0 2) (Float3 0 0 5) (Float3 7 7.5 8))
                (softbox (Float3 7 3 6) (Float3 1.5 0 -3) (Float3 0 4 0) (Float3 6 5 4))
                balls)
         '()
         (GradientSky (Float3 0.3 0.28 0.26) (Float3 0.5 0.6 0.75))))

(define camera
  (Camera-look-at (Float3 0 5 13) (Float3 0 0.7 -1.6) #:vertical-field-of-view-degrees 30))

(define settings (hash 'size '(960 540) 'samples 128 'integrator 'path))
