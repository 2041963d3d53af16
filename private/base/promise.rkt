#lang racket/base
;; A promise that any number of threads may force at once, for Typed Racket, which lacks it.
(require racket/promise)

(provide once)

(define (once thunk) (delay/sync (thunk)))
