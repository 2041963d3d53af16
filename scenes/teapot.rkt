#lang racket/base
;; The Utah teapot in glazed white china, on a table between a copper and a glass one.
;; raco raytrace scenes/teapot.rkt -o teapot.png
(require raytrace)

(provide world camera settings)

(define china (teapot #:material (Plastic (Float3 0.86 0.85 0.8))))

;; Copies share the triangles and differ in place, size and material.
(define (copy material x z degrees scale)
  (Instance china
            (Transform-compose (Transform-translate x 0 z)
                               (Transform-rotate (Float3 0 1 0) #:degrees degrees)
                               (Transform-scale scale))
            #:material material))

(define table (Disk (Float3 0 0 0) (Float3 0 1 0) 30 (Lambertian (Float3 0.32 0.25 0.2))))
(define window (Quad (Float3 -9 4 3) (Float3 0 5 0) (Float3 4 0 6) (Emitter (Float3 11 10.5 9.5))))
(define lamp (Sphere (Float3 7 8 5) 1 (Emitter (Float3 22 17 11))))

(define world
  (World (list table window lamp
               (copy #f 0 0 20 1.0)
               (copy (copper 0.15) -4.2 -2.2 -35 0.8)
               (copy (Dielectric 1.5) 3.9 -1.4 60 0.7))
         '() (GradientSky (Float3 0.12 0.13 0.16) (Float3 0.3 0.36 0.46))))

(define camera
  (Camera-look-at (Float3 1.2 5.2 13) (Float3 0 1.25 -0.4) #:vertical-field-of-view-degrees 32))

(define settings (hash 'size '(960 540) 'samples 64 'integrator 'path))
