#lang typed/racket/base
;; Triangles: the watertight intersection they share with meshes and quads, and the kernel.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/public.rkt"
         "../base/check.rkt" "../material/material.rkt" "kernel.rkt" "shape.rkt")

(provide (struct-out Triangle) make-Triangle Triangle-kernel Triangle-bounds
         let-sheared-ray let-triangle-hit
         let-sheared-vertex edge-function same-sign? front-parameter?
         triangle-normal points-bounds)

;; --- the intersection ---
;; Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013): vertices are sheared so
;; that the ray runs along an axis from the origin, and three edge functions of pairs of vertices
;; tell whether it passes inside. An edge function only changes sign, exactly, when its vertices
;; are swapped, and because rounding is monotonic it may come out as zero but never with the wrong
;; sign; zero counts as inside, so no ray passes between two triangles that share an edge.

;; Per ray: binds kz to the axis where the direction is longest and kx, ky to the others, ox, oy,
;; oz to the origin in that order, and sx, sy, sz to the shear. Reads the ray from the scratch.
(define-syntax-rule (let-sheared-ray (kx ky kz ox oy oz sx sy sz) r body ...)
  (let* ([x (flabs (flvector-ref r ray-direction))]
         [y (flabs (flvector-ref r (fx+ ray-direction 1)))]
         [z (flabs (flvector-ref r (fx+ ray-direction 2)))]
         [kz : Fixnum (if (fl> x y) (if (fl> x z) 0 2) (if (fl> y z) 1 2))]
         [kx : Fixnum (if (fx= kz 2) 0 (fx+ kz 1))]
         [ky : Fixnum (if (fx= kx 2) 0 (fx+ kx 1))]
         [ox (flvector-ref r (fx+ ray-origin kx))]
         [oy (flvector-ref r (fx+ ray-origin ky))]
         [oz (flvector-ref r (fx+ ray-origin kz))]
         [sz (fl/ 1.0 (flvector-ref r (fx+ ray-direction kz)))]
         [sx (fl* (flvector-ref r (fx+ ray-direction kx)) sz)]
         [sy (fl* (flvector-ref r (fx+ ray-direction ky)) sz)])
    body ...))

;; Per triangle: the vertices are at the places a, b and c of the flvector `vertices`. Where the
;; ray's line meets the triangle in front of the origin, `hit` sees the parameter t and the
;; weights v of b and w of c; otherwise the result is `miss`. Both sides are hit. `hit` is to
;; compare t with the limit; the weights cost a division only if it uses them.
(define-syntax-rule (let-triangle-hit (t v w) (kx ky kz ox oy oz sx sy sz) (vertices a b c) hit miss)
  (let-sheared-vertex (ax ay az) (kx ky kz ox oy oz sx sy) (vertices a)
    (let-sheared-vertex (bx by bz) (kx ky kz ox oy oz sx sy) (vertices b)
      (let-sheared-vertex (cx cy cz) (kx ky kz ox oy oz sx sy) (vertices c)
        (let ([a-edge (edge-function bx by cx cy)]
              [b-edge (edge-function cx cy ax ay)]
              [c-edge (edge-function ax ay bx by)])
          (if (same-sign? a-edge b-edge c-edge)
              (let* ([det (fl+ (fl+ a-edge b-edge) c-edge)]
                     [scaled (fl+ (fl+ (fl* a-edge az) (fl* b-edge bz)) (fl* c-edge cz))]
                     [t (fl* (fl/ scaled det) sz)])
                (if (and (fl> t 0.0)
                         (front-parameter? scaled det sz (ax bx cx) (ay by cy) (az bz cz)))
                    (let-syntax ([v (lambda (use) #'(fl/ b-edge det))]
                                 [w (lambda (use) #'(fl/ c-edge det))])
                      hit)
                    miss))
              miss))))))

;; Binds a vertex relative to the ray: x and y across it, z along its axis, not yet scaled.
(define-syntax-rule
  (let-sheared-vertex (x y z) (kx ky kz ox oy oz sx sy) (vertices place) body ...)
  (let* ([z (fl- (flvector-ref vertices (fx+ place kz)) oz)]
         [x (fl- (fl- (flvector-ref vertices (fx+ place kx)) ox) (fl* sx z))]
         [y (fl- (fl- (flvector-ref vertices (fx+ place ky)) oy) (fl* sy z))])
    body ...))

;; Twice the signed area of the origin and two sheared vertices.
(define-syntax-rule (edge-function ax ay bx by) (fl- (fl* ax by) (fl* ay bx)))

;; Whether none is negative or none positive; never for NaN.
(define-syntax-rule (same-sign? p q s)
  (if (fl>= p 0.0)
      (if (and (fl>= q 0.0) (fl>= s 0.0)) #t
          (and (fl<= p 0.0) (fl<= q 0.0) (fl<= s 0.0)))
      (and (fl<= p 0.0) (fl<= q 0.0) (fl<= s 0.0))))

;; Whether the sign of a positive t = sz scaled / det is certain. It is when all vertices are in
;; front of the origin; otherwise `scaled`, the volume of origin and vertices, must exceed what
;; rounding may have made of it. Then a ray that starts on a triangle cannot hit it again.
;; With X, Y, Z the largest magnitudes, a coordinate across the ray is wrong by at most
;; 2 X + 3 Z roundings, an edge function by 12 X Y + 6 Z (X + Y), the sum by what is below.
;; (The shear's own rounding only turns the ray; it does not change the volume.)
(define-syntax-rule (front-parameter? scaled det sz (x ...) (y ...) (z ...))
  (or (if (fl> sz 0.0) (and (fl> z 0.0) ...) (and (fl< z 0.0) ...))
      (let ([x-size (largest-magnitude x ...)]
            [y-size (largest-magnitude y ...)]
            [z-size (largest-magnitude z ...)])
        (fl> (flabs scaled)
             (fl* (fl* (ROUNDING) z-size)
                  (fl+ (fl* 5.0 (flabs det))
                       (fl* 3.0 (fl+ (fl* 12.0 (fl* x-size y-size))
                                     (fl* 6.0 (fl* z-size (fl+ x-size y-size)))))))))))

(define-syntax largest-magnitude
  (syntax-rules ()
    [(_ x) (flabs x)]
    [(_ x more ...) (flmax (flabs x) (largest-magnitude more ...))]))

;; --- the shape ---

;; a, b, c: the corners, counter-clockwise seen from outside. material: the surface.
(struct Triangle Shape ([a : Float3] [b : Float3] [c : Float3] [material : Material]) #:transparent)

;; A triangle without area is allowed, and no ray hits it.
(: make-Triangle (->* (Float3 Float3 Float3) (MaterialOrColor #:material MaterialOrColor) Triangle))
(define (make-Triangle a b c [color (make-Float3 0.5 0.5 0.5)] #:material [material color])
  (Triangle (check-point 'Triangle "a" a)
            (check-point 'Triangle "b" b)
            (check-point 'Triangle "c" c)
            (->material material)))

(define-constructor Triangle make-Triangle (a b c material))

;; The unit normal by the right-hand rule, or #f exactly where the three points are on a line:
;; decided in rational arithmetic where flonums lose more than two digits.
(: triangle-normal (-> Float3 Float3 Float3 (U #f Float3)))
(define (triangle-normal a b c)
  (define u (Float3-subtract b a))
  (define v (Float3-subtract c a))
  (define normal (Float3-cross u v))
  (define size (fl* (Float3-largest-magnitude u) (Float3-largest-magnitude v)))
  (if (and (fl> size SMALLEST-SAFE) (fl< size +inf.0)
           (fl> (Float3-largest-magnitude normal) (fl* 0.01 size)))
      (Float3-normalized/checked normal)
      (exact-triangle-normal a b c)))

;; Products above this have no part lost to underflow.
(define SMALLEST-SAFE : Flonum 1e-280)

(: exact-triangle-normal (-> Float3 Float3 Float3 (U #f Float3)))
(define (exact-triangle-normal a b c)
  (define-syntax-rule (difference component p q)
    (- (inexact->exact (component p)) (inexact->exact (component q))))
  (define-values (ux uy uz)
    (values (difference Float3-x b a) (difference Float3-y b a) (difference Float3-z b a)))
  (define-values (vx vy vz)
    (values (difference Float3-x c a) (difference Float3-y c a) (difference Float3-z c a)))
  (define x (- (* uy vz) (* uz vy)))
  (define y (- (* uz vx) (* ux vz)))
  (define z (- (* ux vy) (* uy vx)))
  (define largest (max (abs x) (abs y) (abs z)))
  (if (zero? largest)
      #f
      (Float3-normalized/checked
       (make-Float3 (/ x largest) (/ y largest) (/ z largest)))))

(: Triangle-kernel (-> Triangle ShapeKernel))
(define (Triangle-kernel triangle)
  (define a (Triangle-a triangle))
  (define b (Triangle-b triangle))
  (define c (Triangle-c triangle))
  (define area-normal (triangle-normal a b c))
  (define normal (or area-normal (make-Float3 0 0 0)))
  (define vertices (make-flvector 9))
  (Float3-put! vertices 0 a)
  (Float3-put! vertices 3 b)
  (Float3-put! vertices 6 c)
  (define edge-u (Float3-subtract b a))
  (define edge-v (Float3-subtract c a))
  (define error-bound
    (fl* (fl* 16.0 (ROUNDING))
         (fl+ (Float3-largest-magnitude a)
              (fl+ (Float3-largest-magnitude edge-u) (Float3-largest-magnitude edge-v)))))
  (: nearest (-> FlVector FxVector Boolean))
  (define (nearest r i)
    (let-sheared-ray (kx ky kz ox oy oz sx sy sz) r
      (let-triangle-hit (t v w) (kx ky kz ox oy oz sx sy sz) (vertices 0 3 6)
        (and (closer? r i t)
             (begin (flvector-set! r hit-t t)
                    (flvector-set! r hit-u v)
                    (flvector-set! r hit-v w)
                    #t))
        #f)))
  (: never (-> FlVector FxVector Boolean))
  (define (never r i) #f)
  ;; From the weights, so that the point is on the triangle wherever the ray came from.
  (: surface (-> FlVector FxVector Void))
  (define (surface r i)
    (let-float3 ([from-a (Float3-multiply-add
                          (Float3-scale-by-scalar edge-u (flvector-ref r hit-u))
                          (flvector-ref r hit-v) edge-v)])
      (put-surface! r (Float3-add a from-a) normal error-bound)))
  (define kernel (if area-normal nearest never))
  (ShapeKernel (Triangle-bounds triangle) kernel kernel surface put-weights! 0 0))

;; Texture coordinates: the weights of the second and the third corner.
(: put-weights! (-> FlVector FxVector Void))
(define (put-weights! r i)
  (let ([u (flvector-ref r hit-u)] [v (flvector-ref r hit-v)])
    (flvector-set! r surface-uv u)
    (flvector-set! r (fx+ surface-uv 1) v)))

(: Triangle-bounds (-> Triangle FlVector))
(define (Triangle-bounds triangle)
  (points-bounds (list (Triangle-a triangle) (Triangle-b triangle) (Triangle-c triangle))))

;; The box of some points: low x y z, high x y z.
(: points-bounds (-> (Listof Float3) FlVector))
(define (points-bounds points)
  (define bounds (flvector +inf.0 +inf.0 +inf.0 -inf.0 -inf.0 -inf.0))
  (define-syntax-rule (include! place x)
    (begin
      (flvector-set! bounds place (flmin x (flvector-ref bounds place)))
      (flvector-set! bounds (fx+ 3 place) (flmax x (flvector-ref bounds (fx+ 3 place))))))
  (for ([p (in-list points)])
    (include! 0 (Float3-x p))
    (include! 1 (Float3-y p))
    (include! 2 (Float3-z p)))
  bounds)
