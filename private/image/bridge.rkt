#lang racket/base
;; Pictures as other libraries know them: flomaps of images/flomap, bitmaps of racket/draw, picts.
;; None of these is loaded before it is asked for.
(provide Image->flomap flomap->Image Image->bitmap Image->pict)
(require racket/lazy-require "image.rkt" "tone.rkt")

(lazy-require ["flomap.rkt" (pixels->flomap flomap->pixels)]
              ["draw.rkt" (bytes->bitmap)]
              [pict (bitmap)])

;; Image->flomap : the linear pixels as a flomap of three components, red green blue.
(define (Image->flomap image)
  (check-image 'Image->flomap image)
  (pixels->flomap (Image-width image) (Image-height image) (Image-pixels image)))

;; flomap->Image : an Image of a flomap's values, as they are: three components are linear red, green
;; and blue, one is a grey; of two or four the first is how much it covers, over black, and it is
;; left out, for flomaps are premultiplied. Raises exn:fail:contract for others.
(define (flomap->Image flomap)
  (define-values (width height pixels) (flomap->pixels flomap))
  (make-Image width height pixels))

;; Image->bitmap : a bitmap% of racket/draw, its colours encoded as sRGB, clipped at white.
(define (Image->bitmap image)
  (check-image 'Image->bitmap image)
  (bytes->bitmap (Image-width image) (Image-height image) (linear->sRGB-bytes (Image-pixels image))))

;; Image->pict : the same as a pict.
(define (Image->pict image)
  (check-image 'Image->pict image)
  (bitmap (Image->bitmap image)))

(define (check-image who image)
  (unless (Image? image) (raise-argument-error who "an Image" image)))
