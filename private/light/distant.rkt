#lang typed/racket/base
;; A light so far away that its direction is the same everywhere: the sun without its disk.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../base/public.rkt" "light.rkt")

(provide (struct-out DistantLight) make-DistantLight DistantLight-kernel)

;; direction: towards the light, any length. color: linear RGB irradiance on a surface facing it.
(struct DistantLight Light ([direction : Float3] [color : Float3]) #:transparent)

(: make-DistantLight (-> Float3 Float3 DistantLight))
(define (make-DistantLight direction color)
  (DistantLight (Float3-normalized/checked (check-direction 'DistantLight "direction" direction))
                (check-color 'DistantLight "color" color)))

(define-constructor DistantLight make-DistantLight (direction color))

(: DistantLight-kernel (-> DistantLight LightKernel))
(define (DistantLight-kernel light)
  (define direction (DistantLight-direction light))
  (define color (DistantLight-color light))
  (LightKernel
   (lambda ([r : FlVector] [i : FxVector])
     (Float3-put! r light-direction direction)
     (flvector-set! r light-distance +inf.0)
     (Float3-put! r light-radiance color)
     (flvector-set! r light-density +inf.0))
   (lambda ([r : FlVector] [i : FxVector]) (flvector-set! r light-density 0.0))
   #f
   -1
   (LightBound #f (mean-component color) direction 0.0 0.0)))
