#lang racket/base
;; Frames around unit vectors, half of them near -z, where older formulas lose their digits.

(module+ test
  (require racket/flonum racket/match rackunit "../statistics.rkt" "frame-vectors.rkt")

  (define uniform (seeded 1))

  (define (unit x y z)
    (define length (flsqrt (+ (* x x) (* y y) (* z z))))
    (list (/ x length) (/ y length) (/ z length)))
  (define (anywhere) (unit (uniform -1.0 1.0) (uniform -1.0 1.0) (uniform -1.0 1.0)))
  ;; off the axis by 1e-9 to 1
  (define (near-minus-z)
    (define-values (off angle) (values (expt 10.0 (uniform -9.0 0.0)) (uniform 0.0 6.3)))
    (unit (* off (flcos angle)) (* off (flsin angle)) -1.0))

  ;; Root mean square of how far the nine products of rows are from the unit matrix, and how far
  ;; the determinant is from 1.
  (define (deviation rows)
    (match-define (list a b c d e f g h k) rows)
    (define-syntax-rule (product x y z p q r expected)
      (let ([off (- (+ (* x p) (* y q) (* z r)) expected)]) (* off off)))
    (values
     (flsqrt (/ (+ (product a b c a b c 1.0) (product d e f d e f 1.0) (product g h k g h k 1.0)
                   (* 2.0 (+ (product a b c d e f 0.0) (product d e f g h k 0.0)
                             (product g h k a b c 0.0))))
                9.0))
     (abs (- (+ (* a (- (* e k) (* f h))) (* b (- (* f g) (* d k))) (* c (- (* d h) (* e g))))
             1.0))))

  (test-case "S13: orthonormal to 4e-16 and right-handed, 10^5 vectors (10^6 under stress)"
    (define-values (worst worst-determinant)
      (for/fold ([worst 0.0] [worst-determinant 0.0]) ([k (stressed 100000 1000000)])
        (define-values (off determinant-off)
          (deviation (apply frame-of (if (even? k) (near-minus-z) (anywhere)))))
        (values (max worst off) (max worst-determinant determinant-off))))
    (check-true (<= worst 4e-16) (format "root mean square ~a" worst))
    (check-true (<= worst-determinant 2e-15) (format "determinant off by ~a" worst-determinant)))

  (test-case "the poles, with zeros of both signs: exact"
    (for* ([x '(0.0 -0.0)] [y '(0.0 -0.0)] [z '(1.0 -1.0)])
      (define-values (off determinant-off) (deviation (frame-of x y z)))
      (check-equal? (list off determinant-off) '(0.0 0.0))))

  (test-case "local to world: the local z axis is the normal, lengths and angles stay to 1e-15"
    (for ([k 1000])
      (define-values (n a b) (values (near-minus-z) (anywhere) (anywhere)))
      (define (world local) (apply frame-to-world (append n local)))
      (define (dot p q) (apply + (map * p q)))
      (check-equal? (world '(0.0 0.0 1.0)) n)
      (check-= (dot (world a) (world b)) (dot a b) 2e-15)
      (check-= (dot (world a) n) (caddr a) 1e-15))))
