#lang typed/racket/base
;; Plastic: a matte body under a smooth clear coat, as billiard balls, glazed tiles or varnish.
;; albedo: linear RGB of the body alone, each component from 0 to 1, or a texture that shows it; under
;; the coat it looks darker and more saturated. ior: index of refraction of the coat, from 1 (none) to 100; 1.5 by default.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/frame.rkt"
         "../base/check.rkt" "../base/public.rkt" "../sample/sampler.rkt" "../sample/warp.rkt"
         "material.rkt" "kernel.rkt" "scatter.rkt" "fresnel.rkt"
         "texture/texture.rkt" "texture/kernels.rkt")

(provide (struct-out Plastic) make-Plastic Plastic-kernel)

(struct Plastic Material ([albedo : ColorOrTexture] [ior : Flonum]) #:transparent)

;; (Plastic albedo [ior 1.5]).
(: make-Plastic (->* (ColorOrTexture) (Real #:ior Real) Plastic))
(define (make-Plastic albedo [ior-by-place 1.5] #:ior [ior ior-by-place])
  (Plastic (check-albedo-or-texture 'Plastic "albedo" albedo)
           (check-between 'Plastic "ior" ior 1.0 100.0)))

(define-constructor Plastic make-Plastic (albedo ior))

;; The coat reflects F(out). What enters is scattered by the body and, where the coat throws it
;; back inside, again and again (Saunderson 1942), which sums to the value
;;   (1 - F(in)) (1 - F(out)) albedo / (pi ior^2 (1 - albedo F-inside)),
;; so a white body under any coat returns all light. The coat is sampled as a mirror, the body by
;; cosine over pi, chosen between by what each returns. Draws one pair, whose first number chooses
;; and is stretched again. The density is the body's; both sides of the surface are alike.
(: Plastic-kernel (-> Plastic MaterialKernel))
(define (Plastic-kernel material)
  (define ior (Plastic-ior material))
  (define inside (Fresnel-average-inside ior))
  (define-syntax-rule (summed component) (let ([a component]) (fl/ a (fl- 1.0 (fl* a inside)))))
  (define inverse (fl/ 1.0 (fl* ior ior)))
  (define leaving (fl* (fl* ior ior) (fl- 1.0 inside)))
  ;; Turns an albedo into what the body returns, times pi, of the light that enters before it leaves
  ;; through the coat; and beside it, the part of the light that entered that leaves again.
  (: put-returned! (-> FlVector Fixnum Void))
  (define (put-returned! v at)
    (let-float3 ([albedo (Float3-in v at)]
                 [body (Float3-scale-by-scalar (Float3 (summed (Float3-x albedo))
                                                       (summed (Float3-y albedo))
                                                       (summed (Float3-z albedo)))
                                               inverse)])
      (Float3-put! v at body)
      (flvector-set! v (fx+ at 3) (fl* (Float3-largest-component body) leaving))))
  (define-values (constant place prepare) (albedo-source (Plastic-albedo material) put-returned!))
  (define-syntax-rule (returned r) (flvector-ref (or constant r) (fx+ place 3)))
  (define-syntax-rule (both r coat) (fl+ coat (fl* (fl- 1.0 coat) (returned r))))
  (define-syntax-rule (coat-probability r coat)
    (let ([total (both r coat)]) (if (fl> total 0.0) (fl/ coat total) 1.0)))

  (: sample (-> FlVector FxVector Void))
  (define (sample r i)
    (sample-next-pair! r i)
    (let-facing-normal r (n out cosine)
      (let* ([coat (Fresnel-dielectric cosine ior)]
             [p (coat-probability r coat)]
             [u (flvector-ref r sample-u)])
        (cond
          [(fl< u p)
           (let ([weight (both r coat)])
             (put-specular! r (Float3-reflect out n) (Float3 weight weight weight)))]
          [else
           (let-float3 ([local (warp-cosine-hemisphere (fl/ (fl- u p) (fl- 1.0 p))
                                                       (flvector-ref r sample-v))])
             (let-frame (tangent bitangent) n
               (Float3-put! r in-direction (Frame-to-world tangent bitangent n local)))
             (put-body! r n coat p))]))))

  ;; weight and density of the body for in-direction, the weight divided by the density
  (define-syntax-rule (put-body! r n coat p)
    (let* ([along (flmin 1.0 (Float3-dot n (Float3-in r in-direction)))]
           [through (fl* (fl- 1.0 coat) (fl- 1.0 (Fresnel-dielectric (flmax 0.0 along) ior)))])
      (Float3-put! r bsdf-weight
                   (Float3-scale-by-scalar (Float3-in (or constant r) place)
                                           (fl/ through (fl- 1.0 p))))
      (flvector-set! r bsdf-density (fl* (fl- 1.0 p) (fl* (INVERSE-PI) along)))))

  (: evaluate (-> FlVector FxVector Void))
  (define (evaluate r i)
    (let-facing-normal r (n out cosine)
      (let* ([coat (Fresnel-dielectric cosine ior)]
             [p (coat-probability r coat)])
        (cond
          [(and (fl< p 1.0) (fl> (Float3-dot n (Float3-in r in-direction)) 0.0))
           (put-body! r n coat p)
           (Float3-put! r bsdf-weight
                        (Float3-scale-by-scalar (Float3-in r bsdf-weight)
                                                (flvector-ref r bsdf-density)))]
          [else (put-nothing! r)]))))

  (MaterialKernel sample evaluate #f #f prepare))
