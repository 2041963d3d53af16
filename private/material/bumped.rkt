#lang typed/racket/base
;; Bumped: a material whose surface looks dented and raised though it is not, as hammered metal or
;; rippled water (Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978). material: what it is made
;; of; no emitter and no boundary of a medium, but either may have a bumped surface. texture: its
;; luminance, from 0 to 1, is how high the surface stands, along the normal that points outside.
;; height: of luminance 1 over luminance 0, in world units; below 0 the texture is carved in.
;; Only the shading normal follows the texture: outlines and shadows stay those of the shape. Light
;; that an opaque surface's bumps would send into the shape is lost, a few percent on steep ones; none
;; is gained. Path tracing shows bumps, the article's shading and previews do not.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../base/public.rkt"
         "material.rkt" "kernel.rkt" "scatter.rkt" "emitter.rkt" "interior.rkt"
         "texture/texture.rkt")

(provide (struct-out Bumped) make-Bumped Bumped-kernel Material-bumps bumped-here)

(struct Bumped Material ([material : Material] [texture : Texture] [height : Flonum])
  #:transparent)

;; (Bumped material texture [height 0.1]), the last also by keyword. Raises exn:fail:contract where
;; the material shines or bounds a medium.
(: make-Bumped (->* (Material Texture) (Real #:height Real) Bumped))
(define (make-Bumped material texture [height-by-place 0.1] #:height [height height-by-place])
  (when (or (Emitter? material) (Interior? material))
    (raise-expected 'Bumped "material" "a material that only reflects or transmits" material))
  (Bumped material texture (check-finite 'Bumped "height" height)))

(define-constructor Bumped make-Bumped (material texture height))

;; Material-bumps : all bumps of a material's surface, the outermost first.
(: Material-bumps (-> (U #f Material) (Listof Bumped)))
(define (Material-bumps material)
  (cond
    [(Bumped? material) (cons material (Material-bumps (Bumped-material material)))]
    [(Emitter? material) (Material-bumps (Emitter-surface material))]
    [(Interior? material) (Material-bumps (Interior-surface material))]
    [else '()]))

;; 1 where the shading normal in the scratch was tilted by a bump, and nothing passes through.
(define-syntax bumped-here (lambda (stx) #'(fx+ fixnum-workspace 7)))

;; Directions that are on one side of the shading normal but on the other side of the shape are no
;; good. Who has a scene tilts the normal (integrate/bump.rkt); elsewhere it stays as it is.
(: Bumped-kernel (-> MaterialKernel MaterialKernel))
(define (Bumped-kernel kernel)
  (define (on-its-side [use! : (-> FlVector FxVector Void)])
    (lambda ([r : FlVector] [i : FxVector])
      (use! r i)
      (when (fx= 1 (fxvector-ref i bumped-here))
        (let-float3 ([in (Float3-in r in-direction)] [n (Float3-in r surface-normal)]
                     [shading (Float3-in r surface-shading-normal)])
          (unless (fl> (fl* (Float3-dot in n) (Float3-dot in shading)) 0.0)
            (put-nothing! r))))))
  (MaterialKernel (on-its-side (MaterialKernel-sample kernel))
                  (on-its-side (MaterialKernel-evaluate kernel))
                  (MaterialKernel-specular? kernel)
                  (MaterialKernel-transmits? kernel)
                  (MaterialKernel-prepare kernel)))
