#lang racket/base
;; All around at once: the picture a panoramic camera takes amid a ring of columns.
;; raco raytrace scenes/lens-panorama.rkt -o lens-panorama.png
(require racket/math raytrace)

(provide world camera settings)

(define floor (Disk (Float3 0 0 0) (Float3 0 1 0) 60 (Lambertian (Float3 0.5 0.45 0.4))))

(define columns
  (for/list ([k 12])
    (define angle (* 2 pi (/ k 12)))
    (define-values (x z) (values (* 5 (sin angle)) (* -5 (cos angle))))
    (Cylinder (Float3 x 0 z) (Float3 x 3.2 z) 0.4
              (Lambertian (Float3 (+ 0.5 (* 0.4 (sin angle))) 0.5 (+ 0.5 (* 0.4 (cos angle))))))))

(define ring (Torus (Float3 0 3.4 0) (Float3 0 1 0) 5 0.35 (Lambertian (Float3 0.7 0.68 0.62))))
(define pool (Disk (Float3 0 0.01 0) (Float3 0 1 0) 3 (Mirror (Float3 0.6 0.65 0.7))))

(define world
  (World (list* floor pool ring columns)
         (DistantLight (Float3 2 3 1) (Float3 2.2 2.0 1.7))
         (GradientSky (Float3 0.8 0.85 0.9) (Float3 0.25 0.45 0.85))))

(define camera (Camera-panoramic (Float3 0 1.6 0) (Float3 0 1.6 -1)))

(define settings (hash 'size '(960 480) 'samples 64 'integrator 'path))
