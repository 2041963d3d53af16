#lang typed/racket/base
;; One colour that stands for a material, for the article's shading and for the Intersection that a
;; caller is given: what it reflects of white light, 1 for glass, the mean of a mixture; a texture is
;; grey, and what shines is black.
(require "../base/unsafe.rkt" "../base/float3.rkt" "material.rkt" "phong.rkt" "emitter.rkt"
         "lambertian.rkt" "mirror.rkt" "metal.rkt" "plastic.rkt" "modified-phong.rkt" "dielectric.rkt" "rough-dielectric.rkt"
         "rough-conductor.rkt" "mix.rkt" "bumped.rkt" "interior.rkt" "texture/texture.rkt")

(provide Material-color RoughConductor-reflectance)

(define GREY : Float3 (make-Float3 0.5 0.5 0.5))
(define WHITE : Float3 (make-Float3 1 1 1))

(: Material-color (-> Material Float3))
(define (Material-color material)
  (define (constant [source : ColorOrTexture]) (if (Float3? source) source GREY))
  (cond
    [(Phong? material) (constant (Phong-color material))]
    [(Lambertian? material) (constant (Lambertian-albedo material))]
    [(Mirror? material) (constant (Mirror-color material))]
    [(Metal? material) (constant (Metal-albedo material))]
    [(Plastic? material) (constant (Plastic-albedo material))]
    [(ModifiedPhong? material) (ModifiedPhong-albedo material)]
    [(RoughConductor? material) (RoughConductor-reflectance material)]
    [(or (Dielectric? material) (RoughDielectric? material)) WHITE]
    [(Bumped? material) (Material-color (Bumped-material material))]
    [(Mix? material)
     (define weight (Mix-weight material))
     (Float3-linear-interpolate (Material-color (Mix-first material))
                                (Material-color (Mix-second material))
                                (if (flonum? weight) weight 0.5))]
    [(Interior? material)
     (define surface (Interior-surface material))
     (if surface (Material-color surface) WHITE)]
    [(Emitter? material)
     (define surface (Emitter-surface material))
     (if surface (Material-color surface) (make-Float3 0 0 0))]
    [else GREY]))

;; RoughConductor-reflectance : along the normal (Fresnel).
(: RoughConductor-reflectance (-> RoughConductor Float3))
(define (RoughConductor-reflectance material)
  (define color (RoughConductor-color material))
  (define eta (RoughConductor-eta material))
  (define k (RoughConductor-k material))
  (define (reflectance [n : Flonum] [k : Flonum])
    (let ([kk (fl* k k)] [below (fl+ n 1.0)] [above (fl- n 1.0)])
      (fl/ (fl+ (fl* above above) kk) (fl+ (fl* below below) kk))))
  (cond
    [color color]
    [(and eta k)
     (Float3 (reflectance (Float3-x eta) (Float3-x k)) (reflectance (Float3-y eta) (Float3-y k))
             (reflectance (Float3-z eta) (Float3-z k)))]
    [else GREY]))
