#lang typed/racket/base
;; A surface that shines. radiance: linear RGB, the same in every direction and however far away.
;; A shape with this material is a light; it need not be listed among the world's lights.
;; two-sided: whether the inside (or back) shines too.
(require (for-syntax racket/base)
         "../base/float3.rkt" "../base/check.rkt" "../base/public.rkt" "material.rkt")

(provide (struct-out Emitter) make-Emitter)

(struct Emitter Material ([radiance : Float3] [two-sided? : Boolean]) #:transparent)

(: make-Emitter (->* (Float3) (Boolean #:two-sided? Boolean) Emitter))
(define (make-Emitter radiance [two-sided-by-place #f] #:two-sided? [two-sided? two-sided-by-place])
  (Emitter (check-color 'Emitter "radiance" radiance) two-sided?))

(define-constructor Emitter make-Emitter (radiance two-sided?))
