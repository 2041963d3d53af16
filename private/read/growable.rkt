#lang racket/base
;; Vectors of flonums and of fixnums that grow by doubling, for readers that learn the size last.

(provide make-flonums flonums-data flonums-count flonums-push! flonums->flvector
         make-fixnums fixnums-data fixnums-count fixnums-push! fixnums-clear! fixnums->fxvector)

(require racket/fixnum
         racket/flonum)

(struct flonums ([data #:mutable] [count #:mutable]) #:authentic)
(struct fixnums ([data #:mutable] [count #:mutable]) #:authentic)

(define (make-flonums) (flonums (make-flvector 64) 0))
(define (make-fixnums) (fixnums (make-fxvector 64) 0))

;; Appends x.
(define (flonums-push! g x)
  (define count (flonums-count g))
  (when (fx= count (flvector-length (flonums-data g)))
    (define larger (make-flvector (fx* 2 count)))
    (define old (flonums-data g))
    (for ([i (in-range count)])
      (flvector-set! larger i (flvector-ref old i)))
    (set-flonums-data! g larger))
  (flvector-set! (flonums-data g) count x)
  (set-flonums-count! g (fx+ count 1)))

;; Appends n.
(define (fixnums-push! g n)
  (define count (fixnums-count g))
  (when (fx= count (fxvector-length (fixnums-data g)))
    (define larger (make-fxvector (fx* 2 count)))
    (define old (fixnums-data g))
    (for ([i (in-range count)])
      (fxvector-set! larger i (fxvector-ref old i)))
    (set-fixnums-data! g larger))
  (fxvector-set! (fixnums-data g) count n)
  (set-fixnums-count! g (fx+ count 1)))

(define (fixnums-clear! g) (set-fixnums-count! g 0))

;; The elements so far, as a vector of exactly their number.
(define (flonums->flvector g) (flvector-copy (flonums-data g) 0 (flonums-count g)))
(define (fixnums->fxvector g) (fxvector-copy (fixnums-data g) 0 (fixnums-count g)))
