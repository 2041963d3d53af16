#lang typed/racket/base
;; The frame of a normal as kernels build it, for the tests: nine numbers.
(require racket/flonum "../../private/base/float3.rkt" "../../private/base/frame.rkt")

(provide frame-of frame-to-world)

;; Tangent, bitangent and the normal of the unit vector (x, y, z), three numbers each.
(: frame-of (-> Flonum Flonum Flonum (Listof Flonum)))
(define (frame-of x y z)
  (define rows (make-flvector 9))
  (let-float3 ([n (Float3 x y z)])
    (let-frame (tangent bitangent) n
      (Float3-put! rows 0 tangent)
      (Float3-put! rows 3 bitangent)
      (Float3-put! rows 6 n)))
  (for/list : (Listof Flonum) ([component (in-flvector rows)]) component))

;; The local vector (a, b, c) in the frame of (x, y, z).
(: frame-to-world (-> Flonum Flonum Flonum Flonum Flonum Flonum (Listof Flonum)))
(define (frame-to-world x y z a b c)
  (define result (make-flvector 3))
  (let-float3 ([n (Float3 x y z)] [local (Float3 a b c)])
    (let-frame (tangent bitangent) n
      (Float3-put! result 0 (Frame-to-world tangent bitangent n local))))
  (for/list : (Listof Flonum) ([component (in-flvector result)]) component))
