#lang racket/base
;; One worker on the calling thread.
(require "../job.rkt" "tiles.rkt")

(provide run-sequential)

;; run-sequential : renders every tile of the job into the film; a list of what workers counted.
(define (run-sequential job film workers counter)
  (define-values (render-tile! counts) (Job-worker job film))
  (work render-tile! counter)
  (list counts))
