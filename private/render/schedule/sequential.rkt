#lang racket/base
;; One worker after another, on the calling thread.
(require "tiles.rkt")

(provide run-sequential)

;; workers: a list of procedures that render the tile they are given.
(define (run-sequential workers counter)
  (define render-tile! (car workers))
  (let loop ()
    (define tile (take-tile! counter))
    (when tile
      (render-tile! tile)
      (loop))))
