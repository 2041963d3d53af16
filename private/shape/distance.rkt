#lang typed/racket/base
;; Shapes given by a signed distance, met by sphere tracing (Hart, "Sphere Tracing: A Geometric
;; Method for the Antialiased Ray Tracing of Implicit Surfaces", 1996).
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/public.rkt"
         "../base/check.rkt" "../material/material.rkt" "kernel.rkt" "shape.rkt" "sphere.rkt")

(provide (struct-out DistanceShape) make-DistanceShape DistanceShape-kernel)

;; distance: of a point x y z from the surface, negative inside. low, high: corners of a box around
;; the surface. error: how near to the surface a ray is taken to meet it. lipschitz: the largest
;; rate at which the distance changes. material: the surface.
(struct DistanceShape Shape
  ([distance : (-> Flonum Flonum Flonum Flonum)] [low : Float3] [high : Float3]
   [error : Flonum] [lipschitz : Flonum] [material : Material])
  #:transparent)

;; DistanceShape : the surface where a function of x, y and z is zero. The function says how far
;; that surface is, negative inside it; it may say less than the true distance, but where it
;; changes by more than 1 per unit, #:lipschitz must say by how much at most, or rays pass through
;; the surface. Rays look for it only between the corners low and high, which must leave it room.
;; A ray hits where the distance over lipschitz is below #:error in world units, from either side: a
;; millionth of the box's diagonal unless said otherwise; details below that size are lost. A ray
;; ends without a hit where the function gives NaN and after 4096 steps. Texture coordinates are
;; those of a sphere with the same normal.
(: make-DistanceShape
   (->* ((-> Flonum Flonum Flonum Flonum) Float3 Float3)
        (MaterialOrColor #:material MaterialOrColor #:error (U #f Real) #:lipschitz Real)
        DistanceShape))
(define (make-DistanceShape distance low high [color (make-Float3 0.5 0.5 0.5)]
                            #:material [material color] #:error [error #f]
                            #:lipschitz [lipschitz 1.0])
  (check-point 'DistanceShape "low" low)
  (check-point 'DistanceShape "high" high)
  (unless (and (fl< (Float3-x low) (Float3-x high))
               (fl< (Float3-y low) (Float3-y high))
               (fl< (Float3-z low) (Float3-z high)))
    (raise-expected 'DistanceShape "high" "three coordinates greater than those of low" high))
  ;; a point's own roundings are no part of a distance
  (define least (fl* (fl* 64.0 (ROUNDING)) (flmax (Float3-largest-magnitude low)
                                                  (Float3-largest-magnitude high))))
  (define checked-error
    (if error
        (check-positive 'DistanceShape "error" error)
        (flmax least (fl* 1e-6 (Float3-distance low high)))))
  (unless (fl>= checked-error least)
    (raise-expected 'DistanceShape "error"
                    (format "at least ~a, the roundings of the box's coordinates," least) error))
  (DistanceShape distance low high checked-error
                 (check-positive 'DistanceShape "lipschitz" lipschitz)
                 (->material material)))

(define-constructor DistanceShape make-DistanceShape
  (distance low high error lipschitz material))

;; Places in the workspace. A ray is traced from where it enters the box, so that numbers are as
;; small as the shape: that point, the parameter there, how far the ray has come since and where it
;; ends.
(define-syntax-rule (START) workspace)
(define-syntax-rule (ENTER) (fx+ workspace 3))
(define-syntax-rule (COME) (fx+ workspace 4))
(define-syntax-rule (END) (fx+ workspace 5))
(define-syntax-rule (STEP-LIMIT) 4096)

;; Binds enter and leave to the parameters between which low <= o + t d <= high along one axis; a
;; ray along the slab is in it always or never.
(define-syntax-rule (let-slab (enter leave) (o d low high) body ...)
  (let* ([enter (if (fl> d 0.0)
                    (fl/ (fl- low o) d)
                    (if (fl< d 0.0)
                        (fl/ (fl- high o) d)
                        (if (and (fl<= low o) (fl<= o high)) -inf.0 +inf.0)))]
         [leave (if (fl> d 0.0)
                    (fl/ (fl- high o) d)
                    (if (fl< d 0.0) (fl/ (fl- low o) d) +inf.0))])
    body ...))

;; hit-u and hit-v keep where the ray entered the box and how far it came from there.
(: DistanceShape-kernel (-> DistanceShape ShapeKernel))
(define (DistanceShape-kernel shape)
  (define distance (DistanceShape-distance shape))
  (define low (DistanceShape-low shape))
  (define high (DistanceShape-high shape))
  (define error (DistanceShape-error shape))
  (define inverse-rate (fl/ 1.0 (DistanceShape-lipschitz shape)))
  (define size (flmax (Float3-largest-magnitude low) (Float3-largest-magnitude high)))
  ;; central differences err by the square of this step, and by the distance's roundings over it
  (define difference (flmax error (fl* 3.814697265625e-06 (Float3-distance low high))))
  (define surface-distance (fl+ (fl* 4.0 error) (fl* (fl* 16.0 (ROUNDING)) size)))

  ;; Whether the ray in the scratch passes through the box before its limit; prepares the search.
  (: enters-box? (-> FlVector Boolean))
  (define (enters-box? r)
    (let-float3 ([o (Float3-in r ray-origin)] [d (Float3-in r ray-direction)]
                 [lo low] [hi high])
      (let-slab (enter-x leave-x) ((Float3-x o) (Float3-x d) (Float3-x lo) (Float3-x hi))
        (let-slab (enter-y leave-y) ((Float3-y o) (Float3-y d) (Float3-y lo) (Float3-y hi))
          (let-slab (enter-z leave-z) ((Float3-z o) (Float3-z d) (Float3-z lo) (Float3-z hi))
            (let* ([enter (flmax 0.0 (flmax enter-x (flmax enter-y enter-z)))]
                   [leave (flmin (flvector-ref r ray-limit)
                                 (flmin leave-x (flmin leave-y leave-z)))])
              (and (fl<= enter leave)
                   (begin
                     (Float3-put! r (START) (Float3-multiply-add o enter d))
                     (flvector-set! r (ENTER) enter)
                     (flvector-set! r (COME) 0.0)
                     (flvector-set! r (END) (fl- leave enter))
                     #t))))))))

  ;; The bound on the distance from the surface at the point the search has come to.
  (define-syntax-rule (distance-ahead r)
    (let-float3 ([p (Float3-multiply-add (Float3-in r (START)) (flvector-ref r (COME))
                                         (Float3-in r ray-direction))])
      (fl* inverse-rate (flabs (distance (Float3-x p) (Float3-y p) (Float3-z p))))))

  ;; A ray that starts on the surface leaves it in steps of the error before it can meet it.
  (: nearest (-> FlVector FxVector Boolean))
  (define (nearest r i)
    (and (enters-box? r)
         (let search ([step : Fixnum 0] [leaving? : Boolean (fl= 0.0 (flvector-ref r (ENTER)))])
           (let ([ahead (distance-ahead r)])
             (let* ([near? (fl< ahead error)]
                    [come (flvector-ref r (COME))]
                    [t (fl+ (flvector-ref r (ENTER)) come)])
               (if (and near? (not leaving?))
                   (and (closer? r i t)
                        (begin
                          (flvector-set! r hit-t t)
                          (flvector-set! r hit-u (flvector-ref r (ENTER)))
                          (flvector-set! r hit-v come)
                          #t))
                   (let* ([onward (fl+ come (fl/ (if near? error ahead)
                                                 (Float3-length (Float3-in r ray-direction))))])
                     (and (fl<= onward (flvector-ref r (END)))
                          (fx< step (STEP-LIMIT))
                          (begin
                            (flvector-set! r (COME) onward)
                            (search (fx+ step 1) (and near? leaving?)))))))))))

  (: surface (-> FlVector FxVector Void))
  (define (surface r i)
    (let-float3 ([d (Float3-in r ray-direction)]
                 [start (Float3-multiply-add (Float3-in r ray-origin) (flvector-ref r hit-u) d)])
      (Float3-put! r surface-point (Float3-multiply-add start (flvector-ref r hit-v) d)))
    (put-rate! r 0 difference 0.0 0.0)
    (put-rate! r 1 0.0 difference 0.0)
    (put-rate! r 2 0.0 0.0 difference)
    (let-float3 ([gradient (Float3-in r surface-normal)] [d (Float3-in r ray-direction)])
      (let* ([largest (Float3-largest-magnitude gradient)])
        (let-float3 ([normal (if (and (fl> largest 0.0) (fl< largest +inf.0))
                                 (Float3-scale-by-scalar gradient (fl/ 1.0 largest))
                                 (Float3-negate d))])
          (put-surface! r (Float3-in r surface-point) (Float3-normalized normal)
                        surface-distance)))))

  ;; Into the axis's place of the surface's normal: the difference of the distances at the two ends
  ;; of a step along it.
  (: put-rate! (-> FlVector Fixnum Flonum Flonum Flonum Void))
  (define (put-rate! r axis hx hy hz)
    (define ahead
      (let-float3 ([p (Float3-in r surface-point)])
        (distance (fl+ (Float3-x p) hx) (fl+ (Float3-y p) hy) (fl+ (Float3-z p) hz))))
    (define behind
      (let-float3 ([p (Float3-in r surface-point)])
        (distance (fl- (Float3-x p) hx) (fl- (Float3-y p) hy) (fl- (Float3-z p) hz))))
    (flvector-set! r (fx+ surface-normal axis) (fl- ahead behind)))

  (ShapeKernel
   (let-float3 ([lo low] [hi high])
     (flvector (Float3-x lo) (Float3-y lo) (Float3-z lo) (Float3-x hi) (Float3-y hi) (Float3-z hi)))
   nearest nearest surface Sphere-uv! 0 0))
