#lang racket/base
;; A lens of six blades in focus on one ball of a row; lamps far behind show its shape.
;; raco raytrace scenes/depth-of-field.rkt -o depth-of-field.png
(require raytrace)

(provide world camera settings)

(define floor (Plane (Float3 0 0 0) (Float3 0 1 0) (Lambertian (Float3 0.3 0.3 0.33))))

(define row
  (for/list ([k 7])
    (define along (- k 3))
    (Sphere (Float3 (* 0.9 along) 0.5 (* -2.2 along)) 0.5
            #:material (Plastic (Float3 (/ (+ 1 k) 8) 0.25 (/ (- 7 k) 8))))))

(define lamps
  (for*/list ([x (in-range -6 7 2)] [y '(1.5 3.5 5.5)])
    (Sphere (Float3 (* 2 x) y -26) 0.12
            #:material (Emitter (if (odd? (quotient x 2)) (Float3 400 250 90) (Float3 120 200 400))))))

(define world (World (append (cons floor row) lamps) '() (Float3 0.12 0.13 0.18)))

(define camera
  (Camera-with
   (Camera-look-at (Float3 -1.5 1.4 10) (Float3 0 0.8 0) #:vertical-field-of-view-degrees 30
                   #:lens-radius 0.28)
   #:blades 6))

(define settings (hash 'size '(640 360) 'samples 128 'integrator 'path))
