#lang racket/base
;; Evaluators for the manual's examples, which render pictures while a page is built.
(require racket/lazy-require)

(provide make-pictures)

(lazy-require [scribble/example (make-base-eval)]) ; not loaded where the package is compiled alone

;; make-pictures : an evaluator of racket/base with raytrace. Where the environment says
;; RAYTRACE_MANUAL=small, all pictures are an eighth as large and of two samples, to see quickly
;; whether every example runs.
(define (make-pictures)
  (define evaluate (make-base-eval #:lang 'racket/base '(require raytrace)))
  (when (equal? (getenv "RAYTRACE_MANUAL") "small")
    (for-each evaluate small-pictures))
  evaluate)

;; Definitions that take the place of what raytrace provides under these names.
(define small-pictures
  '((require (only-in raytrace [render render/full-size] [preview preview/full-size]))
    (define (smaller make)
      (make-keyword-procedure
       (lambda (keywords values . arguments)
         (keyword-apply make keywords
                        (for/list ([keyword keywords] [value values])
                          (case keyword
                            [(#:width #:height) (max 1 (quotient value 8))]
                            [(#:samples) (and value (min value 2))]
                            [(#:seconds) (and value (min value 0.1))]
                            [(#:error) (and value (max value 0.1))]
                            [else value]))
                        arguments))))
    (define render (smaller render/full-size))
    (define preview (smaller preview/full-size))))
