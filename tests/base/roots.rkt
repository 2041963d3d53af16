#lang racket/base
;; Roots against exact arithmetic: quadratics in units in the last place, quartics by Sturm's count.

(provide exact-quadratic-roots exact-square-root sturm-root-count)

;; The real roots of a t^2 + b t + c for exact a /= 0, b, c, to 200 bits, ascending; '() for none.
(define (exact-quadratic-roots a b c)
  (define discriminant (- (* b b) (* 4 a c)))
  (cond
    [(negative? discriminant) '()]
    [else
     (define s (exact-square-root discriminant))
     (define q (/ (if (negative? b) (- s b) (- (- s) b)) 2))
     (if (zero? q) '(0 0) (sort (list (/ q a) (/ c q)) <))]))

;; The square root of an exact number, relative error below 2^-200.
(define (exact-square-root x)
  (cond
    [(zero? x) 0]
    [else
     (define bits (- (integer-length (numerator x)) (integer-length (denominator x))))
     (define shift (* 2 (- 200 (quotient bits 2))))
     (/ (integer-sqrt (floor (* x (expt 2 shift)))) (expt 2 (quotient shift 2)))]))

;; How many distinct real roots a polynomial with exact coefficients, highest first, has.
(define (sturm-root-count coefficients)
  (define (strip p) (if (and (pair? p) (zero? (car p))) (strip (cdr p)) p))
  (define (derivative p)
    (let loop ([p p])
      (if (null? (cdr p)) '() (cons (* (car p) (length (cdr p))) (loop (cdr p))))))
  (define (remainder-of p q)
    (if (< (length p) (length q))
        p
        (let ([factor (/ (car p) (car q))])
          (remainder-of
           (cdr (for/list ([x (in-list p)] [k (in-naturals)])
                  (if (< k (length q)) (- x (* factor (list-ref q k))) x)))
           q))))
  (define p (strip coefficients))
  (define chain
    (let loop ([p p] [q (strip (derivative p))])
      (if (null? q)
          (list p)
          (cons p (loop q (strip (map - (strip (remainder-of p q)))))))))
  (define (changes signs)
    (for/sum ([s (in-list signs)] [t (in-list (cdr signs))]) (if (= s t) 0 1)))
  (define (sign-at-infinity p) (if (positive? (car p)) 1 -1))
  (define (sign-at-minus-infinity p)
    (if (even? (length p)) (- (sign-at-infinity p)) (sign-at-infinity p)))
  (- (changes (map sign-at-minus-infinity chain)) (changes (map sign-at-infinity chain))))

(module+ test
  (require rackunit racket/flonum racket/list math/flonum
           "../../private/base/roots.rkt")

  (define stress? (getenv "RAYTRACE_STRESS"))
  (define generator
    (vector->pseudo-random-generator (vector 1 2 3 4 5 6)))
  (define (uniform low high) (+ low (* (- high low) (random generator))))
  (define (random-sign) (if (< (random generator) 0.5) -1.0 1.0))
  (define (log-uniform low high)
    (* (random-sign) (exp (uniform (log low) (log high)))))

  (test-case "quadratics with simple roots, exactly"
    (check-equal? (quadratic-roots 1.0 -3.0 2.0) '(1.0 2.0))
    (check-equal? (quadratic-roots -1.0 3.0 -2.0) '(1.0 2.0))
    (check-equal? (quadratic-roots 1.0 2.0 1.0) '(-1.0 -1.0))
    (check-equal? (quadratic-roots 1.0 0.0 -4.0) '(-2.0 2.0))
    (check-equal? (quadratic-roots 2.0 0.0 0.0) '(0.0 0.0))
    (check-equal? (quadratic-roots 2.0 -6.0 0.0) '(0.0 3.0))
    (check-equal? (quadratic-roots 1.0 0.0 1.0) '())
    (check-equal? (quadratic-roots 0.0 2.0 -8.0) '(4.0))
    (check-equal? (quadratic-roots 1e-300 1e200 1.0) '(-1e-200))
    (check-equal? (quadratic-roots 0.0 0.0 1.0) '())
    (check-equal? (quadratic-roots 0.0 0.0 0.0) '()))

  (test-case "quadratics at the ends of the range, to 4 ulp"
    (define (check-roots a b c)
      (define expected
        (exact-quadratic-roots (inexact->exact a) (inexact->exact b) (inexact->exact c)))
      (define found (quadratic-roots a b c))
      (check-equal? (length found) (length expected) (format "~a ~a ~a" a b c))
      (for ([t (in-list found)] [e (in-list expected)])
        (check-true (<= (flulp-error t e) 4.0) (format "~a ~a ~a: ~a" a b c found))))
    (check-roots 1e300 -3e300 2e300)
    (check-roots 1e-300 -3e-300 2e-300)
    (check-roots 1e300 1.0 -1e-300)
    (check-roots 1e-300 1.0 -1e300)
    (check-roots 1e-200 -1e-160 1e-120)
    (check-roots 1e-307 1.0 -1.0)
    (check-roots 1.0 1e308 1e308)
    ;; 94906265.625^2 - 94906267 * 94906268.375 is 1.89 where squares have an ulp of 2
    (check-roots 94906265.625 -189812534.0 94906268.375))

  ;; H18, a paraboloid: its quadratic is .25 t^2 - 3.2 t + 5
  (test-case "ray and paraboloid, to 4 ulp"
    (for ([t (in-list (quadratic-roots 0.25 -3.2 5.0))]
          [e '(1.8217907430961612 10.978209256903839)])
      (check-true (<= (abs (flonums-between t e)) 4) (format "~a ~a" t e))))

  ;; S09
  (test-case "quadratics with coefficients log-uniform in 1e-8 to 1e8, to 8 ulp"
    (define count (if stress? 1000000 10000))
    (define-values (worst checked)
      (for/fold ([worst 0.0] [checked 0]) ([k (in-range count)])
        (define a
          (case (remainder k 8)
            [(6) 0.0]
            [(7) (log-uniform 1e-290 1e-20)]
            [else (log-uniform 1e-8 1e8)]))
        (define b (log-uniform 1e-8 1e8))
        (define c
          (if (or (zero? a) (> (random generator) 0.25))
              (log-uniform 1e-8 1e8)
              ;; close to a double root
              (* (/ (* b b) (* 4.0 a)) (- 1.0 (log-uniform 1e-12 1e-2)))))
        (define-values (A B C)
          (values (inexact->exact a) (inexact->exact b) (inexact->exact c)))
        (define discriminant (- (* B B) (* 4 A C)))
        (cond
          [(< (abs discriminant) (* 1e-12 (max (* B B) (abs (* 4 A C))))) (values worst checked)]
          [else
           (define expected
             (if (zero? A) (list (- (/ C B))) (exact-quadratic-roots A B C)))
           (define found (quadratic-roots a b c))
           (unless (= (length found) (length expected))
             (fail (format "~a ~a ~a: ~a" a b c found)))
           (values (for/fold ([worst worst]) ([t (in-list found)] [e (in-list expected)])
                     (max worst (flulp-error t e)))
                   (+ checked 1))])))
    (printf "S09: ~a quadratics, worst error ~a ulp (8 allowed)\n" checked worst)
    (check-true (> checked (* 0.9 count)))
    (check-true (<= worst 8.0)))

  (test-case "quartics with known roots, exactly or to 4 ulp"
    (define (roots p q s) (depressed-quartic-roots p q s -10.0 10.0))
    ;; (t^2 - 1)(t^2 - 4)
    (check-equal? (roots -5.0 0.0 4.0) '(-2.0 -1.0 1.0 2.0))
    ;; (t^2 - 4)(t^2 + 1), one minimum
    (check-equal? (roots -3.0 0.0 -4.0) '(-2.0 2.0))
    (check-equal? (roots 1.0 0.0 1.0) '())
    ;; t^2 (t^2 - 4): a double root at a maximum counts twice
    (check-equal? (map (lambda (t) (+ t 0.0)) (roots -4.0 0.0 0.0)) '(-2.0 0.0 0.0 2.0))
    ;; (t^2 - 1)^2: touches from outside do not
    (check-equal? (roots -2.0 0.0 1.0) '())
    ;; (t - 1)^3 (t + 3): a triple root is one change of sign
    (check-equal? (length (roots -6.0 8.0 -3.0)) 2))

  (test-case "quartics with random roots: as many as Sturm counts, to 8 roundings"
    (define count (if stress? 100000 2000))
    (for ([k (in-range count)])
      (define roots (sort (for/list ([_ (in-range 3)]) (uniform -1.0 1.0)) <))
      (define all (sort (cons (- (apply + roots)) roots) <))
      (define-values (p q s)
        (let* ([pairs (for*/list ([i (in-range 4)] [j (in-range (+ i 1) 4)])
                        (* (list-ref all i) (list-ref all j)))]
               [triples (for/list ([i (in-range 4)])
                          (for/product ([t (in-list all)] [j (in-naturals)] #:unless (= i j)) t))])
          (values (fl (apply + pairs)) (fl (- (apply + triples))) (fl (apply * all)))))
      (define found (depressed-quartic-roots p q s -4.0 4.0))
      (define gaps (map - (cdr all) (drop-right all 1)))
      (when (> (apply min gaps) 1e-3)
        (check-equal? (length found)
                      (sturm-root-count (map inexact->exact (list 1 0 p q s)))
                      (format "~a" all))
        (for ([t (in-list found)])
          ;; the value there is within the roundings of its terms and of t in the interval
          (define T (inexact->exact t))
          (define terms (map * (map inexact->exact (list 1.0 p q s)) (list (expt T 4) (* T T) T 1)))
          (define slope (+ (* 4 T T T) (* 2 (inexact->exact p) T) (inexact->exact q)))
          (define rounding (expt 2 -53))
          (check-true (<= (abs (apply + terms))
                          (* 8 rounding (+ (apply + (map abs terms)) (abs (* 8 slope)))))
                      (format "~a: ~a" all t)))))))
