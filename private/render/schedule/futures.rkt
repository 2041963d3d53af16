#lang racket/base
;; Workers on futures: operating-system threads that share the memory of this process.
(require racket/future "../job.rkt" "tiles.rkt")

(provide run-futures)

;; run-futures : as run-sequential, by as many workers as asked for.
(define (run-futures job target workers next-pass)
  (define-values (procedures counts)
    (for/lists (procedures counts) ([k (in-range workers)])
      (Job-worker job target)))
  (let pass ()
    (define counter (next-pass))
    (when counter
      (run-pass procedures counter)
      (pass)))
  counts)

;; Each worker is a future, and each future is touched by a thread of its own: if a scene's function
;; does what a future may not, it goes on in that thread. The first exception stops the others and is
;; raised again here; so is a break.
(define (run-pass procedures counter)
  (define failure (box #f))
  (define futures
    (for/list ([render-tile! (in-list procedures)])
      (future (lambda () (work render-tile! counter)))))
  (define threads
    (for/list ([f (in-list futures)])
      (thread
       (lambda ()
         (with-handlers ([void (lambda (e)
                                 (box-cas! failure #f e)
                                 (tile-counter-stop! counter))])
           (touch f))))))
  (define (wait) (for-each thread-wait threads))
  (with-handlers ([exn:break? (lambda (e)
                                (tile-counter-stop! counter)
                                (wait)
                                (raise e))])
    (wait))
  (when (unbox failure) (raise (unbox failure))))
