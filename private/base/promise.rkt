#lang racket/base
;; A promise of a pure value, for Typed Racket. Whoever forces it may be interrupted or killed: it is
;; begun anew by the next. Threads that force it at once may each compute it; all get the first value.
(require racket/promise)

(provide once)

(define (once thunk)
  (define found #f)
  (delay/name
   (unbox (or found
              (let ([computed (box (thunk))])
                (unless found (set! found computed))
                found)))))
