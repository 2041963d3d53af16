#lang typed/racket/base
;; Meshes that shine: a triangle chosen in proportion to its area, then a point uniform on it.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt"
         "../shape/mesh.rkt" "../shape/kernel.rkt" "../material/emitter.rkt" "light.rkt"
         "planar.rkt")

(provide Mesh-light-kernel)

;; A mesh may shadow itself, so none of it is passed over by shadow rays: they end short of the
;; triangle by the rounding of the point on it, and by what a composite's part needs more (see
;; parts.rkt). level: where in the path to a hit the triangle's number is. Triangles without area
;; are never chosen; a mesh without area is no light, and the result #f.
(: Mesh-light-kernel (->* (Mesh Emitter) (Fixnum Flonum Flonum) (U #f LightKernel)))
(define (Mesh-light-kernel mesh emitter [level 0] [absolute 0.0] [relative 0.0])
  (define positions (Mesh-positions mesh))
  (define triangles (Mesh-triangles mesh))
  (define count (Mesh-triangle-count mesh))
  (define radiance (Emitter-constant-radiance emitter))
  (define two-sided? (Emitter-two-sided? emitter))
  (define sums (area-sums positions triangles count))
  (define area (if (eqv? count 0) 0.0 (flvector-ref sums (fx- count 1))))

  (: sample (-> FlVector FxVector Void))
  (define (sample r i)
    (define triangle (first-above sums count area r))
    (let* ([target (fl* area (flvector-ref r sample-u))]
           [before (if (fx= triangle 0) 0.0 (flvector-ref sums (fx- triangle 1)))]
           ;; what is left of the number is uniform again; the point by a square root (Osada 2002)
           [u (fl/ (fl- target before) (fl- (flvector-ref sums triangle) before))]
           [root (flsqrt u)]
           [second (fl* root (fl- 1.0 (flvector-ref r sample-v)))]
           [third (fl* root (flvector-ref r sample-v))])
      (let-corners (a b c) (positions triangles triangle)
        (let-float3 ([ab (Float3-subtract b a)]
                     [ac (Float3-subtract c a)]
                     [across (Float3-cross ab ac)]
                     [normal (Float3-normalized
                              (Float3-scale-by-scalar across (largest-to-one across)))])
          (Float3-put! r workspace
                       (Float3-multiply-add (Float3-multiply-add a second ab) third ac))
          (put-area-sample! r normal area radiance two-sided?)
          (let* ([size (fl+ (Float3-largest-magnitude a)
                            (fl+ (Float3-largest-magnitude ab) (Float3-largest-magnitude ac)))]
                 [error (fl* (fl* 32.0 (ROUNDING)) size)]
                 [cosine (flabs (Float3-dot normal (Float3-in r light-direction)))])
            (when (fl> (flvector-ref r light-density) 0.0)
              (end-short! r (fl+ absolute error) relative cosine)))))))

  (define place (fx+ hit-path level))
  ;; Of the triangle that was hit, at the hit.
  (: density (-> FlVector FxVector Void))
  (define (density r i)
    (define triangle (fxvector-ref i place))
    (let-corners (a b c) (positions triangles triangle)
      (let-float3 ([across (Float3-cross (Float3-subtract b a) (Float3-subtract c a))]
                   [normal (Float3-normalized
                            (Float3-scale-by-scalar across (largest-to-one across)))])
        (put-area-density! r a normal area two-sided?))))

  (and (fl> area 0.0)
       (fl< area +inf.0)
       (LightKernel sample density #t -1
                    (mesh-bound mesh area radiance two-sided?))))

;; Binds the corners of a triangle.
(define-syntax-rule (let-corners (a b c) (positions triangles triangle) body ...)
  (let ([first (fx* 3 triangle)])
    (let-float3 ([a (Float3-in positions (fx* 3 (fxvector-ref triangles first)))]
                 [b (Float3-in positions (fx* 3 (fxvector-ref triangles (fx+ first 1))))]
                 [c (Float3-in positions (fx* 3 (fxvector-ref triangles (fx+ first 2))))])
      body ...)))

;; What brings the largest component of a vector to 1, so that its square does not vanish.
(define-syntax-rule (largest-to-one v) (fl/ 1.0 (Float3-largest-magnitude v)))

;; The area of each triangle and all before it.
(: area-sums (-> FlVector FxVector Index FlVector))
(define (area-sums positions triangles count)
  (define sums (make-flvector count 0.0))
  (let loop ([k : Fixnum 0] [sum : Flonum 0.0])
    (when (fx< k count)
      (let-corners (a b c) (positions triangles k)
        (let-float3 ([across (Float3-cross (Float3-subtract b a) (Float3-subtract c a))])
          (let ([sum (fl+ sum (fl* 0.5 (Float3-length across)))])
            (flvector-set! sums k sum)
            (loop (fx+ k 1) sum))))))
  sums)

;; The first triangle whose sum is above sample-u's share of the area.
(: first-above (-> FlVector Fixnum Flonum FlVector Fixnum))
(define (first-above sums count area r)
  (let search ([low : Fixnum 0] [high : Fixnum (fx- count 1)])
    (if (fx< low high)
        (let ([middle (fxrshift (fx+ low high) 1)])
          (if (fl> (flvector-ref sums middle) (fl* area (flvector-ref r sample-u)))
              (search low middle)
              (search (fx+ middle 1) high)))
        low)))

;; An open mesh that faces one way is bounded like a flat light, with the cone of its normals;
;; others like a closed one.
(: mesh-bound (-> Mesh Flonum Float3 Boolean LightBound))
(define (mesh-bound mesh area radiance two-sided?)
  (define box (corners-bounds mesh))
  (define total (total-across mesh))
  (define length (Float3-length total))
  ;; what a closed mesh's rounding leaves is no direction
  (define axis (Float3-scale-by-scalar total (fl/ 1.0 length)))
  (define least (if (fl> length (fl* 1e-9 area)) (least-cosine mesh axis) -1.0))
  (if (fl> least 0.0)
      (flat-bound box radiance area axis (flacos least) two-sided?)
      (round-bound box radiance (if two-sided? (fl* 2.0 area) area))))

(: corners-bounds (-> Mesh FlVector))
(define (corners-bounds mesh)
  (define-values (positions triangles) (values (Mesh-positions mesh) (Mesh-triangles mesh)))
  (define bounds (flvector +inf.0 +inf.0 +inf.0 -inf.0 -inf.0 -inf.0))
  (for* ([corner : Nonnegative-Fixnum (in-range (fxvector-length triangles))]
         [axis : Nonnegative-Fixnum (in-range 3)])
    (define x (flvector-ref positions (fx+ axis (fx* 3 (fxvector-ref triangles corner)))))
    (flvector-set! bounds axis (flmin x (flvector-ref bounds axis)))
    (flvector-set! bounds (fx+ 3 axis) (flmax x (flvector-ref bounds (fx+ 3 axis)))))
  bounds)

;; The sum of the triangles' normals, each twice the area long.
(: total-across (-> Mesh Float3))
(define (total-across mesh)
  (define-values (positions triangles) (values (Mesh-positions mesh) (Mesh-triangles mesh)))
  (let loop ([k : Fixnum 0] [total : Float3 (make-Float3 0 0 0)])
    (if (fx< k (Mesh-triangle-count mesh))
        (let-corners (a b c) (positions triangles k)
          (loop (fx+ k 1)
                (Float3-add total (Float3-cross (Float3-subtract b a) (Float3-subtract c a)))))
        total)))

;; The least cosine between the axis and a triangle's normal.
(: least-cosine (-> Mesh Float3 Flonum))
(define (least-cosine mesh axis)
  (define-values (positions triangles) (values (Mesh-positions mesh) (Mesh-triangles mesh)))
  (let loop ([k : Fixnum 0] [least : Flonum 1.0])
    (if (fx< k (Mesh-triangle-count mesh))
        (let-corners (a b c) (positions triangles k)
          (let-float3 ([across (Float3-cross (Float3-subtract b a) (Float3-subtract c a))])
            (let* ([length (Float3-length across)]
                   [cosine (if (fl> length 0.0) (fl/ (Float3-dot across axis) length) 1.0)])
              (loop (fx+ k 1) (if (fl< cosine least) cosine least)))))
        (fl+ least 0.0))))
