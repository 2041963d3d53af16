#lang racket/base
;; What every schedule shares: a counter from which workers take the next tile, and the flag by
;; which all of them are asked to stop.
(provide make-tile-counter take-tile! tiles-taken tile-counter-stop! work)

(struct tile-counter (next total [stopped? #:mutable]))

(define (make-tile-counter total) (tile-counter (box 0) total #f))

;; The next tile no worker has had, or #f when there is none or the render was stopped.
(define (take-tile! counter)
  (define next (tile-counter-next counter))
  (let try ()
    (define tile (unbox next))
    (cond
      [(or (tile-counter-stopped? counter) (>= tile (tile-counter-total counter))) #f]
      [(box-cas! next tile (+ tile 1)) tile]
      [else (try)])))

;; How many tiles have been taken.
(define (tiles-taken counter) (unbox (tile-counter-next counter)))

(define (tile-counter-stop! counter) (set-tile-counter-stopped?! counter #t))

;; Renders tiles until there are none.
(define (work render-tile! counter)
  (let loop ()
    (define tile (take-tile! counter))
    (when tile
      (render-tile! tile)
      (loop))))
