#lang racket/base
;; A globe whose continents are noise: seas, coasts, deserts, forests, mountains and ice.
;; raco raytrace scenes/globe.rkt -o globe.png
(require raytrace racket/math)

(provide world camera settings)

;; Colours from the sea's floor to the highest mountains, each with the height where it begins.
(define ramp
  (list (cons -1.00 (Float3 0.01 0.03 0.12)) (cons -0.10 (Float3 0.02 0.12 0.30))
        (cons 0.06 (Float3 0.05 0.30 0.42))  (cons 0.07 (Float3 0.55 0.48 0.28))
        (cons 0.11 (Float3 0.10 0.26 0.07))  (cons 0.30 (Float3 0.24 0.21 0.10))
        (cons 0.45 (Float3 0.35 0.30 0.26))  (cons 0.60 (Float3 0.85 0.85 0.88))))

(define (ramp-color height)
  (let next ([below (car ramp)] [rest (cdr ramp)])
    (cond
      [(null? rest) (cdr below)]
      [(>= height (caar rest)) (next (car rest) (cdr rest))]
      [else
       (define s (/ (- height (car below)) (- (caar rest) (car below))))
       (Float3-linear-interpolate (cdr below) (cdar rest) (max 0.0 s))])))

;; The globe has radius 1 around the origin of its own space, so a point is also a direction and
;; its y the sine of the latitude.
(define (land point u v)
  (define height (perlin-noise (Float3-scale-by-scalar point 1.9) #:octaves 8 #:seed 12))
  (define cold (+ (abs (Float3-y point)) (* 0.12 (perlin-noise (Float3-scale-by-scalar point 7) 4))))
  (if (> cold 0.9) (Float3 0.9 0.92 0.95) (ramp-color height)))

(define globe (Sphere (Float3 0 0 0) 1 #:material (Lambertian (FunctionTexture land))))

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
