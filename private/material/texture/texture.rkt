#lang typed/racket/base
;; The supertype of textures: colours that depend on where a surface is met. A Float3 is one that
;; does not. Each texture is a substruct in a file of its own, with its kernel.
(require "../../base/float3.rkt" "../../base/check.rkt")

(provide (struct-out Texture) ColorOrTexture TextureKernel
         check-color-or-texture check-albedo-or-texture)

(struct Texture () #:transparent)

(define-type ColorOrTexture (U Float3 Texture))

;; Reads texture-point, in the space the shape was made in, and surface-uv; writes surface-color.
;; It may leave anything in surface-roughness.
(define-type TextureKernel (-> FlVector FxVector Void))

(: check-color-or-texture (-> Symbol String ColorOrTexture ColorOrTexture))
(define (check-color-or-texture who argument value)
  (if (Float3? value) (check-color who argument value) value))

;; What a texture shows is clamped to what an albedo may be where it is used.
(: check-albedo-or-texture (-> Symbol String ColorOrTexture ColorOrTexture))
(define (check-albedo-or-texture who argument value)
  (if (Float3? value) (check-albedo who argument value) value))
