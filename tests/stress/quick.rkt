#lang racket/base
;; The stress suite at its quick size: one check a case.
(module+ test
  (require rackunit "case.rkt" "all.rkt")
  (for ([c (in-list stress-cases)])
    (define-values (measured passed? seconds) (run-case c QUICK))
    (check-true passed? (format "~a: ~a; pass: ~a" (stress-case-name c) measured
                                (stress-case-pass c)))))
