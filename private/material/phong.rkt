#lang typed/racket/base
;; The article's surface (Phong, "Illumination for Computer Generated Pictures", 1975), as
;; published: ambient and diffuse light times a colour, a white highlight, and a mirror's share.
;; color: linear RGB albedo, or a texture that shows it. specularity: strength of the highlight, 0 none. shininess: exponent
;; of the highlight, larger is smaller and sharper. reflectivity: the part of the light that is
;; reflected as by a mirror, a number or a colour from 0 to 1; what it takes, the rest lacks.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/float3.rkt" "../base/check.rkt" "../base/public.rkt"
         "../sample/warp.rkt" "material.rkt" "kernel.rkt" "phong-lobes.rkt"
         "texture/texture.rkt")

(provide (struct-out Phong) make-Phong Phong-kernel WORLD-SHAPE-SPECULARITY WORLD-SHAPE-SHININESS)

(struct Phong Material
  ([color : ColorOrTexture] [specularity : Flonum] [shininess : Flonum] [reflectivity : Float3])
  #:transparent)

;; The article's values for every shape.
(define WORLD-SHAPE-SPECULARITY : Flonum 0.30)
(define WORLD-SHAPE-SHININESS : Flonum 16.0)

;; (Phong color [specularity shininess reflectivity]), the last three also by keyword.
(: make-Phong (->* (ColorOrTexture)
                   (Real Real (U Real Float3)
                    #:specularity Real #:shininess Real #:reflectivity (U Real Float3))
                   Phong))
(define (make-Phong color [specularity-by-place WORLD-SHAPE-SPECULARITY]
                    [shininess-by-place WORLD-SHAPE-SHININESS] [reflectivity-by-place 0.0]
                    #:specularity [specularity specularity-by-place]
                    #:shininess [shininess shininess-by-place]
                    #:reflectivity [reflectivity reflectivity-by-place])
  (define mirror
    (if (real? reflectivity)
        (make-Float3 reflectivity reflectivity reflectivity)
        reflectivity))
  (for ([part (list (Float3-x mirror) (Float3-y mirror) (Float3-z mirror))])
    (check-between 'Phong "reflectivity" part 0.0 1.0))
  (Phong (check-color-or-texture 'Phong "color" color)
         (check-between 'Phong "specularity" specularity 0.0 1e300)
         (check-between 'Phong "shininess" shininess 0.0 1e300)
         mirror))

(define-constructor Phong make-Phong (color specularity shininess reflectivity))

;; The same surface for the path integrator: all that the article's shading adds up for one light,
;; divided by pi, so that a colour is an albedo, and lights pi times as bright give the article's
;; picture of direct light. The highlight is, as published, not foreshortened, which is neither
;; reciprocal nor energy-conserving: color + 2 specularity / (shininess + 1) should stay below 1.
(: Phong-kernel (-> Phong MaterialKernel))
(define (Phong-kernel material)
  (define mirror (Phong-reflectivity material))
  (define rest (Float3-subtract (make-Float3 1 1 1) mirror))
  (phong-lobes-kernel (Phong-color material) rest
                      (Float3-scale-by-scalar rest (fl* (INVERSE-PI) (Phong-specularity material)))
                      (Phong-shininess material) #f mirror))
