#lang typed/racket/base
;; A surface that shines. radiance: linear RGB, the same in every direction and however far away.
;; A shape with this material is a light; it need not be listed among the world's lights. Spheres,
;; quads, disks, triangles, boxes and meshes are sampled, in groups and instances too; other shapes,
;; those that move and the parts of solids are found by scattered rays alone: the same light, with
;; more noise.
;; two-sided: whether the inside (or back) shines too. surface: the material that scatters the light
;; that falls on it, #f where none is reflected.
(require (for-syntax racket/base)
         "../base/float3.rkt" "../base/check.rkt" "../base/public.rkt" "material.rkt")

(provide (struct-out Emitter) make-Emitter)

(struct Emitter Material ([radiance : Float3] [two-sided? : Boolean] [surface : (U #f Material)])
  #:transparent)

;; Emitter : raises exn:fail:contract where the radiance is no colour or the surface shines itself.
(: make-Emitter (->* (Float3)
                     (Boolean (U #f Material) #:two-sided? Boolean #:surface (U #f Material))
                     Emitter))
(define (make-Emitter radiance [two-sided-by-place #f] [surface-by-place #f]
                      #:two-sided? [two-sided? two-sided-by-place]
                      #:surface [surface surface-by-place])
  (when (Emitter? surface)
    (raise-expected 'Emitter "#:surface" "a material that does not shine" surface))
  (Emitter (check-color 'Emitter "radiance" radiance) two-sided? surface))

(define-constructor Emitter make-Emitter (radiance two-sided? surface))
