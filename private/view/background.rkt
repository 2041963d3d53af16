#lang racket/base
;; What goes on behind a window: whoever looks orders pictures, only the newest order counts, and what
;; is found is shown as it comes.
(require "refine.rkt")

(provide start-background order! stop-background!)

;; The number of the last order and the thread that obeys.
(struct background (thread [orders #:mutable]))

;; start-background : show is called with the number of an order and a shown, fail with that number
;; and an exception, both from any thread. keeper: the custodian of what must not be cut off, for a
;; world that was half made ready could not be used again.
(define (start-background show fail #:keeper [keeper (current-custodian)])
  (background (thread (lambda () (obey show fail keeper))) 0))

;; order! : orders the picture of a scene; returns the order's number.
(define (order! to given)
  (define number (+ 1 (background-orders to)))
  (set-background-orders! to number)
  (thread-send (background-thread to) (cons number given) void)
  number)

;; stop-background! : ends what goes on; returns when it has ended.
(define (stop-background! to)
  (thread-send (background-thread to) 'stop void)
  (thread-wait (background-thread to)))

;; ----------------------------------------------------------------------------------------------

;; What does not end by then, for a function of its scene does not, is left alone or killed.
(define PATIENCE-SECONDS 5.0)

;; A thread and the custodian of all that it starts.
(struct job (thread custodian))

;; Obeys until it is told to stop. A coarse preview comes first, even while the last job is ending; a
;; job refines it unless there is another order by then.
(define (obey show fail keeper)
  (let loop ([divisor 2] [last #f])
    (define order (newest-order))
    (when last (break-thread (job-thread last)))
    (cond
      [(eq? order 'stop) (when last (end! last))]
      [else
       (define-values (number given start) (values (car order) (cdr order) (now)))
       (define found
         (patiently (lambda ()
                      (define-values (image seconds) (fast-preview given divisor))
                      (show number (shown image 0 #f seconds 0 #f))
                      (cons image seconds))
                    (lambda (e) (fail number e))))
       (define fitting (if found (next-divisor divisor (cdr found)) divisor))
       (cond
         [(or (not found) (and last (not (ended-before-mail? last)))) (loop fitting last)]
         [else
          (define sharp (and (= divisor 1) (car found)))
          (loop fitting
                (start-job (lambda ()
                             (finish given sharp start keeper (lambda (seen) (show number seen))))
                           (lambda (e) (fail number e))))])])))

;; Waits for an order and takes the last of those that are there.
(define (newest-order)
  (let next ([order (thread-receive)])
    (define newer (and (not (eq? order 'stop)) (thread-try-receive)))
    (if newer (next newer) order)))

;; The value of (act); #f where it raised, or where it takes long and there is another order: then it
;; goes on by itself.
(define (patiently act fail)
  (define value #f)
  (define worker
    (thread (lambda () (with-handlers ([exn:fail? fail]) (set! value (act))))))
  (unless (sync/timeout PATIENCE-SECONDS worker)
    (sync worker (thread-receive-evt)))
  value)

;; Whether a job ended, or was made to, before another order came.
(define (ended-before-mail? last)
  (define event (sync/timeout PATIENCE-SECONDS (job-thread last) (thread-receive-evt)))
  (cond
    [(not event) (custodian-shutdown-all (job-custodian last)) #t]
    [else (eq? event (job-thread last))]))

(define (end! last)
  (sync/timeout PATIENCE-SECONDS (job-thread last))
  (custodian-shutdown-all (job-custodian last)))

;; A break ends the job quietly, at whatever moment it comes.
(define (start-job act fail)
  (define custodian (make-custodian))
  (job (parameterize ([current-custodian custodian])
         (parameterize-break #f
           (thread (lambda ()
                     (with-handlers ([exn:break? void] [exn:fail? fail])
                       (parameterize-break #t (act)))))))
       custodian))

;; A preview in full size, unless it is there already, then all that follows.
(define (finish given sharp start keeper show)
  (define raster? (eq? 'raster (scene-integrator given)))
  (define under
    (if (and sharp (not raster?))
        sharp
        (let-values ([(image seconds)
                      (fast-preview given 1 #:samples
                                    (if raster? (min 64 (or (scene-samples given) 4)) 1))])
          (show (shown image 0 #f (- (now) start) 0 raster?))
          image)))
  (unless raster?
    (thread-wait
     (parameterize ([current-custodian keeper])
       (thread (lambda () (with-handlers ([exn:fail? void]) (make-ready given))))))
    (refine given under show start)))
