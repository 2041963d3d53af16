#lang typed/racket/base
;; The sampler's points as flvectors, for the tests.
(require racket/flonum racket/fixnum
         "../../private/base/registers.rkt"
         "../../private/sample/sampler.rkt" "../../private/sample/point-sets.rkt")

(provide pairs-of-indices pairs-of-pixels pairs-in-turn fold-pairs
         pairs-of-sampler pixel-pairs-of-sampler unrotated-r2-pairs)

;; Fills u and v by calling draw! with 0 .. count-1 before each pair is read.
(: collect (-> Nonnegative-Fixnum (-> FlVector FxVector Fixnum Void) (Values FlVector FlVector)))
(define (collect count draw!)
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (define u (make-flvector count))
  (define v (make-flvector count))
  (let loop ([k : Nonnegative-Fixnum 0])
    (when (< k count)
      (draw! r i k)
      (flvector-set! u k (flvector-ref r sample-u))
      (flvector-set! v k (flvector-ref r sample-v))
      (loop (assert (+ k 1) fixnum?))))
  (values u v))

;; The pairs of one dimension of one pixel at first, first + step, ...
(: pairs-of-indices (-> Fixnum Fixnum Fixnum Fixnum Fixnum Nonnegative-Fixnum
                        (Values FlVector FlVector)))
(define (pairs-of-indices seed pixel dimension first step count)
  (collect count
           (lambda ([r : FlVector] [i : FxVector] [k : Fixnum])
             (Sampler-start! i pixel seed 0)
             (sample-pair! r i dimension (fx+ first (fx* step k))))))

;; The pairs of one dimension and index at pixels 0 .. count-1.
(: pairs-of-pixels (-> Fixnum Fixnum Fixnum Nonnegative-Fixnum (Values FlVector FlVector)))
(define (pairs-of-pixels seed dimension index count)
  (collect count
           (lambda ([r : FlVector] [i : FxVector] [k : Fixnum])
             (Sampler-start! i k seed 0)
             (sample-pair! r i dimension index))))

;; The pairs of the first dimensions of one sample, asked for one after the other.
(: pairs-in-turn (-> Fixnum Fixnum Fixnum Nonnegative-Fixnum (Values FlVector FlVector)))
(define (pairs-in-turn seed pixel index count)
  (collect count
           (lambda ([r : FlVector] [i : FxVector] [k : Fixnum])
             (when (fx= k 0) (Sampler-start! i pixel seed index))
             (sample-next-pair! r i))))

;; The pairs of a fold over `count` samples at that dimension of a camera sample.
(: fold-pairs (-> Fixnum Fixnum Fixnum Fixnum Nonnegative-Fixnum (Values FlVector FlVector)))
(define (fold-pairs seed pixel index dimension count)
  (collect count
           (lambda ([r : FlVector] [i : FxVector] [k : Fixnum])
             (when (fx= k 0)
               (Sampler-start! i pixel seed index)
               (for ([d (in-range dimension)]) (sample-next-pair! r i))
               (sample-fold-start! i count))
             (sample-fold-pair! r i k))))

;; The pairs of a sampler by name, its grids of `grid` points, at first, first + 1, ...
(: pairs-of-sampler (-> Symbol Fixnum Fixnum Fixnum Fixnum Fixnum Nonnegative-Fixnum
                        (Values FlVector FlVector)))
(define (pairs-of-sampler name grid seed pixel dimension first count)
  (define number (sampler-number name))
  (collect count
           (lambda ([r : FlVector] [i : FxVector] [k : Fixnum])
             (Sampler-choose! i number grid)
             (Sampler-start! i pixel seed 0)
             (sample-pair! r i dimension (fx+ first k)))))

;; The pairs of a sampler by name, one dimension and index, at pixels 0 .. count - 1.
(: pixel-pairs-of-sampler (-> Symbol Fixnum Fixnum Fixnum Fixnum Nonnegative-Fixnum
                              (Values FlVector FlVector)))
(define (pixel-pairs-of-sampler name grid seed dimension index count)
  (define number (sampler-number name))
  (collect count
           (lambda ([r : FlVector] [i : FxVector] [k : Fixnum])
             (Sampler-choose! i number grid)
             (Sampler-start! i k seed 0)
             (sample-pair! r i dimension index))))

;; The R2 sequence itself from point 0 on, neither shuffled nor rotated.
(: unrotated-r2-pairs (-> Nonnegative-Fixnum (Values FlVector FlVector)))
(define (unrotated-r2-pairs count)
  (collect count
           (lambda ([r : FlVector] [i : FxVector] [k : Fixnum])
             (flvector-set! r sample-u (rotated-r2-u k 0))
             (flvector-set! r sample-v (rotated-r2-v k 0)))))
