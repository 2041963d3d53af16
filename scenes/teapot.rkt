#lang racket/base
;; The Utah teapot (Martin Newell, 1975) from its 32 Bézier patches, on a floor under two lamps.
;; raco raytrace scenes/teapot.rkt -o teapot.png
(require raytrace)

(provide world camera settings)

(define pot (teapot #:tolerance 0.002 #:material (Plastic (Float3 0.75 0.3 0.12) 1.5)))

(define floor
  (Disk (Float3 0 0 0) (Float3 0 1 0) 40 #:material (Lambertian (Float3 0.6 0.6 0.62))))

;; A square lamp of half side `size` at a point, turned to the pot.
(define (lamp point size radiance)
  (define toward (Float3-normalized (Float3-subtract (Float3 0 1 0) point)))
  (define u (Float3-scale-by-scalar (Float3-normalized (Float3-cross (Float3 0 1 0) toward)) size))
  (define v (Float3-cross toward u))
  (Quad (Float3-subtract point (Float3-add u v))
        (Float3-scale-by-scalar u 2) (Float3-scale-by-scalar v 2)
        #:material (Emitter radiance)))

(define world
  (World (list pot floor
               (lamp (Float3 -6 8 6) 2 (Float3 14 13 12))
               (lamp (Float3 8 5 2) 1 (Float3 10 12 16)))
         '()
         (GradientSky (Float3 0.25 0.25 0.27) (Float3 0.1 0.12 0.18))))

(define camera
  (Camera-look-at (Float3 1.5 5.5 9.5) (Float3 0.2 1.35 0) #:vertical-field-of-view-degrees 28))

(define settings (hash 'size '(960 540) 'samples 64))
