#lang typed/racket/base
;; The kernel and the material of any shape: the one place that lists them all.
(require "shape.rkt" "kernel.rkt" "sphere.rkt" "cylinder.rkt" "cone.rkt" "torus.rkt"
         "plane.rkt" "disk.rkt" "quad.rkt" "triangle.rkt" "box.rkt" "mesh.rkt"
         "../material/material.rkt" "../base/check.rkt")

(provide Shape-kernel Shape-material)

(: Shape-kernel (-> Shape ShapeKernel))
(define (Shape-kernel shape)
  (cond
    [(Sphere? shape) (Sphere-kernel shape)]
    [(Plane? shape) (Plane-kernel shape)]
    [(Disk? shape) (Disk-kernel shape)]
    [(Quad? shape) (Quad-kernel shape)]
    [(Triangle? shape) (Triangle-kernel shape)]
    [(Box? shape) (Box-kernel shape)]
    [(Cylinder? shape) (Cylinder-kernel shape)]
    [(Cone? shape) (Cone-kernel shape)]
    [(Torus? shape) (Torus-kernel shape)]
    [(Mesh? shape) (Mesh-kernel shape)]
    [else (raise-expected 'World "shapes" "shapes of this library" shape)]))

(: Shape-material (-> Shape Material))
(define (Shape-material shape)
  (cond
    [(Sphere? shape) (Sphere-material shape)]
    [(Plane? shape) (Plane-material shape)]
    [(Disk? shape) (Disk-material shape)]
    [(Quad? shape) (Quad-material shape)]
    [(Triangle? shape) (Triangle-material shape)]
    [(Box? shape) (Box-material shape)]
    [(Cylinder? shape) (Cylinder-material shape)]
    [(Cone? shape) (Cone-material shape)]
    [(Torus? shape) (Torus-material shape)]
    [(Mesh? shape) (Mesh-material shape)]
    [else (raise-expected 'World "shapes" "shapes of this library" shape)]))
