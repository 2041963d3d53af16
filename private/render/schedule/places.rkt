#lang racket/base
;; Workers in places: separate heaps in this process, which collect garbage by themselves. The world
;; goes there as a message (see transport.rkt) or is loaded there from the scene's file, and is compiled
;; there. A place shares memory with this one for one tile only, so that it may end at any moment.
(require racket/place racket/runtime-path racket/flonum "../job.rkt" "crew.rkt" "desk.rkt")

(provide run-places place-watch least-stall-seconds stall-factor)

(define-runtime-path place-worker "place-worker.rkt")

;; Called with each place, and 'started or, when it is ready for its first tile, 'ready.
(define place-watch (make-parameter void))

;; run-places : as run-futures; places that end or stall are replaced.
(define (run-places job target workers next-pass report!)
  (define order (job->order job))
  (define watch (place-watch))
  (run-crew job target
            (for/list ([k (in-range workers)])
              (make-place-worker order (make-desk job target make-shared-flvector) watch))
            next-pass report!))

;; Places that end before they are ready, one after the other, with which the render ends.
(define MOST-FAILED-STARTS 10)

(define (make-place-worker order desk watch)
  (define place #f)
  (define (stop!)
    (when place
      (place-kill place)
      (set! place #f)))
  (define (start! finished?)
    (or place
        (let try ([left MOST-FAILED-STARTS])
          (when (zero? left) (error "worker places end before the first tile"))
          (define fresh (dynamic-place place-worker 'main))
          (set! place fresh)
          (watch fresh 'started)
          (place-channel-put fresh (list order (desk->list desk)))
          (cond
            [(pair? (receive fresh #f)) (watch fresh 'ready)]
            [else
             (stop!)
             (try (- left 1))])))
    #t)
  (define (render! tile seconds)
    (place-channel-put place tile)
    (define answer (receive place seconds))
    (cond
      [(pair? answer) (cdr answer)]
      [else
       (stop!) ; which waits until it writes no more
       answer]))
  (crew-worker desk start! render! stop!))

;; The place's next answer, 'dead where it has ended or 'stalled after so many seconds. Raises what the
;; place could not do at all.
(define (receive place seconds)
  (define event
    (sync/timeout seconds place (handle-evt (place-dead-evt place) (lambda (e) 'dead))))
  ;; a place that ended may have spoken before
  (define answer (if (eq? event 'dead) (or (sync/timeout 0 place) 'dead) (or event 'stalled)))
  (when (and (pair? answer) (eq? (car answer) 'failed))
    (error (cdr answer)))
  answer)
