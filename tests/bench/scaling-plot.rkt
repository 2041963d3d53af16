#lang racket/base
;; Time a ray against the number of spheres, both on logarithmic axes.
(require plot/no-gui)

(provide write-scaling-plot)

;; rows: (list n µs-a-ray scan-µs-or-#f build-seconds)
(define (write-scaling-plot rows path)
  (define (series pick)
    (for*/list ([row (in-list rows)] [value (in-value (pick row))] #:when value)
      (vector (car row) value)))
  (parameterize ([plot-x-transform log-transform]
                 [plot-y-transform log-transform]
                 [plot-x-ticks (log-ticks)]
                 [plot-y-ticks (log-ticks)])
    (plot-file (list (lines (series cadr) #:label "hierarchy" #:color 3 #:width 2)
                     (points (series cadr) #:color 3 #:sym (quote fullcircle))
                     (lines (series caddr) #:label "linear scan" #:color 1 #:width 2)
                     (points (series caddr) #:color 1 #:sym (quote fullcircle)))
               path 'png
               #:x-label "spheres" #:y-label "microseconds a ray"
               #:title "Random rays among spheres of equal density"
               #:width 640 #:height 420)))

