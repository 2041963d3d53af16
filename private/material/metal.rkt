#lang typed/racket/base
;; Metal: the metal of "Ray Tracing in One Weekend", a mirror whose rays are nudged at random.
;; albedo: linear RGB tint, the part of the light that is reflected, each component from 0 to 1, or
;; a texture that shows it.
;; fuzz: how far, from 0 (a mirror) to 1 (blurred like brushed steel; the rim grows dark, since
;; rays nudged below the surface are lost), or a texture whose luminance it is.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../base/public.rkt" "../sample/sampler.rkt" "../sample/warp.rkt"
         "material.rkt" "kernel.rkt" "scatter.rkt" "mirror.rkt"
         "roughness.rkt" "texture/texture.rkt" "texture/kernels.rkt")

(provide (struct-out Metal) make-Metal Metal-kernel)

(struct Metal Material ([albedo : ColorOrTexture] [fuzz : NumberOrTexture]) #:transparent)

;; (Metal albedo [fuzz 0]).
(: make-Metal (->* (ColorOrTexture) ((U Real Texture) #:fuzz (U Real Texture)) Metal))
(define (make-Metal albedo [fuzz-by-place 0.0] #:fuzz [fuzz fuzz-by-place])
  (Metal (check-albedo-or-texture 'Metal "albedo" albedo)
         (check-number-or-texture 'Metal "fuzz" fuzz)))

(define-constructor Metal make-Metal (albedo fuzz))

;; The direction is reflect(d, n) + fuzz p, p uniform in the unit ball, absorbed where that points
;; below the surface. The book gives no density for it, so it counts as specular: lights are only
;; found by chance. Draws two pairs: p's direction, and its distance as a cube root.
(: Metal-kernel (-> Metal MaterialKernel))
(define (Metal-kernel material)
  (define albedo (Metal-albedo material))
  (define fuzz (Metal-fuzz material))
  (define-values (constant place prepare) (albedo-source albedo))
  (define-syntax-rule (fuzzy-kernel r prepare-both fuzz-here)
    (specular-kernel
     #:prepare prepare-both
     (lambda ([r : FlVector] [i : FxVector])
       (sample-next-pair! r i)
       (Float3-put! r in-direction (warp-uniform-sphere (flvector-ref r sample-u)
                                                        (flvector-ref r sample-v)))
       (sample-next-pair! r i)
       (let-facing-normal r (n out cosine)
         (let ([radius (fl* fuzz-here (flexpt (flvector-ref r sample-u) (fl/ 1.0 3.0)))])
           (let-float3 ([d (Float3-multiply-add (Float3-reflect out n)
                                                radius (Float3-in r in-direction))])
             (if (fl> (Float3-dot d n) 0.0)
                 (put-specular! r (Float3-normalized d) (Float3-in (or constant r) place))
                 (put-nothing! r))))))))
  (cond
    [(not (flonum? fuzz))
     (fuzzy-kernel r (prepare-fuzz (weight-kernel fuzz) prepare)
                   (flvector-ref r surface-roughness))]
    [(fl= fuzz 0.0) (tinted-mirror-kernel albedo)]
    [else (fuzzy-kernel r prepare fuzz)]))

;; Both textures are asked, the albedo's first, whose colour waits in the workspace.
(: prepare-fuzz (-> TextureKernel (U #f TextureKernel) TextureKernel))
(define (prepare-fuzz put-fuzz! put-albedo!)
  (if put-albedo!
      (lambda ([r : FlVector] [i : FxVector])
        (put-albedo! r i)
        (Float3-put! r workspace (Float3-in r surface-color))
        (put-fuzz! r i)
        (Float3-put! r surface-color (Float3-in r workspace)))
      put-fuzz!))
