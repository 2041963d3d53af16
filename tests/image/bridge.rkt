#lang racket/base
;; Pictures as flomaps, bitmaps and picts, and back.
(module+ test
  (require racket/class racket/flonum rackunit images/flomap pict file/convertible
           "../../private/image/image.rkt" "../../private/image/bridge.rkt"
           "../../private/image/tone.rkt" "support.rkt")

  (define image
    (make-Image 3 2 (for/flvector ([k (in-range 18)]) (/ (exact->inexact k) 17.0))))

  (test-case "a flomap holds the linear numbers, and gives them back"
    (define map (Image->flomap image))
    (check-equal? (list (flomap-components map) (flomap-width map) (flomap-height map)) '(3 3 2))
    (check-equal? (flomap-ref map 1 2 1) (flvector-ref (Image-pixels image) (+ 1 (* 3 5))))
    (check-equal? (flomap->Image map) image)
    ;; a library's operation in between: twice as wide
    (check-equal? (Image-width (flomap->Image (flomap-scale map 2.0))) 6))

  (test-case "flomaps of other components"
    (define (first-pixel . values)
      (call-with-values
       (lambda ()
         (Image-pixel (flomap->Image (flomap (apply flvector values) (length values) 1 1)) 0 0))
       list))
    (check-equal? (first-pixel 0.5) '(0.5 0.5 0.5))
    (check-equal? (first-pixel 0.25 0.5) '(0.5 0.5 0.5))
    (check-equal? (first-pixel 0.25 0.1 0.2 0.3) '(0.1 0.2 0.3))
    (check-exn #rx"one to four components" (lambda () (first-pixel 1.0 2.0 3.0 4.0 5.0)))
    (check-exn #rx"flomap" (lambda () (flomap->Image 'no))))

  (test-case "a bitmap and a pict have the bytes a file has"
    (define (bytes-of bitmap)
      (define argb (make-bytes 24))
      (send bitmap get-argb-pixels 0 0 3 2 argb)
      (for*/list ([k 6] [channel 3]) (bytes-ref argb (+ 1 channel (* 4 k)))))
    (define expected (bytes->list (linear->sRGB-bytes (Image-pixels image))))
    (check-equal? (bytes-of (Image->bitmap image)) expected)
    (define drawn (Image->pict image))
    (check-equal? (list (pict-width drawn) (pict-height drawn)) '(3 2))
    (check-equal? (bytes-of (pict->bitmap drawn #:make-bitmap (lambda (w h) (make-object bitmap% 3 2))))
                  expected))

  (test-case "no Image, no picture"
    (for ([convert (in-list (list Image->flomap Image->bitmap Image->pict))])
      (check-exn #rx"an Image" (lambda () (convert 'no)))))

  (require (only-in racket/draw bitmap%)))
