#lang typed/racket/base
;; The isotropic GGX microsurface (Walter et al., "Microfacet Models for Refraction", EGSR 2007) as
;; operations that fuse in kernels: distribution of normals, Smith masking, visible normals.
;; alpha > 0 is the width of the distribution of slopes; cosines are those to the mean normal.
;; Nothing subtracts nearly equal numbers, so alpha = 1e-4 and grazing directions keep their digits.
(require "../base/unsafe.rkt" "../base/float3.rkt" "../sample/circle.rkt")

(provide GGX-distribution GGX-length GGX-lambda GGX-masking GGX-masked-share
         GGX-visible-density let-visible-normal
         GGX-distribution/function GGX-length/function GGX-lambda/function)

;; D: area of the microfacets with a normal of that sine and cosine squared, per solid angle and per
;; area of the mean plane.
(define-float3-operation
  (GGX-distribution [sine-squared : Flonum] [cosine-squared : Flonum] [alpha : Flonum])
  #:let ([a (fl* alpha alpha)]
         [length (fl+ sine-squared (fl* a cosine-squared))])
  : Flonum (fl/ a (fl* 3.141592653589793 (fl* length length))))

;; The length of a unit direction once the surface is stretched to roughness 1; it is
;; cosine (1 + 2 Lambda). Not 0 in the mean plane, where Lambda is infinite.
(define-float3-operation (GGX-length [cosine : Flonum] [alpha : Flonum])
  : Flonum (flsqrt (fl+ (fl* cosine cosine)
                        (fl* (fl* alpha alpha) (fl* (fl- 1.0 cosine) (fl+ 1.0 cosine))))))

;; Smith's Lambda: area that is masked over area that is visible. cosine > 0.
(define-float3-operation (GGX-lambda [cosine : Flonum] [alpha : Flonum])
  #:let ([slope (fl* (fl* alpha alpha) (fl* (fl- 1.0 cosine) (fl+ 1.0 cosine)))])
  : Flonum (fl/ slope
                (fl* (fl* 2.0 cosine) (fl+ cosine (flsqrt (fl+ (fl* cosine cosine) slope))))))

;; G2 / (o.n), for height-correlated masking G2 = 1 / (1 + Lambda(o) + Lambda(i)) (Heitz, JCGT 2014),
;; from the cosines, at least 0, and the lengths of o and i.
(define-syntax-rule (GGX-masking o-cosine o-length i-cosine i-length)
  (fl/ (fl* 2.0 i-cosine) (fl+ (fl* i-cosine o-length) (fl* o-cosine i-length))))

;; 1 - G2 / G1(o): of the light that leaves a visible facet towards i, the share that meets the
;; surface again.
(define-syntax-rule (GGX-masked-share o-cosine o-length i-cosine alpha)
  (let* ([slope (fl* (fl* alpha alpha) (flmax 0.0 (fl* (fl- 1.0 i-cosine) (fl+ 1.0 i-cosine))))]
         [i-length (flsqrt (fl+ (fl* i-cosine i-cosine) slope))])
    (fl/ (fl* o-cosine slope)
         (fl* (fl+ i-length i-cosine)
              (fl+ (fl* i-cosine o-length) (fl* o-cosine i-length))))))

;; Density of the normals visible from o, per solid angle of h: G1(o) (o.h) D(h) / (o.n), from
;; o.h >= 0 and D(h).
(define-syntax-rule (GGX-visible-density o-cosine o-length o-h distribution)
  (fl/ (fl* 2.0 (fl* o-h distribution)) (fl+ o-cosine o-length)))

(define-float3-operation (stretched [(x y z) : Float3] [alpha : Flonum])
  : Float3 ((fl* alpha x) (fl* alpha y) z))

;; A point of the unit sphere, uniform above the height -s.z, but with s.z added to its height.
(define-circle-operation (raised-cap-point [(sx sy sz) : Float3] [u : Flonum] [v : Flonum])
  #:let ([top (fl+ 1.0 sz)]
         [height (fl* (fl- 1.0 u) top)])
  ;; the radius is sqrt((1 - z)(1 + z)), where 1 - z is u top
  (flsqrt (fl* (fl* u top) (fl+ height (fl/ (fl+ (fl* sx sx) (fl* sy sy)) top))))
  v height)

(define-float3-operation (add-horizontally [(ax ay az) : Float3] [(bx by bz) : Float3])
  : Float3 ((fl+ ax bx) (fl+ ay by) az))

;; (let-visible-normal h (o alpha u v) body ...) binds h to a normal visible from the local unit
;; direction o (o.z >= 0), chosen by the pair (u, v) in [0, 1): once the surface is stretched to
;; roughness 1, visible normals lie halfway between o and the points of a spherical cap (Dupuy and
;; Benyoub, "Sampling Visible GGX Normals with Spherical Caps", HPG 2023).
(define-syntax-rule (let-visible-normal h (o alpha u v) body ...)
  (let-float3 ([standard (Float3-normalized (stretched o alpha))]
               [h (Float3-normalized
                   (stretched (add-horizontally (raised-cap-point standard u v) standard) alpha))])
    body ...))
