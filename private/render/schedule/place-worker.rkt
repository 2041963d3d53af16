#lang racket/base
;; The other end of places.rkt: renders tiles of the job it is sent, each on the desk it shares.
(require racket/place "../job.rkt" "desk.rkt" "tiles.rkt")

(provide main)

;; After the job, answered by 'ready, come the numbers of tiles, each answered by 'rendered and the
;; pixels that are left in the error colour, with why.
(define (main channel)
  (define order (place-channel-get channel))
  (define (answer kind value) (place-channel-put channel (cons kind value)))
  (parameterize ([current-namespace (variable-reference->empty-namespace (#%variable-reference))]
                 [current-output-port (current-error-port)])
    (with-handlers ([exn:fail? (lambda (e) (answer 'failed (exn-message e)))])
      (call-without-exit
       (lambda ()
         (define render-tile! (Job-worker (order->job (car order)) (list->desk (cadr order)) #t))
         (answer 'ready #t)
         (let loop ()
           (define tile (place-channel-get channel))
           (answer 'rendered (render-with-faults render-tile! tile))
           (loop)))))))
