#lang typed/racket/base
;; Lambertian: matte, equally bright from every side, as chalk or unglazed clay.
;; albedo: linear RGB, the part of the light that is reflected, each component from 0 to 1, or a
;; texture that shows it.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/frame.rkt"
         "../base/check.rkt" "../base/public.rkt" "../sample/sampler.rkt" "../sample/warp.rkt"
         "material.rkt" "kernel.rkt" "texture/texture.rkt" "texture/kernels.rkt")

(provide (struct-out Lambertian) make-Lambertian Lambertian-kernel)

(struct Lambertian Material ([albedo : ColorOrTexture]) #:transparent)

(: make-Lambertian (-> ColorOrTexture Lambertian))
(define (make-Lambertian albedo)
  (Lambertian (check-albedo-or-texture 'Lambertian "albedo" albedo)))

(define-constructor Lambertian make-Lambertian (albedo))

;; Sampled by cosine over pi, so every sample's weight is the albedo.
(: Lambertian-kernel (-> Lambertian MaterialKernel))
(define (Lambertian-kernel material)
  (define-values (constant place prepare) (albedo-source (Lambertian-albedo material)))
  (MaterialKernel
   (lambda ([r : FlVector] [i : FxVector])
     (sample-next-pair! r i)
     (let-float3 ([n (Float3-in r surface-shading-normal)]
                  [local (warp-cosine-hemisphere (flvector-ref r sample-u)
                                                 (flvector-ref r sample-v))])
       (let-frame (tangent bitangent) n
         (Float3-put! r in-direction (Frame-to-world tangent bitangent n local)))
       (Float3-put! r bsdf-weight (Float3-in (or constant r) place))
       (flvector-set! r bsdf-density (fl* (INVERSE-PI) (Float3-z local)))))
   (lambda ([r : FlVector] [i : FxVector])
     (let-float3 ([n (Float3-in r surface-shading-normal)] [d (Float3-in r in-direction)])
       (let ([density (fl* (INVERSE-PI) (flmax 0.0 (Float3-dot n d)))])
         (Float3-put! r bsdf-weight
                      (Float3-scale-by-scalar (Float3-in (or constant r) place) density))
         (flvector-set! r bsdf-density density))))
   #f #f prepare))
