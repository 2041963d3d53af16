#lang racket/base
;; Pearson's chi-square test of sampled directions against their density, in bins of polar angle and
;; azimuth; for every sampling routine of directions.
(require racket/flonum racket/math (only-in math/special-functions gamma-inc))

(provide chi-square-test (struct-out chi-square-result) sidak-level density-integral)

;; p: the probability of bins at least as far off as those found, were the density right.
;; integral: that of the density over the sphere. missing: how many samples had no direction.
(struct chi-square-result (p integral missing))

;; The level of each of `size` independent tests at which all of them together have level alpha.
(define (sidak-level alpha size) (- 1.0 (expt (- 1.0 alpha) (/ 1.0 size))))

;; sample : takes 0 ... count - 1, returns x, y, z of a unit vector in an flvector, or #f for a
;; sample without a density. density : takes x, y, z. The samples must be independent: a
;; low-discrepancy sequence is far too even. What the density lacks of 1 is expected to be missing.
;; halvings: of a bin's sides where the density is not smooth; 5 of them leave 1e-3 of a bin with a
;; jump in it.
(define (chi-square-test sample density count #:theta-bins [theta-bins 20] #:phi-bins [phi-bins 40]
                         #:halvings [halvings 8])
  (define expected (bin-integrals density theta-bins phi-bins halvings))
  (define integral (for/fold ([sum 0.0]) ([e (in-flvector expected)]) (+ sum e)))
  (define found (make-vector (* theta-bins phi-bins) 0))
  (define missing
    (for/sum ([k (in-range count)])
      (define d (sample k))
      (cond
        [d (define bin (bin-of d theta-bins phi-bins))
           (vector-set! found bin (+ 1 (vector-ref found bin)))
           0]
        [else 1])))
  (define rest (* count (max 0.0 (- 1.0 integral))))
  (define cells
    (cons (cons rest missing)
          (for/list ([e (in-flvector expected)] [f (in-vector found)]) (cons (* count e) f))))
  (chi-square-result (pooled-p-value cells) integral missing))

;; The probability for a list of (expected . found): cells that expect fewer than 5 are pooled, in
;; ascending order; what remains of those joins the cell after them.
(define (pooled-p-value cells)
  (define pooled
    (let pool ([cells (sort cells < #:key car)] [expected 0.0] [found 0] [done '()])
      (cond
        [(>= expected 5.0)
         (pool cells 0.0 0 (cons (cons expected found) done))]
        [(null? cells)
         (cond
           [(and (zero? expected) (zero? found)) done]
           [(null? done) (list (cons expected found))]
           [else (cons (cons (+ expected (caar done)) (+ found (cdar done))) (cdr done))])]
        [else
         (pool (cdr cells) (+ expected (caar cells)) (+ found (cdar cells)) done)])))
  (define statistic
    (for/sum ([cell (in-list pooled)])
      (/ (sqr (- (cdr cell) (car cell))) (car cell))))
  (define freedom (- (length pooled) 1))
  (if (> freedom 0)
      (gamma-inc (/ freedom 2.0) (/ statistic 2.0) #t #t)
      (raise-arguments-error 'chi-square-test "too few samples for two bins")))

(define (bin-of d theta-bins phi-bins)
  (define theta (acos (max -1.0 (min 1.0 (flvector-ref d 2)))))
  (define phi (+ pi (atan (flvector-ref d 1) (flvector-ref d 0))))
  (define (place x extent bins)
    (min (- bins 1) (inexact->exact (floor (* bins (/ x extent))))))
  (+ (* phi-bins (place theta pi theta-bins)) (place phi (* 2.0 pi) phi-bins)))

;; The integral of the density over each bin.
(define (bin-integrals density theta-bins phi-bins [halvings 8])
  (for*/flvector #:length (* theta-bins phi-bins)
                 ([j (in-range theta-bins)] [k (in-range phi-bins)])
    (define (theta j) (* pi (/ (->fl j) theta-bins)))
    (define (phi k) (- (* 2.0 pi (/ (->fl k) phi-bins)) pi))
    (adaptive density (theta j) (theta (+ j 1)) (phi k) (phi (+ k 1)) halvings)))

;; The integral of a function of x, y, z over the sphere, to about 1e-7.
(define (density-integral density #:theta-bins [theta-bins 20] #:phi-bins [phi-bins 20])
  (for/fold ([sum 0.0]) ([part (in-flvector (bin-integrals density theta-bins phi-bins))])
    (+ sum part)))

;; A product Gauss rule of 4 x 4 points, halved both ways until it changes by less than 1e-9, at
;; most so many times.
(define (adaptive density theta0 theta1 phi0 phi1 halvings)
  (let refine ([a theta0] [b theta1] [c phi0] [d phi1]
               [coarse (gauss density theta0 theta1 phi0 phi1)] [left halvings])
    (define m (* 0.5 (+ a b)))
    (define n (* 0.5 (+ c d)))
    (define q1 (gauss density a m c n))
    (define q2 (gauss density a m n d))
    (define q3 (gauss density m b c n))
    (define q4 (gauss density m b n d))
    (define fine (+ (+ q1 q2) (+ q3 q4)))
    (if (or (zero? left) (< (abs (- fine coarse)) 1e-9))
        fine
        (+ (+ (refine a m c n q1 (- left 1)) (refine a m n d q2 (- left 1)))
           (+ (refine m b c n q3 (- left 1)) (refine m b n d q4 (- left 1)))))))

(define GAUSS-POINTS (flvector -0.8611363115940526 -0.3399810435848563
                               0.3399810435848563 0.8611363115940526))
(define GAUSS-WEIGHTS (flvector 0.3478548451374538 0.6521451548625461
                                0.6521451548625461 0.3478548451374538))

(define (gauss density a b c d)
  (define half-theta (fl* 0.5 (fl- b a)))
  (define half-phi (fl* 0.5 (fl- d c)))
  (define (at middle half k) (fl+ middle (fl* half (flvector-ref GAUSS-POINTS k))))
  (for*/fold ([sum 0.0] #:result (* sum half-theta half-phi)) ([j (in-range 4)])
    (define theta (at (fl* 0.5 (fl+ a b)) half-theta j))
    (define sine (flsin theta))
    (define cosine (flcos theta))
    (for/fold ([sum sum]) ([k (in-range 4)])
      (define phi (at (fl* 0.5 (fl+ c d)) half-phi k))
      (fl+ sum (fl* (fl* (flvector-ref GAUSS-WEIGHTS j) (flvector-ref GAUSS-WEIGHTS k))
                    (fl* sine
                         (density (fl* sine (flcos phi)) (fl* sine (flsin phi)) cosine)))))))

;; The test tested, with samples and densities known to agree, or not to.
(module+ test
  (require rackunit)
  (define (sampler seed direction)
    (define generator (vector->pseudo-random-generator (vector seed 2 3 4 5 6)))
    (lambda (k) (direction (random generator) (random generator) (random generator))))
  (define (around z phi)
    (define s (sqrt (- 1.0 (* z z))))
    (flvector (* s (cos phi)) (* s (sin phi)) z))
  (define (uniform u v w) (around u (* 2.0 pi v)))
  (define (by-cosine u v w) (around (sqrt u) (* 2.0 pi v)))
  (define (uniform-density x y z) (if (> z 0.0) (/ 0.5 pi) 0.0))
  (define (cosine-density x y z) (if (> z 0.0) (/ z pi) 0.0))
  (define (p sample density) (chi-square-result-p (chi-square-test sample density 20000)))

  ;; 20 seeds each, level .01 for all of them together
  (for ([seed (in-range 1 21)])
    (check-true (> (p (sampler seed uniform) uniform-density) (sidak-level 0.01 40)))
    (check-true (> (p (sampler seed by-cosine) cosine-density) (sidak-level 0.01 40))))
  (check-true (< (p (sampler 1 uniform) cosine-density) 1e-12))
  (check-true (< (p (sampler 1 by-cosine) uniform-density) 1e-12))
  ;; a density 3% tilted
  (check-true (< (chi-square-result-p
                  (chi-square-test (sampler 1 uniform)
                                   (lambda (x y z) (if (> z 0.0) (/ (+ 0.5 (* 0.06 x)) pi) 0.0))
                                   200000))
                 1e-4))
  ;; a part without density: as expected, and when none is expected
  (define (with-missing part) (lambda (u v w) (and (>= w part) (uniform u v w))))
  (check-true (> (p (sampler 1 (with-missing 0.3)) (lambda (x y z) (* 0.7 (uniform-density x y z))))
                 0.001))
  (check-true (< (p (sampler 1 (with-missing 0.01)) uniform-density) 1e-6))
  (check-= (density-integral uniform-density) 1.0 1e-9)
  (check-= (density-integral cosine-density) 1.0 1e-9))
