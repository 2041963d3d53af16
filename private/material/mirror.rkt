#lang typed/racket/base
;; Mirror: perfectly smooth, reflects every ray to one direction, as polished silver.
;; color: linear RGB tint, the part of the light that is reflected, from 0 to 1, or a texture that
;; shows it; white by default.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../base/public.rkt" "material.rkt" "kernel.rkt" "scatter.rkt"
         "texture/texture.rkt" "texture/kernels.rkt")

(provide (struct-out Mirror) make-Mirror Mirror-kernel tinted-mirror-kernel)

(struct Mirror Material ([color : ColorOrTexture]) #:transparent)

;; (Mirror [color]).
(: make-Mirror (->* () (ColorOrTexture) Mirror))
(define (make-Mirror [color (make-Float3 1 1 1)])
  (Mirror (check-albedo-or-texture 'Mirror "color" color)))

(define-constructor Mirror make-Mirror (color))

(: Mirror-kernel (-> Mirror MaterialKernel))
(define (Mirror-kernel material) (tinted-mirror-kernel (Mirror-color material)))

;; Draws no pair.
(: tinted-mirror-kernel (-> ColorOrTexture MaterialKernel))
(define (tinted-mirror-kernel color)
  (define-values (constant place prepare) (albedo-source color))
  (specular-kernel
   #:prepare prepare
   (lambda ([r : FlVector] [i : FxVector])
     (let-facing-normal r (n out cosine)
       (put-specular! r (Float3-reflect out n) (Float3-in (or constant r) place))))))
