#lang racket/base
;; One worker on the calling thread.
(require "../job.rkt" "tiles.rkt")

(provide run-sequential)

;; run-sequential : renders the job into the target, pass by pass; see tiles.rkt.
(define (run-sequential job target workers next-pass report!)
  (define render-tile! (Job-worker job target))
  (define at (box #f))
  (define (finish counter)
    (when (with-handlers ([fault? (lambda (e) (unless (unbox at) (raise e)) #t)])
            (work render-tile! counter at)
            #f)
      (render-carefully! render-tile! (unbox at) report!)
      (tile-done! counter)
      (finish counter)))
  (call-without-exit
   (lambda ()
     (let pass ()
       (define counter (next-pass))
       (when counter
         (finish counter)
         (pass))))))
