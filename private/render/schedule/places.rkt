#lang racket/base
;; Workers in places: separate heaps in this process, which collect garbage by themselves. The world
;; goes there as a message (see transport.rkt) and is compiled there; the film is shared memory.
(require racket/place racket/runtime-path racket/flonum racket/fixnum
         "../job.rkt" "../transport.rkt" "tiles.rkt")

(provide run-places)

(define-runtime-path place-worker "place-worker.rkt")

;; run-places : as run-futures. `film` must be a shared flvector. A worker asks for a tile, renders
;; it and asks again; what it raises stops all of them and is raised here.
(define (run-places job film workers counter)
  (define message (value->message job))
  (define places
    (for/list ([k (in-range workers)])
      (define channel (dynamic-place place-worker 'main))
      (place-channel-put channel (list message film))
      channel))
  (define failure (box #f))
  (define results
    (for/list ([channel (in-list places)]) (box #f)))
  (define threads
    (for/list ([channel (in-list places)] [result (in-list results)])
      (thread (lambda () (serve channel result failure counter)))))
  (dynamic-wind
   void
   (lambda () (for-each thread-wait threads))
   (lambda ()
     (tile-counter-stop! counter)
     (for-each place-kill places)))
  (when (unbox failure) (error 'render (unbox failure)))
  (for/list ([result (in-list results)]) (list->fxvector (unbox result))))

;; Hands tiles to one place until there are none, then takes what it counted.
(define (serve channel result failure counter)
  (define (fail! message)
    (box-cas! failure #f message)
    (tile-counter-stop! counter))
  (let loop ()
    (define event (sync channel (handle-evt (place-dead-evt channel) (lambda (e) 'dead))))
    ;; a place that ended may have spoken before
    (define request (if (eq? event 'dead) (or (sync/timeout 0 channel) 'dead) event))
    (cond
      [(eq? request 'next)
       (place-channel-put channel (take-tile! counter))
       (loop)]
      [(eq? request 'dead) (fail! "a worker place ended by itself")]
      [(eq? (car request) 'counts) (set-box! result (cdr request))]
      [else (fail! (cdr request))])))

(define (list->fxvector numbers) (apply fxvector numbers))
