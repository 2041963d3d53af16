#lang typed/racket/base
;; The hashes as functions.
(require "../../private/sample/hash.rkt")

(provide hash-of hash-of-pair unit-of)

(: hash-of (-> Fixnum Fixnum))
(define (hash-of x) (hash32 x))

(: hash-of-pair (-> Fixnum Fixnum Fixnum))
(define (hash-of-pair a b) (hash-pair a b))

(: unit-of (-> Fixnum Flonum))
(define (unit-of h) (hash->unit h))
