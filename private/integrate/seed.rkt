#lang typed/racket/base
;; The article's shading: ambient light under occlusion, Phong's diffuse and highlight from every
;; light behind its shadow, and mirrors; each distributed effect a fold over samples. Colours of
;; surfaces multiply irradiance as they are, without the division by pi of the path integrator.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/frame.rkt"
         "../sample/sampler.rkt" "../sample/warp.rkt"
         "../material/material.rkt" "../material/phong.rkt"
         "../material/texture/texture.rkt" "../material/texture/kernels.rkt"
         "../material/color.rkt" "../light/light.rkt"
         "../world/scene.rkt" "../world/trace.rkt" "../world/gather.rkt" "../world/world.rkt"
         "emission.rkt")

(provide seed-integrator local-shading pack-materials ambient-visibility! face-viewer!
         put-ray-from-surface!)

;; What this integrator knows of a material, packed by number: colour, specularity, shininess,
;; reflectivity.
(define-syntax-rule (STRIDE) 8)
(define-syntax-rule (specularity-place) 3)
(define-syntax-rule (shininess-place) 4)
(define-syntax-rule (reflectivity-place) 5)

(: pack-materials (-> (Vectorof Material) FlVector))
(define (pack-materials materials)
  (define packed (make-flvector (fx* (STRIDE) (vector-length materials)) 0.0))
  (for ([material (in-vector materials)]
        [k : Nonnegative-Fixnum (in-range (vector-length materials))])
    (define at (fx* (STRIDE) k))
    (Float3-put! packed at (Material-color material))
    (when (Phong? material)
      (flvector-set! packed (fx+ at (specularity-place)) (Phong-specularity material))
      (flvector-set! packed (fx+ at (shininess-place)) (Phong-shininess material))
      (Float3-put! packed (fx+ at (reflectivity-place)) (Phong-reflectivity material))))
  packed)

;; seed-integrator : a procedure that takes the ray in the scratch and leaves its colour in
;; `radiance`.
(: seed-integrator (-> Scene Shading (-> FlVector FxVector Void)))
(define (seed-integrator scene shading)
  (define packed (pack-materials (Scene-materials scene)))
  (define add-emission! (emission-kernel scene))
  (define put-color! (color-kernel scene packed))
  (define background (Scene-background scene))
  (define mirror-bounces (Shading-mirror-bounces shading))
  (define shade-locally! (local-shading scene shading packed))
  (lambda ([r : FlVector] [i : FxVector])
    (Float3-put! r radiance (Float3 0.0 0.0 0.0))
    (Float3-put! r throughput (Float3 1.0 1.0 1.0))
    (let follow ([bounces : Fixnum 0])
      (flvector-set! r ray-limit +inf.0)
      (cond
        [(Scene-nearest! scene r i)
         (Scene-surface! scene r i)
         (when add-emission!
           (flvector-set! r light-density 1.0)
           (add-emission! r i))
         (put-color! r i)
         (face-viewer! r)
         (shade-locally! r i)
         (when (and (reflects? packed r i) (fx< bounces mirror-bounces))
           (reflect! packed r i)
           (follow (fx+ bounces 1)))]
        [else
         (background r i)
         (Float3-put! r radiance
                      (Float3-add (Float3-in r radiance)
                                  (Float3-scale-by-vector (Float3-in r throughput)
                                                          (Float3-in r surface-color))))]))))

(define-syntax-rule (material-place i) (fx* (STRIDE) (fxvector-ref i hit-material)))

;; Turns the normals to the side the ray came from, so that both sides of a surface are shaded.
(define-syntax-rule (face-viewer! r)
  (let-float3 ([n (Float3-in r surface-normal)] [d (Float3-in r ray-direction)]
               [shading-normal (Float3-in r surface-shading-normal)])
    (when (fl> (Float3-dot n d) 0.0)
      (Float3-put! r surface-normal (Float3-negate n))
      (Float3-put! r surface-shading-normal (Float3-negate shading-normal)))
    (Float3-put! r out-direction (Float3-negate (Float3-normalized d)))))

(define-syntax-rule (reflects? packed r i)
  (let-float3 ([mirror (Float3-scale-by-vector
                        (Float3-in r throughput)
                        (Float3-in packed (fx+ (material-place i) (reflectivity-place))))])
    (fl> (Float3-largest-component mirror) 0.0)))

;; The ray goes on as from a mirror.
(define-syntax-rule (reflect! packed r i)
  (let-float3 ([mirror (Float3-in packed (fx+ (material-place i) (reflectivity-place)))])
    (Float3-put! r throughput (Float3-scale-by-vector (Float3-in r throughput) mirror))
    (Float3-put! r ray-direction
                 (Float3-reflect (Float3-in r out-direction) (Float3-in r surface-shading-normal)))
    (put-ray-from-surface! r)))

;; Puts ray-origin at the surface, moved along the normal by the bound of the point's error: far
;; enough that the surface is not hit again, at any scale.
(define-syntax-rule (put-ray-from-surface! r)
  (Float3-put! r ray-origin
               (Float3-multiply-add (Float3-in r surface-point)
                                    (flvector-ref r surface-error)
                                    (Float3-in r surface-normal))))

;; A procedure that leaves the colour of the surface in the scratch, its normals still pointing
;; outside, in surface-color.
(: color-kernel (-> Scene FlVector (-> FlVector FxVector Void)))
(define (color-kernel scene packed)
  (define textures : (Vectorof (U #f TextureKernel))
    (for/vector : (Vectorof (U #f TextureKernel)) ([material (in-vector (Scene-materials scene))])
      (and (Phong? material)
           (Texture? (Phong-color material))
           (radiance-kernel (Phong-color material)))))
  (lambda ([r : FlVector] [i : FxVector])
    (define texture! (vector-ref textures (fxvector-ref i hit-material)))
    (cond
      [texture!
       (Scene-uv! scene r i)
       (texture! r i)]
      [else (Float3-put! r surface-color (Float3-in packed (material-place i)))])))

;; A procedure that adds to `radiance`, times throughput, what the surface in the scratch, of colour
;; surface-color, sends towards out-direction without its mirror's share.
(: local-shading (-> Scene Shading FlVector (-> FlVector FxVector Void)))
(define (local-shading scene shading packed)
  (define lights (Scene-lights scene))
  ;; a background's light is the ambient light here
  (define light-count
    (if (fx< (Scene-background-light scene) 0) (vector-length lights) (Scene-background-light scene)))
  (define ambient-color (Shading-ambient-color shading))
  (define ambient-samples (Shading-ambient-samples shading))
  (define ambient? (fl> (Float3-largest-component ambient-color) 0.0))
  (define shadow-samples (Shading-shadow-samples shading))
  (lambda ([r : FlVector] [i : FxVector])
    (define at (material-place i))
    (let-float3 ([mirror (Float3-in packed (fx+ at (reflectivity-place)))]
                 [share (Float3-scale-by-vector (Float3-in r throughput)
                                                (Float3-subtract (Float3 1.0 1.0 1.0) mirror))])
      (Float3-put! r bsdf-weight share))
    (when (fl> (Float3-largest-component (Float3-in r bsdf-weight)) 0.0)
      (when ambient?
        (cond
          [(fx= ambient-samples 0) (flvector-set! r ambient-percent 1.0)]
          [else (ambient-visibility! scene shading r i)])
        (Float3-put! r radiance
                     (Float3-multiply-add
                      (Float3-in r radiance)
                      (flvector-ref r ambient-percent)
                      (Float3-scale-by-vector
                       (Float3-in r bsdf-weight)
                       (Float3-scale-by-vector (Float3-in r surface-color) ambient-color)))))
      (put-ray-from-surface! r)
      (let each-light ([k : Fixnum 0])
        (when (fx< k light-count)
          (add-light! scene (vector-ref lights k) shadow-samples packed r i)
          (each-light (fx+ k 1)))))))

;; Adds the diffuse light and the highlight of one light.
(: add-light! (-> Scene LightKernel Fixnum FlVector FlVector FxVector Void))
(define (add-light! scene light shadow-samples packed r i)
  (define sample! (LightKernel-sample light))
  (define count (if (and (LightKernel-area? light) (fx> shadow-samples 1)) shadow-samples 1))
  (when (LightKernel-area? light) (sample-fold-start! i count))
  (fxvector-set! i ignored-primitive (LightKernel-primitive light))
  (let fold ([n : Fixnum 0])
    (when (fx< n count)
      (when (LightKernel-area? light) (sample-fold-pair! r i n))
      (sample! r i)
      (when (and (light-in-front? r)
                 (or (fx= shadow-samples 0) (not (shadowed? scene r i))))
        (add-phong! packed count r i))
      (fold (fx+ n 1))))
  (fxvector-set! i ignored-primitive -1))

(define-syntax-rule (light-in-front? r)
  (and (fl> (Float3-dot (Float3-in r light-direction) (Float3-in r surface-normal)) 0.0)
       (fl> (Float3-dot (Float3-in r light-direction) (Float3-in r surface-shading-normal)) 0.0)
       (fl> (Float3-largest-component (Float3-in r light-radiance)) 0.0)))

;; The shadow ray ends a little before the light: 2^-40 of the way, so that what the light lies
;; on does not shadow it.
(define-syntax-rule (shadowed? scene r i)
  (begin
    (Float3-put! r ray-direction (Float3-in r light-direction))
    (flvector-set! r ray-limit (fl* (flvector-ref r light-distance) 0.9999999999990905))
    (Scene-occluded? scene r i)))

(: add-phong! (-> FlVector Fixnum FlVector FxVector Void))
(define (add-phong! packed count r i)
  (define at (material-place i))
  (let-float3 ([n (Float3-in r surface-shading-normal)]
               [to-light (Float3-in r light-direction)]
               [view (Float3-in r out-direction)]
               [light (Float3-scale-by-scalar
                       (Float3-scale-by-vector (Float3-in r bsdf-weight)
                                               (Float3-in r light-radiance))
                       (fl/ 1.0 (fx->fl count)))])
    (let* ([cosine (Float3-dot n to-light)]
           [along (Float3-dot (Float3-reflect to-light n) view)]
           [specularity (flvector-ref packed (fx+ at (specularity-place)))]
           [highlight (if (and (fl> specularity 0.0) (fl> along 0.0))
                          (fl* specularity
                               (flexpt along (flvector-ref packed (fx+ at (shininess-place)))))
                          0.0)])
      (Float3-put! r radiance
                   (Float3-add
                    (Float3-in r radiance)
                    (Float3-scale-by-vector
                     light
                     (Float3-add (Float3-scale-by-scalar (Float3-in r surface-color) cosine)
                                 (Float3 highlight highlight highlight))))))))

;; The article's percentage of ambient light at the surface in the scratch, into ambient-percent:
;; the mean over directions of min(1, distance / max-occlusion-distance), or of visibility. Where
;; nothing is near enough to occlude, it is 1 without a ray.
(: ambient-visibility! (-> Scene Shading FlVector FxVector Void))
(define (ambient-visibility! scene shading r i)
  (put-ray-from-surface! r)
  (Scene-gather! scene (Shading-max-occlusion-distance shading) r i)
  (cond
    [(fx= 0 (fxvector-ref i gathered-count))
     (fxvector-set! i sampler-dimension (fx+ 1 (fxvector-ref i sampler-dimension)))
     (flvector-set! r ambient-percent 1.0)]
    [else (fold-visibility! scene shading r i)]))

(: fold-visibility! (-> Scene Shading FlVector FxVector Void))
(define (fold-visibility! scene shading r i)
  (define count (Shading-ambient-samples shading))
  (define max-distance (Shading-max-occlusion-distance shading))
  (define cosine? (eq? 'cosine (Shading-ambient-weighting shading)))
  (define linear? (eq? 'linear (Shading-occlusion-falloff shading)))
  (define gathered? (fx> (fxvector-ref i gathered-count) 0))
  (sample-fold-start! i count)
  (let-float3 ([n (Float3-in r surface-shading-normal)])
    (let-frame (tangent bitangent) n
      (Float3-put! r frame-tangent tangent)
      (Float3-put! r frame-bitangent bitangent)))
  (flvector-set! r ambient-percent 0.0)
  (let fold ([n : Fixnum 0])
    (when (fx< n count)
      (sample-fold-first! r i n)
      (cond
        [(and gathered? (not (gathered-reach? r i (sample-cosine r cosine?))))
         (add-percent! r 1.0)]
        [else
         (sample-fold-second! r i n)
         (put-hemisphere-direction! r cosine?)
         (flvector-set! r ray-limit max-distance)
         (let ([hit? (cond
                       [gathered? (Scene-nearest-gathered! scene r i)]
                       [linear? (Scene-nearest! scene r i)]
                       [else (Scene-occluded? scene r i)])])
           (add-percent! r (cond
                             [(not hit?) 1.0]
                             [linear? (fl/ (flvector-ref r hit-t) max-distance)]
                             [else 0.0])))])
      (fold (fx+ n 1))))
  (flvector-set! r ambient-percent
                 (fl/ (flvector-ref r ambient-percent) (fx->fl count))))

(define-syntax-rule (add-percent! r amount)
  (flvector-set! r ambient-percent (fl+ amount (flvector-ref r ambient-percent))))

;; The cosine to the normal of the direction that put-hemisphere-direction! will make.
(define-syntax-rule (sample-cosine r cosine?)
  (let ([height (fl- 1.0 (flvector-ref r sample-u))])
    (if cosine? (flsqrt height) height)))

(: put-hemisphere-direction! (-> FlVector Boolean Void))
(define (put-hemisphere-direction! r cosine?)
  (define-syntax-rule (put-in-frame! local-direction)
    (let-float3 ([local local-direction])
      (Float3-put! r ray-direction
                   (Frame-to-world (Float3-in r frame-tangent) (Float3-in r frame-bitangent)
                                   (Float3-in r surface-shading-normal) local))))
  (if cosine?
      (put-in-frame! (warp-cosine-hemisphere (flvector-ref r sample-u) (flvector-ref r sample-v)))
      (put-in-frame! (warp-uniform-hemisphere (flvector-ref r sample-u)
                                              (flvector-ref r sample-v)))))
