#lang typed/racket/base
;; Smooth normals for meshes that come without: at each vertex the sum of its triangles' normals
;; weighted by their angles there (Thürmer and Wüthrich, "Computing Vertex Normals from Polygonal
;; Facets", 1998), which no way of cutting a face into triangles changes.
(require "../base/unsafe.rkt" "../base/float3.rkt")

(provide vertex-normals)

;; vertex-normals : from three coordinates a vertex and three vertices a triangle, counter-clockwise
;; seen from outside, three numbers a vertex, of any length; zero where no triangle has an area.
(: vertex-normals (-> FlVector FxVector FlVector))
(define (vertex-normals positions triangles)
  (define normals (make-flvector (flvector-length positions) 0.0))
  (let loop ([k : Fixnum 0])
    (when (fx< k (fxvector-length triangles))
      (let ([at-a (fx* 3 (fxvector-ref triangles k))]
            [at-b (fx* 3 (fxvector-ref triangles (fx+ k 1)))]
            [at-c (fx* 3 (fxvector-ref triangles (fx+ k 2)))])
        (let-float3 ([a (Float3-in positions at-a)]
                     [b (Float3-in positions at-b)]
                     [c (Float3-in positions at-c)]
                     [across (Float3-cross (Float3-subtract b a) (Float3-subtract c a))])
          (let ([length (Float3-length across)])
            (when (fl> length 0.0)
              (let-float3 ([normal (Float3-scale-by-scalar across (fl/ 1.0 length))])
                (add-weighted! normals at-a length a b c normal)
                (add-weighted! normals at-b length b c a normal)
                (add-weighted! normals at-c length c a b normal))))))
      (loop (fx+ k 3))))
  normals)

;; Adds the normal times the angle at p between the sides to q and s; twice the area is given.
(define-syntax-rule (add-weighted! normals at area p q s normal)
  (let ([angle (atan area (Float3-dot (Float3-subtract q p) (Float3-subtract s p)))])
    (Float3-put! normals at (Float3-multiply-add (Float3-in normals at) angle normal))))
