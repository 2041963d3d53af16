#lang racket/base
;; The place on a host that renders tiles for hosts.rkt.
(require racket/place racket/fasl racket/flonum "../job.rkt" "desk.rkt" "host-check.rkt" "tiles.rkt")

(provide main)

;; The order in fasl is answered by ('ready), or a pair of 'refused and why. Then come lists of a tile
;; and the bytes of its desk, answered by 'rendered, the tile, its faults and the bytes.
(define (main channel)
  (define (answer . parts) (place-channel-put channel parts))
  (parameterize ([current-namespace (variable-reference->empty-namespace (#%variable-reference))]
                 [current-output-port (current-error-port)])
    (call-without-exit
     (lambda ()
       (define job
         (with-handlers ([fault? (lambda (e) (if (exn? e) (exn-message e) (format "raised ~e" e)))])
           (host-order->job (fasl->s-exp (place-channel-get channel)))))
       (cond
         [(string? job) (place-channel-put channel (cons 'refused job))]
         [else
          (define desk (make-desk job (Job-target job (lambda (size value) (flvector))) make-flvector))
          (define render-tile! (Job-worker job desk #t))
          (answer 'ready)
          (let loop ()
            (define order (place-channel-get channel))
            (bytes->desk! desk (cadr order) #t)
            (define faults (render-with-faults render-tile! (car order)))
            (answer 'rendered (car order) faults (desk->bytes desk #f))
            (loop))])))))
