#lang racket/base
;; Motion blur: balls that bounce, one that spins past, and a shutter that is open the whole time.
;; raco raytrace scenes/motion.rkt -o motion.png
(require raytrace)

(provide world camera settings)

(define floor (Plane (Float3 0 0 0) (Float3 0 1 0) (Lambertian (Float3 0.55 0.55 0.52))))

(define (bouncing x height color)
  (Moving (Sphere (Float3 x 0.6 0) 0.6 #:material (Plastic color))
          (Transform-identity)
          (Transform-translate 0 height 0)))

;; Rows of the matrix move linearly from one transform to the other.
(define passing
  (Moving (Box (Float3 -0.5 -0.5 -0.5) (Float3 0.5 0.5 0.5) (Lambertian (Float3 0.85 0.6 0.1)))
          (Transform-translate -3.2 0.5 2.2)
          (Transform-translate -1.6 0.5 2.2)))

(define world
  (World (list floor
               (bouncing -2.4 0.0 (Float3 0.7 0.1 0.1))
               (bouncing -0.8 0.35 (Float3 0.1 0.5 0.2))
               (bouncing 0.8 0.8 (Float3 0.1 0.25 0.7))
               (bouncing 2.4 1.6 (Float3 0.5 0.2 0.6))
               passing)
         (DistantLight (Float3 1 2 1.5) (Float3 2 1.9 1.7))
         (GradientSky (Float3 0.9 0.9 0.9) (Float3 0.4 0.6 0.9))))

(define camera
  (Camera-look-at (Float3 0 2.2 9) (Float3 0 1 0) #:vertical-field-of-view-degrees 32))

(define settings (hash 'size '(640 360) 'samples 64 'integrator 'path))
