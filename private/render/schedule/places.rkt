#lang racket/base
;; Workers in places: separate heaps in this process, which collect garbage by themselves. The world
;; goes there as a message (see transport.rkt) and is compiled there; the film is shared memory.
(require racket/place racket/runtime-path racket/flonum racket/fixnum
         "../film.rkt" "../transport.rkt" "tiles.rkt")

(provide run-places)

(define-runtime-path place-worker "place-worker.rkt")

;; run-places : as run-futures. The target's flvectors must be shared. A worker asks for a tile, renders
;; it and asks again; what it raises stops all of them and is raised here.
(define (run-places job target workers next-pass)
  (define message (value->message job))
  (define places
    (for/list ([k (in-range workers)])
      (define channel (dynamic-place place-worker 'main))
      (place-channel-put channel (list message (Target-film target) (Target-errors target) (Target-tallies target)))
      channel))
  (dynamic-wind
   void
   (lambda ()
     (let pass ()
       (define counter (next-pass))
       (when counter
         (for-each-place places (lambda (channel fail!) (serve channel fail! counter))
                         (lambda () (tile-counter-stop! counter)))
         (pass)))
     (define counts (make-hasheq))
     (for-each-place places (lambda (channel fail!)
                              (define answer (ask channel #f fail!))
                              (when answer (hash-set! counts channel answer)))
                     void)
     (for/list ([channel (in-list places)])
       (apply fxvector (hash-ref counts channel))))
   (lambda () (for-each place-kill places))))

;; Does the same with every place at once, in a thread for each; the first that fails ends it.
(define (for-each-place places act stop!)
  (define failure (box #f))
  (define (fail! message)
    (box-cas! failure #f message)
    (stop!))
  (define threads
    (for/list ([channel (in-list places)])
      (thread (lambda () (act channel fail!)))))
  (with-handlers ([exn:break? (lambda (e) (stop!) (raise e))])
    (for-each thread-wait threads))
  (when (unbox failure) (error 'render (unbox failure))))

;; Hands tiles to one place until there are none in this pass.
(define (serve channel fail! counter)
  (define tile (take-tile! counter))
  (when (and tile (ask channel tile fail!))
    (tile-done! counter)
    (serve channel fail! counter)))

;; Sends a tile, or #f for "no more", and waits for the answer; #f where there is none.
(define (ask channel tile fail!)
  (place-channel-put channel tile)
  (define event (sync channel (handle-evt (place-dead-evt channel) (lambda (e) 'dead))))
  ;; a place that ended may have spoken before
  (define answer (if (eq? event 'dead) (or (sync/timeout 0 channel) 'dead) event))
  (cond
    [(eq? answer 'dead) (fail! "a worker place ended by itself") #f]
    [(eq? (car answer) 'failed) (fail! (cdr answer)) #f]
    [else (cdr answer)]))
