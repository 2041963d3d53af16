#lang typed/racket/base
;; Cylinders of any axis, closed by two caps or open, and what other shapes around an axis share.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/public.rkt"
         "../base/check.rkt" "../base/frame.rkt" "../base/roots.rkt" "../sample/warp.rkt"
         "../material/material.rkt" "kernel.rkt" "shape.rkt")

(provide (struct-out Cylinder) make-Cylinder Cylinder-kernel Cylinder-bounds
         axial-frame local-x local-y local-z axial-angle axial-shift put-axial-hit! SIDE
         disk-extent box-around)

;; base, top: the centres of the two ends. radius: positive. material: the surface. caps?: whether
;; the ends are closed; an open cylinder is a tube seen from both sides.
(struct Cylinder Shape
  ([base : Float3] [top : Float3] [radius : Flonum] [material : Material] [caps? : Boolean])
  #:transparent)

(: make-Cylinder (->* (Float3 Float3 Real)
                      (MaterialOrColor #:material MaterialOrColor #:caps? Boolean)
                      Cylinder))
(define (make-Cylinder base top radius [color (make-Float3 0.5 0.5 0.5)]
                       #:material [material color] #:caps? [caps? #t])
  (check-point 'Cylinder "base" base)
  (check-point 'Cylinder "top" top)
  (when (fl= 0.0 (Float3-distance base top))
    (raise-expected 'Cylinder "top" "a point other than the base" top))
  (Cylinder base top (check-positive 'Cylinder "radius" radius) (->material material) caps?))

(define-constructor Cylinder make-Cylinder (base top radius material caps?))

;; --- shapes around an axis: local coordinates have z along it ---

;; Twelve numbers for the kernels: an origin, and tangent, bitangent and axis of a frame.
(: axial-frame (-> Float3 Float3 FlVector))
(define (axial-frame origin direction)
  (define frame (make-flvector 12))
  (define axis (Float3-normalized/checked direction))
  (let-float3 ([a axis])
    (let-frame (tangent bitangent) a
      (Float3-put! frame 0 origin)
      (Float3-put! frame 3 tangent)
      (Float3-put! frame 6 bitangent)
      (Float3-put! frame 9 a)))
  frame)

(define-syntax-rule (local-x frame v) (Float3-dot (Float3-in frame 3) v))
(define-syntax-rule (local-y frame v) (Float3-dot (Float3-in frame 6) v))
(define-syntax-rule (local-z frame v) (Float3-dot (Float3-in frame 9) v))

;; The angle around the axis as a part of a turn, 0 to 1; around the y axis as on a sphere.
(define-syntax-rule (axial-angle x y)
  (fl+ 0.5 (fl* (fl/ 0.5 (PI)) (atan y x))))

;; hit-u keeps which part of the surface was hit: SIDE, or the cap number the caller gives.
(define-syntax-rule (SIDE) 0.0)

;; How far along the ray to move its origin: to the point nearest to the frame's origin, where
;; numbers are small, but 0 near the shape, so that an origin off the surface stays exactly there.
(define-syntax-rule (axial-shift start d far-squared)
  (if (fl> (Float3-length-squared start) far-squared)
      (fl* -1.0 (fl/ (Float3-dot start d) (Float3-length-squared d)))
      0.0))

;; Takes the hit from the parameters between which the ray is within the side's surface (low to
;; high) and between the planes of the ends (enter to leave), all counted from `shift`. Closed, the
;; two intervals' meeting is one interval, so the ray meets the surface twice or not at all.
(define-syntax-rule (put-axial-hit! r i caps? (low high) (enter leave) shift enter-cap leave-cap)
  (if caps?
      (let* ([near (if (fl< low enter) enter low)]
             [far (if (fl< leave high) leave high)]
             [near-t (fl+ shift near)])
        (and (fl<= near far)
             (if (fl> near-t 0.0)
                 (put-part-hit! r i near-t (if (fl< low enter) enter-cap (SIDE)))
                 (put-part-hit! r i (fl+ shift far) (if (fl< leave high) leave-cap (SIDE))))))
      (let* ([low-t (fl+ shift low)])
        (if (and (fl> low-t 0.0) (fl<= enter low) (fl<= low leave))
            (put-part-hit! r i low-t (SIDE))
            (and (fl<= enter high) (fl<= high leave)
                 (put-part-hit! r i (fl+ shift high) (SIDE)))))))

(define-syntax-rule (put-part-hit! r i t part)
  (let* ([at t] [of part])
    (and (closer? r i at)
         (begin (flvector-set! r hit-t at)
                (flvector-set! r hit-u of)
                #t))))

;; How far a disk of this radius reaches along one coordinate axis, from the other two components
;; of its unit normal; and the box of two extents around two centres.
(define-syntax-rule (disk-extent radius a b)
  (let* ([p a] [q b]) (fl* radius (flsqrt (fl+ (fl* p p) (fl* q q))))))

(: box-around (-> Float3 Flonum Float3 Flonum Float3 FlVector))
(define (box-around p p-radius q q-radius axis)
  (define-syntax-rule (low component a b)
    (flmin (fl- (component p) (disk-extent p-radius (a axis) (b axis)))
           (fl- (component q) (disk-extent q-radius (a axis) (b axis)))))
  (define-syntax-rule (high component a b)
    (flmax (fl+ (component p) (disk-extent p-radius (a axis) (b axis)))
           (fl+ (component q) (disk-extent q-radius (a axis) (b axis)))))
  (flvector (low Float3-x Float3-y Float3-z) (low Float3-y Float3-x Float3-z)
            (low Float3-z Float3-x Float3-y)
            (high Float3-x Float3-y Float3-z) (high Float3-y Float3-x Float3-z)
            (high Float3-z Float3-x Float3-y)))

;; --- the cylinder's kernel ---

(define-syntax-rule (BASE-CAP) 1.0)
(define-syntax-rule (TOP-CAP) 2.0)

(: Cylinder-kernel (-> Cylinder ShapeKernel))
(define (Cylinder-kernel cylinder)
  (define base (Cylinder-base cylinder))
  (define top (Cylinder-top cylinder))
  (define radius (Cylinder-radius cylinder))
  (define caps? (Cylinder-caps? cylinder))
  (define frame (axial-frame base (Float3-subtract top base)))
  (define height (Float3-distance base top))
  (define far-squared (fl* 2.0 (fl+ (fl* radius radius) (fl* height height))))
  (define error-bound
    (fl* (fl* 16.0 (ROUNDING)) (fl+ (fl+ radius height) (Float3-largest-magnitude base))))

  ;; Across the axis the ray passes it at distance |k| / sqrt(a), so the discriminant is
  ;; r^2 a - k^2 whatever the distance of its origin, and c is factored as a sphere's. From outside
  ;; the ball around the cylinder the ray first moves to its point nearest to the base.
  (: nearest (-> FlVector FxVector Boolean))
  (define (nearest r i)
    (let-float3 ([d (Float3-in r ray-direction)]
                 [start (Float3-subtract (Float3-in r ray-origin) (Float3-in frame 0))])
      (let* ([dx (local-x frame d)] [dy (local-y frame d)]
             [start-x (local-x frame start)] [start-y (local-y frame start)]
             [a (fl+ (fl* dx dx) (fl* dy dy))]
             [k (fl- (fl* start-x dy) (fl* start-y dx))]
             [discriminant (fl- (fl* (fl* radius radius) a) (fl* k k))])
        (and
         (fl>= discriminant 0.0)
         (let* ([shift (axial-shift start d far-squared)]
                [dz (local-z frame d)]
                [ox (fl+ start-x (fl* shift dx))]
                [oy (fl+ start-y (fl* shift dy))]
                [oz (fl+ (local-z frame start) (fl* shift dz))])
           (let-slab (enter leave) (oz dz 0.0 height)
             (let* ([distance (flsqrt (fl+ (fl* ox ox) (fl* oy oy)))]
                    [c (fl* (fl- distance radius) (fl+ distance radius))]
                    [b (fl+ (fl* ox dx) (fl* oy dy))]
                    [enter-cap (if (fl> dz 0.0) (BASE-CAP) (TOP-CAP))]
                    [leave-cap (if (fl> dz 0.0) (TOP-CAP) (BASE-CAP))])
               (let-roots-of-discriminant (low high) (a b c discriminant)
                 ;; along the axis there is no root, but a side all around or none
                 (let* ([along? (fl= a 0.0)]
                        [low (if along? (if (fl> c 0.0) +inf.0 -inf.0) low)]
                        [high (if along? +inf.0 high)])
                   (put-axial-hit! r i caps? (low high) (enter leave) shift
                                   enter-cap leave-cap))))
             #f))))))

  (: surface (-> FlVector FxVector Void))
  (define (surface r i)
    (let-float3 ([p (Float3-subtract (Float3-multiply-add (Float3-in r ray-origin)
                                                          (flvector-ref r hit-t)
                                                          (Float3-in r ray-direction))
                                     (Float3-in frame 0))]
                 [axis (Float3-in frame 9)])
      (let* ([part (flvector-ref r hit-u)]
             [z (Float3-dot p axis)])
        (let-float3 ([across (Float3-multiply-add p (fl* -1.0 z) axis)])
          (let* ([distance (Float3-length across)]
                 [side? (fl= part (SIDE))]
                 [from-axis (if (or side? (fl> distance radius)) (fl/ radius distance) 1.0)]
                 [along (if side?
                            (flmax 0.0 (flmin z height))
                            (fl* height (if (fl= part (BASE-CAP)) 0.0 1.0)))]
                 [normal-along (if side? 0.0 (if (fl= part (BASE-CAP)) -1.0 1.0))]
                 [normal-across (if side? (fl/ 1.0 distance) 0.0)])
            (let-float3 ([point (Float3-add (Float3-in frame 0)
                                            (Float3-multiply-add
                                             (Float3-scale-by-scalar across from-axis)
                                             along axis))]
                         [normal (Float3-multiply-add
                                  (Float3-scale-by-scalar across normal-across)
                                  normal-along axis)])
              (put-surface! r point normal error-bound)))))))

  ;; u around the axis; v from base to top, on the caps from the centre out.
  (: uv (-> FlVector FxVector Void))
  (define (uv r i)
    (let-float3 ([p (Float3-subtract (Float3-in r surface-point) (Float3-in frame 0))])
      (let* ([x (local-x frame p)] [y (local-y frame p)])
        (flvector-set! r surface-uv (axial-angle x y))
        (flvector-set! r (fx+ surface-uv 1)
                       (flmin 1.0
                              (if (fl= (flvector-ref r hit-u) (SIDE))
                                  (flmax 0.0 (fl/ (local-z frame p) height))
                                  (fl/ (flsqrt (fl+ (fl* x x) (fl* y y))) radius)))))))

  (ShapeKernel (Cylinder-bounds cylinder) nearest nearest surface uv 0 0))

;; The box of the two end disks.
(: Cylinder-bounds (-> Cylinder FlVector))
(define (Cylinder-bounds cylinder)
  (define base (Cylinder-base cylinder))
  (define top (Cylinder-top cylinder))
  (define radius (Cylinder-radius cylinder))
  (box-around base radius top radius
              (Float3-normalized/checked (Float3-subtract top base))))
