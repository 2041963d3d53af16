#lang typed/racket/base
;; Pictures as textures.
(require (for-syntax racket/base)
         "../../base/unsafe.rkt" "../../base/registers.rkt" "../../base/float3.rkt"
         "../../base/check.rkt" "../../base/public.rkt" "../../image/image.rkt" "texture.rkt")

(provide (struct-out ImageTexture) make-ImageTexture ImageTexture-kernel)

;; image: an Image, rendered or by Image-read, which has already turned 8-bit sRGB into linear
;; light. Its lower left corner is at u = v = 0, its upper right one at u = v = 1. filter: 'bilinear,
;; the mean of the nearest four pixels weighted by nearness, or 'nearest. wrap: what is seen outside
;; 0 .. 1, 'repeat for the picture again, 'clamp for the colours of its border.
(struct ImageTexture Texture ([image : Image] [filter : Symbol] [wrap : Symbol]) #:transparent)

;; (ImageTexture image ['bilinear 'repeat]).
(: make-ImageTexture (->* (Image) (Symbol Symbol #:filter Symbol #:wrap Symbol) ImageTexture))
(define (make-ImageTexture image [filter-by-place 'bilinear] [wrap-by-place 'repeat]
                           #:filter [filter filter-by-place] #:wrap [wrap wrap-by-place])
  (unless (memq filter '(bilinear nearest))
    (raise-expected 'ImageTexture "filter" "'bilinear or 'nearest" filter))
  (unless (memq wrap '(repeat clamp))
    (raise-expected 'ImageTexture "wrap" "'repeat or 'clamp" wrap))
  (ImageTexture image filter wrap))

(define-constructor ImageTexture make-ImageTexture (image filter wrap))

;; The number below size that a whole number stands for; 0 for NaN and infinities.
(define-syntax-rule (wrapped number size repeat?)
  (let* ([k number]
         [inside (if repeat?
                     (fl- k (fl* size (flfloor (fl/ k size))))
                     (flmax 0.0 (flmin (fl- size 1.0) k)))])
    (if (and (fl>= inside 0.0) (fl< inside size)) (fl->fx inside) 0)))

(: ImageTexture-kernel (-> ImageTexture TextureKernel))
(define (ImageTexture-kernel texture)
  (define image (ImageTexture-image texture))
  (define pixels (Image-pixels image))
  (define columns (Image-width image))
  (define width (fx->fl columns))
  (define height (fx->fl (Image-height image)))
  (define repeat? (eq? 'repeat (ImageTexture-wrap texture)))
  (define-syntax-rule (place x y) (fx* 3 (fx+ x (fx* y columns))))
  (if (eq? 'nearest (ImageTexture-filter texture))
      (lambda ([r : FlVector] [i : FxVector])
        (let ([x (flfloor (fl* width (flvector-ref r surface-uv)))]
              [y (flfloor (fl* height (fl- 1.0 (flvector-ref r (fx+ surface-uv 1)))))])
          (Float3-put! r surface-color
                       (Float3-in pixels (place (wrapped x width repeat?)
                                                (wrapped y height repeat?))))))
      ;; a pixel's colour is that of its middle
      (lambda ([r : FlVector] [i : FxVector])
        (let* ([x (fl- (fl* width (flvector-ref r surface-uv)) 0.5)]
               [y (fl- (fl* height (fl- 1.0 (flvector-ref r (fx+ surface-uv 1)))) 0.5)]
               [left (flfloor x)]
               [top (flfloor y)]
               [across (fl- x left)]
               [down (fl- y top)]
               [x0 (wrapped left width repeat?)]
               [x1 (wrapped (fl+ left 1.0) width repeat?)]
               [y0 (wrapped top height repeat?)]
               [y1 (wrapped (fl+ top 1.0) height repeat?)])
          (let-float3 ([upper (Float3-linear-interpolate (Float3-in pixels (place x0 y0))
                                                         (Float3-in pixels (place x1 y0)) across)]
                       [lower (Float3-linear-interpolate (Float3-in pixels (place x0 y1))
                                                         (Float3-in pixels (place x1 y1)) across)])
            (Float3-put! r surface-color (Float3-linear-interpolate upper lower down)))))))
