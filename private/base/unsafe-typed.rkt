#lang racket/base
;; Typed Racket's unsafe-require/typed, brought in only while a module is being compiled: requiring
;; typed/racket/unsafe directly makes every program that loads the module load the type checker.
(provide unsafe-require/typed)
(require racket/lazy-require)

(lazy-require-syntax [typed/racket/unsafe (unsafe-require/typed)])
