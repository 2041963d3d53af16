#lang racket/base
;; Workers that may be lost: each is lent one tile at a time, and a tile whose worker dies or stalls is
;; done again by another.
(require "tiles.rkt" "desk.rkt")

(provide run-crew (struct-out crew-worker) least-stall-seconds stall-factor)

;; A worker: start! gets it going and returns when it can be given tiles, or #f when it never will or the
;; procedure it is given returns true. render! is given a tile and the desk with it and a number of seconds
;; or #f: returns the faults, or the symbol 'dead or 'stalled. stop! ends it for good.
(struct crew-worker (desk start! render! stop!))

;; A worker stalls when it is at a tile for so many times as long as any tile took so far, and for so many
;; seconds at least; after each loss of a tile it may take twice as long.
(define stall-factor (make-parameter 100.0))
(define least-stall-seconds (make-parameter 60.0))

;; A tile that loses as many workers is left in the error colour.
(define LOSSES 3)

(define (now) (/ (current-inexact-monotonic-milliseconds) 1000.0))

;; run-crew : renders all passes by the workers, a thread for each.
(define (run-crew job target workers next-pass report!)
  (define longest #f)
  (define least (least-stall-seconds))
  (define factor (stall-factor))
  (define losses (make-hasheqv))
  (define (allowance tile)
    (and longest
         (* (max least (* factor longest)) (expt 2 (hash-ref losses tile 0)))))
  (define (lost! worker tile why counter)
    (hash-update! losses tile add1 0)
    (cond
      [(< (hash-ref losses tile) LOSSES) (give-back! counter tile)]
      [else
       (report! (desk-fail! (crew-worker-desk worker) job target tile)
                (format "a tile ~a ~a times" (if (eq? why 'dead) "ended its worker" "stalled its worker")
                        LOSSES))
       (tile-done! counter)]))
  (define (serve worker counter going?)
    (define tile (and (or going? ((crew-worker-start! worker) (lambda () (tiles-finished? counter)))) (wait-for-tile counter)))
    (when tile
      (define desk (crew-worker-desk worker))
      (desk-lend! desk job target tile)
      (define start (now))
      (define answer ((crew-worker-render! worker) tile (allowance tile)))
      (cond
        [(symbol? answer)
         (lost! worker tile answer counter)
         (serve worker counter #f)]
        [else
         (set! longest (max (or longest 0.0) (- (now) start)))
         (desk-commit! desk job target tile)
         (for ([fault (in-list answer)]) (report! (car fault) (cdr fault)))
         (tile-done! counter)
         (serve worker counter #t)])))
  (dynamic-wind
   void
   (lambda ()
     (let pass ()
       (define counter (next-pass))
       (when counter
         (run-pass workers counter serve)
         (pass))))
   (lambda () (for ([worker (in-list workers)]) ((crew-worker-stop! worker))))))

;; The pass ends when all tiles are done, whether or not workers are still getting going; what is raised
;; ends it.
(define (run-pass workers counter serve)
  (define failure (box #f))
  (define threads
    (for/list ([worker (in-list workers)])
      (thread (lambda ()
                (with-handlers ([void (lambda (e)
                                        (box-cas! failure #f e)
                                        (tile-counter-stop! counter))])
                  (serve worker counter #f))))))
  (with-handlers ([exn:break? (lambda (e) (tile-counter-stop! counter) (raise e))])
    (for-each thread-wait threads))
  (when (unbox failure) (raise (unbox failure))))
