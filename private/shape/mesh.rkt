#lang typed/racket/base
;; Meshes: indexed triangles with a hierarchy of their own, built once however often it is used.
(require racket/promise "../base/unsafe-typed.rkt" (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/public.rkt"
         "../base/check.rkt" "../material/material.rkt"
         "../world/hierarchy.rkt" "../world/traverse.rkt"
         "kernel.rkt" "shape.rkt" "triangle.rkt")

(provide (struct-out Mesh) make-Mesh Mesh-triangle-count Mesh-kernel Mesh-nearest-by-scan)

(unsafe-require/typed "../base/promise.rkt" [once (All (a) (-> (-> a) (Promise a)))])

;; positions: three numbers a vertex. triangles: three vertex numbers each, counter-clockwise seen
;; from outside. normals: three numbers a vertex, or #f for flat triangles. uvs: two a vertex, or
;; #f. material: the surface. packed: what rays need, made at the first use.
(struct Mesh Shape
  ([positions : FlVector] [triangles : FxVector] [normals : (U #f FlVector)]
   [uvs : (U #f FlVector)] [material : Material] [packed : (Promise Packed)])
  #:property prop:equal+hash
  (list (lambda ([a : Mesh] [b : Mesh] [same? : (-> Any Any Boolean)])
          (same? (Mesh-parts a) (Mesh-parts b)))
        (lambda ([mesh : Mesh] [hash : (-> Any Integer)]) (hash (Mesh-parts mesh)))
        (lambda ([mesh : Mesh] [hash : (-> Any Integer)]) (hash (Mesh-positions mesh))))
  #:property prop:custom-write
  (lambda ([mesh : Mesh] [port : Output-Port] [mode : (U Boolean 0 1)])
    (if (or (boolean? mode) (> (Mesh-triangle-count mesh) MOST-PRINTED-TRIANGLES))
        (fprintf port "#<Mesh: ~a triangles, ~a vertices>"
                 (Mesh-triangle-count mesh) (quotient (flvector-length (Mesh-positions mesh)) 3))
        (print-call 'Mesh (list (Mesh-positions mesh) (Mesh-triangles mesh))
                    (list '#:normals (Mesh-normals mesh) #f '#:uvs (Mesh-uvs mesh) #f
                          '#:material (Mesh-material mesh) (void))
                    port mode))))

(unsafe-require/typed "../base/print.rkt"
  [print-call (-> Symbol (Listof Any) (Listof Any) Output-Port (U Boolean 0 1) Any)])

;; A larger mesh prints short: nobody reads its expression, nor that of one that is displayed or written.
(define MOST-PRINTED-TRIANGLES 100)

;; All that makes two meshes equal.
(: Mesh-parts (-> Mesh (Listof Any)))
(define (Mesh-parts mesh)
  (list (Mesh-positions mesh) (Mesh-triangles mesh) (Mesh-normals mesh) (Mesh-uvs mesh)
        (Mesh-material mesh)))

;; Mesh : triangles over shared vertices. positions: flvector, 3 finite coordinates a vertex.
;; triangles: fxvector, 3 numbers of vertices, from 0, a triangle. #:normals: flvector, 3 a vertex
;; of any length, for smooth shading. #:uvs: flvector, 2 a vertex. The vectors are not copied and
;; must not change. Triangles without area are never hit. Raises exn:fail:contract where lengths
;; do not fit, a number is not finite or a vertex does not exist.
(: make-Mesh (->* (FlVector FxVector)
                  (#:normals (U #f FlVector) #:uvs (U #f FlVector) #:material MaterialOrColor)
                  Mesh))
(define (make-Mesh positions triangles #:normals [normals #f] #:uvs [uvs #f]
                   #:material [material (make-Float3 0.5 0.5 0.5)])
  (define vertices (quotient (flvector-length positions) 3))
  (unless (= (flvector-length positions) (fx* 3 vertices))
    (raise-expected 'Mesh "positions" "three coordinates a vertex" (flvector-length positions)))
  (unless (zero? (remainder (fxvector-length triangles) 3))
    (raise-expected 'Mesh "triangles" "three vertices a triangle" (fxvector-length triangles)))
  (check-finite-elements "positions" positions)
  (check-vertices triangles vertices)
  (check-optional "#:normals" normals (fx* 3 vertices) "three numbers a vertex")
  (check-optional "#:uvs" uvs (fx* 2 vertices) "two numbers a vertex")
  (Mesh positions triangles normals uvs (->material material)
        (once (lambda () (pack positions triangles)))))

(define-constructor Mesh make-Mesh (positions triangles normals uvs material)
  #:struct (positions triangles normals uvs material _))

(: Mesh-triangle-count (-> Mesh Index))
(define (Mesh-triangle-count mesh) (quotient (fxvector-length (Mesh-triangles mesh)) 3))

(: check-finite-elements (-> String FlVector Void))
(define (check-finite-elements argument elements)
  (let loop ([k : Fixnum 0])
    (when (fx< k (flvector-length elements))
      (unless (fl< (flabs (flvector-ref elements k)) +inf.0)
        (raise-expected 'Mesh argument (format "a finite number at place ~a" k)
                        (flvector-ref elements k)))
      (loop (fx+ k 1)))))

(: check-vertices (-> FxVector Fixnum Void))
(define (check-vertices triangles vertices)
  (let loop ([k : Fixnum 0])
    (when (fx< k (fxvector-length triangles))
      (let ([vertex (fxvector-ref triangles k)])
        (unless (and (fx>= vertex 0) (fx< vertex vertices))
          (raise-expected 'Mesh "triangles"
                          (format "a vertex number below ~a at place ~a" vertices k) vertex)))
      (loop (fx+ k 1)))))

(: check-optional (-> String (U #f FlVector) Integer String Void))
(define (check-optional argument elements length expected)
  (when elements
    (unless (= (flvector-length elements) length)
      (raise-expected 'Mesh argument expected (flvector-length elements)))
    (check-finite-elements argument elements)))

;; bounds, links: the hierarchy over the triangles with an area; corners: nine coordinates of the
;; triangle at each of its places; order: the triangle's number. box: around them all. depth: of
;; the hierarchy.
(struct Packed
  ([bounds : FlVector] [links : FxVector] [corners : FlVector] [order : FxVector]
   [box : FlVector] [depth : Fixnum]))

;; In an empty mesh nothing is hit; its box is the point 0.
(: pack (-> FlVector FxVector Packed))
(define (pack positions triangles)
  (define total (quotient (fxvector-length triangles) 3))
  (define boxes (make-flvector (fx* 6 total) 0.0))
  (define used (make-fxvector total 0))
  (define count
    (let loop : Nonnegative-Fixnum ([k : Fixnum 0] [count : Nonnegative-Fixnum 0])
      (cond
        [(fx= k total) count]
        [(triangle-box! boxes (fx* 6 count) positions triangles k)
         (fxvector-set! used count k)
         (loop (fx+ k 1) (assert (fx+ count 1) nonnegative-fixnum?))]
        [else (loop (fx+ k 1) count)])))
  (define hierarchy (build-hierarchy boxes count))
  (define order (Hierarchy-order hierarchy))
  (define corners (make-flvector (fx* 9 count) 0.0))
  (let loop ([place : Fixnum 0])
    (when (fx< place count)
      (let ([triangle (fxvector-ref used (fxvector-ref order place))])
        (fxvector-set! order place triangle)
        (copy-corners! corners (fx* 9 place) positions triangles triangle))
      (loop (fx+ place 1))))
  (define bounds (Hierarchy-bounds hierarchy))
  (Packed bounds (Hierarchy-links hierarchy) corners order
          (if (eqv? count 0) (make-flvector 6 0.0) (flvector-copy bounds 0 6))
          (Hierarchy-depth hierarchy)))

(: nonnegative-fixnum? (-> Any Boolean : Nonnegative-Fixnum))
(define (nonnegative-fixnum? n) (and (fixnum? n) (>= n 0)))

(: copy-corners! (-> FlVector Fixnum FlVector FxVector Fixnum Void))
(define (copy-corners! corners at positions triangles triangle)
  (let loop ([k : Fixnum 0])
    (when (fx< k 3)
      (Float3-put! corners (fx+ at (fx* 3 k))
                   (Float3-in positions (fx* 3 (fxvector-ref triangles (fx+ (fx* 3 triangle) k)))))
      (loop (fx+ k 1)))))

;; Binds the corners of a triangle.
(define-syntax-rule (let-corners (a b c) (positions triangles triangle) body ...)
  (let ([first (fx* 3 triangle)])
    (let-float3 ([a (Float3-in positions (fx* 3 (fxvector-ref triangles first)))]
                 [b (Float3-in positions (fx* 3 (fxvector-ref triangles (fx+ first 1))))]
                 [c (Float3-in positions (fx* 3 (fxvector-ref triangles (fx+ first 2))))])
      body ...)))

;; Across the triangle, twice its area long.
(define-syntax-rule (area-vector a b c)
  (Float3-cross (Float3-subtract b a) (Float3-subtract c a)))

;; Writes the padded box of a triangle; whether the triangle has an area.
(: triangle-box! (-> FlVector Fixnum FlVector FxVector Fixnum Boolean))
(define (triangle-box! boxes at positions triangles triangle)
  (let-corners (a b c) (positions triangles triangle)
    (define-syntax-rule (put-axis! axis component)
      (let* ([p (component a)] [q (component b)] [s (component c)]
             [low (if (fl< p q) (if (fl< p s) p s) (if (fl< q s) q s))]
             [high (if (fl> p q) (if (fl> p s) p s) (if (fl> q s) q s))]
             [size (if (fl> (flabs low) (flabs high)) (flabs low) (flabs high))]
             [pad (fl* (PADDING) size)])
        (flvector-set! boxes (fx+ at axis) (fl- low pad))
        (flvector-set! boxes (fx+ at (fx+ 3 axis)) (fl+ high pad))))
    (put-axis! 0 Float3-x)
    (put-axis! 1 Float3-y)
    (put-axis! 2 Float3-z)
    (fl> (Float3-largest-magnitude (area-vector a b c)) 0.0)))

;; A few roundings of the coordinates, so that what is hit on the very edge is inside the box.
(define-syntax-rule (PADDING) 8.881784197001252e-16)

;; --- rays ---

;; While the search goes on: the number of the nearest triangle so far in the fixnum workspace. It
;; starts above all numbers where a hit at ray-limit is wanted, else below them, so that the lowest
;; of equally near triangles wins whatever order they are met in. hit-t holds what is to be beaten,
;; and the hierarchy goes a few roundings farther, because a lower triangle's box may begin there.
(define-syntax-rule (known-triangle) fixnum-workspace)
(define-syntax-rule (LIMIT-WIDENING) 1.0000000000000036)

(define-syntax-rule (start-search! r i)
  (begin
    (flvector-set! r hit-t (flvector-ref r ray-limit))
    (fxvector-set! i (known-triangle)
                   (if (fx= 1 (fxvector-ref i accept-ties)) (fixnum-literal #xFFFFFFFFFF) -1))))

(define-syntax-rule (found-any? i)
  (let ([known (fxvector-ref i (known-triangle))])
    (and (fx>= known 0) (fx< known (fixnum-literal #xFFFFFFFFFF)))))

;; Goes through the triangles at places first .. end-1, keeps the nearest hit, and ends with
;; (finish limit).
(define-syntax-rule
  (nearest-in-leaf! (first end limit finish) (kx ky kz ox oy oz sx sy sz) corners order r i)
  (let try ([place : Fixnum first] [far : Flonum limit])
    (if (fx= place end)
        (finish far)
        (let* ([a (fx* 9 place)] [b (fx+ a 3)] [c (fx+ a 6)])
          (let-triangle-hit (t v w) (kx ky kz ox oy oz sx sy sz) (corners a b c)
            (let ([best (flvector-ref r hit-t)])
              (if (and (fl<= t best)
                       (or (fl< t best)
                           (fx< (fxvector-ref order place)
                                (fxvector-ref i (known-triangle)))))
                  (begin
                    (flvector-set! r hit-t t)
                    (flvector-set! r hit-u v)
                    (flvector-set! r hit-v w)
                    (fxvector-set! i (known-triangle) (fxvector-ref order place))
                    (try (fx+ place 1) (fl* t (LIMIT-WIDENING))))
                  (try (fx+ place 1) far)))
            (try (fx+ place 1) far))))))

(: nearest-kernel (-> Packed (-> FlVector FxVector Boolean)))
(define (nearest-kernel packed)
  (define bounds (Packed-bounds packed))
  (define links (Packed-links packed))
  (define corners (Packed-corners packed))
  (define order (Packed-order packed))
  (lambda ([r : FlVector] [i : FxVector])
    (start-search! r i)
    (let-sheared-ray (kx ky kz ox oy oz sx sy sz) r
      (traverse
       (bounds links r i) (o d) limit
       #:leaf (first end top next again)
       (nearest-in-leaf! (first end limit next) (kx ky kz ox oy oz sx sy sz) corners order r i)
       #:done (finish-search! r i)))))

;; Whether the search found a triangle; then notes which.
(: finish-search! (-> FlVector FxVector Boolean))
(define (finish-search! r i)
  (and (found-any? i)
       (begin
         (fxvector-set! i (fx+ hit-path (fxvector-ref i nest-level))
                        (fxvector-ref i (known-triangle)))
         #t)))

(: occluded-kernel (-> Packed (-> FlVector FxVector Boolean)))
(define (occluded-kernel packed)
  (define bounds (Packed-bounds packed))
  (define links (Packed-links packed))
  (define corners (Packed-corners packed))
  (lambda ([r : FlVector] [i : FxVector])
    (let-sheared-ray (kx ky kz ox oy oz sx sy sz) r
      (traverse
       (bounds links r i) (o d) limit
       #:leaf (first end top next again)
       (let try ([place : Fixnum first])
         (if (fx= place end)
             (next limit)
             (let* ([a (fx* 9 place)] [b (fx+ a 3)] [c (fx+ a 6)])
               (let-triangle-hit (t v w) (kx ky kz ox oy oz sx sy sz) (corners a b c)
                 (if (fl< t limit) #t (try (fx+ place 1)))
                 (try (fx+ place 1))))))
       #:done #f))))

;; The nearest kernel's answer from trying every triangle in turn: the reference for tests.
(: Mesh-nearest-by-scan (-> Mesh FlVector FxVector Boolean))
(define (Mesh-nearest-by-scan mesh r i)
  (define packed (force (Mesh-packed mesh)))
  (define corners (Packed-corners packed))
  (define order (Packed-order packed))
  (define count (fxvector-length order))
  (define-syntax-rule (finish far) (finish-search! r i))
  (start-search! r i)
  (let ([limit (flvector-ref r ray-limit)])
    (let-sheared-ray (kx ky kz ox oy oz sx sy sz) r
      (nearest-in-leaf! (0 count limit finish) (kx ky kz ox oy oz sx sy sz) corners order r i))))

;; --- surfaces ---

;; The point from the weights of the corners, so it is on the triangle wherever the ray came from,
;; but for roundings of its coordinates; where normals are given they are blended, and turned to the
;; side the triangle's vertices say is outside.
(: surface-kernel (-> Mesh (-> FlVector FxVector Void)))
(define (surface-kernel mesh)
  (define positions (Mesh-positions mesh))
  (define triangles (Mesh-triangles mesh))
  (define normals (Mesh-normals mesh))
  (lambda ([r : FlVector] [i : FxVector])
    (define triangle (hit-triangle i))
    (let-corners (a b c) (positions triangles triangle)
      (let* ([v (flvector-ref r hit-u)]
             [w (flvector-ref r hit-v)]
             [u (fl- (fl- 1.0 v) w)])
        (let-float3 ([edge-v (Float3-subtract b a)]
                     [edge-w (Float3-subtract c a)]
                     [across (Float3-cross edge-v edge-w)]
                     [normal (Float3-normalized
                              (Float3-scale-by-scalar
                               across (fl/ 1.0 (Float3-largest-magnitude across))))]
                     [point (Float3-multiply-add
                             (Float3-multiply-add a v edge-v) w edge-w)])
          (let* ([size (fl+ (Float3-largest-magnitude a)
                            (fl+ (Float3-largest-magnitude edge-v)
                                 (Float3-largest-magnitude edge-w)))])
            (put-surface! r point normal (fl* (fl* 16.0 (ROUNDING)) size))
            (when normals
              (let ([first (fx* 3 triangle)])
                (let-float3 ([p (Float3-in normals (fx* 3 (fxvector-ref triangles first)))]
                             [q (Float3-in normals
                                           (fx* 3 (fxvector-ref triangles (fx+ first 1))))]
                             [s (Float3-in normals
                                           (fx* 3 (fxvector-ref triangles (fx+ first 2))))]
                             [smooth (Float3-multiply-add
                                      (Float3-multiply-add (Float3-scale-by-scalar p u) v q) w s)])
                  (let* ([length (Float3-length smooth)]
                         [side (Float3-dot smooth normal)]
                         [factor (fl/ (if (fl< side 0.0) -1.0 1.0) length)])
                    (when (and (fl> length 0.0) (fl< (flabs factor) +inf.0))
                      (Float3-put! r surface-shading-normal
                                   (Float3-scale-by-scalar smooth factor)))))))))))))

(define-syntax-rule (hit-triangle i)
  (fxvector-ref i (fx+ hit-path (fxvector-ref i nest-level))))

;; Texture coordinates: the vertices' interpolated, or else the weights of the second and third.
(: uv-kernel (-> Mesh (-> FlVector FxVector Void)))
(define (uv-kernel mesh)
  (define triangles (Mesh-triangles mesh))
  (define uvs (Mesh-uvs mesh))
  (lambda ([r : FlVector] [i : FxVector])
    (let* ([v (flvector-ref r hit-u)]
           [w (flvector-ref r hit-v)]
           [u (fl- (fl- 1.0 v) w)]
           [first (fx* 3 (hit-triangle i))])
      (cond
        [uvs
         (let ([a (fx* 2 (fxvector-ref triangles first))]
               [b (fx* 2 (fxvector-ref triangles (fx+ first 1)))]
               [c (fx* 2 (fxvector-ref triangles (fx+ first 2)))])
           (define-syntax-rule (blend k)
             (fl+ (fl+ (fl* u (flvector-ref uvs (fx+ a k))) (fl* v (flvector-ref uvs (fx+ b k))))
                  (fl* w (flvector-ref uvs (fx+ c k)))))
           (flvector-set! r surface-uv (blend 0))
           (flvector-set! r (fx+ surface-uv 1) (blend 1)))]
        [else
         (flvector-set! r surface-uv v)
         (flvector-set! r (fx+ surface-uv 1) w)]))))

;; Builds the hierarchy if nothing has before.
(: Mesh-kernel (-> Mesh ShapeKernel))
(define (Mesh-kernel mesh)
  (define packed (force (Mesh-packed mesh)))
  (ShapeKernel (Packed-box packed) (nearest-kernel packed) (occluded-kernel packed)
               (surface-kernel mesh) (uv-kernel mesh) 1 (Packed-depth packed)))
