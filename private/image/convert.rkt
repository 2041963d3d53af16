#lang racket/base
;; The picture of an Image as a PNG byte string; the encoder is loaded at the first request.
(provide image-png-bytes)
(require racket/lazy-require)

(lazy-require ["png.rkt" (encode-png)]
              ["tone.rkt" (linear->sRGB-bytes)])

;; image-png-bytes : an sRGB PNG of linear pixels, each of them magnification x magnification dots.
(define (image-png-bytes width height pixels magnification)
  (define bytes (linear->sRGB-bytes pixels))
  (encode-png (* width magnification) (* height magnification)
              (if (= magnification 1) bytes (magnify width height bytes magnification))))

(define (magnify width height bytes magnification)
  (define wide (* width magnification))
  (define target (make-bytes (* 3 wide height magnification)))
  (for* ([y (in-range height)] [x (in-range width)])
    (define from (* 3 (+ (* y width) x)))
    (for* ([down (in-range magnification)] [right (in-range magnification)])
      (define to (* 3 (+ (* (+ (* y magnification) down) wide) (* x magnification) right)))
      (bytes-copy! target to bytes from (+ from 3))))
  target)
