#lang racket/base
;; Schedules that are loaded only when asked for.
(require racket/lazy-require)

(provide run-places run-hosts read-hosts)

(lazy-require ["places.rkt" (run-places)]
              ["hosts.rkt" (run-hosts read-hosts)])
