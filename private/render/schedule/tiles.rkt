#lang racket/base
;; What every schedule shares: a counter from which workers take the next tile, and the flag by
;; which all of them are asked to stop.
(provide make-tile-counter take-tile! tile-done! tiles-done tile-counter-stop! work
         call-with-lock)

;; skip: bytes, not 0 for the tiles that are not to be rendered, or #f. done: how many are.
(struct tile-counter (next total skip done [stopped? #:mutable]))

(define (make-tile-counter total [skip #f]) (tile-counter (box 0) total skip (box 0) #f))

;; The next tile no worker has had, or #f when there is none or the render was stopped.
(define (take-tile! counter)
  (define next (tile-counter-next counter))
  (define skip (tile-counter-skip counter))
  (let try ()
    (define tile (unbox next))
    (cond
      [(or (tile-counter-stopped? counter) (>= tile (tile-counter-total counter))) #f]
      [(not (box-cas! next tile (+ tile 1))) (try)]
      [(and skip (positive? (bytes-ref skip tile))) (try)]
      [else tile])))

(define (tile-done! counter)
  (define done (tile-counter-done counter))
  (let try ()
    (define count (unbox done))
    (unless (box-cas! done count (+ count 1)) (try))))

;; How many tiles have been rendered.
(define (tiles-done counter) (unbox (tile-counter-done counter)))

(define (tile-counter-stop! counter) (set-tile-counter-stopped?! counter #t))

;; Renders tiles until there are none.
(define (work render-tile! counter)
  (let loop ()
    (define tile (take-tile! counter))
    (when tile
      (render-tile! tile)
      (tile-done! counter)
      (loop))))

;; The value of (use) while no one else has the lock, a semaphore; breaks wait until then.
(define (call-with-lock lock use)
  (parameterize-break #f (call-with-semaphore lock use)))
