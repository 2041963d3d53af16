#lang typed/racket/base
;; The kernel of any texture, and what materials read their colours by: one of the same body for
;; colours that are constant and colours that a texture drives.
(require "../../base/unsafe.rkt" "../../base/registers.rkt" "../../base/float3.rkt"
         "../../base/check.rkt"
         "texture.rkt" "checker.rkt" "image.rkt" "noises.rkt" "gradient.rkt" "uv.rkt"
         "function.rkt")

(provide Texture-kernel albedo-source radiance-kernel weight-kernel)

(: Texture-kernel (-> ColorOrTexture TextureKernel))
(define (Texture-kernel texture)
  (cond
    [(Float3? texture)
     (lambda ([r : FlVector] [i : FxVector]) (Float3-put! r surface-color texture))]
    [(Checker? texture) (Checker-kernel texture Texture-kernel)]
    [(CheckerUV? texture) (CheckerUV-kernel texture Texture-kernel)]
    [(ImageTexture? texture) (ImageTexture-kernel texture)]
    [(Noise? texture) (Noise-kernel texture)]
    [(Turbulence? texture) (Turbulence-kernel texture)]
    [(Marble? texture) (Marble-kernel texture)]
    [(GradientTexture? texture) (GradientTexture-kernel texture)]
    [(UVTexture? texture) (UVTexture-kernel texture)]
    [(FunctionTexture? texture) (FunctionTexture-kernel texture)]
    [else (raise-expected 'World "textures" "textures of this library" texture)]))

;; At least 0, at most `most`; NaN is 0.
(define-syntax-rule (clamped-to most x)
  (let ([c x]) (if (fl> c 0.0) (if (fl< c most) c most) 0.0)))

(define-syntax-rule (clamp-color! r most)
  (let-float3 ([color (Float3-in r surface-color)])
    (Float3-put! r surface-color (Float3 (clamped-to most (Float3-x color))
                                         (clamped-to most (Float3-y color))
                                         (clamped-to most (Float3-z color))))))

;; Where a kernel reads an albedo: (values constant place prepare) to read it by
;; (Float3-in (or constant r) place), after prepare where that is not #f. finish! may turn the
;; colour at that place into something else, and a scalar at the place after it.
(: albedo-source (->* (ColorOrTexture) ((-> FlVector Fixnum Void))
                      (Values (U #f FlVector) Fixnum (U #f TextureKernel))))
(define (albedo-source albedo [finish! void])
  (cond
    [(Float3? albedo)
     (define constant (make-flvector 4))
     (Float3-put! constant 0 albedo)
     (finish! constant 0)
     (values constant 0 #f)]
    [else
     (define texture! (Texture-kernel albedo))
     (values #f surface-color
             (lambda ([r : FlVector] [i : FxVector])
               (texture! r i)
               (clamp-color! r 1.0)
               (finish! r surface-color)))]))

;; Leaves in surface-color what a texture shows as radiance: neither negative nor infinite.
(: radiance-kernel (-> ColorOrTexture TextureKernel))
(define (radiance-kernel texture)
  (define texture! (Texture-kernel texture))
  (lambda ([r : FlVector] [i : FxVector])
    (texture! r i)
    (clamp-color! r 1e300)))

;; Leaves in surface-roughness the luminance (Rec. 709) of what a texture shows, from 0 to 1; of a
;; grey its component, to the bit.
(: weight-kernel (-> ColorOrTexture TextureKernel))
(define (weight-kernel texture)
  (define texture! (Texture-kernel texture))
  (lambda ([r : FlVector] [i : FxVector])
    (texture! r i)
    (clamp-color! r 1.0)
    (let-float3 ([color (Float3-in r surface-color)])
      (let ([red (Float3-x color)])
        (flvector-set! r surface-roughness
                       (if (and (fl= red (Float3-y color)) (fl= red (Float3-z color)))
                           red
                           (flmin 1.0 (Float3-dot color (Float3 0.2126 0.7152 0.0722)))))))))
