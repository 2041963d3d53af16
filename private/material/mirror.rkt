#lang typed/racket/base
;; Mirror: perfectly smooth, reflects every ray to one direction, as polished silver.
;; color: linear RGB tint, the part of the light that is reflected, from 0 to 1; white by default.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../base/public.rkt" "material.rkt" "kernel.rkt" "scatter.rkt")

(provide (struct-out Mirror) make-Mirror Mirror-kernel tinted-mirror-kernel)

(struct Mirror Material ([color : Float3]) #:transparent)

;; (Mirror [color]).
(: make-Mirror (->* () (Float3) Mirror))
(define (make-Mirror [color (make-Float3 1 1 1)])
  (Mirror (check-albedo 'Mirror "color" color)))

(define-constructor Mirror make-Mirror (color))

(: Mirror-kernel (-> Mirror MaterialKernel))
(define (Mirror-kernel material) (tinted-mirror-kernel (Mirror-color material)))

;; Draws no pair.
(: tinted-mirror-kernel (-> Float3 MaterialKernel))
(define (tinted-mirror-kernel color)
  (specular-kernel
   (lambda ([r : FlVector] [i : FxVector])
     (let-facing-normal r (n out cosine)
       (put-specular! r (Float3-reflect out n) color)))))
