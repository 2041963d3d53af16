#lang racket/base
;; Numbers for scenes that are strewn by chance, the same at every run.
(require raytrace)

(provide random-between)

;; The k-th number of a series, from low to high.
(define (random-between low high k #:series [series 0])
  (define-values (u v) (sample-point 'independent #:index k #:dimension series))
  (+ low (* (- high low) u)))
