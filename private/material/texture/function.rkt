#lang typed/racket/base
;; Textures of users' own.
(require (for-syntax racket/base)
         "../../base/unsafe.rkt" "../../base/registers.rkt" "../../base/float3.rkt"
         "../../base/public.rkt" "texture.rkt")

(provide (struct-out FunctionTexture) make-FunctionTexture FunctionTexture-kernel)

;; function: from a point in the space the shape is made in, u and v to a colour. It must be pure:
;; it is called in any order, and more than once for a pixel. Worlds with one cannot be sent to
;; places; futures and a single worker render them.
(struct FunctionTexture Texture ([function : (-> Float3 Flonum Flonum Float3)]) #:transparent)

(: make-FunctionTexture (-> (-> Float3 Flonum Flonum Float3) FunctionTexture))
(define (make-FunctionTexture function) (FunctionTexture function))

(define-constructor FunctionTexture make-FunctionTexture (function))

(: FunctionTexture-kernel (-> FunctionTexture TextureKernel))
(define (FunctionTexture-kernel texture)
  (define function (FunctionTexture-function texture))
  (lambda ([r : FlVector] [i : FxVector])
    (define color
      (function (Float3-in r texture-point)
                (flvector-ref r surface-uv) (flvector-ref r (fx+ surface-uv 1))))
    (Float3-put! r surface-color color)))
