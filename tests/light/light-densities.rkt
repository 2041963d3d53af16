#lang typed/racket/base
;; The density with which a world's only light samples a direction, found as the path integrator finds
;; it: by the hit of a ray in that direction. For the tests.
(require racket/flonum racket/fixnum
         "../../private/base/registers.rkt" "../../private/base/float3.rkt"
         "../../private/light/light.rkt"
         "../../private/world/world.rkt" "../../private/world/scene.rkt"
         "../../private/world/trace.rkt")

(provide make-light-density)

;; x, y, z of a unit direction from the point -> the density, 0 where the light is not hit.
(: make-light-density (-> World Float3 (-> Flonum Flonum Flonum Flonum)))
(define (make-light-density world point)
  (define-values (r i) (values (make-flonum-registers) (make-fixnum-registers)))
  (define scene (World-scene world))
  (define light (vector-ref (Scene-lights scene) 0))
  (lambda ([x : Flonum] [y : Flonum] [z : Flonum])
    (define direction (Float3 x y z))
    (Float3-put! r ray-origin point)
    (Float3-put! r ray-direction direction)
    (flvector-set! r ray-limit +inf.0)
    (cond
      [(and (Scene-nearest! scene r i) (fx= 0 (hit-light scene i)))
       (Float3-put! r surface-point point)
       (Float3-put! r in-direction direction)
       ((LightKernel-density light) r i)
       (flvector-ref r light-density)]
      [else 0.0])))

(: hit-light (-> Scene FxVector Fixnum))
(define (hit-light scene i)
  (define known (fxvector-ref (Scene-primitive-lights scene) (fxvector-ref i hit-primitive)))
  (if (fx< known -1) ((vector-ref (Scene-part-lights scene) (fx- -2 known)) i) known))
