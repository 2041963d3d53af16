#lang typed/racket/base
;; The kernel and the material of any shape: the one place that lists them all.
(require "shape.rkt" "kernel.rkt" "sphere.rkt" "../material/material.rkt" "../base/check.rkt")

(provide Shape-kernel Shape-material)

(: Shape-kernel (-> Shape ShapeKernel))
(define (Shape-kernel shape)
  (cond
    [(Sphere? shape) (Sphere-kernel shape)]
    [else (raise-expected 'World "shapes" "shapes of this library" shape)]))

(: Shape-material (-> Shape Material))
(define (Shape-material shape)
  (cond
    [(Sphere? shape) (Sphere-material shape)]
    [else (raise-expected 'World "shapes" "shapes of this library" shape)]))
