#lang typed/racket/base
;; What the kernels of materials share: the side they face, directions without neighbours, nothing.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "kernel.rkt")

(provide let-facing-normal put-specular! put-nothing! put-absorbed! specular-kernel)

;; Binds normal to the shading normal, or to the geometric one where the shading normal is turned
;; away from the viewer, out to out-direction, and cosine to their dot product, from 0 to 1.
(define-syntax-rule (let-facing-normal r (normal out cosine) body ...)
  (let-float3 ([out (Float3-in r out-direction)]
               [shading (Float3-in r surface-shading-normal)])
    (let ([place (if (fl> (Float3-dot shading out) 0.0) surface-shading-normal surface-normal)])
      (let-float3 ([normal (Float3-in r place)])
        (let ([cosine (flmax 0.0 (flmin 1.0 (Float3-dot normal out)))])
          body ...)))))

;; A sampled direction that has no neighbours.
(define-syntax-rule (put-specular! r direction weight)
  (begin
    (Float3-put! r in-direction direction)
    (Float3-put! r bsdf-weight weight)
    (flvector-set! r bsdf-density +inf.0)))

;; No light, and no density.
(define-syntax-rule (put-nothing! r)
  (begin
    (Float3-put! r bsdf-weight (Float3 0.0 0.0 0.0))
    (flvector-set! r bsdf-density 0.0)))

;; Times what is left of light after the way from the last vertex through a shape that absorbs, per
;; unit of length, with that absorption (Beer and Lambert).
(define-syntax-rule (put-absorbed! r absorption)
  (let ([distance (fl+ (flvector-ref r travelled)
                       (fl* (flvector-ref r hit-t) (Float3-length (Float3-in r ray-direction))))])
    (let-float3 ([exponent (Float3-scale-by-scalar absorption (fl* -1.0 distance))])
      (Float3-put! r bsdf-weight
                   (Float3-scale-by-vector (Float3-in r bsdf-weight)
                                           (Float3 (flexp (Float3-x exponent))
                                                   (flexp (Float3-y exponent))
                                                   (flexp (Float3-z exponent))))))))

;; The kernel of a material all of whose samples are specular.
(: specular-kernel (->* ((-> FlVector FxVector Void))
                        (#:transmits? Boolean #:prepare (U #f (-> FlVector FxVector Void)))
                        MaterialKernel))
(define (specular-kernel sample #:transmits? [transmits? #f] #:prepare [prepare #f])
  (MaterialKernel sample (lambda ([r : FlVector] [i : FxVector]) (put-nothing! r))
                  #t transmits? prepare))
