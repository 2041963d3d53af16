#lang racket/base
;; How values print; what does it is loaded when the first one is printed.
(require racket/lazy-require)

(provide print-struct print-call)

(lazy-require ["expression.rkt" (print-struct print-call)])
