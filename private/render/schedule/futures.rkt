#lang racket/base
;; Workers on futures: operating-system threads that share the memory of this process.
(require racket/future "../job.rkt" "../faults.rkt" "tiles.rkt")

(provide run-futures)

;; run-futures : as run-sequential, by as many workers as asked for.
(define (run-futures job target workers next-pass report!)
  (define procedures
    (for/list ([k (in-range workers)]) (Job-worker job target)))
  (call-without-exit
   (lambda ()
     (let pass ()
       (define counter (next-pass))
       (when counter
         (run-pass procedures counter report!)
         (pass))))))

;; Nothing that waits for the main thread may stand here, as with-handlers would: the future would render
;; only when touched.
(define (start render-tile! counter at) (future (lambda () (work render-tile! counter at))))

;; Each worker is a future, and each future is touched by a thread of its own: if a scene's function
;; does what a future may not, it goes on in that thread. So does a tile in which something was raised,
;; and then another future takes the worker's other tiles. What goes on being raised stops all of them
;; and is raised again here; so is a break.
(define (run-pass procedures counter report!)
  (define failure (box #f))
  (define futures
    (for/list ([render-tile! (in-list procedures)])
      (define at (box #f))
      (cons (start render-tile! counter at) at)))
  (define (finish f render-tile! at)
    (when (with-handlers ([fault? (lambda (e) (unless (unbox at) (raise e)) #t)])
            (touch f)
            #f)
      (render-carefully! render-tile! (unbox at) report!)
      (set-box! at #f)
      (tile-done! counter)
      (finish (start render-tile! counter at) render-tile! at)))
  (define threads
    (for/list ([f+at (in-list futures)] [render-tile! (in-list procedures)])
      (thread
       (lambda ()
         (with-handlers ([void (lambda (e)
                                 (box-cas! failure #f e)
                                 (tile-counter-stop! counter))])
           (finish (car f+at) render-tile! (cdr f+at)))))))
  (define (wait) (for-each thread-wait threads))
  (with-handlers ([exn:break? (lambda (e)
                                (tile-counter-stop! counter)
                                (wait)
                                (raise e))])
    (wait))
  (when (unbox failure) (raise (unbox failure))))
