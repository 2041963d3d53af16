#lang typed/racket/base
;; The light that surfaces give off themselves, for every integrator.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt"
         "../material/material.rkt" "../material/emitter.rkt"
         "../material/texture/texture.rkt" "../material/texture/kernels.rkt"
         "../world/scene.rkt" "../world/trace.rkt")

(provide emission-kernel)

;; emission-kernel : a procedure that adds to `radiance` what the surface in the scratch, its normals
;; still pointing outside, sends towards the ray's origin, times throughput and light-density; #f
;; where nothing in the scene shines.
(: emission-kernel (-> Scene (U #f (-> FlVector FxVector Void))))
(define (emission-kernel scene)
  (define materials (Scene-materials scene))
  (define packed (pack-emission materials))
  (define textures : (Vectorof (U #f TextureKernel))
    (for/vector : (Vectorof (U #f TextureKernel)) ([material (in-vector materials)])
      (and (Emitter? material)
           (Texture? (Emitter-radiance material))
           (radiance-kernel (Emitter-radiance material)))))
  (and (for/or : Boolean ([material (in-vector materials)]) (Emitter? material))
       (lambda ([r : FlVector] [i : FxVector])
         (define at (fx* 4 (fxvector-ref i hit-material)))
         (when (or (let-float3 ([n (Float3-in r surface-normal)] [d (Float3-in r ray-direction)])
                     (fl< (Float3-dot n d) 0.0))
                   (fl= (flvector-ref packed (fx+ at 3)) 1.0))
           (define texture! (vector-ref textures (fxvector-ref i hit-material)))
           (when texture!
             (Scene-uv! scene r i)
             (texture! r i))
           (Float3-put! r radiance
                        (Float3-multiply-add
                         (Float3-in r radiance)
                         (flvector-ref r light-density)
                         (Float3-scale-by-vector
                          (Float3-in r throughput)
                          (Float3-in (if texture! r packed) (if texture! surface-color at)))))))))

;; Radiance and, in the fourth place, 1 where the emission is two-sided; by material.
(: pack-emission (-> (Vectorof Material) FlVector))
(define (pack-emission materials)
  (define packed (make-flvector (fx* 4 (vector-length materials)) 0.0))
  (for ([k (in-range (vector-length materials))])
    (define material (vector-ref materials k))
    (when (Emitter? material)
      (Float3-put! packed (fx* 4 k) (Emitter-constant-radiance material))
      (flvector-set! packed (fx+ 3 (fx* 4 k)) (if (Emitter-two-sided? material) 1.0 0.0))))
  packed)
