#lang racket/base
;; The warnings of one reading: one line each, one per kind, and not without end.

(provide make-warnings
         warn-once!
         warnings->list)

(require "file.rkt")

(struct warnings (kinds [lines #:mutable]) #:authentic)

(define most-warnings 20)

(define (make-warnings) (warnings (make-hash) '()))

;; Adds "path:line: message" unless there is one of this kind (any value) already.
(define (warn-once! w kind path line . message)
  (define kinds (warnings-kinds w))
  (define known (hash-count kinds))
  (unless (or (> known most-warnings) (hash-ref kinds kind #f))
    (hash-set! kinds kind #t)
    (define text
      (if (= known most-warnings)
          "more warnings are not shown"
          (apply format message)))
    (set-warnings-lines! w (cons (format "~a:~a: ~a" (path-label path) line text)
                                 (warnings-lines w)))))

;; The warnings in the order they were added.
(define (warnings->list w) (reverse (warnings-lines w)))
