#lang typed/racket/base
;; The kernel of any light and of any shape that shines: the one place that lists them all.
(require "../shape/shape.rkt" "../shape/sphere.rkt" "../base/float3.rkt"
         "../material/material.rkt" "../material/emitter.rkt" "../base/check.rkt"
         "../shape/quad.rkt" "../shape/disk.rkt" "../shape/triangle.rkt" "../shape/box.rkt"
         "../shape/mesh.rkt"
         "light.rkt" "distant.rkt" "point.rkt" "spot.rkt" "sphere.rkt" "quad.rkt" "planar.rkt"
         "box.rkt" "mesh.rkt")

(provide Light-kernel Shape-light-kernel)

(: Light-kernel (-> Light LightKernel))
(define (Light-kernel light)
  (cond
    [(DistantLight? light) (DistantLight-kernel light)]
    [(PointLight? light) (PointLight-kernel light)]
    [(SpotLight? light) (SpotLight-kernel light)]
    [else (raise-expected 'World "lights" "lights of this library" light)]))

;; The light that a shape with an emitting material is; #f where it does not shine, or has no way to
;; The light that a shape with an emitting material is; #f where it does not shine, or has no way to
;; be sampled and only scattered rays find it (composites: see parts.rkt), as one with a texture.
;; primitive: its index in the world, which does not shadow itself, or -1.
(: Shape-light-kernel (-> Shape Material Fixnum (U #f LightKernel)))
(define (Shape-light-kernel shape emitter primitive)
  (cond
    [(not (and (Emitter? emitter) (Float3? (Emitter-radiance emitter)))) #f]
    [(Sphere? shape) (Sphere-light-kernel shape emitter primitive)]
    [(Quad? shape) (Quad-light-kernel shape emitter primitive)]
    [(Disk? shape) (Disk-light-kernel shape emitter primitive)]
    [(Triangle? shape) (Triangle-light-kernel shape emitter primitive)]
    [(Box? shape) (Box-light-kernel shape emitter primitive)]
    [(Mesh? shape) (Mesh-light-kernel shape emitter)]
    [else #f]))
