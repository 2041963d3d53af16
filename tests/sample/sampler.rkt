#lang racket/base
;; Sample points: every aligned block is a net, the same arguments give the same bits, and what
;; should be independent is uncorrelated and uniform.

(module+ test
  (require racket/flonum rackunit "../statistics.rkt" "points.rkt")

  (define (pairs . arguments)
    (define-values (u v) (apply pairs-of-indices arguments))
    (map cons (for/list ([x (in-flvector u)]) x) (for/list ([x (in-flvector v)]) x)))
  (define (folded seed pixel indices dimension count)
    (for*/list ([index indices]
                [pair (let-values ([(u v) (fold-pairs seed pixel index dimension count)])
                        (map cons (for/list ([x (in-flvector u)]) x)
                             (for/list ([x (in-flvector v)]) x)))])
      pair))

  ;; Whether each of the 2^m cells of 2^-i by 2^(i-m), for every i, has one of the 2^m points.
  (define (net? points m)
    (define size (expt 2 m))
    (and (= size (length points))
         (for/and ([i (+ m 1)])
           (define-values (columns rows) (values (expt 2 i) (expt 2 (- m i))))
           (define seen (make-vector size #f))
           (for ([p points])
             (vector-set! seen
                          (+ (inexact->exact (floor (* columns (car p))))
                             (* columns (inexact->exact (floor (* rows (cdr p))))))
                          #t))
           (for/and ([s seen]) s))))

  (test-case "S25: every aligned block of 2^m points is a (0,m,2)-net, m = 2 .. 10"
    (for ([key 6] [seed '(0 1 2 77 123456789 #xFFFFFFFF)] [pixel '(0 1 1919 0 2073599 5)]
          [dimension '(0 0 1 2 7 300)])
      (for* ([m (in-range 2 11)]
             [block (if (< m 9) (list 0 1 2 5 1000) (list 0 (+ 3 key)))])
        (unless (net? (pairs seed pixel dimension (* block (expt 2 m)) 1 (expt 2 m)) m)
          (fail (format "seed ~a pixel ~a dimension ~a, block ~a of 2^~a"
                        seed pixel dimension block m))))))

  (test-case "a net detector that can fail: a block not aligned, and a block with a point moved"
    (check-false (net? (pairs 0 0 0 3 1 64) 6))
    (define points (pairs 0 0 0 0 1 64))
    (check-false (net? (cons (cadr points) (cdr points)) 6)))

  (test-case "folds: the samples of one are a net, and so are those of a block of camera samples"
    (for* ([seed '(0 9)] [dimension '(0 3)] [m '(2 4 6)])
      (for ([index '(0 1 6)]) (check-true (net? (folded seed 11 (list index) dimension (expt 2 m)) m)))
      (for ([start '(0 8)])
        (check-true (net? (folded seed 11 (for/list ([k 8]) (+ start k)) dimension (expt 2 m))
                          (+ m 3))))))

  (test-case "the same arguments, the same bits: in any order, one by one or in turn"
    (define forward (pairs 5 17 3 0 1 1000))
    (check-equal? (reverse (pairs 5 17 3 999 -1 1000)) forward)
    (check-equal? (car (pairs 5 17 3 640 1 1)) (list-ref forward 640))
    (define-values (u v) (pairs-in-turn 5 17 123 8))
    (for ([dimension 8])
      (check-equal? (list (cons (flvector-ref u dimension) (flvector-ref v dimension)))
                    (pairs 5 17 dimension 123 1 1))))

  (test-case "all are whole multiples of 2^-32 in [0, 1)"
    (for ([p (pairs 1 2 3 4 1 100)])
      (for ([x (list (car p) (cdr p))])
        (check-true (and (<= 0.0 x) (< x 1.0) (integer? (* x 4294967296.0)))))))

  (define count (stressed 100000 1000000))
  (define (check-uncorrelated what a b)
    (define r (correlation a b))
    (check-true (< (abs r) (/ 4.0 (sqrt count))) (format "~a: ~a" what r)))
  (define (shifted v lag) (flvector-append (flvector-copy v lag) (flvector-copy v 0 lag)))
  (define (flvector-append a b)
    (for/flvector #:length (+ (flvector-length a) (flvector-length b))
                  ([x (sequence-of a b)]) x))
  (define (sequence-of a b) (append (for/list ([x (in-flvector a)]) x)
                                    (for/list ([x (in-flvector b)]) x)))

  ;; (indices of one pixel and dimension do: they are spread out)
  (test-case "S26: pixels, dimensions, seeds and the two numbers of a pair do not correlate"
    (define-values (u v) (pairs-of-pixels 0 0 0 count))
    (check-uncorrelated "u and v" u v)
    (for ([lag '(1 2 3 64 1920)])
      (check-uncorrelated (format "u, pixels ~a apart" lag) u (shifted u lag))
      (check-uncorrelated (format "v, pixels ~a apart" lag) v (shifted v lag))
      (check-uncorrelated (format "u and v, pixels ~a apart" lag) u (shifted v lag)))
    (for ([other '((1 0 0) (2 0 0) (0 1 0) (0 2 0) (1 1 0) (0 1 3))])
      (define-values (u* v*) (apply pairs-of-pixels (append other (list count))))
      (check-uncorrelated (format "u, seed, dimension, index ~a" other) u u*)
      (check-uncorrelated (format "v, seed, dimension, index ~a" other) v v*)
      (check-uncorrelated (format "u and v, seed, dimension, index ~a" other) u v*)))

  (test-case "uniform over pixels: in 256 cells, in 16 x 16 of a pair, of neighbours, of dimensions"
    (define (paired a b)
      (for/list ([x (in-flvector a)] [y (in-flvector b)])
        (/ (+ (floor (* 16.0 x)) y) 16.0)))
    (define (check-uniform what values)
      (define z (uniform-deviate values 256))
      (check-true (< (abs z) 4.0) (format "~a: chi-square deviate ~a" what z)))
    (for ([index '(0 1 2 5 1023)])
      (define-values (u v) (pairs-of-pixels 0 0 index count))
      (define-values (u* v*) (pairs-of-pixels 0 1 index count))
      (check-uniform (list "u" index) u)
      (check-uniform (list "v" index) v)
      (check-uniform (list "u, v" index) (paired u v))
      (check-uniform (list "u, u of the next pixel" index) (paired u (shifted u 1)))
      (check-uniform (list "u, u of the next dimension" index) (paired u u*)))))
