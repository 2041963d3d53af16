#lang typed/racket/base
;; One colour that stands for a material, for the article's shading and for previews: grey where
;; nothing better is known, as of a texture.
(require "../base/float3.rkt" "material.rkt" "phong.rkt" "emitter.rkt")

(provide Material-color)

(: Material-color (-> Material Float3))
(define (Material-color material)
  (cond
    [(Phong? material)
     (define color (Phong-color material))
     (if (Float3? color) color (make-Float3 0.5 0.5 0.5))]
    [(Emitter? material) (make-Float3 0 0 0)]
    [else (make-Float3 0.5 0.5 0.5)]))
