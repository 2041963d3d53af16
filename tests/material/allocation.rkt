#lang typed/racket/base
;; Kernels of materials allocate nothing: less than one byte a call, over 100,000 calls.
(module+ test
  (require typed/rackunit
           "../../private/base/unsafe.rkt" "../../private/base/registers.rkt"
           "../../private/base/float3.rkt" "../../private/sample/sampler.rkt"
           "../../private/material/material.rkt" "../../private/material/kernel.rkt"
           "../../private/material/kernels.rkt" "../../private/material/lambertian.rkt"
           "../../private/material/mirror.rkt" "../../private/material/metal.rkt"
           "../../private/material/dielectric.rkt" "../../private/material/plastic.rkt"
           "../../private/material/modified-phong.rkt" "../../private/material/phong.rkt"
           "../../private/material/mix.rkt" "../../private/material/rough-conductor.rkt"
           "../../private/material/rough-dielectric.rkt" "../../private/material/bumped.rkt"
           "../../private/material/texture/checker.rkt"
           "../../private/material/texture/noises.rkt"
           "../../private/material/texture/gradient.rkt" "../../private/material/texture/image.rkt"
           "../../private/image/image.rkt")

  (define calls : Fixnum 100000)

  (: bytes-per-call (-> (-> FlVector FxVector Void) Fixnum Flonum))
  (define (bytes-per-call kernel inside)
    (define r (make-flonum-registers))
    (define i (make-fixnum-registers))
    (Float3-put! r surface-normal (Float3 0.0 1.0 0.0))
    (Float3-put! r surface-shading-normal (Float3 0.0 1.0 0.0))
    (Float3-put! r out-direction (Float3 0.6 0.8 0.0))
    (Float3-put! r in-direction (Float3 -0.48 0.8 0.36))
    (Float3-put! r ray-direction (Float3 -0.6 -0.8 0.0))
    (flvector-set! r hit-t 1.0)
    (fxvector-set! i surface-inside inside)
    (: run (-> Fixnum Void))
    (define (run count)
      (let next ([k : Fixnum 0])
        (when (fx< k count)
          (fxvector-set! i sampler-index k)
          (fxvector-set! i sampler-dimension 0)
          (kernel r i)
          (next (fx+ k 1)))))
    (run 100)
    (define before (current-memory-use 'cumulative))
    (run calls)
    (fl/ (real->double-flonum (- (current-memory-use 'cumulative) before)) (fx->fl calls)))

  (define white (make-Float3 1 1 1))
  (define grey (make-Float3 0.5 0.4 0.3))
  (define glass (make-Dielectric 1.5 #:absorption grey))
  (define plastic (make-Plastic grey))
  (define modified-phong (make-ModifiedPhong grey grey 50))
  (: materials (Listof (Pairof String Material)))
  (define materials
    (list (cons "Lambertian" (make-Lambertian grey))
          (cons "Mirror" (make-Mirror))
          (cons "Metal" (make-Metal white))
          (cons "Metal, fuzz" (make-Metal white 0.5))
          (cons "Dielectric" glass)
          (cons "Dielectric, Schlick" (make-Dielectric 1.5 #:fresnel 'schlick))
          (cons "Plastic" plastic)
          (cons "ModifiedPhong" modified-phong)
          (cons "Phong" (make-Phong grey #:reflectivity 0.2))
          (cons "Mix" (make-Mix (make-Mix glass plastic 0.5) modified-phong 0.5))
          (cons "Checker" (make-Metal (make-Checker white (make-CheckerUV grey white)) 0.5))
          (cons "Noise" (make-Lambertian (make-Noise white grey #:octaves 4)))
          (cons "Marble" (make-Plastic (make-Marble white grey)))
          (cons "GradientTexture" (make-Mirror (make-GradientTexture white grey)))
          (cons "ImageTexture"
                (make-Lambertian (make-ImageTexture (make-Image 1 2 (make-flvector 6 0.5)))))
          (cons "roughness by a texture"
                (make-RoughConductor (make-Checker white grey)))
          (cons "glass of a texture's roughness"
                (make-RoughDielectric 1.5 (make-CheckerUV white grey)))
          (cons "fuzz by a texture" (make-Metal (make-Checker white grey) (make-Noise white grey)))
          (cons "Bumped" (make-Bumped plastic (make-Noise white grey)))
          (cons "Mix by a texture" (make-Mix glass plastic (make-Turbulence white grey)))))

  (for ([material (in-list materials)])
    (define kernel (Material-kernel (cdr material)))
    (define prepare (MaterialKernel-prepare kernel))
    (define (check [kind : String] [bytes : Flonum])
      (when (getenv "RAYTRACE_STRESS")
        (printf "~a ~a: ~a bytes a call\n" (car material) kind bytes))
      (check-true (fl< bytes 1.0) (format "~a ~a: ~a bytes a call" (car material) kind bytes)))
    (when prepare (check "prepare" (bytes-per-call prepare 0)))
    (for ([inside (in-list (ann '(0 1) (Listof Fixnum)))])
      (check "sample" (bytes-per-call (MaterialKernel-sample kernel) inside))
      (check "evaluate" (bytes-per-call (MaterialKernel-evaluate kernel) inside)))))
