#lang typed/racket/base
;; The Utah teapot as a shape.
(require "../base/unsafe-typed.rkt" "../base/unsafe.rkt" "../base/float3.rkt" "../base/check.rkt"
         "shape.rkt" "mesh.rkt")

(provide teapot)

(unsafe-require/typed "bezier.rkt"
  [teapot-mesh-vectors (-> #:tolerance Real (Values FlVector FlVector FlVector FxVector))])

;; teapot : a Mesh of the teapot, standing on y = 0 around the y axis, 3.15 high, its handle towards
;; -x and its spout towards +x, with smooth normals and texture coordinates. #:tolerance: how far
;; the mesh may be from the patches.
(: teapot (->* () (#:tolerance Real #:material MaterialOrColor) Mesh))
(define (teapot #:tolerance [tolerance 0.005] #:material [material (make-Float3 0.5 0.5 0.5)])
  (define-values (positions normals uvs triangles)
    (teapot-mesh-vectors #:tolerance (check-positive 'teapot "#:tolerance" tolerance)))
  (make-Mesh positions triangles #:normals normals #:uvs uvs #:material material))
