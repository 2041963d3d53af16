#lang typed/racket/base
;; Right circular cones of any axis, closed by a cap at the base or open.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/public.rkt"
         "../base/check.rkt" "../base/roots.rkt" "../material/material.rkt"
         "kernel.rkt" "shape.rkt" "cylinder.rkt")

(provide (struct-out Cone) make-Cone Cone-kernel Cone-bounds)

;; base: the centre of the base. radius: the base's, positive. apex: the tip. material: the
;; surface. caps?: whether the base is closed; an open cone is seen from both sides.
(struct Cone Shape
  ([base : Float3] [radius : Flonum] [apex : Float3] [material : Material] [caps? : Boolean])
  #:transparent)

(: make-Cone (->* (Float3 Real Float3)
                  (MaterialOrColor #:material MaterialOrColor #:caps? Boolean)
                  Cone))
(define (make-Cone base radius apex [color (make-Float3 0.5 0.5 0.5)]
                   #:material [material color] #:caps? [caps? #t])
  (check-point 'Cone "base" base)
  (check-point 'Cone "apex" apex)
  (when (fl= 0.0 (Float3-distance base apex))
    (raise-expected 'Cone "apex" "a point other than the base" apex))
  (Cone base (check-positive 'Cone "radius" radius) apex (->material material) caps?))

(define-constructor Cone make-Cone (base radius apex material caps?))

(define-syntax-rule (BASE-CAP) 1.0)

(: Cone-kernel (-> Cone ShapeKernel))
(define (Cone-kernel cone)
  (define base (Cone-base cone))
  (define apex (Cone-apex cone))
  (define radius (Cone-radius cone))
  (define caps? (Cone-caps? cone))
  ;; local z runs from the apex to the base; the side is x^2 + y^2 = (spread z)^2
  (define frame (axial-frame apex (Float3-subtract base apex)))
  (define height (Float3-distance base apex))
  (define slant (Float3-length (make-Float3 radius height 0.0)))
  (define spread (fl/ radius height))
  (define sine (fl/ radius slant))
  (define cosine (fl/ height slant))
  (define far-squared (fl* 2.0 (fl* slant slant)))
  (define error-bound
    (fl* (fl* 16.0 (ROUNDING)) (fl+ (fl+ radius height) (Float3-largest-magnitude apex))))

  ;; From outside the ball around the cone the ray first moves to its point nearest to the apex,
  ;; where the coefficients keep their digits. The discriminant b^2 - a c is, multiplied out, a
  ;; difference of two squares: spread^2 |dz o - oz d|^2 - (ox dy - oy dx)^2.
  (: nearest (-> FlVector FxVector Boolean))
  (define (nearest r i)
    (let-float3 ([d (Float3-in r ray-direction)]
                 [start (Float3-subtract (Float3-in r ray-origin) (Float3-in frame 0))])
      (let* ([shift (axial-shift start d far-squared)])
        (let-float3 ([o (Float3-multiply-add start shift d)])
          (let* ([dx (local-x frame d)] [dy (local-y frame d)] [dz (local-z frame d)]
                 [ox (local-x frame o)] [oy (local-y frame o)] [oz (local-z frame o)]
                 [mx (fl* spread (fl- (fl* dz ox) (fl* oz dx)))]
                 [my (fl* spread (fl- (fl* dz oy) (fl* oz dy)))]
                 [k (fl- (fl* ox dy) (fl* oy dx))]
                 [discriminant (fl- (fl+ (fl* mx mx) (fl* my my)) (fl* k k))]
                 [mz (fl* spread dz)]
                 [a (fl- (fl+ (fl* dx dx) (fl* dy dy)) (fl* mz mz))]
                 ;; a ray steeper than the side meets both nappes, whatever rounding says
                 [steep? (fl<= a 0.0)])
            (and
             (or steep? (fl>= discriminant 0.0))
             (let-slab (enter leave) (oz dz 0.0 height)
               (let* ([distance (flsqrt (fl+ (fl* ox ox) (fl* oy oy)))]
                      [m (fl* spread oz)]
                      [c (fl* (fl- distance m) (fl+ distance m))]
                      [b (fl- (fl+ (fl* ox dx) (fl* oy dy)) (fl* m mz))]
                      [signed-a (if steep? (fl* -1.0 (flabs a)) a)])
                 (let-roots-of-discriminant (low high) (signed-a b c (flmax 0.0 discriminant))
                   ;; inside one nappe: between the roots, or beyond one of them
                   (let* ([from (if steep? (if (fl> dz 0.0) high -inf.0) low)]
                          [to (if steep? (if (fl> dz 0.0) +inf.0 low) high)])
                     (put-axial-hit! r i caps? (from to) (enter leave) shift
                                     (BASE-CAP) (BASE-CAP)))))
               #f)))))))

  (: surface (-> FlVector FxVector Void))
  (define (surface r i)
    (let-float3 ([p (Float3-subtract (Float3-multiply-add (Float3-in r ray-origin)
                                                          (flvector-ref r hit-t)
                                                          (Float3-in r ray-direction))
                                     (Float3-in frame 0))]
                 [axis (Float3-in frame 9)])
      (let* ([side? (fl= (flvector-ref r hit-u) (SIDE))]
             [z (Float3-dot p axis)])
        (let-float3 ([across (Float3-multiply-add p (fl* -1.0 z) axis)])
          (let* ([distance (Float3-length across)]
                 ;; at the very tip the normal points out along the axis
                 [inverse-distance (if (fl> distance 0.0) (fl/ 1.0 distance) 0.0)]
                 [along-slant (flmax 0.0 (flmin slant (fl+ (fl* distance sine) (fl* z cosine))))]
                 [point-across (if side?
                                   (fl* along-slant (fl* sine inverse-distance))
                                   (if (fl> distance radius) (fl/ radius distance) 1.0))]
                 [point-along (if side? (fl* along-slant cosine) (fl* 1.0 height))]
                 [normal-across (if side? (fl* cosine inverse-distance) 0.0)]
                 [normal-along (if (and side? (fl> distance 0.0)) (fl* -1.0 sine)
                                   (if side? -1.0 1.0))])
            (let-float3 ([point (Float3-add (Float3-in frame 0)
                                            (Float3-multiply-add
                                             (Float3-scale-by-scalar across point-across)
                                             point-along axis))]
                         [normal (Float3-multiply-add
                                  (Float3-scale-by-scalar across normal-across)
                                  normal-along axis)])
              (put-surface! r point normal error-bound)))))))

  ;; u around the axis; v from base to apex, on the cap from the centre out.
  (: uv (-> FlVector FxVector Void))
  (define (uv r i)
    (let-float3 ([p (Float3-subtract (Float3-in r surface-point) (Float3-in frame 0))])
      (let* ([x (local-x frame p)] [y (local-y frame p)])
        ;; local z points to the base, the angle is seen from the apex
        (flvector-set! r surface-uv (axial-angle x (fl* -1.0 y)))
        (flvector-set! r (fx+ surface-uv 1)
                       (flmin 1.0
                              (if (fl= (flvector-ref r hit-u) (SIDE))
                                  (flmax 0.0 (fl- 1.0 (fl/ (local-z frame p) height)))
                                  (fl/ (flsqrt (fl+ (fl* x x) (fl* y y))) radius)))))))

  (ShapeKernel (Cone-bounds cone) nearest nearest surface uv 0 0))

;; The box of the base disk and the apex.
(: Cone-bounds (-> Cone FlVector))
(define (Cone-bounds cone)
  (define base (Cone-base cone))
  (define apex (Cone-apex cone))
  (box-around base (Cone-radius cone) apex 0.0
              (Float3-normalized/checked (Float3-subtract apex base))))
