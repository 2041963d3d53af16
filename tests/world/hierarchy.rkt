#lang racket/base
;; The hierarchy's structure, for ordinary boxes and for those meant to break a builder.

(module+ test
  (require racket/flonum racket/list racket/match rackunit "../statistics.rkt" "tree.rkt")

  (define uniform (seeded 1))
  (define (boxes lists) (apply flvector (append* lists)))
  (define (box-around x y z size)
    (list (- x size) (- y size) (- z size) (+ x size) (+ y size) (+ z size)))
  (define (random-boxes count [extent 10.0] [size 0.5])
    (for/list ([k count])
      (box-around (uniform (- extent) extent) (uniform (- extent) extent) (uniform (- extent) extent)
                  (* size (uniform)))))

  (define (union a b)
    (append (map min (take a 3) (take b 3)) (map max (drop a 3) (drop b 3))))

  ;; Leaves hold at most four; every box of a node is exactly that of what is below it; every
  ;; member is in one leaf.
  (define (check-tree lists)
    (define count (length lists))
    (define all (list->vector lists))
    (define (walk tree)
      (match tree
        [(list 'leaf box members)
         (check-true (<= 1 (length members) 4))
         (check-equal? box (for/fold ([u (vector-ref all (car members))]) ([m (cdr members)])
                             (union u (vector-ref all m))))
         members]
        [(list 'inner box left right)
         (check-equal? box (union (second left) (second right)))
         (append (walk left) (walk right))]))
    (check-equal? (sort (walk (hierarchy-tree (boxes lists) count)) <) (range count)))

  (define degenerate
    (list (list "one" (random-boxes 1))
          (list "two" (random-boxes 2))
          (list "five" (random-boxes 5))
          (list "a thousand" (random-boxes 1000))
          (list "points" (random-boxes 500 10.0 0.0))
          (list "all at one point" (for/list ([k 300]) (box-around 1.0 2.0 3.0 0.0)))
          (list "all the same box" (for/list ([k 300]) (box-around 1.0 2.0 3.0 1.0)))
          (list "nested" (for/list ([k 300]) (box-around 1.0 2.0 3.0 (expt 1.1 k))))
          (list "all in a plane" (for/list ([k 300]) (list* 0.0 (cdr (box-around 0.0 (uniform) (uniform) 0.0)))))
          (list "along a line" (for/list ([k 300]) (box-around (* 1.0 k) 0.0 0.0 0.1)))
          (list "geometric" (for/list ([k 300]) (box-around (expt 2.0 k) 0.0 0.0 (expt 2.0 (- k 3)))))
          (list "extents from 1e-9 to 1e9"
                (for/list ([k 500])
                  (define size (expt 10.0 (uniform -9.0 9.0)))
                  (box-around (* size (uniform -3.0 3.0)) (* size (uniform -3.0 3.0)) 0.0 size)))
          (list "tiny numbers" (random-boxes 100 1e-310 1e-311))
          (list "huge numbers" (random-boxes 100 1e300 1e299))
          (list "two clusters 1e12 apart"
                (append (random-boxes 100)
                        (for/list ([b (random-boxes 100)]) (map (lambda (x) (+ x 1e12)) b))))))

  (for ([input degenerate])
    (test-case (format "~a: every box in one leaf, leaves of at most four, boxes tight" (car input))
      (check-tree (cadr input))))

  (test-case "none: one empty leaf that no ray enters"
    (check-equal? (hierarchy-tree (flvector) 0)
                  '(leaf (+inf.0 +inf.0 +inf.0 -inf.0 -inf.0 -inf.0) ())))

  (test-case "depth: at most 40 levels and the logarithm of the count, whatever the input"
    (for ([input degenerate])
      (define count (length (cadr input)))
      (check-true (<= (hierarchy-depth (boxes (cadr input)) count)
                      (+ 41 (integer-length count)))
                  (car input)))
    (check-true (<= (hierarchy-depth (boxes (random-boxes 4096)) 4096) 24)))

  (test-case "deterministic: two builds agree in every number"
    (define input (boxes (random-boxes 2000)))
    (check-equal? (hierarchy-data input 2000) (hierarchy-data input 2000)))

  (test-case "the surface-area heuristic pays: less than 0.85 of the area of halving by count"
    (define lists (append (random-boxes 500 1.0 0.01) (random-boxes 500 100.0 1.0)))
    (define (area box)
      (match-define (list x y z) (map - (drop box 3) (take box 3)))
      (+ (* x y) (* y z) (* z x)))
    (define (cost tree)
      (match tree
        [(list 'leaf box members) (* (area box) (length members))]
        [(list 'inner box left right) (+ (* 2.0 (area box)) (cost left) (cost right))]))
    (define (halved lists)
      (define box (for/fold ([u (car lists)]) ([b (cdr lists)]) (union u b)))
      (cond
        [(<= (length lists) 4) (list 'leaf box lists)]
        [else
         (define axis (argmax (lambda (k) (- (list-ref box (+ 3 k)) (list-ref box k))) '(0 1 2)))
         (define ordered (sort lists < #:key (lambda (b) (+ (list-ref b axis) (list-ref b (+ 3 axis))))))
         (define-values (left right) (split-at ordered (quotient (length ordered) 2)))
         (list 'inner box (halved left) (halved right))]))
    (check-true (< (cost (hierarchy-tree (boxes lists) 1000)) (* 0.85 (cost (halved lists)))))))
