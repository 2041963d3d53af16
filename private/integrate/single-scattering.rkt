#lang typed/racket/base
;; Light scattered once on the way along a segment: a point is chosen by the angle it has from a light
;; (Kulla and Fajardo, "Importance Sampling Techniques for Path Tracing in Participating Media",
;; 2012), so that it is found near lamps too, where chance by transmittance rarely scatters. Points
;; found both ways are weighted by the balance of the densities.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt"
         "../sample/sampler.rkt" "../material/kernel.rkt" "../light/light.rkt" "../light/choice.rkt"
         "../medium/medium.rkt" "../medium/media.rkt" "../medium/scattering.rkt"
         "../world/scene.rkt" "media.rkt")

(provide PathMedia (struct-out PathMedia) path-media compete-as-sample! compete-as-hit!
         forget-segment!)

;; What paths know of media: the phase functions as a material, lit-segment-kernel's procedure, and
;; light-pivots.
(struct PathMedia
  ([media : Media] [phase : MaterialKernel] [add-lit! : (U #f (-> FlVector FxVector Void))]
   [pivots : FlVector]))

;; path-media : of a scene in a world with that medium; #f where there are none.
(: path-media (-> Scene (U #f Medium) (U #f PathMedia)))
(define (path-media scene medium)
  (define media (pack-media (Scene-materials scene) medium))
  (define pivots (light-pivots (Scene-lights scene)))
  (and media
       (let ([phase (scattering-kernel media)])
         (PathMedia media ((Scene-watch-scattering scene) phase)
                    (lit-segment-kernel media scene phase pivots) pivots))))

;; By light: the middle of its box, half the diagonal (-1 for a light without a box), and what it sends
;; in any direction at most.
(define-syntax-rule (PIVOT-PLACES) 5)
(define-syntax-rule (pivot-radius pivots light)
  (flvector-ref pivots (fx+ 3 (fx* (PIVOT-PLACES) light))))
(define-syntax-rule (pivot-intensity pivots light)
  (flvector-ref pivots (fx+ 4 (fx* (PIVOT-PLACES) light))))

(: light-pivots (-> (Vectorof LightKernel) FlVector))
(define (light-pivots lights)
  (define pivots (make-flvector (* (PIVOT-PLACES) (vector-length lights)) -1.0))
  (for ([light (in-vector lights)] [k : Nonnegative-Fixnum (in-range (vector-length lights))])
    (define bound (LightKernel-bound light))
    (define box (LightBound-box bound))
    (when box
      (let-float3 ([low (Float3-in box 0)] [high (Float3-in box 3)])
        (Float3-put! pivots (fx* (PIVOT-PLACES) k) (Float3-scale-by-scalar (Float3-add low high) 0.5))
        (flvector-set! pivots (fx+ 3 (fx* (PIVOT-PLACES) k))
                       (fl* 0.5 (Float3-length (Float3-subtract high low))))
        (flvector-set! pivots (fx+ 4 (fx* (PIVOT-PLACES) k)) (LightBound-intensity bound)))))
  pivots)

;; Binds where the segment at `at` passes the pivot, how far from it, and the angles at which its
;; ends are seen from there. The distance is at least the light's size: nearer its shape counts.
(define-syntax-rule (let-angles (nearest distance first last) (r at pivots light) body ...)
  (let-float3 ([to-pivot (Float3-subtract (Float3-in pivots (fx* (PIVOT-PLACES) light))
                                          (Float3-in r at))]
               [d (Float3-in r (fx+ at 3))])
    (let* ([nearest (Float3-dot to-pivot d)]
           [radius (pivot-radius pivots light)]
           [aside (Float3-length (Float3-cross to-pivot d))]
           [distance (flmax aside (flmax radius (fl+ 1e-150 (fl* 1e-7 (Float3-length to-pivot)))))]
           [length (flvector-ref r (fx+ at 6))]
           [first (flatan (fl/ (fl* -1.0 nearest) distance))]
           [last (flatan (fl/ (fl- length nearest) distance))])
      body ...)))

;; Up to so many lights are all weighed by what they may send into the whole segment, wherever they
;; shine; more are chosen among as for its middle.
(define-syntax-rule (MOST-WEIGHED) 16)

(define-syntax-rule (light-weight at pivots light r)
  (if (fl< (pivot-radius pivots light) 0.0)
      0.0
      (let-angles (nearest distance first last) (r at pivots light)
        (fl/ (fl* (pivot-intensity pivots light) (fl- last first)) distance))))

(define-syntax-rule (weigh-lights at pivots count r)
  (let add : Flonum ([k : Fixnum 0] [total : Flonum 0.0])
    (if (fx< k count)
        (add (fx+ k 1) (fl+ total (light-weight at pivots k r)))
        total)))

;; The segment's middle into surface-point; its origin if it has no end.
(define-syntax-rule (put-middle! at r)
  (let* ([length (flvector-ref r (fx+ at 6))]
         [half (if (fl< length +inf.0) (fl* 0.5 length) 0.0)])
    (Float3-put! r surface-point
                 (Float3-multiply-add (Float3-in r at) half (Float3-in r (fx+ at 3))))))

;; A part of a whole, 0 of nothing.
(define-syntax-rule (share part whole0) (let ([whole whole0]) (if (fl> whole 0.0) (fl/ part whole) 0.0)))

;; put-distance-ratio! : the density with which the other way would have chosen that light and the
;; distance of the last vertex, over the density of the distance as it was chosen, into
;; distance-ratio; 0 where it could not.
(: put-distance-ratio! (-> Scene FlVector Fixnum FlVector Void))
(define (put-distance-ratio! scene pivots light r)
  (flvector-set! r distance-ratio 0.0)
  (when (and (fl> (flvector-ref r (fx+ last-segment 7)) 0.0)
             (fl>= (pivot-radius pivots light) 0.0))
    (let-angles (nearest distance first last) (r last-segment pivots light)
      (let* ([aside (fl- (flvector-ref r (fx+ last-segment 8)) nearest)]
             [turn (fl* (fl- last first) (fl+ (fl* distance distance) (fl* aside aside)))])
        (flvector-set! r distance-ratio
                       (if (fl> turn 0.0)
                           (fl/ distance (fl* turn (flvector-ref r (fx+ last-segment 7))))
                           0.0))))
    (times-choice! scene pivots light r)))

;; Times the probability that the light is chosen for the segment; surface-point and
;; light-probability stay.
(: times-choice! (-> Scene FlVector Fixnum FlVector Void))
(define (times-choice! scene pivots light r)
  (define count (vector-length (Scene-lights scene)))
  (cond
    [(eqv? 1 count) (void)]
    [(fx<= count (MOST-WEIGHED))
     (let* ([total (weigh-lights last-segment pivots count r)]
            [own (light-weight last-segment pivots light r)])
       (flvector-set! r distance-ratio
                      (fl* (flvector-ref r distance-ratio) (share own total))))]
    [else
     (Float3-put! r (fx+ workspace 16) (Float3-in r surface-point))
     (flvector-set! r (fx+ workspace 19) (flvector-ref r (light-probability)))
     (put-middle! last-segment r)
     (put-light-probability! (Scene-light-choice scene) light #t r)
     (flvector-set! r distance-ratio
                    (fl* (flvector-ref r distance-ratio) (flvector-ref r (light-probability))))
     (Float3-put! r surface-point (Float3-in r (fx+ workspace 16)))
     (flvector-set! r (light-probability) (flvector-ref r (fx+ workspace 19)))]))

;; The light for the segment in the scratch, by the number in sample-u; its probability into
;; light-probability.
(: choose-for-segment! (-> Scene FlVector FlVector Fixnum))
(define (choose-for-segment! scene pivots r)
  (define count (vector-length (Scene-lights scene)))
  (flvector-set! r (light-probability) 1.0)
  (cond
    [(eqv? 1 count) 0]
    [(fx<= count (MOST-WEIGHED))
     (let* ([total (weigh-lights segment-origin pivots count r)])
       (let find ([k : Fixnum 0] [left : Flonum (fl* total (flvector-ref r sample-u))])
         (let ([own (light-weight segment-origin pivots k r)])
           (cond
             [(or (fl< left own) (fx= k (fx- count 1)))
              (flvector-set! r (light-probability) (share own total))
              k]
             [else (find (fx+ k 1) (fl- left own))]))))]
    [else
     (put-middle! segment-origin r)
     (choose-light! (Scene-light-choice scene) #t r)]))

;; After a vertex on a surface there is no other way.
(define-syntax-rule (forget-segment! r) (flvector-set! r (fx+ last-segment 7) 0.0))

;; compete-as-sample! : a light's sample at the last vertex is weighted against both other ways: by
;; bsdf-density, or in its radiance where no scattered ray can find the light.
(: compete-as-sample! (-> Scene FlVector Fixnum FlVector Void))
(define (compete-as-sample! scene pivots light r)
  (put-distance-ratio! scene pivots light r)
  (let* ([chosen (if (eqv? 1 (vector-length (Scene-lights scene)))
                     1.0
                     (flvector-ref r (light-probability)))]
         [ratio (fl/ (flvector-ref r distance-ratio) chosen)]
         [density (flvector-ref r light-density)])
    (if (fl= density +inf.0)
        (Float3-put! r light-radiance
                     (Float3-scale-by-scalar (Float3-in r light-radiance)
                                             (fl/ 1.0 (fl+ 1.0 (fl* ratio ratio)))))
        (flvector-set! r bsdf-density
                       (root-of-squares (flvector-ref r bsdf-density) (fl* density ratio))))))

;; compete-as-hit! : the same where a scattered ray has found the light: by light-probability.
(: compete-as-hit! (-> Scene FlVector Fixnum FlVector Void))
(define (compete-as-hit! scene pivots light r)
  (put-distance-ratio! scene pivots light r)
  (flvector-set! r (light-probability)
                 (root-of-squares (flvector-ref r (light-probability))
                                  (flvector-ref r distance-ratio))))

(define-syntax-rule (root-of-squares a b)
  (let ([x a] [y b]) (flsqrt (fl+ (fl* x x) (fl* y y)))))

;; lit-segment-kernel : adds to `radiance` an estimate of what one light sends into the segment in the
;; scratch and the media, whose sums are there too, scatter towards its origin; all that path and hit
;; need is kept. #f where no light has a place.
(: lit-segment-kernel (-> Media Scene MaterialKernel FlVector (U #f (-> FlVector FxVector Void))))
(define (lit-segment-kernel media scene phase pivots)
  (define lights (Scene-lights scene))
  (define count (vector-length lights))
  (define choice (Scene-light-choice scene))

  (: add-lit! (-> FlVector FxVector Void))
  (define (add-lit! r i)
    (keep-segment! r i)
    (sample-next-pair! r i)
    (define light (choose-for-segment! scene pivots r))
    (sample-next-pair! r i)
    (when (fl>= (pivot-radius pivots light) 0.0)
      (choose-point! light r)
      (when (fl> (flvector-ref r segment-t) 0.0)
        (light-point! light r i)))
    (restore-segment! r i))

  ;; A distance into segment-t, its density times the light's into distance-ratio, and over it what
  ;; transmittance would have into segment-density.
  (: choose-point! (-> Fixnum FlVector Void))
  (define (choose-point! light r)
    (let-angles (nearest distance first last) (r segment-origin pivots light)
      (let* ([angle (fl+ first (fl* (flvector-ref r sample-u) (fl- last first)))]
             [aside (fl* distance (fltan angle))]
             [t (fl+ nearest aside)]
             [turn (fl* (fl- last first) (fl+ (fl* distance distance) (fl* aside aside)))]
             [density (fl* (flvector-ref r (light-probability)) (fl/ distance turn))])
        (cond
          [(and (fl> t 0.0) (fl< t (flvector-ref r segment-length)) (fl> density 0.0)
                (fl< density +inf.0))
           (flvector-set! r segment-t t)
           (flvector-set! r distance-ratio density)
           (let-float3 ([carried (Float3-in r throughput)] [e (Float3-in r extinction)])
             (flvector-set! r segment-density
                            (fl/ (collision-density carried e t) density)))]
          [else (flvector-set! r segment-t 0.0)]))))

  ;; The light's sample at the point, weighted against a distance by transmittance with the light's
  ;; sample, and with the phase function's.
  (: light-point! (-> Fixnum FlVector FxVector Void))
  (define (light-point! light r i)
    (define kernel (vector-ref lights light))
    (put-medium-vertex! r i)
    (put-densities! media r i)
    (sample-next-pair! r i)
    ((LightKernel-sample kernel) r i)
    (when (fl> (Float3-largest-component (Float3-in r light-radiance)) 0.0)
      (unless (eqv? count 1) (put-light-probability! choice light #t r))
      (Float3-put! r in-direction (Float3-in r light-direction))
      ((MaterialKernel-evaluate phase) r i)
      (put-carried-light! r)
      (Float3-put! r ray-origin (Float3-in r surface-point))
      (Float3-put! r ray-direction (Float3-in r in-direction))
      (flvector-set! r ray-limit (fl* (flvector-ref r light-distance) 0.9999999999990905))
      (fxvector-set! i ignored-primitive (LightKernel-primitive kernel))
      (let ([left? (light-left? media scene r i)])
        (fxvector-set! i ignored-primitive -1)
        (when left?
          (Float3-put! r radiance (Float3-add (Float3-in r radiance)
                                              (Float3-in r light-radiance)))))))

  ;; All but the shadow: into light-radiance.
  (define-syntax-rule (put-carried-light! r)
    (let* ([by-light (fl* (flvector-ref r (light-probability)) (flvector-ref r segment-density))]
           [sampled (flvector-ref r light-density)]
           [by-phase (if (fl= sampled +inf.0)
                         0.0
                         (fl/ (fl* (flvector-ref r bsdf-density) (flvector-ref r segment-density))
                              sampled))]
           [weight (fl/ 1.0 (fl+ 1.0 (fl+ (fl* by-light by-light) (fl* by-phase by-phase))))]
           [scale (fl/ weight (flvector-ref r distance-ratio))])
      (Float3-put! r light-radiance
                   (Float3-scale-by-scalar
                    (Float3-scale-by-vector
                     (Float3-scale-by-vector (Float3-in r throughput) (Float3-in r scattering))
                     (Float3-scale-by-vector (Float3-in r bsdf-weight) (Float3-in r light-radiance)))
                    scale))
      (put-attenuation! r light-radiance (flvector-ref r segment-t))))

  (and (for/or : Boolean ([k (in-range count)])
         (fl>= (pivot-radius pivots k) 0.0))
       add-lit!))
