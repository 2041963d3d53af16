#lang racket/base
;; The white furnace: everything here returns all light that falls on it and is lit evenly from
;; everywhere with 1, so whatever can be seen in the picture is an error of the renderer.
;; raco raytrace scenes/furnace.rkt -o furnace.pfm
(require raytrace)

(provide world camera settings)

(define white (Float3 1 1 1))

(define rows
  (list (list (Lambertian white) (Mirror white) (Dielectric 1.5) (Dielectric 1.5 #:fresnel 'schlick))
        (for/list ([roughness '(0.05 0.2 0.5 1.0)]) (RoughConductor roughness #:color white))
        (for/list ([roughness '(0.05 0.2 0.5 1.0)]) (RoughDielectric 1.5 #:roughness roughness))))

(define world
  (World (for*/list ([(row y) (in-indexed rows)] [(material x) (in-indexed row)])
           (Sphere (Float3 (* 2.4 (- x 1.5)) (* -2.4 (- y 1)) 0) 1 #:material material))
         '()
         white))

(define camera (Camera-look-at (Float3 0 0 20) (Float3 0 0 0) #:vertical-field-of-view-degrees 24))

(define settings (hash 'size '(640 480) 'samples 64 'integrator 'path))
