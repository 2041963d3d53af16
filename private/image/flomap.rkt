#lang racket/base
;; Flomaps from pixels and back. Loading their library is slow, so only a lazy-require names this
;; file.
(provide pixels->flomap flomap->pixels)
(require racket/flonum images/flomap)

(define (pixels->flomap width height pixels)
  (flomap (flvector-copy pixels) 3 width height))

;; flomap->pixels : width, height, and three numbers a pixel.
(define (flomap->pixels given)
  (unless (and (flomap? given) (<= 1 (flomap-components given) 4)
               (positive? (flomap-width given)) (positive? (flomap-height given)))
    (raise-argument-error 'flomap->Image "a flomap of one to four components" given))
  (define components (flomap-components given))
  (define values-given (flomap-values given))
  (define first (if (even? components) 1 0))
  (define step (if (> components 2) 1 0))
  (define-values (width height) (values (flomap-width given) (flomap-height given)))
  (define pixels (make-flvector (* 3 width height)))
  (for* ([k (in-range (* width height))] [channel (in-range 3)])
    (flvector-set! pixels (+ (* 3 k) channel)
                   (flvector-ref values-given (+ (* components k) first (* step channel)))))
  (values width height pixels))
