#lang racket/base
;; The other end of places.rkt: renders tiles of the job it is sent.
(require racket/place racket/fixnum "../job.rkt" "../transport.rkt")

(provide main)

(define (main channel)
  (define order (place-channel-get channel))
  (with-handlers ([exn:fail? (lambda (e)
                               (place-channel-put channel (cons 'failed (exn-message e))))])
    (define job (message->value (car order)))
    (define-values (render-tile! counts) (Job-worker job (cadr order)))
    (let loop ()
      (place-channel-put channel 'next)
      (define tile (place-channel-get channel))
      (when tile
        (render-tile! tile)
        (loop)))
    (place-channel-put channel (cons 'counts (for/list ([n (in-fxvector counts)]) n)))))
