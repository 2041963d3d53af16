#lang typed/racket/base
;; An orthonormal frame around a unit vector (Duff et al., "Building an Orthonormal Basis,
;; Revisited", JCGT 2017): no branch on the direction, no loss of digits near -z.
(require "unsafe.rkt" "float3.rkt")

(provide let-frame Frame-to-world)

;; Binds tangent and bitangent to the frame of the unit vector n, a name bound by let-float3.
(define-syntax-rule (let-frame (tangent bitangent) n body ...)
  (let* ([sign (if (fl< (Float3-z n) 0.0) -1.0 1.0)]
         [a (fl/ -1.0 (fl+ sign (Float3-z n)))]
         [b (fl* (Float3-x n) (fl* (Float3-y n) a))])
    (let-float3 ([tangent (Float3 (fl+ 1.0 (fl* sign (fl* (Float3-x n) (fl* (Float3-x n) a))))
                                  (fl* sign b)
                                  (fl* (fl* -1.0 sign) (Float3-x n)))]
                 [bitangent (Float3 b
                                    (fl+ sign (fl* (Float3-y n) (fl* (Float3-y n) a)))
                                    (fl* -1.0 (Float3-y n)))])
      body ...)))

;; Local coordinates (x along tangent, y along bitangent, z along n) as a world vector.
(define-float3-operation
  (Frame-to-world [(tx ty tz) : Float3] [(bx by bz) : Float3] [(nx ny nz) : Float3]
                  [(x y z) : Float3])
  : Float3 ((fl+ (fl+ (fl* x tx) (fl* y bx)) (fl* z nx))
            (fl+ (fl+ (fl* x ty) (fl* y by)) (fl* z ny))
            (fl+ (fl+ (fl* x tz) (fl* y bz)) (fl* z nz))))
