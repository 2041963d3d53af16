#lang typed/racket/base
;; The kernel and the material of any shape: the one place that lists them all.
(require "shape.rkt" "kernel.rkt" "sphere.rkt" "cylinder.rkt" "cone.rkt" "torus.rkt"
         "plane.rkt" "disk.rkt" "quad.rkt" "triangle.rkt" "box.rkt" "mesh.rkt"
         "composite.rkt" "instance.rkt" "moving.rkt" "group.rkt" "solid.rkt"
         "distance.rkt" "custom.rkt"
         "../material/material.rkt" "../base/check.rkt" "../base/float3.rkt")

(provide Shape-kernel Shape-compiler Shape-material Shape-moves?)

;; The kernel of a shape by itself.
(: Shape-kernel (-> Shape ShapeKernel))
(define (Shape-kernel shape) ((Shape-compiler (lambda (material) -1)) shape))

;; A procedure from shapes to their kernels, each made once however often it is a part of others.
;; number: the index by which the parts of a composite name their materials.
(: Shape-compiler (-> NumberMaterial CompileShape))
(define (Shape-compiler number)
  (define known : (HashTable Shape ShapeKernel) (make-hasheq))
  (: compile CompileShape)
  (define (compile shape)
    (or (hash-ref known shape (lambda () #f))
        (let ([kernel (new-kernel shape compile number)])
          (hash-set! known shape kernel)
          kernel)))
  compile)

(: new-kernel (-> Shape CompileShape NumberMaterial ShapeKernel))
(define (new-kernel shape compile number)
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
    [(Instance? shape) (Instance-kernel shape compile number)]
    [(Moving? shape) (Moving-kernel shape compile)]
    [(Group? shape) (Group-kernel shape compile number Shape-material)]
    [(Solid? shape) (Solid-kernel shape compile number Shape-material)]
    [(DistanceShape? shape) (DistanceShape-kernel shape)]
    [(CustomShape? shape) (CustomShape-kernel shape)]
    [else (raise-expected 'World "shapes" "shapes of this library" shape)]))

;; The material of a shape; of a composite, that of its first part.
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
    [(Instance? shape) (or (Instance-material shape) (Shape-material (Instance-shape shape)))]
    [(Moving? shape) (Shape-material (Moving-shape shape))]
    [(Group? shape)
     (if (pair? (Group-shapes shape))
         (Shape-material (car (Group-shapes shape)))
         (->material (make-Float3 0.5 0.5 0.5)))]
    [(Solid? shape) (or (Solid-material shape) (Shape-material (Solid-a shape)))]
    [(DistanceShape? shape) (DistanceShape-material shape)]
    [(CustomShape? shape) (CustomShape-material shape)]
    [else (raise-expected 'World "shapes" "shapes of this library" shape)]))

;; Whether a shape or a part of it moves while the shutter is open.
(: Shape-moves? (-> Shape Boolean))
(define (Shape-moves? shape)
  (cond
    [(not (Composite? shape)) #f]
    [(Instance? shape) (Shape-moves? (Instance-shape shape))]
    [(Group? shape) (ormap Shape-moves? (Group-shapes shape))]
    [(Solid? shape) (or (Shape-moves? (Solid-a shape)) (Shape-moves? (Solid-b shape)))]
    [else (Moving? shape)]))
