#lang racket/base
;; The integer hash: its definition in exact integers, a permutation, avalanche, uniformity.

(module+ test
  (require racket/flonum rackunit "../statistics.rkt" "hashes.rkt")

  (define MASK #xFFFFFFFF)
  (define uniform (seeded 1))
  (define (random-word) (inexact->exact (floor (uniform 0.0 4294967296.0))))

  ;; O'Neill's step and RXS-M-XS output for 32 bits, in unbounded integers.
  (define (reference x)
    (define state (bitwise-and MASK (+ (* x 747796405) 2891336453)))
    (define shift (+ 4 (arithmetic-shift state -28)))
    (define word
      (bitwise-and MASK (* 277803737
                           (bitwise-xor state (arithmetic-shift state (- shift))))))
    (bitwise-xor word (arithmetic-shift word -22)))

  (test-case "equal to its definition: corners and 20,000 random words"
    (for ([x (append (list 0 1 2 MASK (- MASK 1) (expt 2 31)) (for/list ([k 20000]) (random-word)))])
      (unless (= (hash-of x) (reference x)) (fail (format "hash32 of ~a" x)))))

  (test-case "no two of 2^17 neighbours collide, nor of 2^17 with the low 15 bits 0"
    (for ([step (list 1 32768)])
      (define seen (make-hasheqv))
      (for ([k (expt 2 17)]) (hash-set! seen (hash-of (bitwise-and MASK (* k step))) #t))
      (check-equal? (hash-count seen) (expt 2 17))))

  (test-case "avalanche: each input bit turns each output bit half the time, within 0.1; on average
within 0.005"
    (define trials 2000)
    (define turned (make-vector 1024 0))
    (for* ([bit 32] [k trials])
      (define x (random-word))
      (define change (bitwise-xor (hash-of x) (hash-of (bitwise-xor x (arithmetic-shift 1 bit)))))
      (for ([b 32] #:when (bitwise-bit-set? change b))
        (define cell (+ b (* 32 bit)))
        (vector-set! turned cell (+ 1 (vector-ref turned cell)))))
    (define parts (for/list ([count turned]) (/ count (exact->inexact trials))))
    (for ([part parts]) (check-= part 0.5 0.1))
    (check-= (mean parts) 0.5 0.005))

  (test-case "consecutive words: uniform in 256 cells by high and by low bits; pairs uncorrelated"
    (define count (stressed 100000 1000000))
    (define units (for/list ([k count]) (unit-of (hash-of k))))
    (check-true (< (abs (uniform-deviate units 256)) 4.0))
    (check-true (< (abs (uniform-deviate
                         (for/list ([k count]) (/ (bitwise-and 255 (hash-of k)) 256.0)) 256))
                   4.0))
    (define row (apply flvector units))
    (define (check-uncorrelated other)
      (check-true (< (abs (correlation row other)) (/ 4.0 (sqrt count)))))
    (check-uncorrelated (for/flvector #:length count ([k count]) (unit-of (hash-of (+ k 1)))))
    (check-uncorrelated (for/flvector #:length count ([k count]) (unit-of (hash-of-pair 0 k))))
    (check-uncorrelated (for/flvector #:length count ([k count]) (unit-of (hash-of-pair k 0)))))

  (test-case "pairs: not symmetric, both words count, and within 32 bits"
    (for ([k 1000])
      (define-values (a b) (values (random-word) (random-word)))
      (define h (hash-of-pair a b))
      (check-true (<= 0 h MASK))
      (check-not-equal? h (hash-of-pair b a))
      (check-not-equal? h (hash-of-pair (bitwise-xor a 1) b))
      (check-not-equal? h (hash-of-pair a (bitwise-xor b 1)))))

  (test-case "as a number: h / 2^32 exactly, below 1"
    (for ([h (list 0 1 MASK 12345678)])
      (check-equal? (inexact->exact (unit-of h)) (/ h (expt 2 32))))))
