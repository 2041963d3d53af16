#lang typed/racket/base
;; Integrators by name: what a ray's colour means.
(require "../base/check.rkt" "../world/world.rkt" "seed.rkt" "views.rkt")

(provide Integrator INTEGRATORS World-integrator)

;; Takes the ray in a worker's scratch and leaves its colour in `radiance`.
(define-type Integrator (-> FlVector FxVector Void))

(define INTEGRATORS : (Listof Symbol) '(auto seed ambient-occlusion normals depth))

;; The named integrator for a world; 'auto is the one that suits its materials and lights.
(: World-integrator (-> World Symbol Integrator))
(define (World-integrator world name)
  (define scene (World-scene world))
  (define shading (World-shading world))
  (case name
    [(auto seed) (seed-integrator scene shading)]
    [(ambient-occlusion) (ambient-occlusion-view scene shading)]
    [(normals) (normals-view scene)]
    [(depth) (depth-view scene)]
    [else (raise-expected 'render "integrator" (format "one of ~a" INTEGRATORS) name)]))
