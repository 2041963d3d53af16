#lang racket/base
;; The merging table against Racket's own hash table.

(module+ test
  (require rackunit
           "../../private/read/index-table.rkt")

  ;; Indices given to keys by the table, hashed by hash.
  (define (intern-all keys hash)
    (define table (make-index-table))
    (define seen (make-hasheqv))
    (for/list ([key (in-list keys)])
      (define index
        (index-table-intern! table (hash key) (λ (k) (equal? key (hash-ref seen k)))))
      (unless (hash-has-key? seen index)
        (check-equal? index (hash-count seen))
        (hash-set! seen index key))
      index))

  (define (expected keys)
    (define seen (make-hash))
    (for/list ([key (in-list keys)])
      (hash-ref! seen key (hash-count seen))))

  (define keys
    (for/list ([i (in-range 5000)])
      (list (modulo (* i i) 977) (modulo i 7) (- (modulo i 3)))))

  (test-case "first come, first numbered; also when every hash is the same"
    (check-equal? (intern-all keys (λ (key) (apply mix-hash key))) (expected keys))
    (define few (for/list ([i (in-range 500)]) (modulo i 90)))
    (check-equal? (intern-all few (λ (_) 5)) (expected few)))

  (test-case "hashes of neighbouring keys fill 4096 cells like random ones: chi-square, z < 5"
    (for ([key-of (in-list (list (λ (i) (list i -1 -1)) (λ (i) (list 0 i i))
                                 (λ (i) (list (arithmetic-shift i 12) 0 i))))])
      (define counts (make-vector 4096 0))
      (for ([i (in-range 65536)])
        (define cell (bitwise-and 4095 (apply mix-hash (key-of i))))
        (vector-set! counts cell (+ 1 (vector-ref counts cell))))
      (define chi-square
        (for/sum ([n (in-vector counts)]) (/ (expt (- n 16.0) 2) 16.0)))
      (check-true (< (/ (- chi-square 4095) (sqrt (* 2 4095))) 5.0)))))
