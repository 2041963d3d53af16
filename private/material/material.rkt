#lang typed/racket/base
;; The supertype of materials. Each material is a substruct in a file of its own.
(provide (struct-out Material))

(struct Material () #:transparent)
