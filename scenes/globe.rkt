#lang racket/base
;; A globe whose continents are noise: seas, coasts, deserts, forests, mountains and ice.
;; raco raytrace scenes/globe.rkt -o globe.png
(require raytrace racket/math "parts/land.rkt")

(provide world camera settings)

(define globe (Sphere (Float3 0 0 0) 1 #:material (Lambertian land)))

;; The Earth's axis leans by 23.4 degrees, and its texture with it.
(define world
  (World (list (Instance globe (Transform-compose (Transform-rotate (Float3 0 0 1) (* -23.4 pi 1/180))
                                                  (Transform-rotate (Float3 0 1 0) 0.6)))
               (Sphere (Float3 -30 14 26) 5 #:material (Emitter (Float3 90 86 78))))
         '()
         (Float3 0.012 0.014 0.02)))

(define camera
  (Camera-look-at (Float3 0 0 6) (Float3 0 0 0) #:vertical-field-of-view-degrees 24))

(define settings (hash 'size '(400 400) 'samples 64))
