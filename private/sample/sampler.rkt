#lang typed/racket/base
;; Sample points: pairs of numbers in [0,1) as a pure function of (key, dimension, index), where
;; the key stands for pixel, seed and randomisation. Kernels ask for one pair at a time.
(require "../base/unsafe.rkt" "../base/registers.rkt" "hash.rkt")

(provide Sampler-start! sample-pair! sample-next-pair! owen-sobol-pair!
         sample-fold-start! sample-fold-pair!)

;; Prepares the scratch for one sample of one pixel.
(: Sampler-start! (-> FxVector Fixnum Fixnum Fixnum Void))
(define (Sampler-start! i pixel seed index)
  (fxvector-set! i sampler-key (hash-pair (fxand seed (MASK32)) (fxand pixel (MASK32))))
  (fxvector-set! i sampler-index index)
  (fxvector-set! i sampler-dimension 0))

;; The pair of the next dimension at the current sample, into sample-u and sample-v.
(: sample-next-pair! (-> FlVector FxVector Void))
(define (sample-next-pair! r i)
  (define dimension (fxvector-ref i sampler-dimension))
  (fxvector-set! i sampler-dimension (fx+ dimension 1))
  (sample-pair! r i dimension (fxvector-ref i sampler-index)))

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
  (fxvector-set! i fold-seed-u seed-u)
  (fxvector-set! i fold-seed-v (hash32 seed-u)))

;; The pair of the n-th sample of the fold.
(: sample-fold-pair! (-> FlVector FxVector Fixnum Void))
(define (sample-fold-pair! r i n)
  (define index (fxand (fx+ n (fxvector-ref i fold-start)) (MASK32)))
  (put-scrambled-sobol! r index (fxvector-ref i fold-seed-u) (fxvector-ref i fold-seed-v)))

;; The pair of a dimension at an index.
(: sample-pair! (-> FlVector FxVector Fixnum Fixnum Void))
(define (sample-pair! r i dimension index)
  (owen-sobol-pair! r (hash-pair (fxvector-ref i sampler-key) dimension) index))

;; Reverses 32 bits.
(define-syntax-rule (reverse-bits x0)
  (let* ([x x0]
         [x (fxior (fxlshift (fxand x (fixnum-literal #x0000FFFF)) 16)
                   (fxand (fxrshift x 16) (fixnum-literal #x0000FFFF)))]
         [x (fxior (fxlshift (fxand x (fixnum-literal #x00FF00FF)) 8)
                   (fxand (fxrshift x 8) (fixnum-literal #x00FF00FF)))]
         [x (fxior (fxlshift (fxand x (fixnum-literal #x0F0F0F0F)) 4)
                   (fxand (fxrshift x 4) (fixnum-literal #x0F0F0F0F)))]
         [x (fxior (fxlshift (fxand x (fixnum-literal #x33333333)) 2)
                   (fxand (fxrshift x 2) (fixnum-literal #x33333333)))])
    (fxior (fxlshift (fxand x (fixnum-literal #x55555555)) 1)
           (fxand (fxrshift x 1) (fixnum-literal #x55555555)))))

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
(define-syntax-rule (put-scrambled-sobol! r index0 seed-u seed-v)
  (let ([index index0])
    (flvector-set! r sample-u (hash->unit (reverse-bits (scramble-reversed index seed-u))))
    (flvector-set! r sample-v
                   (hash->unit (reverse-bits (scramble-reversed (pascal index) seed-v))))))

;; The first two Sobol dimensions, their index shuffled and each scrambled by its own seed
;; (Burley, "Practical Hash-based Owen Scrambling", JCGT 2020). Every 2^m points that start at a
;; multiple of 2^m are a (0,m,2)-net; other dimensions are other seeds.
(: owen-sobol-pair! (-> FlVector Fixnum Fixnum Void))
(define (owen-sobol-pair! r seed index)
  (define seed-u (hash32 seed))
  (put-scrambled-sobol! r (shuffled-index index seed) seed-u (hash32 seed-u)))
