#lang racket/base
;; First light: a sunflower of glossy beads around two mirrors, under one warm lamp and a wide sky.
;; raco raytrace scenes/first-light.rkt -o first-light.png
(require raytrace racket/math)

(provide world camera settings)

;; A palette from dusk to gold, by linear interpolation between its colours.
(define palette
  (vector (Float3 0.03 0.09 0.30) (Float3 0.02 0.32 0.42) (Float3 0.10 0.55 0.38)
          (Float3 0.95 0.62 0.12) (Float3 0.90 0.22 0.07) (Float3 0.55 0.04 0.14)))

(define (palette-color s)
  (define place (* s (- (vector-length palette) 1)))
  (define k (min (exact-floor place) (- (vector-length palette) 2)))
  (Float3-linear-interpolate (vector-ref palette k) (vector-ref palette (+ k 1)) (- place k)))

;; Seeds of a sunflower (Vogel 1979): each a golden angle on from the last, farther out, larger.
(define golden-angle (* pi (- 3 (sqrt 5))))

(define beads
  (for/list ([k (in-range 22 420)])
    (define s (/ k 420.0))
    (define distance (* 0.385 (sqrt k)))
    (define angle (* k golden-angle))
    (define radius (+ 0.09 (* 0.22 (sqrt s))))
    (Sphere (Float3 (* distance (cos angle)) radius (* distance (sin angle))) radius
            #:material (Phong (palette-color s) #:specularity 0.5 #:shininess 90
                              #:reflectivity 0.08))))

(define gold-mirror (Phong (Float3 0.02 0.015 0.01) #:reflectivity (Float3 0.98 0.80 0.48)
                           #:specularity 0.6 #:shininess 400))
(define clear-mirror (Phong (Float3 0.01 0.01 0.01) #:reflectivity 0.92
                            #:specularity 0.6 #:shininess 400))

(define mirrors
  (list (Sphere (Float3 0 1.22 0) 1.22 #:material gold-mirror)
        (Sphere (Float3 0 3.02 0) 0.58 #:material clear-mirror)))

(define ground
  (Sphere (Float3 0 -2000 0) 2000
          #:material (Phong (Float3 0.34 0.33 0.36) #:specularity 0.12 #:shininess 24)))

(define lamp (Sphere (Float3 -15 11 7) 2.6 #:material (Emitter (Float3 40 29 18))))

(define world
  (World (append (list ground lamp) mirrors beads)
         '()
         (GradientSky (Float3 1.30 0.70 0.36) (Float3 0.06 0.16 0.48))
         #:ambient-color (Float3 0.32 0.36 0.46)
         #:ambient-samples 2 #:ambient-weighting 'cosine #:max-occlusion-distance 4
         #:shadow-samples 2 #:mirror-bounces 4))

(define camera
  (Camera-look-at (Float3 2.4 3.1 9.6) (Float3 0 1.25 0)
                  #:vertical-field-of-view-degrees 34
                  #:lens-radius 0.03 #:focus-distance 8.9))

(define settings (hash 'size '(640 360) 'samples 16))
