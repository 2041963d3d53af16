#lang racket/base
;; Schedules that are loaded only when asked for.
(require racket/lazy-require)

(provide run-places)

(lazy-require ["places.rkt" (run-places)])
