#lang racket/base
;; The cover of Ray Tracing in One Weekend (Shirley, Black, Hollasch): 487 spheres under the sky.
;; raco raytrace scenes/weekend.rkt -o weekend.png
(require raytrace racket/runtime-path racket/string)

(provide world camera settings)

;; One sphere a line: centre, radius, then `diffuse r g b`, `metal r g b fuzz` or `glass ior`.
(define-runtime-path spheres-file "weekend.txt")

(define (line->sphere line)
  (define words (string-split line))
  (define (number k) (string->number (list-ref words k)))
  (define (color k) (Float3 (number k) (number (+ k 1)) (number (+ k 2))))
  (Sphere (color 0) (number 3)
          #:material (case (list-ref words 4)
                       [("diffuse") (Lambertian (color 5))]
                       [("metal") (Metal (color 5) (number 8))]
                       [else (Dielectric (number 5) #:fresnel 'schlick)])))

(define world
  (World (call-with-input-file spheres-file
           (lambda (in) (for/list ([line (in-lines in)]) (line->sphere line))))
         '()
         (GradientSky (Float3 1 1 1) (Float3 0.5 0.7 1))))

(define camera
  (Camera-look-at (Float3 13 2 3) (Float3 0 0 0)
                  #:vertical-field-of-view-degrees 20
                  #:focus-distance 10 #:lens-radius 0.052360356057001275))

(define settings (hash 'size '(1200 675) 'samples 64))
