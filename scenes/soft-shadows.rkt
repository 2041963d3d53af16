#lang racket/base
;; Soft shadows: three spherical lights of growing size over the same balls; the larger the light,
;; the wider the half shadow.
;; raco raytrace scenes/soft-shadows.rkt -o soft-shadows.png
(require raytrace)

(provide world camera settings)

(define chalk (Phong (Float3 0.75 0.73 0.70) #:specularity 0))

(define floor (Sphere (Float3 0 -3000 0) 3000 #:material chalk))

;; One ball on the floor below one light of that radius, all lights equally strong.
(define (station x radius color)
  (define strength (/ 11.0 (* radius radius)))
  (list (Sphere (Float3 x 0.8 0) 0.8
                #:material (Phong color #:specularity 0.4 #:shininess 60))
        (Sphere (Float3 (- x 1.5) 3.2 1.2) radius
                #:material (Emitter (Float3-scale-by-scalar (Float3 0.16 0.15 0.13) strength)))))

(define world
  (World (append (list floor)
                 (station -4 0.08 (Float3 0.85 0.25 0.18))
                 (station 0 0.35 (Float3 0.20 0.55 0.30))
                 (station 4 0.8 (Float3 0.20 0.35 0.80)))
         '()
         (Float3 0.02 0.025 0.035)
         #:ambient-color (Float3 0.03 0.035 0.05)
         #:ambient-samples 8 #:ambient-weighting 'cosine
         #:shadow-samples 16))

(define camera
  (Camera-look-at (Float3 0 5.0 11) (Float3 0 1.2 0) #:vertical-field-of-view-degrees 34))

(define settings (hash 'size '(960 400) 'samples 4))
