#lang typed/racket/base
;; What the inside of the library needs of a shape: a bounding box and three kernels that read the
;; ray from a worker's scratch and write what they find there.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt")

(provide (struct-out ShapeKernel) closer? ROUNDING put-surface!)

;; bounds: low x y z, high x y z; infinite for a plane. nearest: looks for a hit with parameter in
;; (0, ray-limit), writes hit-t, hit-u, hit-v, and tells whether there was one. occluded: the same
;; without caring which hit or writing one. surface: from the hit to surface-point, -normal,
;; -shading-normal and -error. uv: from the surface to surface-uv; a shape that puts another one
;; into a place of its own leaves the point in that one's space in texture-point. nesting: levels of instances
;; and hierarchies entered below this shape; stack: traversal places they need.
(struct ShapeKernel
  ([bounds : FlVector]
   [nearest : (-> FlVector FxVector Boolean)]
   [occluded : (-> FlVector FxVector Boolean)]
   [surface : (-> FlVector FxVector Void)]
   [uv : (-> FlVector FxVector Void)]
   [nesting : Fixnum]
   [stack : Fixnum]))

;; Unit roundoff of doubles, 2^-53.
(define-syntax-rule (ROUNDING) 1.1102230246251565e-16)

;; Whether a hit at t replaces the one known so far; ties go where `accept-ties` says, so that the
;; lowest primitive wins whatever order the hierarchy visits them in.
(define-syntax-rule (closer? r i t)
  (let ([limit (flvector-ref r ray-limit)])
    (and (fl> t 0.0)
         (or (fl< t limit)
             (and (fl= t limit) (fx= 1 (fxvector-ref i accept-ties)))))))

;; Writes a surface whose shading normal is its geometric normal.
(define-syntax-rule (put-surface! r point normal error)
  (let-float3 ([n normal])
    (Float3-put! r surface-point point)
    (Float3-put! r surface-normal n)
    (Float3-put! r surface-shading-normal n)
    (flvector-set! r surface-error error)))
