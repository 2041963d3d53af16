#lang racket/base
;; Rasterization, loaded only when it is asked for.
(require racket/lazy-require)

(provide raster-image)

(lazy-require ["raster.rkt" (preview)])

;; The picture that preview draws, by place.
(define (raster-image world camera width height samples shading crop)
  (preview world camera #:width width #:height height #:samples samples #:shading shading
           #:crop crop))
