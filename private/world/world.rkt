#lang typed/racket/base
;; Worlds: shapes, lights, what lies behind them, and how the article's shading treats them.
(require (for-syntax racket/base) racket/promise "../base/unsafe-typed.rkt"
         "../base/float3.rkt" "../base/check.rkt" "../base/public.rkt"
         "../shape/shape.rkt" "../shape/sphere.rkt" "../light/light.rkt" "../light/distant.rkt"
         "../medium/medium.rkt" "background.rkt" "scene.rkt")

(provide (struct-out World) make-World (struct-out Shading) World-from-parts World-parts World-scene
         World-spheres World-sun World-background-color
         WORLD-AMBIENT-SAMPLES WORLD-MAX-OCCLUSION-DISTANCE)

(unsafe-require/typed "../base/promise.rkt" [once (All (a) (-> (-> a) (Promise a)))])

;; How the article's shading is done. ambient-color: light from everywhere; black costs nothing.
;; ambient-samples: occlusion rays at a point, 0 for none. max-occlusion-distance:
;; what is farther does not occlude. ambient-weighting: 'uniform over the hemisphere or 'cosine.
;; occlusion-falloff: 'linear counts a hit as its share of the distance, 'binary as dark.
;; shadow-samples: rays to each light with an area at a point (lights without one take one ray),
;; 0 for no shadows. mirror-bounces: how many mirrors a ray follows.
(struct Shading
  ([ambient-color : Float3] [ambient-samples : Fixnum] [max-occlusion-distance : Flonum]
   [ambient-weighting : (U 'uniform 'cosine)] [occlusion-falloff : (U 'linear 'binary)]
   [shadow-samples : Fixnum] [mirror-bounces : Fixnum])
  #:transparent)

;; The article's quality of ambient occlusion, and the distance at which it ends.
(define WORLD-AMBIENT-SAMPLES : Positive-Fixnum 64)
(define WORLD-MAX-OCCLUSION-DISTANCE : Flonum 5.0)

;; medium: what fills the world, seen by paths, #f for nothing. compiled: the Scene the first render
;; makes; renders of the same World share it.
(struct World
  ([shapes : (Listof Shape)] [lights : (Listof Light)] [background : Background]
   [shading : Shading] [medium : (U #f Medium)] [compiled : (Promise Scene)])
  #:property prop:equal+hash
  (list (lambda ([a : World] [b : World] [same? : (-> Any Any Boolean)])
          (same? (World-parts a) (World-parts b)))
        (lambda ([world : World] [hash : (-> Any Integer)]) (hash (World-parts world)))
        (lambda ([world : World] [hash : (-> Any Integer)]) (hash (World-shapes world))))
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write
  (lambda ([world : World] [port : Output-Port] [mode : (U Boolean 0 1)])
    (define shading (World-shading world))
    (define default (World-shading (make-World '() '() (World-background world))))
    (define-syntax-rule (keyword name accessor)
      (list 'name (accessor shading) (accessor default)))
    (print-call 'World
                (list (World-shapes world) (World-lights world) (World-background world))
                (append (list '#:medium (World-medium world) #f)
                        (keyword #:ambient-color Shading-ambient-color)
                        (keyword #:ambient-samples Shading-ambient-samples)
                        (keyword #:max-occlusion-distance Shading-max-occlusion-distance)
                        (keyword #:ambient-weighting Shading-ambient-weighting)
                        (keyword #:occlusion-falloff Shading-occlusion-falloff)
                        (keyword #:shadow-samples Shading-shadow-samples)
                        (keyword #:mirror-bounces Shading-mirror-bounces))
                port mode)))

(unsafe-require/typed "../base/print.rkt"
  [print-call (-> Symbol (Listof Any) (Listof Any) Output-Port (U Boolean 0 1) Any)])

;; All that makes two worlds equal, as World-from-parts takes it.
(: World-parts (-> World (Listof Any)))
(define (World-parts world)
  (list (World-shapes world) (World-lights world) (World-background world) (World-shading world)
        (World-medium world)))

;; (World shapes lights background): as in the article, shapes a list of spheres, lights the sun,
;; background a colour; lights may also be a list and background a GradientSky. The ambient colour
;; is the background's unless given.
(: make-World
   (->* ()
        ((Listof Shape) (U Light (Listof Light)) Background
         #:shapes (Listof Shape) #:lights (U Light (Listof Light)) #:background Background
         #:medium (U #f Medium) #:ambient-color (U #f Float3) #:ambient-samples Integer #:max-occlusion-distance Real
         #:ambient-weighting Symbol #:occlusion-falloff Symbol
         #:shadow-samples Integer #:mirror-bounces Integer)
        World))
(define (make-World [shapes-by-place '()] [lights-by-place '()]
                    [background-by-place (make-Float3 0.45 0.65 1.0)]
                    #:shapes [shapes shapes-by-place]
                    #:lights [lights lights-by-place]
                    #:background [background background-by-place]
                    #:medium [medium #f]
                    #:ambient-color [ambient-color #f]
                    #:ambient-samples [ambient-samples WORLD-AMBIENT-SAMPLES]
                    #:max-occlusion-distance [distance WORLD-MAX-OCCLUSION-DISTANCE]
                    #:ambient-weighting [weighting 'uniform]
                    #:occlusion-falloff [falloff 'linear]
                    #:shadow-samples [shadow-samples 16]
                    #:mirror-bounces [mirror-bounces 50])
  (when (Float3? background) (check-color 'World "background" background))
  (when ambient-color (check-color 'World "ambient-color" ambient-color))
  (define shading
    (Shading (or ambient-color (Background-color background))
             (check-count 'World "ambient-samples" ambient-samples 0 1000000)
             (check-positive-or-infinite 'World "max-occlusion-distance" distance)
             (case weighting
               [(uniform cosine) weighting]
               [else (raise-expected 'World "ambient-weighting" "'uniform or 'cosine" weighting)])
             (case falloff
               [(linear binary) falloff]
               [else (raise-expected 'World "occlusion-falloff" "'linear or 'binary" falloff)])
             (check-count 'World "shadow-samples" shadow-samples 0 1000000)
             (check-count 'World "mirror-bounces" mirror-bounces 0 1000000)))
  (define all-lights (if (Light? lights) (list lights) lights))
  (when (and medium (Medium-density medium))
    (raise-expected 'World "medium" "one without a density; those with one fill shapes" medium))
  (World-from-parts shapes all-lights background shading medium))

;; A World from checked parts.
(: World-from-parts (-> (Listof Shape) (Listof Light) Background Shading (U #f Medium) World))
(define (World-from-parts shapes lights background shading medium)
  (World shapes lights background shading medium
         (once (lambda () (compile-scene shapes lights background)))))

(define-constructor World make-World (shapes lights background)
  #:struct (shapes lights background _ _ _))

;; The World compiled for rendering; made at the first call.
(: World-scene (-> World Scene))
(define (World-scene world) (force (World-compiled world)))

;; The article's accessors: the spheres among the shapes, the first distant light (an error where
;; there is none), and one colour for the background.
(: World-spheres (-> World (Listof Sphere)))
(define (World-spheres world) (filter Sphere? (World-shapes world)))

(: World-sun (-> World DistantLight))
(define (World-sun world)
  (or (for/or : (U #f DistantLight) ([light (in-list (World-lights world))])
        (and (DistantLight? light) light))
      (raise-expected 'World-sun "world" "a world with a DistantLight" (World-lights world))))

(: World-background-color (-> World Float3))
(define (World-background-color world) (Background-color (World-background world)))
