#lang typed/racket/base
;; The path integrator's kernel of any material: the one place that lists them all.
(require "material.rkt" "kernel.rkt" "lambertian.rkt" "phong.rkt" "emitter.rkt"
         "mirror.rkt" "metal.rkt" "dielectric.rkt" "plastic.rkt" "modified-phong.rkt" "mix.rkt"
         "rough-conductor.rkt" "rough-dielectric.rkt" "interior.rkt" "bumped.rkt"
         "../base/check.rkt" "../base/float3.rkt")

(provide Material-kernel)

;; An emitter without a surface reflects nothing.
(: Material-kernel (-> Material MaterialKernel))
(define (Material-kernel material)
  (cond
    [(Lambertian? material) (Lambertian-kernel material)]
    [(Phong? material) (Phong-kernel material)]
    [(ModifiedPhong? material) (ModifiedPhong-kernel material)]
    [(Mirror? material) (Mirror-kernel material)]
    [(Metal? material) (Metal-kernel material)]
    [(Dielectric? material) (Dielectric-kernel material)]
    [(RoughConductor? material) (RoughConductor-kernel material)]
    [(RoughDielectric? material) (RoughDielectric-kernel material)]
    [(Plastic? material) (Plastic-kernel material)]
    [(Mix? material) (Mix-kernel material Material-kernel)]
    [(Bumped? material) (Bumped-kernel (Material-kernel (Bumped-material material)))]
    [(Interior? material)
     (define surface (Interior-surface material))
     (if surface (Material-kernel surface) straight-on)]
    [(Emitter? material)
     (Material-kernel (or (Emitter-surface material) (make-Lambertian (make-Float3 0 0 0))))]
    [else (raise-expected 'World "materials" "materials of this library" material)]))
