#lang racket/base
;; What statistical tests share: seeded random numbers, means with their standard errors, and
;; chi-square statistics as standard normal deviates.

(provide stress? stressed seeded
         mean standard-deviation standard-error deviations check-mean
         chi-square-deviate uniform-deviate correlation)

(require racket/flonum rackunit)

(define stress? (and (getenv "RAYTRACE_STRESS") #t))

;; A number of repetitions: the first one, or the second when RAYTRACE_STRESS is set.
(define (stressed count stress-count) (if stress? stress-count count))

;; A function of low and high (0 and 1 unless given) to uniform numbers between them, by a
;; generator of its own that starts from the seed.
(define (seeded seed)
  (define generator (vector->pseudo-random-generator (vector (+ seed 1) 2 3 4 5 6)))
  (for ([k 10]) (random generator))
  (lambda ([low 0.0] [high 1.0]) (+ low (* (- high low) (random generator)))))

(define (mean values) (/ (for/fold ([sum 0.0]) ([v values]) (+ sum v)) (sequence-count values)))

(define (sequence-count values) (for/sum ([v values]) 1))

(define (standard-deviation values)
  (define m (mean values))
  (sqrt (/ (for/fold ([sum 0.0]) ([v values]) (+ sum (* (- v m) (- v m))))
           (- (sequence-count values) 1))))

(define (standard-error values) (/ (standard-deviation values) (sqrt (sequence-count values))))

;; How many standard errors the mean of independent estimates is away from what was expected.
;; Roundings of the mean, 1e-12 of it, are forgiven.
(define (deviations values expected)
  (define distance (max 0.0 (- (abs (- (mean values) expected)) (* 1e-12 (abs expected)))))
  (define error (standard-error values))
  (cond
    [(= distance 0.0) 0.0]
    [(= error 0.0) +inf.0]
    [else (/ distance error)]))

;; The mean of independent estimates is within so many standard errors (4 unless given), and these
;; are at most `precision` of what is expected, so that the check means something.
(define-check (check-mean name values expected precision)
  (define found (deviations values expected))
  (unless (and (<= found 4.0) (<= (standard-error values) (* precision (abs expected))))
    (with-check-info (['mean (mean values)] ['expected expected] ['standard-error (standard-error values)]
                      ['standard-errors-away found])
      (fail-check name))))

;; Pearson's statistic of counts against expected counts as a standard normal deviate (Wilson and
;; Hilferty 1931); expected counts should be 20 or more.
(define (chi-square-deviate counts expected)
  (define-values (statistic cells)
    (for/fold ([sum 0.0] [cells 0]) ([c counts] [e expected])
      (values (+ sum (/ (* (- c e) (- c e)) e)) (+ cells 1))))
  (define freedom (exact->inexact (- cells 1)))
  (define spread (/ 2.0 (* 9.0 freedom)))
  (/ (- (expt (/ statistic freedom) (/ 1.0 3.0)) (- 1.0 spread)) (sqrt spread)))

;; The same for values in [0, 1) that should be uniform, in equal cells.
(define (uniform-deviate values cells)
  (define counts (make-vector cells 0))
  (for ([v values])
    (define cell (min (- cells 1) (max 0 (inexact->exact (floor (* v cells))))))
    (vector-set! counts cell (+ 1 (vector-ref counts cell))))
  (define expected (/ (exact->inexact (sequence-count values)) cells))
  (chi-square-deviate counts (for/list ([k cells]) expected)))

;; Pearson's correlation of two flvectors; for independent ones it is about 1 / sqrt(length).
(define (correlation a b)
  (define-values (ma mb) (values (mean (in-flvector a)) (mean (in-flvector b))))
  (define-values (ab aa bb)
    (for/fold ([ab 0.0] [aa 0.0] [bb 0.0]) ([x (in-flvector a)] [y (in-flvector b)])
      (define-values (dx dy) (values (- x ma) (- y mb)))
      (values (+ ab (* dx dy)) (+ aa (* dx dx)) (+ bb (* dy dy)))))
  (/ ab (sqrt (* aa bb))))

(module+ test
  (test-case "chi-square deviates: 0.95 quantile of 10 and of 100 degrees of freedom, to 0.01"
    (for ([freedom '(10 100)] [statistic '(18.307 124.342)])
      (define cells (+ freedom 1))
      (define shift (sqrt (/ (* statistic 100.0) 2)))
      (define counts (list* (+ 100.0 shift) (- 100.0 shift) (for/list ([k (- cells 2)]) 100.0)))
      (check-= (chi-square-deviate counts (for/list ([k cells]) 100.0)) 1.6449 0.01)))
  (test-case "a generator's numbers pass, a skewed one's do not"
    (define uniform (seeded 1))
    (define values (for/list ([k 10000]) (uniform)))
    (check-true (< (abs (uniform-deviate values 64)) 4.0))
    (check-true (> (uniform-deviate (map (lambda (v) (* v v)) values) 64) 10.0))
    (check-true (> (uniform-deviate (map (lambda (v) (* 0.97 v)) values) 64) 4.0)))
  (test-case "means: 4 standard errors hold, a shift of 6 does not, nor does a wide error"
    (define uniform (seeded 2))
    (define values (for/list ([k 400]) (uniform)))
    (define error (standard-error values))
    (check-mean "uniform" values 0.5 0.1)
    (check-true (> (deviations values (+ (mean values) (* 6 error))) 5.9))
    (check-= (standard-deviation values) (sqrt (/ 1.0 12.0)) 0.02)))
