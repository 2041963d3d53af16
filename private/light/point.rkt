#lang typed/racket/base
;; A light that shines from one point in all directions.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../base/public.rkt" "../shape/triangle.rkt" "light.rkt")

(provide (struct-out PointLight) make-PointLight PointLight-kernel)

;; point: where it is. intensity: linear RGB radiant intensity; at distance d a surface facing it
;; receives irradiance intensity / d^2.
(struct PointLight Light ([point : Float3] [intensity : Float3]) #:transparent)

(: make-PointLight (-> Float3 Float3 PointLight))
(define (make-PointLight point intensity)
  (PointLight (check-point 'PointLight "point" point)
              (check-color 'PointLight "intensity" intensity)))

(define-constructor PointLight make-PointLight (point intensity))

(: PointLight-kernel (-> PointLight LightKernel))
(define (PointLight-kernel light)
  (define point (PointLight-point light))
  (define intensity (PointLight-intensity light))
  (LightKernel
   (lambda ([r : FlVector] [i : FxVector])
     (let-float3 ([to-light (Float3-subtract point (Float3-in r surface-point))])
       (let* ([squared (Float3-length-squared to-light)]
              [distance (flsqrt squared)])
         (cond
           [(fl> distance 0.0)
            (Float3-put! r light-direction (Float3-scale-by-scalar to-light (fl/ 1.0 distance)))
            (flvector-set! r light-distance distance)
            (Float3-put! r light-radiance (Float3-scale-by-scalar intensity (fl/ 1.0 squared)))]
           [else (Float3-put! r light-radiance (Float3 0.0 0.0 0.0))])
         (flvector-set! r light-density +inf.0))))
   (lambda ([r : FlVector] [i : FxVector]) (flvector-set! r light-density 0.0))
   #f
   -1
   (LightBound (points-bounds (list point)) (mean-component intensity) #f 0.0 0.0)))
