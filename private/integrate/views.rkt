#lang typed/racket/base
;; Integrators that show one thing: ambient occlusion, normals, depth.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt"
         "../world/scene.rkt" "../world/trace.rkt" "../world/world.rkt" "seed.rkt")

(provide ambient-occlusion-view normals-view depth-view)

;; What `show` leaves in `radiance` where the ray hits, black elsewhere.
(: view (-> Scene (-> FlVector FxVector Void) (-> FlVector FxVector Void)))
(define (view scene show!)
  (lambda ([r : FlVector] [i : FxVector])
    (flvector-set! r ray-limit +inf.0)
    (cond
      [(Scene-nearest! scene r i)
       (Scene-surface! scene r i)
       (face-viewer! r)
       (show! r i)]
      [else (Float3-put! r radiance (Float3 0.0 0.0 0.0))])))

;; The unoccluded part of the hemisphere, as a grey.
(: ambient-occlusion-view (-> Scene Shading (-> FlVector FxVector Void)))
(define (ambient-occlusion-view scene shading)
  (view scene
        (lambda ([r : FlVector] [i : FxVector])
          (if (fx= (Shading-ambient-samples shading) 0)
              (flvector-set! r ambient-percent 1.0)
              (ambient-visibility! scene shading r i))
          (let ([percent (flvector-ref r ambient-percent)])
            (Float3-put! r radiance (Float3 percent percent percent))))))

;; The shading normal towards the viewer, each component from -1 .. 1 to 0 .. 1.
(: normals-view (-> Scene (-> FlVector FxVector Void)))
(define (normals-view scene)
  (view scene
        (lambda ([r : FlVector] [i : FxVector])
          (Float3-put! r radiance
                       (Float3-multiply-add (Float3 0.5 0.5 0.5)
                                            0.5 (Float3-in r surface-shading-normal))))))

;; The distance along the ray in world units, as a grey.
(: depth-view (-> Scene (-> FlVector FxVector Void)))
(define (depth-view scene)
  (view scene
        (lambda ([r : FlVector] [i : FxVector])
          (let ([t (flvector-ref r hit-t)])
            (Float3-put! r radiance (Float3 t t t))))))
