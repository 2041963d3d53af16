#lang typed/racket/base
;; What a ray sees that hits nothing: one colour, a gradient from below to above, or a picture.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../base/public.rkt" "../light/light.rkt" "../light/environment.rkt")

(provide Background (struct-out GradientSky) make-GradientSky Background-color
         Background-kernel Background-light-kernel)

;; From `bottom` where a direction points straight down to `top` where it points up, linear in
;; the height of the unit direction: the sky of Ray Tracing in One Weekend.
(struct GradientSky ([bottom : Float3] [top : Float3]) #:transparent)

(: make-GradientSky (-> Float3 Float3 GradientSky))
(define (make-GradientSky bottom top)
  (GradientSky (check-color 'GradientSky "bottom" bottom) (check-color 'GradientSky "top" top)))

(define-constructor GradientSky make-GradientSky (bottom top))

(define-type Background (U Float3 GradientSky EnvironmentMap))

;; One colour that stands for the whole background: its mean over the sphere of directions.
(: Background-color (-> Background Float3))
(define (Background-color background)
  (cond
    [(Float3? background) background]
    [(EnvironmentMap? background) (EnvironmentMap-color background)]
    [else (Float3-linear-interpolate (GradientSky-bottom background) (GradientSky-top background)
                                     0.5)]))

;; The background as a light of its own, where sampling it pays: a picture's bright places are found by
;; no other way. Colours and gradients are found by scattered rays soon enough.
(: Background-light-kernel (-> Background (U #f LightKernel)))
(define (Background-light-kernel background)
  (and (EnvironmentMap? background) (EnvironmentMap-light-kernel background)))

;; A procedure that writes the background seen along ray-direction into surface-color.
(: Background-kernel (-> Background (-> FlVector FxVector Void)))
(define (Background-kernel background)
  (cond
    [(Float3? background)
     (lambda ([r : FlVector] [i : FxVector]) (Float3-put! r surface-color background))]
    [(EnvironmentMap? background) (EnvironmentMap-background background)]
    [else
     (define bottom (GradientSky-bottom background))
     (define top (GradientSky-top background))
     (lambda ([r : FlVector] [i : FxVector])
       (let-float3 ([d (Float3-in r ray-direction)])
         (let ([s (fl* 0.5 (fl+ 1.0 (fl/ (Float3-y d) (Float3-length d))))])
           (Float3-put! r surface-color (Float3-linear-interpolate bottom top s)))))]))
