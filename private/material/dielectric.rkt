#lang typed/racket/base
;; Dielectric: smooth clear glass, water or diamond, seen through its reflections.
;; ior: index of refraction (water 1.33, glass 1.5, diamond 2.42). outside-ior: that of the medium
;; around the shape, 1 for air. absorption: per unit of distance inside the shape, linear RGB; light
;; fades as exp(-absorption distance) (Beer and Lambert), so thick parts show the colour least
;; absorbed. fresnel: 'exact, or 'schlick for the approximation of "Ray Tracing in One Weekend".
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../base/public.rkt" "../sample/sampler.rkt"
         "material.rkt" "kernel.rkt" "scatter.rkt" "fresnel.rkt")

(provide (struct-out Dielectric) make-Dielectric Dielectric-kernel FresnelFormula)

(define-type FresnelFormula (U 'exact 'schlick))

(struct Dielectric Material
  ([ior : Flonum] [fresnel : FresnelFormula] [absorption : Float3] [outside-ior : Flonum])
  #:transparent)

;; (Dielectric ior [fresnel absorption outside-ior]), the last three also by keyword.
(: make-Dielectric (->* (Real)
                        (FresnelFormula Float3 Real #:fresnel FresnelFormula
                         #:absorption Float3 #:outside-ior Real)
                        Dielectric))
(define (make-Dielectric ior [fresnel-by-place 'exact] [absorption-by-place (make-Float3 0 0 0)]
                         [outside-ior-by-place 1.0]
                         #:fresnel [fresnel fresnel-by-place]
                         #:absorption [absorption absorption-by-place]
                         #:outside-ior [outside-ior outside-ior-by-place])
  (unless (memq fresnel '(exact schlick))
    (raise-expected 'Dielectric "fresnel" "'exact or 'schlick" fresnel))
  (Dielectric (check-positive 'Dielectric "ior" ior)
              fresnel
              (check-color 'Dielectric "absorption" absorption)
              (check-positive 'Dielectric "outside-ior" outside-ior)))

(define-constructor Dielectric make-Dielectric (ior fresnel absorption outside-ior))

;; One number decides between reflection and refraction by the reflected part, so that the weight
;; is 1. As in the book, radiance is not scaled by the squared index on the way through: for light
;; that enters a closed shape and leaves it again the factors cancel. What was absorbed since the
;; last hit is known where the surface is met from inside. Draws one pair.
(: Dielectric-kernel (-> Dielectric MaterialKernel))
(define (Dielectric-kernel material)
  (define schlick? (eq? 'schlick (Dielectric-fresnel material)))
  (define entering (fl/ (Dielectric-ior material) (Dielectric-outside-ior material)))
  (define leaving (fl/ (Dielectric-outside-ior material) (Dielectric-ior material)))
  (define absorption (Dielectric-absorption material))
  (define absorbs? (fl> (Float3-largest-component absorption) 0.0))
  (specular-kernel
   #:transmits? #t
   (lambda ([r : FlVector] [i : FxVector])
     (sample-next-pair! r i)
     (let ([inside? (fx= 1 (fxvector-ref i surface-inside))])
       (let-facing-normal r (n out cosine)
         (let* ([eta (if inside? leaving entering)]
                [reflectance (if schlick?
                                 (Fresnel-schlick-dielectric cosine eta)
                                 (Fresnel-dielectric cosine eta))])
           (if (fl< (flvector-ref r sample-u) reflectance)
               (put-specular! r (Float3-reflect out n) (Float3 1.0 1.0 1.0))
               (put-specular! r (Float3-refract out n eta) (Float3 1.0 1.0 1.0)))))
       (when (and inside? absorbs?)
         (put-absorbed! r absorption))))))
