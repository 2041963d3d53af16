#lang racket/base
;; One worker on the calling thread.
(require "../job.rkt" "tiles.rkt")

(provide run-sequential)

;; run-sequential : renders the job into the target, pass by pass; a list of what workers counted.
;; next-pass gives the counter of the tiles of another pass, or #f when there is none; it is called
;; when the workers have finished the last one.
(define (run-sequential job target workers next-pass)
  (define-values (render-tile! counts) (Job-worker job target))
  (let pass ()
    (define counter (next-pass))
    (when counter
      (work render-tile! counter)
      (pass)))
  (list counts))
