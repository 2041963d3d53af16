#lang racket/base
;; Workers on futures: operating-system threads that share the memory of this process.
(require racket/future "tiles.rkt")

(provide run-futures)

;; Each worker is a future, and each future is touched by a thread of its own: if a scene's function
;; does what a future may not, it goes on in that thread. The first exception stops the others and
;; is raised again here; so is a break.
(define (run-futures workers counter)
  (define (work render-tile!)
    (let loop ()
      (define tile (take-tile! counter))
      (when tile
        (render-tile! tile)
        (loop))))
  (define failure (box #f))
  (define futures
    (for/list ([render-tile! (in-list workers)])
      (future (lambda () (work render-tile!)))))
  (define threads
    (for/list ([f (in-list futures)])
      (thread
       (lambda ()
         (with-handlers ([(lambda (e) #t)
                          (lambda (e)
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
