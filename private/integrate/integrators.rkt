#lang typed/racket/base
;; Integrators by name: what a ray's colour means.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../light/light.rkt" "../world/world.rkt"
         "../material/material.rkt" "../material/phong.rkt" "../material/emitter.rkt"
         "../world/scene.rkt" "seed.rkt" "path.rkt" "views.rkt")

(provide Integrator INTEGRATORS SHADINGS check-integrator World-integrator)

;; Takes the ray in a worker's scratch and leaves its colour in `radiance`.
(define-type Integrator (-> FlVector FxVector Void))

(define INTEGRATORS : (Listof Symbol)
  '(auto path naive-path seed ambient-occlusion normals depth cost error raster))

;; How rasterization shades: normals of corners interpolated, or colours of corners, one colour a
;; triangle, steps with an outline, all edges, edges that no surface hides; and views of one thing
;; each.
(define SHADINGS : (Listof Symbol)
  '(phong gouraud flat toon wireframe hidden-lines normals depth texture-coordinates))

;; Raises where there is no integrator of that name.
(: check-integrator (-> Symbol Void))
(define (check-integrator name)
  (unless (memq name INTEGRATORS)
    (raise-expected 'render "integrator" (format "one of ~a" INTEGRATORS) name)))

;; The scene with nothing that shines sampled: paths find it by chance, or not at all where it has no
;; area.
(: without-lights (-> Scene Scene))
(define (without-lights scene)
  (struct-copy Scene scene
               [lights (ann (vector) (Vectorof LightKernel))]
               [primitive-lights (make-fxvector (fxvector-length (Scene-primitive-lights scene)) -1)]
               [background-light -1]))

;; What an integrator costs: the rays it asks for, as a grey.
(: counting-rays (-> Integrator Integrator))
(define ((counting-rays integrator) r i)
  (define before (fx+ (fxvector-ref i nearest-rays) (fxvector-ref i occlusion-rays)))
  (integrator r i)
  (let ([rays (fx->fl (fx- (fx+ (fxvector-ref i nearest-rays) (fxvector-ref i occlusion-rays))
                           before))])
    (Float3-put! r radiance (Float3 rays rays rays))))

;; The named integrator for a world; not 'raster, which draws whole pictures. 'auto is the article's
;; shading where every surface is the article's and nothing fills the world, else the path integrator;
;; 'cost shows its rays, 'error is it, and the picture shows its errors; 'naive-path is the estimator of the
;; three books, for comparison. max-depth: bounces of a path, #f for no limit.
(: World-integrator (->* (World Symbol) ((U #f Fixnum)) Integrator))
(define (World-integrator world name [max-depth #f])
  (define scene (World-scene world))
  (define shading (World-shading world))
  (define (path) (path-integrator scene (PathLimits max-depth) (World-medium world)))
  (case name
    [(cost) (counting-rays (World-integrator world 'auto max-depth))]
    [(auto error)
     (if (and (not (World-medium world))
              (for/and : Boolean ([material (in-vector (Scene-materials scene))])
                (or (Phong? material) (Emitter? material))))
         (seed-integrator scene shading)
         (path))]
    [(seed) (seed-integrator scene shading)]
    [(path) (path)]
    [(naive-path)
     (path-integrator (without-lights scene) (PathLimits max-depth) (World-medium world))]
    [(ambient-occlusion) (ambient-occlusion-view scene shading)]
    [(normals) (normals-view scene)]
    [(depth) (depth-view scene)]
    [else (raise-expected 'render "integrator" (format "one of ~a" INTEGRATORS) name)]))
