#lang typed/racket/base
;; A surface that shines. radiance: linear RGB, the same in every direction and however far away, or
;; a texture that shows it. A shape with this material is a light; it need not be listed among the
;; world's lights. Spheres, quads, disks, triangles, boxes and meshes are sampled, in groups and
;; instances too; those with a texture, other shapes, those that move and the parts of solids are
;; found by scattered rays alone: the same light, with more noise.
;; two-sided: whether the inside (or back) shines too. surface: the material that scatters the light
;; that falls on it, #f where none is reflected.
(require (for-syntax racket/base)
         "../base/float3.rkt" "../base/check.rkt" "../base/public.rkt" "material.rkt"
         "texture/texture.rkt")

(provide (struct-out Emitter) make-Emitter Emitter-constant-radiance)

(struct Emitter Material
  ([radiance : ColorOrTexture] [two-sided? : Boolean] [surface : (U #f Material)])
  #:transparent)

;; Emitter : raises exn:fail:contract where the radiance is no colour or the surface shines itself.
(: make-Emitter (->* (ColorOrTexture)
                     (Boolean (U #f Material) #:two-sided? Boolean #:surface (U #f Material))
                     Emitter))
(define (make-Emitter radiance [two-sided-by-place #f] [surface-by-place #f]
                      #:two-sided? [two-sided? two-sided-by-place]
                      #:surface [surface surface-by-place])
  (when (Emitter? surface)
    (raise-expected 'Emitter "#:surface" "a material that does not shine" surface))
  (Emitter (check-color-or-texture 'Emitter "radiance" radiance) two-sided? surface))

(define-constructor Emitter make-Emitter (radiance two-sided? surface))

;; The radiance where it is the same everywhere; black where a texture shows it.
(: Emitter-constant-radiance (-> Emitter Float3))
(define (Emitter-constant-radiance emitter)
  (define radiance (Emitter-radiance emitter))
  (if (Float3? radiance) radiance (make-Float3 0 0 0)))
