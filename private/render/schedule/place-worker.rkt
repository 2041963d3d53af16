#lang racket/base
;; The other end of places.rkt: renders tiles of the job it is sent.
(require racket/place racket/fixnum "../film.rkt" "../job.rkt" "../transport.rkt")

(provide main)

;; After the job come the numbers of tiles, each answered when it is rendered, and in the end #f,
;; answered by what was counted.
(define (main channel)
  (define order (place-channel-get channel))
  (define (answer kind value) (place-channel-put channel (cons kind value)))
  (with-handlers ([exn:fail? (lambda (e) (answer 'failed (exn-message e)))])
    (define-values (render-tile! counts) 
      (Job-worker (message->value (car order)) (apply Target (cdr order))))
    (let loop ()
      (define tile (place-channel-get channel))
      (when tile
        (render-tile! tile)
        (answer 'rendered #t)
        (loop)))
    (answer 'counts (for/list ([n (in-fxvector counts)]) n))))
