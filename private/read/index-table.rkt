#lang racket/base
;; A hash table from keys kept elsewhere to 0, 1, 2 ... in the order they are first seen: the
;; merging of equal vertices. Open addressing, linear probing, at most half full.

(provide make-index-table
         index-table-intern!
         mix-hash)

(require racket/fixnum
         "growable.rkt")

;; slots holds index + 1, or 0 when free; hashes holds the hash of every index.
(struct index-table ([slots #:mutable] hashes) #:authentic)

(define (make-index-table)
  (index-table (make-fxvector 256) (make-fixnums)))

;; The index of the key with this hash (a nonnegative fixnum) for which (same? index) holds, or a new
;; one: then it is the number of keys so far and the caller stores the key there.
(define (index-table-intern! table hash same?)
  (define hashes (index-table-hashes table))
  (when (fx>= (fx* 2 (fixnums-count hashes)) (fxvector-length (index-table-slots table)))
    (grow! table))
  (define slots (index-table-slots table))
  (define mask (fx- (fxvector-length slots) 1))
  (let probe ([i (fxand hash mask)])
    (define index (fx- (fxvector-ref slots i) 1))
    (cond
      [(fx< index 0)
       (define new (fixnums-count hashes))
       (fixnums-push! hashes hash)
       (fxvector-set! slots i (fx+ new 1))
       new]
      [(and (fx= hash (fxvector-ref (fixnums-data hashes) index)) (same? index)) index]
      [else (probe (fxand mask (fx+ i 1)))])))

(define (grow! table)
  (define hashes (index-table-hashes table))
  (define slots (make-fxvector (fx* 2 (fxvector-length (index-table-slots table)))))
  (define mask (fx- (fxvector-length slots) 1))
  (for ([index (in-range (fixnums-count hashes))])
    (let probe ([i (fxand mask (fxvector-ref (fixnums-data hashes) index))])
      (if (fx= 0 (fxvector-ref slots i))
          (fxvector-set! slots i (fx+ index 1))
          (probe (fxand mask (fx+ i 1))))))
  (set-index-table-slots! table slots))

;; A nonnegative fixnum that depends on every bit of three fixnums.
(define (mix-hash a b c)
  (define (spread h) (fxxor h (fxrshift h 31)))
  (define (step h n) (spread (fx*/wraparound (fxxor h n) #x0E3779B97F4A7C15)))
  (fxand (spread (step (step (step #x0851F42D4C957F2D a) b) c)) hash-mask))

(define hash-mask #x0FFFFFFFFFFFFFFF)
