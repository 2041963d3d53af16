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
                 (list (lines (straightened at) #:color color #:width 2 #:label (car s))
                       (points at #:color color #:sym 'fullcircle)))
               path 'png
               #:title title #:x-label "CPU time (cu)" #:y-label "RMSE"
               #:width 640 #:height 420 #:legend-anchor 'bottom-left)))

;; Points along the straight lines that join points on logarithmic axes; plot draws lines as if axes
;; were not.
(define (straightened at)
  (define steps 24)
  (if (null? (cdr at))
      at
      (for*/list ([(p q) (in-parallel at (cdr at))] [k (in-range (+ steps 1))])
        (define (between a b) (* a (expt (/ b a) (/ k 1.0 steps))))
        (vector (between (vector-ref p 0) (vector-ref q 0))
                (between (vector-ref p 1) (vector-ref q 1))))))
