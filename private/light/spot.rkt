#lang typed/racket/base
;; A light that shines from one point into a cone.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../base/public.rkt" "../sample/warp.rkt" "../shape/triangle.rkt" "light.rkt")

(provide (struct-out SpotLight) make-SpotLight SpotLight-kernel)

;; point: where it is. direction: where it shines, unit. intensity: linear RGB radiant intensity
;; along the axis. Up to falloff-angle from the axis, in radians, it is all there; from there to
;; cone-angle it falls to 0 as the smoothstep of the cosine.
(struct SpotLight Light
  ([point : Float3] [direction : Float3] [intensity : Float3]
   [cone-angle : Flonum] [falloff-angle : Flonum])
  #:transparent)

;; SpotLight : direction of any length but 0; intensity linear RGB, at least 0: at distance d along
;; the axis a surface facing the light receives irradiance intensity / d^2. cone-angle: half the
;; opening of the cone in radians, above 0 and at most pi. falloff-angle: from 0 to cone-angle,
;; which gives a sharp edge. Raises exn:fail:contract for other values.
(: make-SpotLight (-> Float3 Float3 Float3 Real Real SpotLight))
(define (make-SpotLight point direction intensity cone-angle falloff-angle)
  (define cone (check-positive 'SpotLight "cone-angle" cone-angle))
  (check-between 'SpotLight "cone-angle" cone-angle 0.0 (PI))
  (SpotLight (check-point 'SpotLight "point" point)
             (Float3-normalized/checked (check-direction 'SpotLight "direction" direction))
             (check-color 'SpotLight "intensity" intensity)
             cone
             (check-between 'SpotLight "falloff-angle" falloff-angle 0.0 cone)))

(define-constructor SpotLight make-SpotLight
  (point direction intensity cone-angle falloff-angle))

(: SpotLight-kernel (-> SpotLight LightKernel))
(define (SpotLight-kernel light)
  (define point (SpotLight-point light))
  (define direction (SpotLight-direction light))
  (define intensity (SpotLight-intensity light))
  (define cone-cosine (flcos (SpotLight-cone-angle light)))
  (define falloff-cosine (flcos (SpotLight-falloff-angle light)))
  (LightKernel
   (lambda ([r : FlVector] [i : FxVector])
     (let-float3 ([to-light (Float3-subtract point (Float3-in r surface-point))])
       (let* ([squared (Float3-length-squared to-light)]
              [distance (flsqrt squared)]
              [cosine (fl/ (fl* -1.0 (Float3-dot to-light direction)) distance)])
         (cond
           [(and (fl> distance 0.0) (fl> cosine cone-cosine))
            (let* ([part (if (fl>= cosine falloff-cosine)
                             1.0
                             (fl/ (fl- cosine cone-cosine) (fl- falloff-cosine cone-cosine)))]
                   [share (fl* (fl* part part) (fl- 3.0 (fl* 2.0 part)))])
              (Float3-put! r light-direction (Float3-scale-by-scalar to-light (fl/ 1.0 distance)))
              (flvector-set! r light-distance distance)
              (Float3-put! r light-radiance
                           (Float3-scale-by-scalar intensity (fl/ share squared))))]
           [else (Float3-put! r light-radiance (Float3 0.0 0.0 0.0))])
         (flvector-set! r light-density +inf.0))))
   (lambda ([r : FlVector] [i : FxVector]) (flvector-set! r light-density 0.0))
   #f
   -1
   (SpotLight-bound light)))

;; Beyond a right angle the cosine is no bound any more.
(: SpotLight-bound (-> SpotLight LightBound))
(define (SpotLight-bound light)
  (define cone (SpotLight-cone-angle light))
  (define falloff (SpotLight-falloff-angle light))
  (define narrow? (fl<= cone (fl* 0.5 (PI))))
  (LightBound (points-bounds (list (SpotLight-point light)))
              (mean-component (SpotLight-intensity light))
              (and narrow? (SpotLight-direction light)) falloff (fl- cone falloff)))
