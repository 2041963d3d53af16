#lang typed/racket/base
;; Projections onto a screen: the 4 x 4 matrices of rasterization, in eye space looking along -z, to
;; normalized device coordinates from -1 to 1 on all axes, -1 being near (the convention of OpenGL).
(require "../base/unsafe.rkt" "../base/float3.rkt" "../base/check.rkt")

(provide (struct-out Projection) Projection-perspective Projection-orthographic
         Projection-point Projection-unproject Projection-matrix-rows
         perspective-depth check-farther)

;; The entries of the matrix that are not 0: the diagonal, the offsets of the third column or the
;; fourth, and whether points are divided by their distance -z.
(struct Projection
  ([x-scale : Flonum] [y-scale : Flonum] [z-scale : Flonum]
   [x-offset : Flonum] [y-offset : Flonum] [z-offset : Flonum] [divides? : Boolean])
  #:transparent)

;; Projection-perspective : of a camera with that vertical field of view (degrees, below 180), width
;; over height `aspect`, and planes at the distances 0 < near < far; far may be +inf.0, for all there
;; is.
(: Projection-perspective
   (-> #:vertical-field-of-view-degrees Real #:aspect Real #:near Real #:far Real Projection))
(define (Projection-perspective #:vertical-field-of-view-degrees degrees #:aspect aspect
                                #:near near #:far far)
  (define angle
    (check-between 'Projection-perspective "vertical-field-of-view-degrees" degrees
                   1e-9 179.9999999))
  (define n (check-positive 'Projection-perspective "near" near))
  (define f (check-farther 'Projection-perspective n far))
  (define y (fl/ 1.0 (fltan (fl* angle 0.008726646259971648))))
  (define-values (z-scale z-offset) (perspective-depth n f))
  (Projection (fl/ y (check-positive 'Projection-perspective "aspect" aspect)) y
              z-scale 0.0 0.0 z-offset #t))

;; perspective-depth : the scale and the offset of depths between two planes in perspective; their
;; limits where the far one is infinitely far.
(: perspective-depth (-> Flonum Flonum (Values Flonum Flonum)))
(define (perspective-depth n f)
  (if (fl= f +inf.0)
      (values -1.0 (fl* -2.0 n))
      (values (fl/ (fl+ f n) (fl- n f)) (fl/ (fl* 2.0 (fl* f n)) (fl- n f)))))

;; Projection-orthographic : of the box from left to right, bottom to top, and -near to -far along z.
(: Projection-orthographic
   (-> #:left Real #:right Real #:bottom Real #:top Real #:near Real #:far Real Projection))
(define (Projection-orthographic #:left left #:right right #:bottom bottom #:top top
                                 #:near near #:far far)
  (: axis (-> String Real Real (Values Flonum Flonum)))
  (define (axis name low high)
    (define a (check-finite 'Projection-orthographic name low))
    (define b (check-finite 'Projection-orthographic name high))
    (when (fl= a b)
      (raise-expected 'Projection-orthographic name "two edges that differ" high))
    (values a b))
  (define-values (l r) (axis "right" left right))
  (define-values (b t) (axis "top" bottom top))
  (define-values (n f) (axis "far" near far))
  (Projection (fl/ 2.0 (fl- r l)) (fl/ 2.0 (fl- t b)) (fl/ 2.0 (fl- n f))
              (fl/ (fl+ r l) (fl- l r)) (fl/ (fl+ t b) (fl- b t)) (fl/ (fl+ f n) (fl- n f)) #f))

;; check-farther : a far plane beyond the near one.
(: check-farther (-> Symbol Flonum Real Flonum))
(define (check-farther who near far)
  (define f (if (eqv? far +inf.0) +inf.0 (check-positive who "far" far)))
  (unless (fl< near f) (raise-expected who "far" "a distance beyond near" far))
  f)

;; Projection-point : a point of eye space in normalized device coordinates. What a perspective finds
;; behind the eye comes out mirrored: clip first.
(: Projection-point (-> Projection Float3 Float3))
(define (Projection-point projection point)
  (define-values (x y z) (values (Float3-x point) (Float3-y point) (Float3-z point)))
  (define w (if (Projection-divides? projection) (fl- 0.0 z) 1.0))
  (Float3 (fl/ (fl+ (fl* (Projection-x-scale projection) x) (Projection-x-offset projection)) w)
          (fl/ (fl+ (fl* (Projection-y-scale projection) y) (Projection-y-offset projection)) w)
          (fl/ (fl+ (fl* (Projection-z-scale projection) z) (Projection-z-offset projection)) w)))

;; Projection-unproject : the point of eye space that is seen there.
(: Projection-unproject (-> Projection Float3 Float3))
(define (Projection-unproject projection seen)
  (define z-scale (Projection-z-scale projection))
  (define z
    (if (Projection-divides? projection)
        (fl/ (Projection-z-offset projection) (fl- (fl* -1.0 (Float3-z seen)) z-scale))
        (fl/ (fl- (Float3-z seen) (Projection-z-offset projection)) z-scale)))
  (define w (if (Projection-divides? projection) (fl- 0.0 z) 1.0))
  (Float3 (fl/ (fl- (fl* w (Float3-x seen)) (Projection-x-offset projection))
               (Projection-x-scale projection))
          (fl/ (fl- (fl* w (Float3-y seen)) (Projection-y-offset projection))
               (Projection-y-scale projection))
          z))

;; Projection-matrix-rows : the four rows of four numbers, for column vectors.
(: Projection-matrix-rows (-> Projection (Listof (Listof Flonum))))
(define (Projection-matrix-rows p)
  (list (list (Projection-x-scale p) 0.0 0.0 (Projection-x-offset p))
        (list 0.0 (Projection-y-scale p) 0.0 (Projection-y-offset p))
        (list 0.0 0.0 (Projection-z-scale p) (Projection-z-offset p))
        (if (Projection-divides? p) (list 0.0 0.0 -1.0 0.0) (list 0.0 0.0 0.0 1.0))))
