#lang typed/racket/base
;; Path tracing: the rendering equation (Kajiya 1986) along one path at a time, iteratively.
;;   L(x, out) = emitted + integral of bsdf(out, in) L(in) cos(in) over directions
;; At each vertex the light is estimated twice, by sampling a light and by sampling the material,
;; and the two are weighted by the balance of their densities (Veach 1997, power heuristic).
(require racket/promise "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt"
         "../sample/sampler.rkt"
         "../material/material.rkt" "../material/kernel.rkt"
         "../light/light.rkt" "../light/choice.rkt"
         "../medium/medium.rkt" "../medium/media.rkt"
         "../world/scene.rkt" "../world/trace.rkt"
         "emission.rkt" "bump.rkt" "media.rkt" "single-scattering.rkt")

(provide path-integrator PathLimits (struct-out PathLimits))

;; max-depth: the most bounces a path takes; light seen directly is 0 bounces, light reflected once
;; is 1. #f for no limit.
(struct PathLimits ([max-depth : (U #f Fixnum)]) #:transparent)

;; Every vertex has its own block of sample dimensions, so that the same dimension always means the
;; same choice: camera 0 and 1, then for vertex k the light's and roulette's numbers, the light's
;; point, and the material's.
(define-syntax-rule (FIRST-DIMENSION) 2)
(define-syntax-rule (DIMENSIONS-A-VERTEX) 8)

;; Roulette starts after this many bounces, and no path survives for sure after the second number.
(define-syntax-rule (ROULETTE-DEPTH) 3)
(define-syntax-rule (MORTAL-DEPTH) 32)

;; A procedure that takes the ray in the scratch and leaves one sample of its radiance there. medium:
;; what the world is filled with, #f for nothing.
(: path-integrator (-> Scene PathLimits (U #f Medium) (-> FlVector FxVector Void)))
(define (path-integrator scene limits medium)
  (define media (path-media scene medium))
  (define kernels (with-bumps scene (force (Scene-material-kernels scene))))
  (define add-emission! (emission-kernel scene))
  (define background (Scene-background scene))
  (define lights (Scene-lights scene))
  (define background-light (Scene-background-light scene))
  (define lights? (> (vector-length lights) 0))
  (define max-depth (or (PathLimits-max-depth limits) (fixnum-literal #xFFFFFFFF)))
  (lambda ([r : FlVector] [i : FxVector])
    (Float3-put! r radiance (Float3 0.0 0.0 0.0))
    (Float3-put! r throughput (Float3 1.0 1.0 1.0))
    (flvector-set! r previous-density +inf.0)
    (when media (start-in-media! (PathMedia-media media) scene r i))
    ;; transmitting?: whether the last vertex sends light through
    (let vertex ([depth : Fixnum 0] [transmitting? : Boolean #f])
      (flvector-set! r ray-limit +inf.0)
      (define met
        (cond
          [media (travel-on! media scene (fx< depth max-depth) depth r i)]
          [(Scene-nearest! scene r i) (SURFACE)]
          [else (NOTHING)]))
      (cond
        [(fx= met (SURFACE))
         (when add-emission! (put-emission-weight! scene lights media transmitting? r i))
         (Scene-surface! scene r i)
         (when add-emission! (add-emission! r i))
         (when media (forget-segment! r))
         (when (fx< depth max-depth)
           (let ([kernel (vector-ref kernels (fxvector-ref i hit-material))])
             (fxvector-set! i sampler-dimension
                            (fx+ (FIRST-DIMENSION) (fx* depth (DIMENSIONS-A-VERTEX))))
             (let ([prepare (MaterialKernel-prepare kernel)])
               (when prepare
                 (Scene-uv! scene r i)
                 (prepare r i)))
             (face-ray! r i)
             (when (and lights? (not (MaterialKernel-specular? kernel)))
               (add-direct-light! scene lights media kernel r i))
             ((MaterialKernel-sample kernel) r i)
             (when media (cross-surface! (PathMedia-media media) media-count r i))
             (when (and (scatter! r) (survives-roulette? depth r i))
               (vertex (fx+ depth 1) (MaterialKernel-transmits? kernel)))))]
        [(fx= met (NOTHING))
         (background r i)
         (cond
           [(fx< background-light 0) (flvector-set! r light-density 1.0)]
           [else (put-light-weight! scene lights media background-light transmitting? r i)])
         (Float3-put! r radiance
                      (Float3-multiply-add (Float3-in r radiance)
                                           (flvector-ref r light-density)
                                           (Float3-scale-by-vector (Float3-in r throughput)
                                                                   (Float3-in r surface-color))))]
        [(and media (fx< depth max-depth))
         (let ([kernel (PathMedia-phase media)])
           (fxvector-set! i sampler-dimension
                          (fx+ (FIRST-DIMENSION) (fx* depth (DIMENSIONS-A-VERTEX))))
           (when lights? (add-direct-light! scene lights media kernel r i))
           ((MaterialKernel-sample kernel) r i)
           (when (and (scatter! r) (survives-roulette? depth r i))
             (vertex (fx+ depth 1) #t)))]))))

;; From the ray in the scratch to what it comes to; light is gathered on the way if another bounce is
;; allowed.
(: travel-on! (-> PathMedia Scene Boolean Fixnum FlVector FxVector Fixnum))
(define (travel-on! media scene bounces? depth r i)
  (travel! (PathMedia-media media) scene (and bounces? (PathMedia-add-lit! media)) depth r i))

;; The power heuristic with exponent 2: the weight of a sample of density `own`.
(define-syntax-rule (power-heuristic own other)
  (let ([ratio (fl/ other own)])
    (fl/ 1.0 (fl+ 1.0 (fl* ratio ratio)))))

;; Before the new surface replaces the last one: the weight of light found by scattering, given
;; that the last vertex could have sampled the light that was hit. Left in light-density.
(: put-emission-weight! (-> Scene (Vectorof LightKernel) (U #f PathMedia) Boolean FlVector FxVector
                            Void))
(define (put-emission-weight! scene lights media transmitting? r i)
  (define known (fxvector-ref (Scene-primitive-lights scene) (fxvector-ref i hit-primitive)))
  ;; below -1: one of a composite's parts
  (define light
    (if (fx< known -1) ((vector-ref (Scene-part-lights scene) (fx- -2 known)) i) known))
  (if (fx< light 0)
      (flvector-set! r light-density 1.0)
      (put-light-weight! scene lights media light transmitting? r i)))

;; The same for a light of that number.
(: put-light-weight! (-> Scene (Vectorof LightKernel) (U #f PathMedia) Fixnum Boolean
                         FlVector FxVector Void))
(define (put-light-weight! scene lights media light transmitting? r i)
  (cond
    [(fl= (flvector-ref r previous-density) +inf.0) (flvector-set! r light-density 1.0)]
    [else
     ((LightKernel-density (vector-ref lights light)) r i)
     (put-light-probability! (Scene-light-choice scene) light transmitting? r)
     (when media (compete-as-hit! scene (PathMedia-pivots media) light r))
     (let ([own (flvector-ref r previous-density)]
           [other (fl* (flvector-ref r light-density) (flvector-ref r (light-probability)))])
       (flvector-set! r light-density (power-heuristic own other)))]))

;; Turns the normals to the side the ray came from, and notes whether that is the inside.
(define-syntax-rule (face-ray! r i)
  (let-float3 ([n (Float3-in r surface-normal)] [d (Float3-in r ray-direction)]
               [shading-normal (Float3-in r surface-shading-normal)])
    (Float3-put! r out-direction (Float3-negate (Float3-normalized d)))
    (cond
      [(fl> (Float3-dot n d) 0.0)
       (fxvector-set! i surface-inside 1)
       (Float3-put! r surface-normal (Float3-negate n))
       (Float3-put! r surface-shading-normal (Float3-negate shading-normal))]
      [else (fxvector-set! i surface-inside 0)])))

;; Next-event estimation: one light, one point on it, one shadow ray if anything could arrive.
(: add-direct-light! (-> Scene (Vectorof LightKernel) (U #f PathMedia) MaterialKernel
                         FlVector FxVector Void))
(define (add-direct-light! scene lights media kernel r i)
  (define count (vector-length lights))
  (define number
    (cond
      [(eqv? count 1) 0]
      [else (sample-next-pair! r i)
            (choose-light! (Scene-light-choice scene) (MaterialKernel-transmits? kernel) r)]))
  (define light (vector-ref lights number))
  (fxvector-set! i sampler-dimension
                 (fx+ (fxvector-ref i sampler-dimension) (if (eqv? count 1) 1 0)))
  (sample-next-pair! r i)
  ((LightKernel-sample light) r i)
  (unless (eqv? count 1) (count-choice! r))
  (when (fl> (Float3-largest-component (Float3-in r light-radiance)) 0.0)
    (Float3-put! r in-direction (Float3-in r light-direction))
    (when (or (fl> (Float3-dot (Float3-in r light-direction) (Float3-in r surface-normal)) 0.0)
              (MaterialKernel-transmits? kernel))
      ((MaterialKernel-evaluate kernel) r i)
      (when (fl> (Float3-largest-component (Float3-in r bsdf-weight)) 0.0)
        (when media (compete-as-sample! scene (PathMedia-pivots media) number r))
        (put-ray-along-in-direction! r)
        (flvector-set! r ray-limit (fl* (flvector-ref r light-distance) 0.9999999999990905))
        (fxvector-set! i ignored-primitive (LightKernel-primitive light))
        (let ([dark? (if media
                         (not (light-left? (PathMedia-media media) scene r i))
                         (Scene-occluded? scene r i))])
          (fxvector-set! i ignored-primitive -1)
          (unless dark? (add-light-sample! r)))))))

;; That this light was chosen is part of the sample's density.
(define-syntax-rule (count-choice! r)
  (let ([probability (flvector-ref r (light-probability))])
    (flvector-set! r light-density (fl* (flvector-ref r light-density) probability))
    (Float3-put! r light-radiance
                 (Float3-scale-by-scalar (Float3-in r light-radiance) (fl/ 1.0 probability)))))

(: add-light-sample! (-> FlVector Void))
(define (add-light-sample! r)
  (let* ([density (flvector-ref r light-density)]
         [weight (if (fl= density +inf.0)
                     1.0
                     (power-heuristic density (flvector-ref r bsdf-density)))])
    (Float3-put! r radiance
                 (Float3-multiply-add
                  (Float3-in r radiance)
                  weight
                  (Float3-scale-by-vector
                   (Float3-in r throughput)
                   (Float3-scale-by-vector (Float3-in r bsdf-weight)
                                           (Float3-in r light-radiance)))))))

;; The ray from the surface along in-direction, started on the side it goes to.
(define-syntax-rule (put-ray-along-in-direction! r)
  (let-float3 ([n (Float3-in r surface-normal)] [d (Float3-in r in-direction)])
    (let ([away (if (fl< (Float3-dot n d) 0.0) -1.0 1.0)])
      (Float3-put! r ray-origin
                   (Float3-multiply-add (Float3-in r surface-point)
                                        (fl* away (flvector-ref r surface-error)) n))
      (Float3-put! r ray-direction d))))

;; Goes on in the sampled direction; whether anything is left to carry.
(: scatter! (-> FlVector Boolean))
(define (scatter! r)
  (let-float3 ([carried (Float3-scale-by-vector (Float3-in r throughput)
                                                (Float3-in r bsdf-weight))])
    (and (fl> (Float3-largest-component carried) 0.0)
         (begin
           (Float3-put! r throughput carried)
           (flvector-set! r previous-density (flvector-ref r bsdf-density))
           (put-ray-along-in-direction! r)
           #t))))

;; Russian roulette by what the path still carries (Arvo and Kirk 1990).
(: survives-roulette? (-> Fixnum FlVector FxVector Boolean))
(define (survives-roulette? depth r i)
  (or (fx< depth (ROULETTE-DEPTH))
      (let* ([carried (Float3-largest-component (Float3-in r throughput))]
             [chance (if (fx< depth (MORTAL-DEPTH))
                         (if (fl< carried 1.0) carried 1.0)
                         (if (fl< carried 0.95) carried 0.95))])
        (or (fl= chance 1.0)
            (roulette! depth chance r i)))))

(: roulette! (-> Fixnum Flonum FlVector FxVector Boolean))
(define (roulette! depth chance r i)
  (fxvector-set! i sampler-dimension
                 (fx+ (fx+ (FIRST-DIMENSION) (fx- (DIMENSIONS-A-VERTEX) 1))
                      (fx* depth (DIMENSIONS-A-VERTEX))))
  (sample-next-pair! r i)
  (and (fl< (flvector-ref r sample-u) chance)
       (begin
         (Float3-put! r throughput
                      (Float3-scale-by-scalar (Float3-in r throughput) (fl/ 1.0 chance)))
         #t)))
