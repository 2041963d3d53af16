#lang typed/racket/base
;; Texture coordinates as colours, to see where a picture would come to lie.
(require (for-syntax racket/base)
         "../../base/unsafe.rkt" "../../base/registers.rkt" "../../base/float3.rkt"
         "../../base/public.rkt" "texture.rkt")

(provide (struct-out UVTexture) make-UVTexture UVTexture-kernel)

;; Red is u and green is v, again and again outside 0 .. 1.
(struct UVTexture Texture () #:transparent)

(: make-UVTexture (-> UVTexture))
(define (make-UVTexture) (UVTexture))

(define-constructor UVTexture make-UVTexture ())

(: UVTexture-kernel (-> UVTexture TextureKernel))
(define (UVTexture-kernel texture)
  (define-syntax-rule (repeated x)
    (let ([c x]) (if (and (fl>= c 0.0) (fl<= c 1.0)) c (fl- c (flfloor c)))))
  (lambda ([r : FlVector] [i : FxVector])
    (Float3-put! r surface-color
                 (Float3 (repeated (flvector-ref r surface-uv))
                         (repeated (flvector-ref r (fx+ surface-uv 1)))
                         0.0))))
