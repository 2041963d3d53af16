#lang typed/racket/base
;; The article's functions, asked one ray at a time. They run the kernels a render runs, so they
;; give the same numbers.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../sample/sampler.rkt" "../sample/warp.rkt" "../base/frame.rkt"
         "../shape/shape.rkt" "../shape/kernel.rkt" "../shape/kernels.rkt" "../shape/sphere.rkt"
         "../material/color.rkt" "../material/phong.rkt"
         "../world/ray.rkt" "../world/scene.rkt" "../world/trace.rkt" "../world/world.rkt"
         "seed.rkt" "integrators.rkt")

(provide World-nearest-hit World-occluded? World-ray-trace World-get-color-at
         World-get-ambient-percent Shape-intersect Sphere-intersect Sphere-color
         Float3-random-hemisphere-direction Float3-random-point-in-sphere Float3-random-color)

;; A ray ready in a fresh scratch, its samples drawn from the seed.
(: scratch-for (->* (Ray Integer) (Symbol) (Values FlVector FxVector)))
(define (scratch-for ray seed [who 'World-ray-trace])
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (Float3-put! r ray-origin (Ray-point ray))
  (Float3-put! r ray-direction (Ray-direction ray))
  (flvector-set! r ray-limit INTERSECTION-T-MAX)
  (flvector-set! r ray-time (Ray-time ray))
  (Sampler-start! i 0 (check-count who "#:seed" seed 0 #xFFFFFFFF) 0)
  (values r i))

;; World-nearest-hit : what the ray meets first, or an Intersection whose t is INTERSECTION-T-MAX.
(: World-nearest-hit (-> World Ray Intersection))
(define (World-nearest-hit world ray)
  (define scene (World-scene world))
  (define-values (r i) (scratch-for ray 0))
  (cond
    [(Scene-nearest! scene r i)
     (Scene-surface! scene r i)
     (Intersection (flvector-ref r hit-t)
                   (Float3-in r surface-point)
                   (Float3-in r surface-shading-normal)
                   (Material-color
                    (vector-ref (Scene-materials scene) (fxvector-ref i hit-material))))]
    [else (Intersection-empty)]))

;; World-occluded? : whether the ray meets anything nearer than the parameter `limit`.
(: World-occluded? (->* (World Ray) (Real) Boolean))
(define (World-occluded? world ray [limit INTERSECTION-T-MAX])
  (define-values (r i) (scratch-for ray 0))
  (flvector-set! r ray-limit (check-positive-or-infinite 'World-occluded? "limit" limit))
  (Scene-occluded? (World-scene world) r i))

;; World-ray-trace : the colour seen along a ray. Distributed effects draw their samples from
;; #:seed, 0 unless said otherwise: the same call gives the same colour.
(: World-ray-trace (->* (World Ray) (#:seed Integer) Float3))
(define (World-ray-trace world ray #:seed [seed 0])
  (define-values (r i) (scratch-for ray seed))
  ((World-integrator world 'auto) r i)
  (Float3-in r radiance))

;; World-get-color-at : the shaded colour at an intersection of the ray. Where it is the ray's
;; nearest hit, that is what World-ray-trace sees; elsewhere the article's surface is assumed.
(: World-get-color-at (->* (World Ray Intersection) (#:seed Integer) Float3))
(define (World-get-color-at world ray intersection #:seed [seed 0])
  (define nearest (World-nearest-hit world ray))
  (cond
    [(fl= (Intersection-t nearest) (Intersection-t intersection))
     (World-ray-trace world ray #:seed seed)]
    [else
     (define scene (World-scene world))
     (define-values (r i) (scratch-for ray seed 'World-get-color-at))
     (put-surface-at! scene r (Intersection-point intersection) (Intersection-normal intersection))
     (Float3-put! r throughput (Float3 1.0 1.0 1.0))
     (fxvector-set! i hit-material 0)
     (Float3-put! r surface-color (Intersection-color intersection))
     (face-viewer! r)
     ((local-shading scene (World-shading world)
                     (pack-materials (vector (make-Phong (Intersection-color intersection)))))
      r i)
     (Float3-in r radiance)]))

;; World-get-ambient-percent : the share of ambient light that reaches a point with that unit
;; normal: 1 where nothing is near. Directions are uniform over the hemisphere unless the World
;; says cosine (the published program's, drawn from a cube, are neither), and the ray starts off
;; the surface by an error bound instead of a fixed EPSILON.
(: World-get-ambient-percent (->* (World Float3 Float3) (#:seed Integer) Flonum))
(define (World-get-ambient-percent world point normal #:seed [seed 0])
  (define-values (r i) (scratch-for (make-Ray point normal) seed 'World-get-ambient-percent))
  (define scene (World-scene world))
  (put-surface-at! scene r point (Float3-normalized/checked normal))
  (cond
    [(fx= 0 (Shading-ambient-samples (World-shading world))) 1.0]
    [else
     (ambient-visibility! scene (World-shading world) r i)
     (flvector-ref r ambient-percent)]))

;; A surface known only by point and normal: its error is bounded by the world's largest
;; coordinate.
(: put-surface-at! (-> Scene FlVector Float3 Float3 Void))
(define (put-surface-at! scene r point normal)
  (define size (flmax (Scene-extent scene) (Float3-largest-magnitude point)))
  (put-surface! r point normal (fl* (fl* 64.0 (ROUNDING)) size)))

;; Shape-intersect : the first hit of a ray with one shape, as World-nearest-hit for a world.
(: Shape-intersect (-> Shape Ray Intersection))
(define (Shape-intersect shape ray)
  (define kernel (Shape-kernel shape))
  (define-values (r i) (scratch-for ray 0))
  (cond
    [((ShapeKernel-nearest kernel) r i)
     ((ShapeKernel-surface kernel) r i)
     (Intersection (flvector-ref r hit-t) (Float3-in r surface-point)
                   (Float3-in r surface-shading-normal) (Material-color (Shape-material shape)))]
    [else (Intersection-empty)]))

;; The article's name for it. (The published program multiplies by half of a where it means to
;; divide by twice a, subtracts nearly equal numbers in the discriminant, and takes the root of a
;; negative one.)
(: Sphere-intersect (-> Sphere Ray Intersection))
(define (Sphere-intersect sphere ray) (Shape-intersect sphere ray))

;; The article's colour of a sphere: its material's.
(: Sphere-color (-> Sphere Float3))
(define (Sphere-color sphere) (Material-color (Sphere-material sphere)))

;; Float3-random-hemisphere-direction : a unit direction, uniform over the hemisphere of the
;; normal; the index-th of a well-spread sequence that the seed chooses.
(: Float3-random-hemisphere-direction (->* (Float3) (#:seed Integer #:index Integer) Float3))
(define (Float3-random-hemisphere-direction normal #:seed [seed 0] #:index [index 0])
  (define-values (u v) (random-pair 'Float3-random-hemisphere-direction seed index))
  (let-float3 ([n (Float3-normalized/checked normal)] [local (warp-uniform-hemisphere u v)])
    (let-frame (tangent bitangent) n
      (Float3-normalized (Frame-to-world tangent bitangent n local)))))

;; A point uniform in the ball of that radius around the origin (the published one crowds the
;; centre), and a colour uniform in the unit cube; both by seed and index.
(: Float3-random-point-in-sphere (->* (Real) (#:seed Integer #:index Integer) Float3))
(define (Float3-random-point-in-sphere radius #:seed [seed 0] #:index [index 0])
  (define-values (u v) (random-pair 'Float3-random-point-in-sphere seed index))
  (define-values (w _) (random-pair 'Float3-random-point-in-sphere (hash-seed seed) index))
  (Float3-scale-by-scalar (warp-uniform-sphere u v)
                          (fl* (check-positive 'Float3-random-point-in-sphere "radius" radius)
                               (flexpt w (fl/ 1.0 3.0)))))

(: Float3-random-color (->* () (#:seed Integer #:index Integer) Float3))
(define (Float3-random-color #:seed [seed 0] #:index [index 0])
  (define-values (u v) (random-pair 'Float3-random-color seed index))
  (define-values (w _) (random-pair 'Float3-random-color (hash-seed seed) index))
  (Float3 u v w))

(: hash-seed (-> Integer Integer))
(define (hash-seed seed) (bitwise-xor seed #x5bd1e995))

(: random-pair (-> Symbol Integer Integer (Values Flonum Flonum)))
(define (random-pair who seed index)
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (Sampler-start! i 0 (check-count who "#:seed" seed 0 #xFFFFFFFF) 0)
  (sample-pair! r i 0 (check-count who "#:index" index 0 #xFFFFFFFF))
  (values (flvector-ref r sample-u) (flvector-ref r sample-v)))
