#lang typed/racket/base
;; Interior: the boundary of a medium. A closed shape of this material is filled with the medium;
;; where shapes overlap, their media are all there. surface: a material that transmits, as glass, or
;; #f where there is nothing to see but the medium.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/public.rkt"
         "../base/check.rkt" "../medium/medium.rkt"
         "material.rkt" "kernel.rkt" "scatter.rkt" "emitter.rkt")

(provide (struct-out Interior) make-Interior straight-on)

(struct Interior Material ([medium : Medium] [surface : (U #f Material)]) #:transparent)

;; Interior : raises exn:fail:contract where the surface shines or is a boundary itself.
(: make-Interior (->* (Medium) ((U #f Material) #:surface (U #f Material)) Interior))
(define (make-Interior medium [surface-by-place #f] #:surface [surface surface-by-place])
  (when (or (Emitter? surface) (Interior? surface))
    (raise-expected 'Interior "surface" "a material that transmits, or #f" surface))
  (Interior medium surface))

(define-constructor Interior make-Interior (medium surface))

;; What a boundary does to light that is not to be seen: nothing. Only for integrators that know no
;; media; paths go through without it.
(: straight-on MaterialKernel)
(define straight-on
  (specular-kernel
   #:transmits? #t
   (lambda ([r : FlVector] [i : FxVector])
     (put-specular! r (Float3-negate (Float3-in r out-direction)) (Float3 1.0 1.0 1.0)))))
