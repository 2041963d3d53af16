#lang racket/base
;; The public names that are constructor, match pattern and type at once, for typed and untyped
;; code (see base/public.rkt).
(require "base/public.rkt"
         (prefix-in struct: (combine-in (except-in "base/float3.rkt" Float3)
                                        (only-in "base/fuse.rkt" Float3)
                                        "material/phong.rkt" "material/emitter.rkt"
                                        "shape/sphere.rkt"
                                        "light/distant.rkt" "light/point.rkt"
                                        "world/ray.rkt" "world/camera.rkt"
                                        "world/background.rkt" "world/world.rkt"))
         (for-syntax racket/base))

(define-surface Float3 (x y z))
(define-surface Camera (eye forward right up lens-radius focus-distance))
(define-surface Ray (point direction time))
(define-surface Intersection (t point normal color))
(define-surface Sphere (point radius material))
(define-surface DistantLight (direction color))
(define-surface PointLight (point intensity))
(define-surface Phong (color specularity shininess reflectivity))
(define-surface Emitter (radiance two-sided?))
(define-surface GradientSky (bottom top))
(define-surface World (shapes lights background) #:struct (shapes lights background _ _))
