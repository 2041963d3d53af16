#lang racket/base
;; RMSE against CPU time, both on logarithmic axes, a line for each way of sampling.
(require plot/no-gui)

(provide write-error-plot)

;; series: (list name (list (cons cu rmse) ...)) for each.
(define (write-error-plot title series path)
  (parameterize ([plot-x-transform log-transform]
                 [plot-y-transform log-transform]
                 [plot-x-ticks (log-ticks)]
                 [plot-y-ticks (log-ticks)])
    (plot-file (for/list ([s (in-list series)] [color (in-naturals 1)] #:unless (null? (cadr s)))
                 (define at (for/list ([p (in-list (cadr s))]) (vector (car p) (cdr p))))
                 (list (lines at #:color color #:width 2 #:label (car s))
                       (points at #:color color #:sym 'fullcircle)))
               path 'png
               #:title title #:x-label "CPU time (cu)" #:y-label "RMSE"
               #:width 640 #:height 420 #:legend-anchor 'bottom-left)))
