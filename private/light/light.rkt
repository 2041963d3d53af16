#lang typed/racket/base
;; The supertype of lights that are not shapes, and what the inside needs of any light.
(require "../base/unsafe.rkt" "../base/float3.rkt")

(provide (struct-out Light) (struct-out LightKernel) (struct-out LightBound)
         flat-bound round-bound mean-component)

(struct Light () #:transparent)

;; sample: seen from surface-point with the pair in sample-u and sample-v, writes light-direction
;; (unit), light-distance, light-radiance (already divided by the density) and light-density (per
;; solid angle, infinite for a light no scattered ray can hit); radiance 0 where nothing arrives.
;; density: the density with which sample would choose in-direction, into light-density; the hit
;; that a ray in that direction finds on the light is in the scratch.
;; primitive: the primitive that is this light and does not shadow itself, or -1.
;; bound: what a choice among lights goes by.
(struct LightKernel
  ([sample : (-> FlVector FxVector Void)]
   [density : (-> FlVector FxVector Void)]
   [area? : Boolean]
   [primitive : Fixnum]
   [bound : LightBound]))

;; box: low x y z and high x y z of where the light is, or #f for one infinitely far away.
;; intensity: at most what the light sends in any direction, mean of the colours: radiance times
;; projected area; of a light without a box the irradiance. axis: within the angle `spread` of it
;; lie the directions of full intensity, which then falls like the cosine of the angle to the
;; nearest of them and is 0 beyond `reach`; #f where the intensity is much the same in all
;; directions. Of a light without a box: the unit direction towards it, #f for all directions.
(struct LightBound
  ([box : (U #f FlVector)] [intensity : Flonum] [axis : (U #f Float3)]
   [spread : Flonum] [reach : Flonum]))

(define-syntax-rule (HALF-PI) 1.5707963267948966)

;; Of a light that shines to the side of its normals, which are within the angle `spread` of one,
;; or to both sides.
(: flat-bound (-> FlVector Float3 Flonum Float3 Flonum Boolean LightBound))
(define (flat-bound box radiance area normal spread two-sided?)
  (LightBound box (fl* area (mean-component radiance)) (if two-sided? #f normal) spread (HALF-PI)))

;; Of a closed light with that surface: a convex body's projections have a quarter of its area on
;; average (Cauchy 1832).
(: round-bound (-> FlVector Float3 Flonum LightBound))
(define (round-bound box radiance area)
  (LightBound box (fl* (fl* 0.25 area) (mean-component radiance)) #f 0.0 0.0))

(: mean-component (-> Float3 Flonum))
(define (mean-component color)
  (fl/ (fl+ (fl+ (Float3-x color) (Float3-y color)) (Float3-z color)) 3.0))
