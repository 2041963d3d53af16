#lang typed/racket/base
;; Shapes of users' own: all that a new kind of shape has to say, in the library's public types.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/public.rkt"
         "../base/check.rkt" "../material/material.rkt" "kernel.rkt" "shape.rkt" "sphere.rkt")

(provide (struct-out CustomShape) make-CustomShape CustomShape-kernel Intersect TextureCoordinates)

;; Origin, direction and largest parameter of a ray; #f, or parameter and outward unit normal.
(define-type Intersect (-> Float3 Float3 Flonum (U #f (List Flonum Float3))))
;; Point and outward normal; u and v.
(define-type TextureCoordinates (-> Float3 Float3 (Values Flonum Flonum)))

;; low, high: corners of a box around the shape. intersect: its nearest hit with a ray. error: of
;; the hit point beyond the roundings of its parameter. uv: texture coordinates, or #f for those of
;; a sphere with the same normal. material: the surface.
(struct CustomShape Shape
  ([low : Float3] [high : Float3] [intersect : Intersect] [error : Flonum]
   [uv : (U #f TextureCoordinates)] [material : Material])
  #:transparent)

;; CustomShape : a shape by a procedure of its own, anywhere a shape can be.
;; low, high: no hit may be outside the box between these corners; coordinates may be infinite where
;; the shape goes on for ever. intersect: is called with a ray's origin, its direction, of any
;; length, and t-max, perhaps infinite. It returns #f, or a list of the least parameter t with
;; 0 < t < t-max at which origin + t direction is on the shape, and the outward unit normal there,
;; whichever side the ray comes from: that is how solids and glass know the inside. It must be a
;; pure function, as it runs in any order and more than once for a ray. A parameter outside that
;; range and NaN are no hit. #:error: how far a hit's point may be from the surface in world units,
;; beyond 32 roundings of the sizes of origin and point: a ray that leaves the surface starts so far
;; off it. #:uv: from point and normal to two texture coordinates.
(: make-CustomShape
   (->* (Float3 Float3 Intersect)
        (MaterialOrColor #:material MaterialOrColor #:error Real #:uv (U #f TextureCoordinates))
        CustomShape))
(define (make-CustomShape low high intersect [color (make-Float3 0.5 0.5 0.5)]
                          #:material [material color] #:error [error 0.0] #:uv [uv #f])
  (unless (and (fl<= (Float3-x low) (Float3-x high))
               (fl<= (Float3-y low) (Float3-y high))
               (fl<= (Float3-z low) (Float3-z high)))
    (raise-expected 'CustomShape "high" "three coordinates not less than those of low" high))
  (define bound (real->double-flonum error))
  (unless (and (fl>= bound 0.0) (fl< bound +inf.0))
    (raise-expected 'CustomShape "error" "a finite number of at least 0" error))
  (CustomShape low high intersect bound
               uv (->material material)))

(define-constructor CustomShape make-CustomShape (low high intersect error uv material))

(: CustomShape-kernel (-> CustomShape ShapeKernel))
(define (CustomShape-kernel shape)
  (define intersect (CustomShape-intersect shape))
  (define error (CustomShape-error shape))
  (define texture-coordinates (CustomShape-uv shape))

  ;; One rounding above the limit, where a hit at the limit itself may be wanted.
  (: nearest (-> FlVector FxVector Boolean))
  (define (nearest r i)
    (define hit (intersect (Float3-in r ray-origin) (Float3-in r ray-direction)
                           (fl* 1.0000000000000002 (flvector-ref r ray-limit))))
    (and hit
         (let ([t (car hit)])
           (and (closer? r i t)
                (begin (flvector-set! r hit-t t) #t)))))

  ;; Asks again for the normal: hits of other shapes may have been found since.
  (: surface (-> FlVector FxVector Void))
  (define (surface r i)
    (define hit (intersect (Float3-in r ray-origin) (Float3-in r ray-direction) +inf.0))
    (define given (and hit (cadr hit)))
    (let-float3 ([o (Float3-in r ray-origin)] [d (Float3-in r ray-direction)]
                 [normal (or given (Float3-negate d))]
                 [along (Float3-scale-by-scalar d (flvector-ref r hit-t))])
      (put-surface! r (Float3-add o along) (Float3-normalized normal)
                    (fl+ error
                         (fl* (fl* 32.0 (ROUNDING))
                              (fl+ (Float3-largest-magnitude o)
                                   (Float3-largest-magnitude along)))))))

  (: custom-uv (-> TextureCoordinates (-> FlVector FxVector Void)))
  (define ((custom-uv texture-coordinates) r i)
    (define-values (u v)
      (texture-coordinates (Float3-in r surface-point) (Float3-in r surface-normal)))
    (flvector-set! r surface-uv u)
    (flvector-set! r (fx+ surface-uv 1) v))

  (ShapeKernel
   (let-float3 ([lo (CustomShape-low shape)] [hi (CustomShape-high shape)])
     (flvector (Float3-x lo) (Float3-y lo) (Float3-z lo) (Float3-x hi) (Float3-y hi) (Float3-z hi)))
   nearest nearest surface
   (if texture-coordinates (custom-uv texture-coordinates) Sphere-uv!)
   0 0))
