#lang typed/racket/base
;; Four ways to spread points over the unit square, each a pure function of a seed and an index: it
;; leaves a pair of numbers in [0,1) in sample-u and sample-v.
(require "../base/unsafe.rkt" "../base/registers.rkt" "hash.rkt")

(provide owen-sobol-pair! independent-pair! stratified-pair! r2-pair!
         scrambled-sobol-u scrambled-sobol-v rotated-r2-u rotated-r2-v independent-u independent-v
         shuffled-index)

;; The first two Sobol dimensions, their index shuffled and each scrambled by its own seed
;; (Burley, "Practical Hash-based Owen Scrambling", JCGT 2020). Every 2^m points that start at a
;; multiple of 2^m are a (0,m,2)-net; other dimensions are other seeds.
(: owen-sobol-pair! (-> FlVector Fixnum Fixnum Void))
(define (owen-sobol-pair! r seed index)
  (define seed-u (hash32 seed))
  (define place (shuffled-index index seed))
  (flvector-set! r sample-u (scrambled-sobol-u place seed-u))
  (flvector-set! r sample-v (scrambled-sobol-v place (hash32 seed-u))))

;; Numbers that have nothing to do with each other.
(: independent-pair! (-> FlVector Fixnum Fixnum Void))
(define (independent-pair! r seed index)
  (flvector-set! r sample-u (independent-u seed index))
  (flvector-set! r sample-v (independent-v seed index)))

(define-syntax-rule (independent-u seed index) (hash->unit (hash-pair seed index)))
(define-syntax-rule (independent-v seed index)
  (let ([hash-u (hash-pair seed index)])
    (hash->unit (hash-pair hash-u (fixnum-literal #x9E3779B9)))))

;; One point anywhere in each cell of a grid, the cells in an order the seed chooses. `count` points
;; make one grid, as square as the count allows (a prime has one row); the next `count` another one.
(: stratified-pair! (-> FlVector Fixnum Fixnum Fixnum Void))
(define (stratified-pair! r seed0 index0 count)
  (define seed (hash-pair seed0 (fxquotient index0 count)))
  (define index (fxremainder index0 count))
  (define rows (largest-divisor-to-root count))
  (define columns (fxquotient count rows))
  (define cell (permuted index count seed))
  (define hash-u (hash-pair seed index))
  (put-cell-pair! r (fxremainder cell columns) (fxquotient cell columns) columns rows
                  hash-u (hash-pair hash-u (fixnum-literal #x9E3779B9))))

;; The generalised golden ratio's sequence in two dimensions (Roberts 2018), its index shuffled and
;; the square rotated by an offset of the seed's (Cranley and Patterson 1976).
(: r2-pair! (-> FlVector Fixnum Fixnum Void))
(define (r2-pair! r seed index)
  (define seed-u (hash32 seed))
  (define place (shuffled-index index seed))
  (flvector-set! r sample-u (rotated-r2-u place seed-u))
  (flvector-set! r sample-v (rotated-r2-v place (hash32 seed-u))))

;; ----------------------------------------------------------------------------------------------

;; Reverses 32 bits, by bytes: the table costs half of what shifting ever smaller groups does.
(define-syntax-rule (reverse-bits x0)
  (let ([x x0])
    (fxior (fxior (fxlshift (reversed-byte (fxand x 255)) 24)
                  (fxlshift (reversed-byte (fxand (fxrshift x 8) 255)) 16))
           (fxior (fxlshift (reversed-byte (fxand (fxrshift x 16) 255)) 8)
                  (reversed-byte (fxrshift x 24))))))
(define-syntax-rule (reversed-byte x) (fxvector-ref REVERSED-BYTES x))
(define REVERSED-BYTES : FxVector
  (let ([table (make-fxvector 256 0)])
    (for* ([byte : Nonnegative-Fixnum (in-range 256)] [bit : Nonnegative-Fixnum (in-range 8)])
      (unless (fx= 0 (fxand byte (fxlshift 1 bit)))
        (fxvector-set! table byte (fxior (fxvector-ref table byte) (fxlshift 1 (fx- 7 bit))))))
    table))

;; Owen scrambling of the reversed bits of x by a hash in which a bit depends on lower bits only
;; (Laine and Karras 2011; constants by Vegdahl 2021).
(define-syntax-rule (scramble-reversed x0 seed0)
  (let* ([seed seed0]
         [x x0]
         [x (fxxor x (fxand (fx*/wraparound x (fixnum-literal #x3d20adea)) (MASK32)))]
         [x (fxand (fx+ x seed) (MASK32))]
         [x (fxand (fx*/wraparound x (fxior (fxrshift seed 16) 1)) (MASK32))]
         [x (fxxor x (fxand (fx*/wraparound x (fixnum-literal #x05526c56)) (MASK32)))])
    (fxxor x (fxand (fx*/wraparound x (fixnum-literal #x53a22864)) (MASK32)))))

;; The Pascal matrix modulo 2 on reversed bits: the second Sobol dimension, by halves.
(define-syntax-rule (pascal x0)
  (let* ([x x0]
         [x (fxxor x (fxand (fxrshift x 16) (fixnum-literal #x0000FFFF)))]
         [x (fxxor x (fxand (fxrshift x 8) (fixnum-literal #x00FF00FF)))]
         [x (fxxor x (fxand (fxrshift x 4) (fixnum-literal #x0F0F0F0F)))]
         [x (fxxor x (fxand (fxrshift x 2) (fixnum-literal #x33333333)))])
    (fxxor x (fxand (fxrshift x 1) (fixnum-literal #x55555555)))))

;; An index moved within its aligned block of every size by an Owen scramble.
(define-syntax-rule (shuffled-index index seed)
  (reverse-bits (scramble-reversed (reverse-bits index) seed)))

;; The first two Sobol dimensions at an index, each scrambled by its own seed.
(define-syntax-rule (scrambled-sobol-u index seed-u)
  (hash->unit (reverse-bits (scramble-reversed index seed-u))))
(define-syntax-rule (scrambled-sobol-v index seed-v)
  (hash->unit (reverse-bits (scramble-reversed (pascal index) seed-v))))

;; Point `index` of the R2 sequence, in 32-bit fractions, rotated by two offsets.
(define-syntax-rule (rotated-r2-u index offset-u)
  (hash->unit (fxand (fx+ offset-u (fx*/wraparound index (fixnum-literal 3242174889))) (MASK32))))
(define-syntax-rule (rotated-r2-v index offset-v)
  (hash->unit (fxand (fx+ offset-v (fx*/wraparound index (fixnum-literal 2447445414))) (MASK32))))

;; A point in a cell, chosen by two hashes.
(: put-cell-pair! (-> FlVector Fixnum Fixnum Fixnum Fixnum Fixnum Fixnum Void))
(define (put-cell-pair! r column row columns rows hash-u hash-v)
  (flvector-set! r sample-u (below-one (fl/ (fl+ (fx->fl column) (hash->unit hash-u))
                                            (fx->fl columns))))
  (flvector-set! r sample-v (below-one (fl/ (fl+ (fx->fl row) (hash->unit hash-v))
                                            (fx->fl rows)))))

(define-syntax-rule (below-one x) (flmin x 0.9999999999999999))

(: largest-divisor-to-root (-> Fixnum Fixnum))
(define (largest-divisor-to-root count)
  (let try ([d : Fixnum (fl->fx (flsqrt (fx->fl count)))])
    (cond
      [(fx<= d 1) 1]
      [(fx= 0 (fxremainder count d)) d]
      [else (try (fx- d 1))])))

;; Where index goes in a permutation of 0 .. count - 1 (Kensler, "Correlated Multi-Jittered
;; Sampling", 2013): a hash that permutes the next power of two, walked until it falls below count,
;; and turned by another hash of the seed.
(: permuted (-> Fixnum Fixnum Fixnum Fixnum))
(define (permuted index count seed)
  (define mask (ones-up-to (fx- count 1)))
  (define odd (fxior 1 (fxlshift seed 1)))
  (let walk ([k : Fixnum index])
    (let* ([k (fxxor k seed)]
           [k (fx*/wraparound (fxand k mask) (fixnum-literal #xe170893d))]
           [k (fxxor k (fxrshift seed 16))]
           [k (fxand k mask)]
           [k (fxxor k (fxrshift k 4))]
           [k (fxxor k (fxrshift seed 8))]
           [k (fx*/wraparound (fxand k mask) (fixnum-literal #x0929eb3f))]
           [k (fxxor k (fxrshift seed 23))]
           [k (fxand k mask)]
           [k (fxxor k (fxrshift k 1))]
           [k (fxand (fx*/wraparound k odd) mask)]
           [k (fxand (fx*/wraparound k (fixnum-literal #x6935fa69)) mask)]
           [k (fxxor k (fxrshift k 11))]
           [k (fxand (fx*/wraparound k (fixnum-literal #x74dcb303)) mask)]
           [k (fxxor k (fxrshift k 2))]
           [k (fxand (fx*/wraparound k (fixnum-literal #x9e501cc3)) mask)]
           [k (fxxor k (fxrshift k 5))])
      ;; the turn makes every cell as likely as any other at small counts too
      (if (fx< k count) (fxremainder (fx+ k (hash32 seed)) count) (walk k)))))

;; The least 2^m - 1 that is not below x.
(: ones-up-to (-> Fixnum Fixnum))
(define (ones-up-to x0)
  (let* ([x x0]
         [x (fxior x (fxrshift x 1))]
         [x (fxior x (fxrshift x 2))]
         [x (fxior x (fxrshift x 4))]
         [x (fxior x (fxrshift x 8))])
    (fxior x (fxrshift x 16))))
