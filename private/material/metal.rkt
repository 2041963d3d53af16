#lang typed/racket/base
;; Metal: the metal of "Ray Tracing in One Weekend", a mirror whose rays are nudged at random.
;; albedo: linear RGB tint, the part of the light that is reflected, each component from 0 to 1, or
;; a texture that shows it.
;; fuzz: how far, from 0 (a mirror) to 1 (blurred like brushed steel; the rim grows dark, since
;; rays nudged below the surface are lost).
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../base/public.rkt" "../sample/sampler.rkt" "../sample/warp.rkt"
         "material.rkt" "kernel.rkt" "scatter.rkt" "mirror.rkt"
         "texture/texture.rkt" "texture/kernels.rkt")

(provide (struct-out Metal) make-Metal Metal-kernel)

(struct Metal Material ([albedo : ColorOrTexture] [fuzz : Flonum]) #:transparent)

;; (Metal albedo [fuzz 0]).
(: make-Metal (->* (ColorOrTexture) (Real #:fuzz Real) Metal))
(define (make-Metal albedo [fuzz-by-place 0.0] #:fuzz [fuzz fuzz-by-place])
  (Metal (check-albedo-or-texture 'Metal "albedo" albedo)
         (check-between 'Metal "fuzz" fuzz 0.0 1.0)))

(define-constructor Metal make-Metal (albedo fuzz))

;; The direction is reflect(d, n) + fuzz p, p uniform in the unit ball, absorbed where that points
;; below the surface. The book gives no density for it, so it counts as specular: lights are only
;; found by chance. Draws two pairs: p's direction, and its distance as a cube root.
(: Metal-kernel (-> Metal MaterialKernel))
(define (Metal-kernel material)
  (define albedo (Metal-albedo material))
  (define fuzz (Metal-fuzz material))
  (define-values (constant place prepare) (albedo-source albedo))
  (if (fl= fuzz 0.0)
      (tinted-mirror-kernel albedo)
      (specular-kernel
       #:prepare prepare
       (lambda ([r : FlVector] [i : FxVector])
         (sample-next-pair! r i)
         (Float3-put! r in-direction (warp-uniform-sphere (flvector-ref r sample-u)
                                                          (flvector-ref r sample-v)))
         (sample-next-pair! r i)
         (let-facing-normal r (n out cosine)
           (let ([radius (fl* fuzz (flexpt (flvector-ref r sample-u) (fl/ 1.0 3.0)))])
             (let-float3 ([d (Float3-multiply-add (Float3-reflect out n)
                                                  radius (Float3-in r in-direction))])
               (if (fl> (Float3-dot d n) 0.0)
                   (put-specular! r (Float3-normalized d) (Float3-in (or constant r) place))
                   (put-nothing! r)))))))))
