#lang typed/racket/base
;; What a world's first light sends to a point, for the tests.
(require racket/flonum racket/fixnum
         "../../private/base/registers.rkt" "../../private/base/float3.rkt"
         "../../private/sample/sampler.rkt" "../../private/light/light.rkt"
         "../../private/world/world.rkt" "../../private/world/scene.rkt"
         "../../private/world/trace.rkt")

(provide sample-light light-density-toward light-irradiance light-visible-part)

(: scratch (-> Float3 (Values FlVector FxVector)))
(define (scratch point)
  (define-values (r i) (values (make-flonum-registers) (make-fixnum-registers)))
  (Float3-put! r surface-point point)
  (values r i))

(: first-light (-> World LightKernel))
(define (first-light world) (vector-ref (Scene-lights (World-scene world)) 0))

;; Direction, distance, radiance over density, density: eight numbers.
(: sample-light (-> World Float3 Flonum Flonum (Listof Flonum)))
(define (sample-light world point u v)
  (define-values (r i) (scratch point))
  (flvector-set! r sample-u u)
  (flvector-set! r sample-v v)
  ((LightKernel-sample (first-light world)) r i)
  (: three (-> Fixnum (Listof Flonum)))
  (define (three at) (for/list ([k (in-range 3)]) (flvector-ref r (+ at k))))
  (append (three light-direction) (list (flvector-ref r light-distance)) (three light-radiance)
          (list (flvector-ref r light-density))))

;; The density with which sampling would choose a direction.
(: light-density-toward (-> World Float3 Float3 Flonum))
(define (light-density-toward world point direction)
  (define-values (r i) (scratch point))
  (Float3-put! r in-direction direction)
  ((LightKernel-density (first-light world)) r i)
  (flvector-ref r light-density))

;; An estimate of the red irradiance on a surface of that normal, nothing in between, from `count`
;; samples.
(: light-irradiance (-> World Float3 Float3 Fixnum Fixnum Flonum))
(define (light-irradiance world point normal count seed)
  (define-values (r i) (scratch point))
  (define sample! (LightKernel-sample (first-light world)))
  (Sampler-start! i 0 seed 0)
  (let loop ([k : Fixnum 0] [sum : Flonum 0.0])
    (cond
      [(fx= k count) (fl/ sum (fx->fl count))]
      [else
       (sample-pair! r i 0 k)
       (sample! r i)
       (define cosine (Float3-dot (Float3-in r light-direction) normal))
       (loop (fx+ k 1)
             (if (fl> cosine 0.0) (fl+ sum (fl* cosine (flvector-ref r light-radiance))) sum))])))

;; The part of the light's samples that nothing stands in the way of.
(: light-visible-part (-> World Float3 Fixnum Fixnum Flonum))
(define (light-visible-part world point count seed)
  (define-values (r i) (scratch point))
  (define light (first-light world))
  (define scene (World-scene world))
  (Sampler-start! i 0 seed 0)
  (fxvector-set! i ignored-primitive (LightKernel-primitive light))
  (let loop ([k : Fixnum 0] [seen : Fixnum 0])
    (cond
      [(fx= k count) (fl/ (fx->fl seen) (fx->fl count))]
      [else
       (sample-pair! r i 0 k)
       ((LightKernel-sample light) r i)
       (Float3-put! r ray-origin point)
       (Float3-put! r ray-direction (Float3-in r light-direction))
       (flvector-set! r ray-limit (flvector-ref r light-distance))
       (loop (fx+ k 1) (if (Scene-occluded? scene r i) seen (fx+ seen 1)))])))
