#lang typed/racket/base
;; Infinite planes, and the intersection that planes and disks share.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/public.rkt"
         "../base/check.rkt" "../base/frame.rkt" "../material/material.rkt" "kernel.rkt" "shape.rkt")

(provide (struct-out Plane) make-Plane Plane-kernel plane-parameter plane-offset)

;; point: any point of the plane. normal: the side that is outside; kept as a unit vector.
;; material: the surface.
(struct Plane Shape ([point : Float3] [normal : Float3] [material : Material]) #:transparent)

(: make-Plane (->* (Float3 Float3) (MaterialOrColor #:material MaterialOrColor) Plane))
(define (make-Plane point normal [color (make-Float3 0.5 0.5 0.5)] #:material [material color])
  (Plane (check-point 'Plane "point" point)
         (Float3-normalized/checked (check-direction 'Plane "normal" normal))
         (->material material)))

(define-constructor Plane make-Plane (point normal material))

;; The parameter at which o + t d crosses the plane; infinite or NaN for a ray along it.
(define-syntax-rule (plane-parameter o d point normal)
  (fl/ (Float3-dot normal (Float3-subtract point o)) (Float3-dot normal d)))

;; From the plane's point to the hit in the scratch, brought back into the plane: what t or a far
;; origin left as an error along the normal is taken out.
(define-float3-operation
  (plane-offset [(ox oy oz) : Float3] [t : Flonum] [(dx dy dz) : Float3]
                [(px py pz) : Float3] [(nx ny nz) : Float3])
  #:let ([x (fl- (fl+ ox (fl* t dx)) px)]
         [y (fl- (fl+ oy (fl* t dy)) py)]
         [z (fl- (fl+ oz (fl* t dz)) pz)]
         [height (fl+ (fl+ (fl* x nx) (fl* y ny)) (fl* z nz))])
  : Float3 ((fl- x (fl* height nx)) (fl- y (fl* height ny)) (fl- z (fl* height nz))))

;; The error of a hit grows with its distance from the plane's point, by which the plane is known.
(: Plane-kernel (-> Plane ShapeKernel))
(define (Plane-kernel plane)
  (define point (Plane-point plane))
  (define normal (Plane-normal plane))
  (define size (Float3-largest-magnitude point))
  (: nearest (-> FlVector FxVector Boolean))
  (define (nearest r i)
    (let-float3 ([o (Float3-in r ray-origin)] [d (Float3-in r ray-direction)]
                 [p point] [n normal])
      (let ([t (plane-parameter o d p n)])
        (and (closer? r i t)
             (begin (flvector-set! r hit-t t) #t)))))
  (: surface (-> FlVector FxVector Void))
  (define (surface r i)
    (let-float3 ([p point] [n normal]
                 [offset (plane-offset (Float3-in r ray-origin) (flvector-ref r hit-t)
                                       (Float3-in r ray-direction) p n)])
      (put-surface! r (Float3-add p offset) n
                    (fl* (fl* 32.0 (ROUNDING)) (fl+ size (Float3-largest-magnitude offset))))))
  ;; In world units from the plane's point, along a frame around the normal.
  (: uv (-> FlVector FxVector Void))
  (define (uv r i)
    (let-float3 ([n normal] [offset (Float3-subtract (Float3-in r surface-point) point)])
      (let-frame (tangent bitangent) n
        (flvector-set! r surface-uv (Float3-dot offset tangent))
        (flvector-set! r (fx+ surface-uv 1) (Float3-dot offset bitangent)))))
  (ShapeKernel (flvector -inf.0 -inf.0 -inf.0 +inf.0 +inf.0 +inf.0) nearest nearest surface uv 0 0))
