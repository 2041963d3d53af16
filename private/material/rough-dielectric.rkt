#lang typed/racket/base
;; RoughDielectric: glass with a GGX microsurface, from slightly blurred to frosted; light that
;; bounces among the microfacets is given back, so frosted glass is not too dark.
;; ior: index of refraction (water 1.33, glass 1.5, diamond 2.42). roughness: GGX alpha itself, from
;; 0 (clear; below 1e-4 counts as clear) over .1 (etched) to 1, or a texture whose luminance it is.
;; outside-ior: index of the medium around the shape, 1 for air. absorption: per unit of distance inside the shape, linear RGB, as
;; for Dielectric.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/frame.rkt"
         "../base/check.rkt" "../base/public.rkt" "../sample/sampler.rkt"
         "material.rkt" "kernel.rkt" "scatter.rkt" "fresnel.rkt" "dielectric.rkt"
         "microfacet.rkt" "energy.rkt" "compensation.rkt" "rough-conductor.rkt"
         "roughness.rkt" "texture/texture.rkt")

(provide (struct-out RoughDielectric) make-RoughDielectric RoughDielectric-kernel)

(struct RoughDielectric Material
  ([ior : Flonum] [roughness : NumberOrTexture] [absorption : Float3] [outside-ior : Flonum])
  #:transparent)

;; (RoughDielectric ior [roughness absorption outside-ior]), the last three also by keyword.
(: make-RoughDielectric (->* (Real)
                             ((U Real Texture) Float3 Real
                              #:roughness (U Real Texture) #:absorption Float3 #:outside-ior Real)
                             RoughDielectric))
(define (make-RoughDielectric ior [roughness-by-place 0.1]
                              [absorption-by-place (make-Float3 0 0 0)]
                              [outside-ior-by-place 1.0]
                              #:roughness [roughness roughness-by-place]
                              #:absorption [absorption absorption-by-place]
                              #:outside-ior [outside-ior outside-ior-by-place])
  (RoughDielectric (check-positive 'RoughDielectric "ior" ior)
                   (check-number-or-texture 'RoughDielectric "roughness" roughness)
                   (check-color 'RoughDielectric "absorption" absorption)
                   (check-positive 'RoughDielectric "outside-ior" outside-ior)))

(define-constructor RoughDielectric make-RoughDielectric (ior roughness absorption outside-ior))

;; Light is compensated as for the rough conductor, but with a lobe on either side of the boundary.
;; Radiance is not scaled by the squared index on the way through, as for Dielectric; so reciprocity
;; reads n(o)^2 f(o, i) = n(i)^2 f(i, o), and fixes how much of the lobe is transmitted from inside
;; by how much is from outside. (Dividing by the albedo instead would be simpler, but transmit more
;; from inside than reciprocity, and with it thermal equilibrium, allows.)
(: RoughDielectric-kernel (-> RoughDielectric MaterialKernel))
(define (RoughDielectric-kernel material)
  (define roughness (RoughDielectric-roughness material))
  (cond
    [(flonum? roughness) (kernel-at material roughness single-scattering-losses)]
    [(texture-roughnesses roughness)
     (roughness-kernel roughness
                       (lambda ([alpha : Flonum])
                         (kernel-at material alpha single-scattering-losses)))]
    [else
     (define entering (fl/ (RoughDielectric-ior material) (RoughDielectric-outside-ior material)))
     (define entering-table (loss-table entering))
     (define leaving-table (loss-table (fl/ 1.0 entering)))
     (define (losses [alpha : Flonum] [eta : Flonum])
       (table-losses (if (fl= eta entering) entering-table leaving-table) alpha))
     (roughness-kernel roughness (lambda ([alpha : Flonum]) (kernel-at material alpha losses)))]))

;; losses: the column of a roughness and an eta.
(: kernel-at (-> RoughDielectric Flonum (-> Flonum Flonum FlVector) MaterialKernel))
(define (kernel-at material alpha losses)
  (define ior (RoughDielectric-ior material))
  (define outside-ior (RoughDielectric-outside-ior material))
  (define absorption (RoughDielectric-absorption material))
  (define entering (fl/ ior outside-ior))
  (define leaving (fl/ outside-ior ior))
  (cond
    ;; a boundary of equal indices does not scatter, however rough
    [(or (fl< alpha (SMOOTH-ROUGHNESS)) (fl< (flabs (fl- entering 1.0)) 1e-6))
     (Dielectric-kernel (make-Dielectric ior #:absorption absorption #:outside-ior outside-ior))]
    [else
     (define outside (make-compensation (losses alpha entering) alpha))
     (define inside (make-compensation (losses alpha leaving) alpha))
     (define absorbs? (fl> (Float3-largest-component absorption) 0.0))
     (define-values (sample-outside evaluate-outside) (make-side alpha entering outside inside))
     (define-values (sample-inside evaluate-inside) (make-side alpha leaving inside outside))
     (define (on-either-side [from-outside : (-> FlVector FxVector Void)]
                             [from-inside : (-> FlVector FxVector Void)])
       (lambda ([r : FlVector] [i : FxVector])
         (cond
           [(fx= 0 (fxvector-ref i surface-inside)) (from-outside r i)]
           [else
            (from-inside r i)
            (when absorbs? (put-absorbed! r absorption))])))
     (MaterialKernel (on-either-side sample-outside sample-inside)
                     (on-either-side evaluate-outside evaluate-inside)
                     #f #t #f)]))

;; The part of smooth diffuse light that passes to a side of relative index eta.
(: average-transmittance (-> Flonum Flonum))
(define (average-transmittance eta)
  (fl- 1.0 (if (fl>= eta 1.0) (Fresnel-average eta) (Fresnel-average-inside (fl/ 1.0 eta)))))

;; Both kernels for light seen from one side, where the far side has eta times the index. A sample
;; draws two pairs: one number chooses lobe and side, two choose the direction.
(: make-side (-> Flonum Flonum Compensation Compensation
                 (Values (-> FlVector FxVector Void) (-> FlVector FxVector Void))))
(define (make-side alpha eta near far)
  (define near-rows (Compensation-rows near))
  (define far-rows (Compensation-rows far))
  (define near-average (Compensation-average near))
  (define far-average (Compensation-average far))
  ;; the part of the lobe that is transmitted: reciprocal, since transmittances go as n^2
  (define share
    (fl* (average-transmittance eta) (flmin 1.0 (fl/ far-average near-average))))
  (define near-scale (fl/ (fl- 1.0 share) (fl* 3.141592653589793 near-average)))
  (define far-scale (fl/ share (fl* 3.141592653589793 far-average)))
  (: evaluate (-> FlVector FxVector Void))
  (define (evaluate r i)
    (let-facing-normal r (n out o-cosine)
      (let-float3 ([in (Float3-in r in-direction)])
        (let* ([height (Float3-dot n in)]
               [reflects? (fl> height 0.0)]
               [i-cosine (flmin 1.0 (flabs height))])
          ;; the normal of the facet, up to its length and sign
          (let-float3 ([sum (Float3-multiply-add out (if reflects? 1.0 eta) in)]
                       [across (Float3-cross n sum)])
            (let* ([along (Float3-dot n sum)]
                   [squared (Float3-length-squared sum)]
                   [inverse (fl/ (if (fl< along 0.0) -1.0 1.0) (flsqrt squared))]
                   [o-h (fl* inverse (Float3-dot out sum))]
                   [i-h (fl* inverse (Float3-dot in sum))]
                   [cosine (flmin 1.0 (flmax 0.0 o-h))]
                   [reflectance (Fresnel-dielectric cosine eta)]
                   [distribution
                    (GGX-distribution (fl/ (Float3-length-squared across) squared)
                                      (fl/ (fl* along along) squared) alpha)]
                   [o-length (GGX-length o-cosine alpha)]
                   [i-length (GGX-length i-cosine alpha)]
                   [masking (GGX-masking o-cosine o-length i-cosine i-length)]
                   [scattered
                    (cond
                      [reflects? (fl* 0.25 (fl* reflectance distribution))]
                      [(and (fl> o-h 0.0) (fl< i-h 0.0))
                       (fl* (fl* (fl- 1.0 reflectance) distribution)
                            (fl/ (fl* -1.0 (fl* (fl* o-h i-h) (fl* eta eta))) squared))]
                      [else 0.0])]
                   [visible (fl/ (fl* 2.0 scattered) (fl+ o-cosine o-length))])
              (if (fl> i-cosine 0.0)
                  (let-loss (o-loss unused) (near-rows alpha o-cosine)
                    (if reflects?
                        (let-loss (i-loss i-density) (near-rows alpha i-cosine)
                          (put-value! r (fl+ (fl* scattered masking)
                                             (fl* (fl* o-loss i-loss) (fl* i-cosine near-scale)))
                                      (fl+ (fl* (fl- 1.0 o-loss) visible)
                                           (fl* (fl* o-loss (fl- 1.0 share)) i-density))))
                        (let-loss (i-loss i-density) (far-rows alpha i-cosine)
                          (put-value! r (fl+ (fl* scattered masking)
                                             (fl* (fl* o-loss i-loss) (fl* i-cosine far-scale)))
                                      (fl+ (fl* (fl- 1.0 o-loss) visible)
                                           (fl* (fl* o-loss share) i-density))))))
                  (put-nothing! r))))))))
  (values
   (lambda ([r : FlVector] [i : FxVector])
     (sample-next-pair! r i)
     (flvector-set! r workspace (flvector-ref r sample-u))
     (sample-next-pair! r i)
     (cond
       [(choose-by-loss! near-rows alpha r workspace)
        (if (choose-below! r workspace share)
            (sample-compensation! far-rows -1.0 r)
            (sample-compensation! near-rows 1.0 r))
        (evaluate r i)
        (divide-by-density! r)]
       [(sample-visible! alpha eta r)
        (evaluate r i)
        (divide-by-density! r)]
       [else (put-nothing! r)]))
   evaluate))

(define-syntax-rule (put-value! r value density)
  (let ([whole value])
    (Float3-put! r bsdf-weight (Float3 whole whole whole))
    (flvector-set! r bsdf-density density)))

;; A direction that a visible normal, chosen by sample-u and sample-v, reflects or refracts to, by
;; the number in the workspace; #f where that is on the wrong side of the mean plane.
(: sample-visible! (-> Flonum Flonum FlVector Boolean))
(define (sample-visible! alpha eta r)
  (let-facing-normal r (n out cosine)
    (let-frame (tangent bitangent) n
      (let-float3 ([o (Float3 (Float3-dot tangent out) (Float3-dot bitangent out) cosine)])
        (let-visible-normal h (o alpha (flvector-ref r sample-u) (flvector-ref r sample-v))
          (let ([angle (flmin 1.0 (flmax 0.0 (Float3-dot o h)))])
            (if (fl< (flvector-ref r workspace) (Fresnel-dielectric angle eta))
                (let-float3 ([d (Float3-reflect o h)])
                  (Float3-put! r in-direction (Frame-to-world tangent bitangent n d))
                  (fl> (Float3-z d) 0.0))
                (let-float3 ([d (Float3-refract o h eta)])
                  (Float3-put! r in-direction (Frame-to-world tangent bitangent n d))
                  (fl< (Float3-z d) 0.0)))))))))
