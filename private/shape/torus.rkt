#lang typed/racket/base
;; Tori (rings) of any axis: the quartic's roots bracketed by its extremes, refined on the distance
;; from the ring's circle, which does not cancel as the quartic's coefficients do.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/public.rkt"
         "../base/check.rkt" "../base/roots.rkt" "../material/material.rkt"
         "kernel.rkt" "shape.rkt" "cylinder.rkt")

(provide (struct-out Torus) make-Torus Torus-kernel Torus-bounds Torus-crossings)

;; center, axis: of the ring; any direction but zero. major-radius: of the circle in the ring's
;; middle. minor-radius: of the ring's cross section, positive and smaller. material: the surface.
(struct Torus Shape
  ([center : Float3] [axis : Float3] [major-radius : Flonum] [minor-radius : Flonum]
   [material : Material])
  #:transparent)

(: make-Torus (->* (Float3 Float3 Real Real)
                   (MaterialOrColor #:material MaterialOrColor)
                   Torus))
(define (make-Torus center axis major-radius minor-radius [color (make-Float3 0.5 0.5 0.5)]
                    #:material [material color])
  (define major (check-positive 'Torus "major-radius" major-radius))
  (define minor (check-positive 'Torus "minor-radius" minor-radius))
  (unless (fl< minor major)
    (raise-expected 'Torus "minor-radius" "a number below the major-radius" minor-radius))
  (Torus (check-point 'Torus "center" center) (check-direction 'Torus "axis" axis)
         major minor (->material material)))

(define-constructor Torus make-Torus (center axis major-radius minor-radius material))

;; Places in the workspace. The ray in local coordinates, z along the axis, from its point nearest
;; to the centre: that origin, the direction, and the parameter there. The quartic's p and q, how
;; far the search has come and where it ends.
(define-syntax-rule (LOCAL-O) workspace)
(define-syntax-rule (LOCAL-D) (fx+ workspace 3))
(define-syntax-rule (SHIFT) (fx+ workspace 6))
(define-syntax-rule (QUARTIC-P) (fx+ workspace 7))
(define-syntax-rule (QUARTIC-Q) (fx+ workspace 8))
(define-syntax-rule (FROM) (fx+ workspace 9))
(define-syntax-rule (HIGH) (fx+ workspace 10))
(define-syntax-rule (FROM-VALUE) (fx+ workspace 11))
(define-syntax-rule (ROOT) (fx+ workspace 12))
(define-syntax-rule (PIECE) fixnum-workspace)

;; Binds value and slope at t of (rho - R)^2 + z^2 - r^2, rho the distance from the axis: negative
;; inside; and its derivative.
(define-syntax-rule (let-tube (value slope) (ox oy oz dx dy dz t major minor) body)
  (let* ([x (fl+ ox (fl* t dx))] [y (fl+ oy (fl* t dy))] [z (fl+ oz (fl* t dz))]
         [rho (flsqrt (fl+ (fl* x x) (fl* y y)))]
         [beyond (fl- rho major)]
         [value (fl- (fl+ (fl* beyond beyond) (fl* z z)) (fl* minor minor))]
         [slope (fl* 2.0 (fl+ (fl* (fl/ beyond rho) (fl+ (fl* x dx) (fl* y dy))) (fl* z dz)))])
    body))

;; Whether the coefficients and the powers the search takes of them are numbers: not so for directions
;; shorter than 1e-50 of the torus or with no length at all, whose rays miss it.
(define-syntax-rule (representable? p q)
  (and (fl< (flabs p) 1e100) (fl< (flabs q) 1e150)))

;; Prepares the search for the roots after parameter `first` of the ray; whether there can be any.
;; With the origin nearest to the centre the quartic over (d.d)^2 has no cubic term:
;; t^4 + 2 p t^2 + 4 q t + s, p = (o.o - R^2 - r^2 + 2 R^2 dz^2 / d.d) / d.d,
;; q = 2 R^2 oz dz / (d.d)^2. Roots lie in the ball of radius R + r, between the planes z = +-r, and
;; not where the ray stays within the hole.
(: prepare! (-> FlVector FxVector FlVector Flonum Flonum Flonum Boolean))
(define (prepare! r i frame major minor first)
  (let-float3 ([d (Float3-in r ray-direction)]
               [start (Float3-subtract (Float3-in r ray-origin) (Float3-in frame 0))])
    (let* ([dd (Float3-length-squared d)]
           [inverse-dd (fl/ 1.0 dd)]
           [shift (fl* -1.0 (fl* (Float3-dot start d) inverse-dd))])
      (let-float3 ([near (Float3-multiply-add start shift d)])
        ;; once more, because from far away the first step leaves a rest
        (let* ([more (fl* -1.0 (fl* (Float3-dot near d) inverse-dd))])
          (let-float3 ([o (Float3-multiply-add near more d)])
            (let* ([shift (fl+ shift more)]
                   [reach (fl+ major minor)]
                   [oo (Float3-length-squared o)]
                   [room (fl- (fl* reach reach) oo)])
              (and
               (fl> room 0.0)
               (let* ([oz (local-z frame o)] [dz (local-z frame d)])
                 (let-slab (enter leave) (oz dz (fl* -1.0 minor) minor)
                   (let* ([half (flsqrt (fl* room inverse-dd))]
                          [low (flmax enter (fl* -1.0 half))]
                          [high (flmin leave half)]
                          [begin-at (fl- first shift)]
                          [within? (fl> begin-at low)]
                          [from (if within? begin-at low)])
                     (and
                      (fl< from high)
                      (let* ([ox (local-x frame o)] [oy (local-y frame o)]
                             [dx (local-x frame d)] [dy (local-y frame d)]
                             [hole (fl- major minor)]
                             [hole-squared (fl* hole hole)])
                        (define-syntax-rule (in-hole? t)
                          (let* ([x (fl+ ox (fl* t dx))] [y (fl+ oy (fl* t dy))])
                            (fl< (fl+ (fl* x x) (fl* y y)) hole-squared)))
                        (and
                         (not (and (in-hole? from) (in-hole? high)))
                         (let* ([major-squared (fl* major major)]
                                [twice (fl* 2.0 (fl* major-squared (fl* dz inverse-dd)))]
                                [p (fl* inverse-dd
                                        (fl+ (fl- (fl- oo major-squared) (fl* minor minor))
                                             (fl* twice dz)))]
                                [q (fl* twice (fl* oz inverse-dd))])
                          (and
                           (representable? p q)
                           (begin
                             (flvector-set! r (LOCAL-O) ox)
                             (flvector-set! r (fx+ 1 (LOCAL-O)) oy)
                             (flvector-set! r (fx+ 2 (LOCAL-O)) oz)
                             (flvector-set! r (LOCAL-D) dx)
                             (flvector-set! r (fx+ 1 (LOCAL-D)) dy)
                             (flvector-set! r (fx+ 2 (LOCAL-D)) dz)
                             (flvector-set! r (SHIFT) shift)
                             (flvector-set! r (QUARTIC-P) p)
                             (flvector-set! r (QUARTIC-Q) q)
                             (flvector-set! r (FROM) from)
                             (flvector-set! r (HIGH) high)
                             (fxvector-set! i (PIECE) 0)
                             (let-tube (value slope) (ox oy oz dx dy dz from major minor)
                               (flvector-set! r (FROM-VALUE) (if within? value (flmax 0.0 value))))
                             #t)))))))
                   #f))))))))))

;; Writes the next root's parameter along the ray to ROOT; whether there was one.
(: next-root! (-> FlVector FxVector Flonum Flonum Boolean))
(define (next-root! r i major minor)
  (let* ([ox (flvector-ref r (LOCAL-O))]
         [oy (flvector-ref r (fx+ 1 (LOCAL-O)))]
         [oz (flvector-ref r (fx+ 2 (LOCAL-O)))]
         [dx (flvector-ref r (LOCAL-D))]
         [dy (flvector-ref r (fx+ 1 (LOCAL-D)))]
         [dz (flvector-ref r (fx+ 2 (LOCAL-D)))]
         [p (flvector-ref r (QUARTIC-P))]
         [q (flvector-ref r (QUARTIC-Q))]
         [from (flvector-ref r (FROM))]
         [high (flvector-ref r (HIGH))]
         [piece (fxvector-ref i (PIECE))]
         [from-value (flvector-ref r (FROM-VALUE))])
    (define-syntax-rule (evaluate t (value slope) body)
      (let-tube (value slope) (ox oy oz dx dy dz t major minor) body))
    (find-sign-change (evaluate) (p q) (piece from from-value)
                      (high (evaluate high (value slope) (flmax 0.0 value)))
      #:found (root next-piece next-from next-value)
      (begin
        (flvector-set! r (ROOT) (fl+ root (flvector-ref r (SHIFT))))
        (flvector-set! r (FROM) next-from)
        (fxvector-set! i (PIECE) next-piece)
        (flvector-set! r (FROM-VALUE) next-value)
        #t)
      #:none #f)))

(: Torus-kernel (-> Torus ShapeKernel))
(define (Torus-kernel torus)
  (define center (Torus-center torus))
  (define major (Torus-major-radius torus))
  (define minor (Torus-minor-radius torus))
  (define frame (axial-frame center (Torus-axis torus)))
  (define error-bound
    (fl* (fl* 16.0 (ROUNDING)) (fl+ (fl+ major minor) (Float3-largest-magnitude center))))

  (: nearest (-> FlVector FxVector Boolean))
  (define (nearest r i)
    (and (prepare! r i frame major minor 0.0)
         (next-root! r i major minor)
         (let ([t (flvector-ref r (ROOT))])
           (and (closer? r i t)
                (begin (flvector-set! r hit-t t) #t)))))

  (: surface (-> FlVector FxVector Void))
  (define (surface r i)
    (let-float3 ([p (Float3-subtract (Float3-multiply-add (Float3-in r ray-origin)
                                                          (flvector-ref r hit-t)
                                                          (Float3-in r ray-direction))
                                     (Float3-in frame 0))]
                 [axis (Float3-in frame 9)])
      (let* ([z (Float3-dot p axis)])
        (let-float3 ([across (Float3-multiply-add p (fl* -1.0 z) axis)]
                     [ring (Float3-scale-by-scalar across (fl/ major (Float3-length across)))]
                     [normal (Float3-normalized (Float3-subtract p ring))]
                     [point (Float3-add (Float3-in frame 0)
                                        (Float3-multiply-add ring minor normal))])
          (put-surface! r point normal error-bound)))))

  ;; u around the axis; v around the ring's cross section, 1/2 on the outer equator, growing
  ;; towards the axis's side.
  (: uv (-> FlVector FxVector Void))
  (define (uv r i)
    (let-float3 ([p (Float3-subtract (Float3-in r surface-point) (Float3-in frame 0))])
      (let* ([x (local-x frame p)] [y (local-y frame p)])
        (flvector-set! r surface-uv (axial-angle x y))
        (flvector-set! r (fx+ surface-uv 1)
                       (axial-angle (fl- (flsqrt (fl+ (fl* x x) (fl* y y))) major)
                                    (local-z frame p))))))

  (ShapeKernel (Torus-bounds torus) nearest nearest surface uv 0 0))

;; The box of the ring's circle, widened by the cross section's radius.
(: Torus-bounds (-> Torus FlVector))
(define (Torus-bounds torus)
  (define center (Torus-center torus))
  (define minor (Torus-minor-radius torus))
  (define circle
    (box-around center (Torus-major-radius torus) center (Torus-major-radius torus)
                (Float3-normalized/checked (Torus-axis torus))))
  (flvector (fl- (flvector-ref circle 0) minor) (fl- (flvector-ref circle 1) minor)
            (fl- (flvector-ref circle 2) minor) (fl+ (flvector-ref circle 3) minor)
            (fl+ (flvector-ref circle 4) minor) (fl+ (flvector-ref circle 5) minor)))

;; The parameters of all crossings of the whole line through the ray in the scratch, in ascending
;; order: none, two or four.
(: Torus-crossings (-> Torus FlVector FxVector (Listof Flonum)))
(define (Torus-crossings torus r i)
  (define major (Torus-major-radius torus))
  (define minor (Torus-minor-radius torus))
  (define frame (axial-frame (Torus-center torus) (Torus-axis torus)))
  (if (prepare! r i frame major minor -inf.0)
      (let more ()
        (if (next-root! r i major minor)
            (let ([t (flvector-ref r (ROOT))])
              (cons t (more)))
            '()))
      '()))
