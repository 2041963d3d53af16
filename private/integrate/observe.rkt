#lang typed/racket/base
;; A World whose kernels tell what they do: rendered by the same integrators, it gives the same
;; pictures to the bit, and somebody sees how. The renderer itself knows nothing of it.
(require racket/promise
         "../base/unsafe.rkt" "../base/registers.rkt"
         "../shape/shape.rkt" "../shape/kernel.rkt" "../shape/sphere.rkt"
         "../material/kernel.rkt" "../light/light.rkt"
         "../world/scene.rkt" "../world/world.rkt")

(provide World-observed PLACES)

;; What happened, a number that goes with it, and the registers as they are then:
;;   surface     a ray's nearest hit is in the scratch, with its surface; number of the primitive
;;   background  a ray hit nothing, and surface-color is what it sees; -1
;;   light       a light was sampled; its number
;;   evaluated   the material was evaluated for that light; number of the material
;;   scattered   the material chose the direction onward; number of the material
(define-type See (-> Symbol Fixnum FlVector FxVector Void))

;; Where an observer finds in the registers what it may want to see, by name.
(define-syntax-rule (places name ...)
  (make-immutable-hasheq (list (cons 'name (ann name Fixnum)) ...)))
(define PLACES : (Immutable-HashTable Symbol Fixnum)
  (places hit-t hit-material surface-point surface-normal surface-shading-normal surface-color
          ray-direction in-direction bsdf-weight bsdf-density light-distance light-density
          throughput radiance film-x film-y nearest-rays occlusion-rays looking))

;; World-observed : the same world, with see called after each of these steps. Compiled anew at the
;; first use of the world it is made from only.
(: World-observed (-> World See World))
(define (World-observed world see)
  (define scene (World-scene world))
  (World (World-shapes world) (World-lights world) (World-background world) (World-shading world)
         (World-medium world)
         (delay (observed scene (list->vector (World-shapes world)) see))))

(: observed (-> Scene (Vectorof Shape) See Scene))
(define (observed scene shapes see)
  (: after (-> (-> FlVector FxVector Void) Symbol Fixnum (-> FlVector FxVector Void)))
  (define ((after kernel event number) r i)
    (kernel r i)
    (see event number r i))
  ;; worlds keep spheres packed, but ask for the surface of one with a kernel there
  (: shape-kernel (-> (U #f ShapeKernel) Shape Fixnum (U #f ShapeKernel)))
  (define (shape-kernel known shape number)
    (define kernel (or known (and (Sphere? shape) (Sphere-kernel shape))))
    (and kernel
         (struct-copy ShapeKernel kernel
                      [surface (after (ShapeKernel-surface kernel) 'surface number)])))
  (: light-kernel (-> LightKernel Fixnum LightKernel))
  (define (light-kernel kernel number)
    (struct-copy LightKernel kernel [sample (after (LightKernel-sample kernel) 'light number)]))
  (: material-kernel (-> MaterialKernel Fixnum MaterialKernel))
  (define (material-kernel kernel number)
    (struct-copy MaterialKernel kernel
                 [sample (after (MaterialKernel-sample kernel) 'scattered number)]
                 [evaluate (after (MaterialKernel-evaluate kernel) 'evaluated number)]))
  (: numbered (All (a b) (-> (-> a Fixnum b) (Vectorof a) (Vectorof b))))
  (define (numbered wrap kernels)
    (for/vector : (Vectorof b) ([kernel (in-vector kernels)]
                                [k : Nonnegative-Fixnum (in-range (vector-length kernels))])
      (wrap kernel k)))
  (struct-copy Scene scene
               [kernels
                (numbered (lambda ([kernel : (U #f ShapeKernel)] [k : Fixnum])
                            (shape-kernel kernel (vector-ref shapes k) k))
                          (Scene-kernels scene))]
               [lights (numbered light-kernel (Scene-lights scene))]
               [background (after (Scene-background scene) 'background -1)]
               [material-kernels
                (delay (numbered material-kernel (force (Scene-material-kernels scene))))]
               [watch-scattering
                (lambda ([kernel : MaterialKernel])
                  (struct-copy MaterialKernel kernel
                               [sample (after (MaterialKernel-sample kernel) 'within -1)]))]))
