#lang typed/racket/base
;; Integer hashing: the only source of randomness. Everything drawn is a function of what is hashed.
(require "../base/unsafe.rkt")

(provide hash32 hash-pair hash->unit MASK32)

(define-syntax-rule (MASK32) (fixnum-literal #xFFFFFFFF))

;; A 32-bit permutation with good avalanche: one step of a linear congruence and the output
;; function RXS-M-XS (O'Neill, "PCG", 2014; found best of its cost by Jarzynski and Olano, JCGT
;; 2020). x in [0, 2^32).
(define-syntax-rule (hash32 x)
  (let* ([state (fxand (fx+ (fx*/wraparound x (fixnum-literal 747796405))
                            (fixnum-literal 2891336453))
                       (MASK32))]
         [word (fxand (fx*/wraparound
                       (fxxor (fxrshift state (fx+ (fxrshift state 28) 4)) state)
                       (fixnum-literal 277803737))
                      (MASK32))])
    (fxxor (fxrshift word 22) word)))

;; Hash of two 32-bit integers; not symmetric.
(define-syntax-rule (hash-pair a b)
  (let ([inner (hash32 a)])
    (hash32 (fxand (fx+ inner b) (MASK32)))))

;; A 32-bit integer as a number in [0, 1).
(define-syntax-rule (hash->unit h) (fl* (fx->fl h) 2.3283064365386963e-10))
