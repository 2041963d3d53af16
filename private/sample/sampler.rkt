#lang typed/racket/base
;; Samplers: how the samples of a pixel are spread. A sample is a pure function of (pixel, sample
;; index, dimension, seed); kernels ask for one pair of numbers in [0,1) at a time.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/check.rkt"
         "hash.rkt" "point-sets.rkt")

(provide SAMPLERS sampler-number Sampler-choose! Sampler-start! sample-point
         sample-pair! sample-next-pair! sample-fold-start! sample-fold-pair! sample-fold-first!
         sample-fold-second!)

;; By name, in the order of their numbers in the scratch.
(define SAMPLERS : (Listof Symbol) '(owen-sobol independent stratified r2))
(define-syntax-rule (OWEN-SOBOL) 0)
(define-syntax-rule (INDEPENDENT) 1)
(define-syntax-rule (STRATIFIED) 2)

;; The number of a sampler by name; raises for other names.
(: sampler-number (-> Symbol Fixnum))
(define (sampler-number name)
  (let find ([names : (Listof Symbol) SAMPLERS] [k : Fixnum 0])
    (cond
      [(null? names) (raise-expected 'render "sampler" (format "one of ~a" SAMPLERS) name)]
      [(eq? (car names) name) k]
      [else (find (cdr names) (fx+ k 1))])))

;; Prepares a scratch for a sampler; `count` samples a pixel make one grid of the stratified one.
;; A scratch that is not told otherwise has owen-sobol.
(: Sampler-choose! (-> FxVector Fixnum Fixnum Void))
(define (Sampler-choose! i number count)
  (fxvector-set! i sampler-kind number)
  (fxvector-set! i sampler-count count))

;; Prepares the scratch for one sample of one pixel.
(: Sampler-start! (-> FxVector Fixnum Fixnum Fixnum Void))
(define (Sampler-start! i pixel seed index)
  (fxvector-set! i sampler-key (hash-pair (fxand seed (MASK32)) (fxand pixel (MASK32))))
  (fxvector-set! i sampler-index index)
  (fxvector-set! i sampler-dimension 0))

;; sample-point : the pair of numbers that a sampler gives for a pixel's sample and dimension; the
;; indices from 0 to `count` - 1 are one grid of the stratified sampler. All whole numbers below 2^32.
(: sample-point (->* (Symbol #:index Integer)
                     (#:pixel Integer #:dimension Integer #:seed Integer #:count Integer)
                     (Values Flonum Flonum)))
(define (sample-point sampler #:index index #:pixel [pixel 0] #:dimension [dimension 0]
                      #:seed [seed 0] #:count [count 16])
  (define (whole [name : String] [low : Integer] [n : Integer])
    (check-count 'sample-point name n low #xFFFFFFFF))
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (Sampler-choose! i (sampler-number sampler) (whole "count" 1 count))
  (Sampler-start! i (whole "pixel" 0 pixel) (whole "seed" 0 seed) 0)
  (sample-pair! r i (whole "dimension" 0 dimension) (whole "index" 0 index))
  (values (flvector-ref r sample-u) (flvector-ref r sample-v)))

;; The pair of the next dimension at the current sample, into sample-u and sample-v.
(: sample-next-pair! (-> FlVector FxVector Void))
(define (sample-next-pair! r i)
  (define dimension (fxvector-ref i sampler-dimension))
  (fxvector-set! i sampler-dimension (fx+ dimension 1))
  (sample-pair! r i dimension (fxvector-ref i sampler-index)))

;; The pair of a dimension at an index.
(: sample-pair! (-> FlVector FxVector Fixnum Fixnum Void))
(define (sample-pair! r i dimension index)
  (define seed (hash-pair (fxvector-ref i sampler-key) dimension))
  (define kind (fxvector-ref i sampler-kind))
  (cond
    [(fx= kind (OWEN-SOBOL)) (owen-sobol-pair! r seed index)]
    [(fx= kind (INDEPENDENT)) (independent-pair! r seed index)]
    [(fx= kind (STRATIFIED)) (stratified-pair! r seed index (fxvector-ref i sampler-count))]
    [else (r2-pair! r seed index)]))

;; Begins a fold over `count` samples at one point of the path: a dimension of its own, in which
;; every camera sample has its own block of `count` consecutive points, so that all blocks together
;; are well spread too. The blocks are shuffled like the indices of other dimensions.
(: sample-fold-start! (-> FxVector Fixnum Void))
(define (sample-fold-start! i count)
  (define dimension (fxvector-ref i sampler-dimension))
  (define seed (hash-pair (fxvector-ref i sampler-key) dimension))
  (define block (shuffled-index (fxvector-ref i sampler-index) seed))
  (define seed-u (hash32 seed))
  (fxvector-set! i sampler-dimension (fx+ dimension 1))
  (fxvector-set! i fold-start (fxand (fx*/wraparound block count) (MASK32)))
  (fxvector-set! i fold-count count)
  (fxvector-set! i fold-seed-u seed-u)
  (fxvector-set! i fold-seed-v (hash32 seed-u)))

;; The pair of the n-th sample of the fold.
(: sample-fold-pair! (-> FlVector FxVector Fixnum Void))
(define (sample-fold-pair! r i n)
  (sample-fold-first! r i n)
  (sample-fold-second! r i n))

;; The first number of the n-th sample of the fold, into sample-u; where it already decides the
;; second one, which costs more, need not be asked for.
(: sample-fold-first! (-> FlVector FxVector Fixnum Void))
(define (sample-fold-first! r i n)
  (define index (fold-index i n))
  (define seed-u (fxvector-ref i fold-seed-u))
  (define kind (fxvector-ref i sampler-kind))
  (cond
    [(fx= kind (OWEN-SOBOL)) (flvector-set! r sample-u (scrambled-sobol-u index seed-u))]
    [(fx= kind (INDEPENDENT)) (flvector-set! r sample-u (independent-u seed-u index))]
    [(fx= kind (STRATIFIED))
     (stratified-pair! r (hash-pair seed-u (fxvector-ref i fold-start)) n
                       (fxvector-ref i fold-count))]
    [else (flvector-set! r sample-u (rotated-r2-u index seed-u))]))

;; The second number of the n-th sample of the fold, after the first, into sample-v.
(: sample-fold-second! (-> FlVector FxVector Fixnum Void))
(define (sample-fold-second! r i n)
  (define index (fold-index i n))
  (define seed-v (fxvector-ref i fold-seed-v))
  (define kind (fxvector-ref i sampler-kind))
  (cond
    [(fx= kind (OWEN-SOBOL)) (flvector-set! r sample-v (scrambled-sobol-v index seed-v))]
    [(fx= kind (INDEPENDENT))
     (flvector-set! r sample-v (independent-v (fxvector-ref i fold-seed-u) index))]
    ;; both numbers of a cell came together
    [(fx= kind (STRATIFIED)) (void)]
    [else (flvector-set! r sample-v (rotated-r2-v index seed-v))]))

(define-syntax-rule (fold-index i n) (fxand (fx+ n (fxvector-ref i fold-start)) (MASK32)))
