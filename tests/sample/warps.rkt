#lang typed/racket/base
;; The warps as functions from flonums to lists of flonums.
(require racket/flonum "../../private/base/float3.rkt" "../../private/sample/warp.rkt")

(provide disk cosine-hemisphere uniform-hemisphere uniform-sphere cone)

(define-syntax-rule (define-warp name operation argument ...)
  (define (name [argument : Flonum] ...) : (Listof Flonum)
    (let-float3 ([point (operation argument ...)])
      (list (Float3-x point) (Float3-y point) (Float3-z point)))))

(define-warp disk warp-disk u v)
(define-warp cosine-hemisphere warp-cosine-hemisphere u v)
(define-warp uniform-hemisphere warp-uniform-hemisphere u v)
(define-warp uniform-sphere warp-uniform-sphere u v)
(define-warp cone warp-cone u v h)
