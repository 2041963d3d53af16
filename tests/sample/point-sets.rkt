#lang racket/base
;; The four samplers: each is uniform, and independent from pixel to pixel, dimension to dimension and
;; seed to seed; and each is spread the way its name says.

(module+ test
  (require racket/flonum racket/list rackunit "../../main.rkt" "../statistics.rkt" "points.rkt")

  (define samplers '(owen-sobol independent stratified r2))
  (define count (stressed 50000 1000000))

  (define (number-list v) (for/list ([x (in-flvector v)]) x))
  (define (point-list name grid seed pixel dimension first n)
    (define-values (u v) (pairs-of-sampler name grid seed pixel dimension first n))
    (map cons (number-list u) (number-list v)))

  ;; --- the public function ---

  (test-case "sample-point gives the points the kernels draw, to the bit"
    (for ([name samplers] [grid '(16 7 12 64)])
      (for ([index '(0 1 5 11 12 100)] [pixel '(0 3 2073599 1 #xFFFFFFFF 8)]
            [dimension '(0 1 2 300 7 #xFFFFFFFF)] [seed '(0 1 #xFFFFFFFF 77 2 3)])
        (define-values (u v)
          (sample-point name #:index index #:dimension dimension #:pixel pixel #:seed seed
                        #:count grid))
        (check-equal? (list (cons u v)) (point-list name grid seed pixel dimension index 1)))
      (define-values (u v) (sample-point name #:index 3))
      (check-equal? (list (cons u v)) (point-list name 16 0 0 0 3 1))))

  (test-case "sample-point raises on names, indices and counts that are none, and names the argument"
    (define (check-raises argument ask)
      (check-exn (lambda (e) (and (exn:fail:contract? e)
                                  (regexp-match? argument (exn-message e))
                                  (not (regexp-match? "\n" (exn-message e)))))
                 ask))
    (check-raises "sampler" (lambda () (sample-point 'sobol #:index 0)))
    (for ([wrong '(-1 4294967296)])
      (check-raises "index" (lambda () (sample-point 'r2 #:index wrong)))
      (check-raises "pixel" (lambda () (sample-point 'r2 #:index 0 #:pixel wrong)))
      (check-raises "dimension" (lambda () (sample-point 'r2 #:index 0 #:dimension wrong)))
      (check-raises "seed" (lambda () (sample-point 'r2 #:index 0 #:seed wrong))))
    (check-raises "count" (lambda () (sample-point 'stratified #:index 0 #:count 0)))
    (for ([wrong '(0.5 1/2 "1" #f)])
      (check-exn exn:fail:contract? (lambda () (sample-point 'owen-sobol #:index wrong)))))

  ;; --- uniform and independent ---

  (define (check-uncorrelated what a b)
    (define r (correlation a b))
    (check-true (< (abs r) (/ 4.0 (sqrt (flvector-length a)))) (format "~a: ~a" what r)))
  (define (check-uniform what values cells)
    (define z (uniform-deviate values cells))
    (check-true (< (abs z) 4.0) (format "~a: chi-square deviate ~a" what z)))
  ;; two numbers in [0, 1) as one, which is uniform when the pair is uniform in 16 x 16 cells
  (define (paired a b)
    (for/list ([x (in-flvector a)] [y (in-flvector b)])
      (/ (+ (floor (* 16.0 x)) y) 16.0)))

  (for ([name samplers])
    (test-case (format "~a: uniform over pixels, in 256 cells, at any index of several grids" name)
      (for ([grid '(16 7 64)] [index '(0 5 1000)])
        (define-values (u v) (pixel-pairs-of-sampler name grid 0 0 index count))
        (check-uniform (list name grid index "u") u 256)
        (check-uniform (list name grid index "v") v 256)
        (check-uniform (list name grid index "u and v") (paired u v) 256)))

    (test-case (format "~a: neighbours, dimensions, seeds and pairs are independent, 4 / sqrt N" name)
      (define (numbers seed dimension) (pixel-pairs-of-sampler name 16 seed dimension 3 count))
      (define-values (u v) (numbers 0 0))
      (define (from k x) (flvector-copy x k))
      (define (up-to k x) (flvector-copy x 0 (- (flvector-length x) k)))
      (check-uncorrelated (list name "u and v") u v)
      (for ([lag '(1 2 64 1920)])
        (check-uncorrelated (list name "u, pixels apart" lag) (from lag u) (up-to lag u))
        (check-uncorrelated (list name "u and v, pixels apart" lag) (from lag u) (up-to lag v))
        (check-uniform (list name "u, u of a pixel apart" lag)
                       (paired (from lag u) (up-to lag u)) 256))
      (for ([other '((1 0) (2 0) (0 1) (0 2) (1 1) (7 300))])
        (define-values (u* v*) (apply numbers other))
        (check-uncorrelated (list name "u, seed and dimension" other) u u*)
        (check-uncorrelated (list name "u and v, seed and dimension" other) u v*)
        (check-uniform (list name "u and u, seed and dimension" other) (paired u u*) 256)))

    (test-case (format "~a: all numbers are in [0, 1)" name)
      (for ([grid '(1 3 16 997)] [seed '(0 1 2 3)])
        (define-values (u v) (pairs-of-sampler name grid seed 5 seed 0 20000))
        (for ([x (in-flvector u)] [y (in-flvector v)])
          (unless (and (<= 0.0 x) (< x 1.0) (<= 0.0 y) (< y 1.0))
            (fail (format "~a: ~a ~a" name x y)))))
      (check-true #t)))

  ;; --- independent ---

  (test-case "independent: indices have nothing to do with each other"
    (define-values (u v) (pairs-of-sampler 'independent 16 0 0 0 0 count))
    (check-uncorrelated "u and v" u v)
    (check-uniform "u" u 256)
    (check-uniform "u and v" (paired u v) 256)
    (for ([lag '(1 2 16)])
      (define-values (later later-v) (pairs-of-sampler 'independent 16 0 0 0 lag count))
      (check-uncorrelated (list "u, indices apart" lag) u later)
      (check-uniform (list "u, u of an index apart" lag) (paired u later) 256)))

  ;; --- stratified ---

  ;; The grid of a count, as columns and rows.
  (define grids '((1 1 1) (2 2 1) (7 7 1) (12 4 3) (16 4 4) (64 8 8) (100 10 10)))
  (define (cell p columns rows)
    (+ (inexact->exact (floor (* columns (car p))))
       (* columns (inexact->exact (floor (* rows (cdr p)))))))

  (test-case "stratified: each cell of every grid has exactly one point"
    (for* ([grid grids] [seed '(0 1 99 #xFFFFFFFF)] [pixel '(0 1 1919)] [block '(0 1 2 1000)])
      (define-values (n columns rows) (apply values grid))
      (define cells
        (for/list ([p (point-list 'stratified n seed pixel 2 (* n block) n)]) (cell p columns rows)))
      (check-equal? (sort cells <) (range n) (format "~a points, seed ~a, pixel ~a, grid ~a"
                                                     n seed pixel block))))

  (test-case "stratified: every cell is as likely as any other, for the first sample and the last"
    (for* ([n '(2 3 5 7 12 16 100)] [index (remove-duplicates (list 0 (quotient n 2) (- n 1)))])
      (define-values (u v) (pixel-pairs-of-sampler 'stratified n 0 0 index count))
      (define-values (columns rows)
        (apply values (cond [(assv n grids) => cdr] [else (list n 1)])))
      (define z
        (uniform-deviate (for/list ([x (in-flvector u)] [y (in-flvector v)])
                           (/ (+ 0.5 (cell (cons x y) columns rows)) n))
                         n))
      (check-true (< (abs z) 4.0) (format "~a points, sample ~a: ~a" n index z))))

  (test-case "stratified: points are uniform within their cells"
    (define-values (u v) (pixel-pairs-of-sampler 'stratified 16 0 0 7 count))
    (define (within x) (let ([y (* 4.0 x)]) (- y (floor y))))
    (check-uniform "u" (for/list ([x (in-flvector u)]) (within x)) 256)
    (check-uniform "v" (for/list ([x (in-flvector v)]) (within x)) 256))

  (test-case "stratified: the cell of one sample says nothing about that in another dimension"
    (for ([n '(2 7 12 16)])
      (define-values (u v) (pixel-pairs-of-sampler 'stratified n 0 0 1 count))
      (define-values (u* v*) (pixel-pairs-of-sampler 'stratified n 0 1 1 count))
      (check-uncorrelated (list n "u and u") u u*)
      (check-uncorrelated (list n "v and v") v v*)))

  ;; --- R2 ---

  ;; Powers of the plastic number's reciprocal, a root of x^3 + x^2 = 1, to 2^-128 (Newton).
  (define root
    (for/fold ([x 3/4]) ([k 8])
      (define better (- x (/ (- (+ (* x x x) (* x x)) 1) (+ (* 3 x x) (* 2 x)))))
      (/ (round (* better (expt 2 128))) (expt 2 128))))
  (define (fraction x) (- x (floor x)))
  (define (exact-r2 k) (cons (fraction (* k root)) (fraction (* k root root))))
  ;; how far two numbers are apart on a circle of circumference 1
  (define (apart a b)
    (define d (fraction (- (inexact->exact a) (inexact->exact b))))
    (min d (- 1 d)))
  (define (near? p q k)
    ;; a multiplier of 32 bits is off by half a unit at most, its multiples by as many halves
    (define tolerance (* (max k 1) (expt 2 -33)))
    (and (<= (apart (car p) (car q)) tolerance) (<= (apart (cdr p) (cdr q)) tolerance)))

  (test-case "R2: the first points are k g and k g^2 modulo 1, to k units of 2^-33"
    (define-values (u v) (unrotated-r2-pairs 1000))
    (for ([k (append (range 9) '(100 999))])
      (check-true (near? (cons (flvector-ref u k) (flvector-ref v k)) (exact-r2 k) k)
                  (format "point ~a" k)))
    (check-false (near? (cons (flvector-ref u 3) (flvector-ref v 3)) (exact-r2 2) 3)))

  ;; Whether points, in any order, are a point and those that follow it in the sequence.
  (define (successive? points)
    (for/or ([start points])
      (for/and ([k (length points)])
        (define step (exact-r2 k))
        (define wanted (cons (+ (inexact->exact (car start)) (car step))
                             (+ (inexact->exact (cdr start)) (cdr step))))
        (for/or ([p points]) (near? p wanted k)))))

  (test-case "r2: a block of eight is eight successive points of the sequence, rotated"
    (for* ([seed '(0 1 99)] [pixel '(0 7)] [dimension '(0 3)] [first '(0 8 512)])
      (define points (point-list 'r2 16 seed pixel dimension first 8))
      (check-true (successive? points)
                  (format "seed ~a pixel ~a dimension ~a from ~a" seed pixel dimension first))
      (define other (point-list 'r2 16 seed (+ pixel 1) dimension first 1))
      (check-false (successive? (append other (cdr points))))))

  ;; --- discrepancy ---

  ;; The squared L2 star discrepancy (Warnock 1972).
  (define (squared-discrepancy points)
    (define n (exact->inexact (length points)))
    (define single
      (for/fold ([sum 0.0]) ([p points])
        (+ sum (* (- 1.0 (* (car p) (car p))) (- 1.0 (* (cdr p) (cdr p)))))))
    (define double
      (for*/fold ([sum 0.0]) ([p points] [q points])
        (+ sum (* (- 1.0 (max (car p) (car q))) (- 1.0 (max (cdr p) (cdr q)))))))
    (+ (/ 1.0 9.0) (/ (* -0.5 single) n) (/ double (* n n))))

  (test-case "discrepancy: of one point and of independent ones as in theory, of the others smaller"
    (check-= (squared-discrepancy '((0.5 . 0.5))) (+ 1/9 (* -1/2 9/16) 1/4) 1e-15)
    (define (discrepancies name n)
      (for/list ([seed 40]) (squared-discrepancy (point-list name n seed 0 0 0 n))))
    (for ([n '(64 144)])
      (define independent (discrepancies 'independent n))
      ;; expected: (1/4 - 1/9) / n
      (check-true (< (deviations independent (/ 5/36 n)) 4.0))
      (for ([name '(stratified r2 owen-sobol)])
        (define ratio (/ (mean (discrepancies name n)) (mean independent)))
        (check-true (< ratio 0.35) (format "~a, ~a points: ~a" name n ratio))))))
