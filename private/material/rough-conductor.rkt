#lang typed/racket/base
;; RoughConductor: metal with a GGX microsurface, from polished to blasted; light that bounces among
;; the microfacets is given back, so rough metal is not too dark.
;; roughness: GGX alpha itself, from 0 (a mirror; below 1e-4 counts as one) over .1 (satin) to 1, or a
;; texture whose luminance it is.
;; The metal is either eta + i k, its complex index of refraction for linear RGB, or color, linear
;; RGB: what it reflects along the normal, rising to white at grazing (Schlick); white by default.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/frame.rkt"
         "../base/check.rkt" "../base/public.rkt" "../sample/sampler.rkt"
         "material.rkt" "kernel.rkt" "scatter.rkt" "fresnel.rkt"
         "microfacet.rkt" "energy.rkt" "compensation.rkt" "roughness.rkt" "texture/texture.rkt")

(provide (struct-out RoughConductor) make-RoughConductor RoughConductor-kernel
         SMOOTH-ROUGHNESS
         gold copper aluminium silver)

(struct RoughConductor Material
  ([roughness : NumberOrTexture] [color : (U #f Float3)] [eta : (U #f Float3)] [k : (U #f Float3)])
  #:transparent)

;; (RoughConductor roughness [color eta k]), the last three also by keyword; color or eta and k.
(: make-RoughConductor (->* ((U Real Texture))
                            ((U #f Float3) (U #f Float3) (U #f Float3)
                             #:color (U #f Float3) #:eta (U #f Float3) #:k (U #f Float3))
                            RoughConductor))
(define (make-RoughConductor roughness [color-by-place #f] [eta-by-place #f] [k-by-place #f]
                             #:color [color color-by-place]
                             #:eta [eta eta-by-place] #:k [k k-by-place])
  (define alpha (check-number-or-texture 'RoughConductor "roughness" roughness))
  (cond
    [(and eta k (not color))
     (RoughConductor alpha #f
                     (check-color 'RoughConductor "eta" eta) (check-color 'RoughConductor "k" k))]
    [(or eta k) (raise-expected 'RoughConductor "eta and k" "both of them and no color"
                                (list color eta k))]
    [else
     (RoughConductor alpha
                     (check-albedo 'RoughConductor "color" (or color (make-Float3 1 1 1)))
                     #f #f)]))

(define-constructor RoughConductor make-RoughConductor (roughness color eta k))

;; Measured indices at 650, 550 and 450 nm, by the line between the nearest two of the published
;; wavelengths. Gold, copper and silver: Johnson and Christy, "Optical Constants of the Noble
;; Metals", 1972. Aluminium: Rakic, "Algorithm for the Determination of Intrinsic Optical Constants
;; of Metal Films", 1995.
(define-syntax-rule (define-metal name (er eg eb) (kr kg kb))
  (begin
    (: name (->* () ((U Real Texture)) RoughConductor))
    (define (name [roughness : (U Real Texture) 0.1])
      (make-RoughConductor roughness #:eta (make-Float3 er eg eb) #:k (make-Float3 kr kg kb)))))

(define-metal gold (0.156 0.424 1.383) (3.602 2.472 1.915))
(define-metal copper (0.238 1.007 1.240) (3.626 2.582 2.393))
(define-metal silver (0.052 0.060 0.040) (4.409 3.597 2.648))
(define-metal aluminium (1.558 1.015 0.633) (7.712 6.627 5.454))

(define-syntax-rule (SMOOTH-ROUGHNESS) 1e-4)

(: RoughConductor-kernel (-> RoughConductor MaterialKernel))
(define (RoughConductor-kernel material)
  (define roughness (RoughConductor-roughness material))
  (if (flonum? roughness)
      (kernel-at material roughness)
      (roughness-kernel roughness (lambda ([alpha : Flonum]) (kernel-at material alpha)))))

(: kernel-at (-> RoughConductor Flonum MaterialKernel))
(define (kernel-at material alpha)
  (define smooth? (fl< alpha (SMOOTH-ROUGHNESS)))
  (define color (RoughConductor-color material))
  (define eta (RoughConductor-eta material))
  (define k (RoughConductor-k material))
  (cond
    [(and eta k)
     (define (average [eta : Flonum] [k : Flonum]) : Flonum
       (average-over-cosine (lambda ([c : Flonum]) (Fresnel-conductor c eta k))))
     (if smooth?
         (mirror-kernel (cosine) (Fresnel-conductor-color cosine eta k))
         (rough-kernel alpha
                       (Float3 (average (Float3-x eta) (Float3-x k))
                               (average (Float3-y eta) (Float3-y k))
                               (average (Float3-z eta) (Float3-z k)))
                       (cosine) (Fresnel-conductor-color cosine eta k)))]
    [else
     (define tint (or color (make-Float3 1 1 1)))
     ;; the average over the hemisphere of Schlick's formula
     (define (average [c : Flonum]) : Flonum (fl/ (fl+ (fl* 20.0 c) 1.0) 21.0))
     (if smooth?
         (mirror-kernel (cosine) (Fresnel-schlick-color cosine tint))
         (rough-kernel alpha
                       (Float3 (average (Float3-x tint)) (average (Float3-y tint))
                               (average (Float3-z tint)))
                       (cosine) (Fresnel-schlick-color cosine tint)))]))

(define-float3-operation (Fresnel-schlick-color [cosine : Flonum] [(x y z) : Float3])
  #:let ([d (flmax 0.0 (fl- 1.0 cosine))] [dd (fl* d d)] [s (fl* d (fl* dd dd))])
  : Float3 ((fl+ x (fl* s (fl- 1.0 x))) (fl+ y (fl* s (fl- 1.0 y))) (fl+ z (fl* s (fl- 1.0 z)))))

(define-syntax-rule (mirror-kernel (angle) fresnel)
  (specular-kernel
   (lambda ([r : FlVector] [i : FxVector])
     (let-facing-normal r (n out cosine)
       (let ([angle cosine])
         (put-specular! r (Float3-reflect out n) fresnel))))))

;; Two lobes, the second one chosen as often as single scattering loses light: visible normals, and
;; the compensation. Directions below the surface are absorbed. The sampled direction is evaluated
;; as any other is, so that both agree to the last bit. Draws one pair.
(define-syntax-rule (rough-kernel alpha average-fresnel (angle) fresnel)
  (let* ([compensation (make-compensation (conductor-losses alpha) alpha)]
         [rows (Compensation-rows compensation)]
         [average (Compensation-average compensation)]
         [tint (multiple-scattering-tint average-fresnel average)]
         [evaluate
          (lambda ([r : FlVector] [i : FxVector])
            (let-facing-normal r (n out o-cosine)
              (let-float3 ([in (Float3-in r in-direction)]
                           [sum (Float3-add out in)]
                           [across (Float3-cross n sum)])
                (let* ([i-cosine (flmin 1.0 (Float3-dot n in))]
                       [along (fl+ o-cosine i-cosine)]
                       [squared (Float3-length-squared sum)]
                       [angle (fl* 0.5 (flsqrt squared))]
                       [distribution
                        (GGX-distribution (fl/ (Float3-length-squared across) squared)
                                          (fl/ (fl* along along) squared) alpha)]
                       [o-length (GGX-length o-cosine alpha)]
                       [visible (fl/ distribution (fl* 2.0 (fl+ o-cosine o-length)))])
                  (let-loss (o-loss unused) (rows alpha o-cosine)
                    (cond
                      [(fl> i-cosine 0.0)
                       (let-loss (i-loss i-density) (rows alpha i-cosine)
                         (let* ([i-length (GGX-length i-cosine alpha)]
                                [single
                                 (fl* (fl* 0.25 distribution)
                                      (GGX-masking o-cosine o-length i-cosine i-length))]
                                [multiple (fl* (fl* o-loss i-loss) i-cosine)])
                           (Float3-put! r bsdf-weight
                                        (Float3-multiply-add
                                         (Float3-scale-by-scalar fresnel single) multiple tint))
                           (flvector-set! r bsdf-density
                                          (fl+ (fl* (fl- 1.0 o-loss) visible)
                                               (fl* o-loss i-density)))))]
                      [else
                       (Float3-put! r bsdf-weight (Float3 0.0 0.0 0.0))
                       (flvector-set! r bsdf-density
                                      (if (fl> along 0.0) (fl* (fl- 1.0 o-loss) visible) 0.0))]))))))])
    (MaterialKernel
     (lambda ([r : FlVector] [i : FxVector])
       (sample-next-pair! r i)
       (if (choose-by-loss! rows alpha r sample-u)
           (sample-compensation! rows 1.0 r)
           (sample-visible-reflection! alpha r))
       (evaluate r i)
       (divide-by-density! r))
     evaluate
     #f #f #f)))

;; A direction that a visible normal, chosen by sample-u and sample-v, reflects to.
(: sample-visible-reflection! (-> Flonum FlVector Void))
(define (sample-visible-reflection! alpha r)
  (let-facing-normal r (n out cosine)
    (let-frame (tangent bitangent) n
      (let-float3 ([o (Float3 (Float3-dot tangent out) (Float3-dot bitangent out) cosine)])
        (let-visible-normal h (o alpha (flvector-ref r sample-u) (flvector-ref r sample-v))
          (Float3-put! r in-direction
                       (Frame-to-world tangent bitangent n (Float3-reflect o h))))))))

;; What multiple scattering keeps of each colour, over pi and the average loss: light that comes
;; back at the bounces after the first, each of which reflects the average Fresnel term (Kulla and
;; Conty 2017; squared, since two bounces are the least).
(: multiple-scattering-tint (-> Float3 Flonum Float3))
(define (multiple-scattering-tint fresnel lost)
  (define (component [f : Flonum]) : Flonum
    (fl/ (fl/ (fl* (fl* f f) (fl- 1.0 lost)) (fl- 1.0 (fl* f lost)))
         (fl* 3.141592653589793 lost)))
  (Float3 (component (Float3-x fresnel)) (component (Float3-y fresnel))
          (component (Float3-z fresnel))))
