#lang typed/racket/base
;; The kernel of any light and of any shape that shines: the one place that lists them all.
(require "../shape/shape.rkt" "../shape/sphere.rkt" "../shape/kernels.rkt"
         "../material/emitter.rkt" "../base/check.rkt"
         "../shape/quad.rkt" "../shape/disk.rkt" "../shape/triangle.rkt"
         "light.rkt" "distant.rkt" "point.rkt" "sphere.rkt" "quad.rkt" "planar.rkt")

(provide Light-kernel Shape-light-kernel)

(: Light-kernel (-> Light LightKernel))
(define (Light-kernel light)
  (cond
    [(DistantLight? light) (DistantLight-kernel light)]
    [(PointLight? light) (PointLight-kernel light)]
    [else (raise-expected 'World "lights" "lights of this library" light)]))

;; shape: one whose material is an Emitter; primitive: its index in the world.
(: Shape-light-kernel (-> Shape Fixnum LightKernel))
(define (Shape-light-kernel shape primitive)
  (define emitter (Shape-material shape))
  (cond
    [(not (Emitter? emitter)) (raise-expected 'World "lights" "a shape that shines" shape)]
    [(Sphere? shape) (Sphere-light-kernel shape emitter primitive)]
    [(Quad? shape) (Quad-light-kernel shape emitter primitive)]
    [(Disk? shape) (Disk-light-kernel shape emitter primitive)]
    [(Triangle? shape) (Triangle-light-kernel shape emitter primitive)]
    [else (raise-expected 'World "shapes" "a shape that can be a light" shape)]))
