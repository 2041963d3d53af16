#lang racket/base
;; S09, S10: quadratics and the torus' quartic against exact arithmetic.

(provide cases)

(require racket/list racket/math "case.rkt" "../base/roots.rkt" "../../private/base/roots.rkt"
         (prefix-in probe: "../shape/probe.rkt"))

;; --- S09 ---

(define (quadratics size)
  (define uniform (seeded 9))
  (define count (amount 1000000 size 5000))
  (define (log-uniform low high)
    (* (if (< (uniform) 0.5) -1.0 1.0) (exp (uniform (log low) (log high)))))
  ;; one in eight without a square, one with next to none, a quarter of the rest near a double root
  (define (coefficients k)
    (define a
      (case (remainder k 8)
        [(6) 0.0]
        [(7) (log-uniform 1e-290 1e-20)]
        [else (log-uniform 1e-8 1e8)]))
    (define b (log-uniform 1e-8 1e8))
    (define c
      (if (or (zero? a) (> (uniform) 0.25))
          (log-uniform 1e-8 1e8)
          (* (/ (* b b) (* 4.0 a)) (- 1.0 (log-uniform 1e-12 1e-2)))))
    (values a b c))
  (define-values (worst wrong checked)
    (for/fold ([worst 0.0] [wrong 0] [checked 0]) ([k (in-range count)])
      (define-values (a b c) (coefficients k))
      (define-values (A B C) (apply values (exact (list a b c))))
      (define-values (square product) (values (* B B) (* 4 A C)))
      (cond
        [(or (not (< (abs c) +inf.0))
             (<= (abs (- square product)) (* 1e-12 (max square (abs product)))))
         (values worst wrong checked)]
        [else
         (define right (if (zero? A) (list (- (/ C B))) (exact-quadratic-roots A B C)))
         (define found (quadratic-roots a b c))
         (if (= (length found) (length right))
             (values (apply max worst (map ulps found right)) wrong (+ checked 1))
             (values worst (+ wrong 1) (+ checked 1)))])))
  (values (format "~a ulp, ~a with another number of roots, of ~a" (rounded worst) wrong checked)
          (and (<= worst 8.0) (= wrong 0) (> checked (* 0.9 count)))))

;; --- S10 ---

(define (evaluate coefficients t)
  (for/fold ([value 0]) ([c (in-list coefficients)]) (+ c (* t value))))

(define (derivative coefficients)
  (for/list ([c (in-list coefficients)] [k (in-range (- (length coefficients) 1) 0 -1)]) (* k c)))

(define (flat-dot a b) (+ (* (car a) (car b)) (* (cadr a) (cadr b))))

;; (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + y^2) along a line o + t d with R = 1, everything exact.
(define (quartic minor o d)
  (define k (+ (dot o o) 1 (- (* minor minor))))
  (define-values (dd od) (values (dot d d) (dot o d)))
  (list (* dd dd) (* 4 dd od)
        (+ (* 2 dd k) (* 4 od od) (* -4 (flat-dot d d)))
        (- (* 4 od k) (* 8 (flat-dot o d)))
        (- (* k k) (* 4 (flat-dot o o)))))

;; |F| / |grad F| at parameter t, exact but for the last step.
(define (residual minor o d t)
  (define p (add o (scale t d)))
  (define k (+ (dot p p) 1 (- (* minor minor))))
  (define gradient
    (subtract (scale (* 4 k) p) (list (* 8 (first p)) (* 8 (second p)) 0)))
  (/ (abs (real->double-flonum (- (* k k) (* 4 (flat-dot p p)))))
     (norm (map real->double-flonum gradient))))

;; Whether a pair of roots is closer than 1e-6: two that were found, or two at an extreme that is
;; no deeper than half of that makes it.
(define (near-double? coefficients found)
  (define slope (derivative coefficients))
  (define bend (derivative slope))
  (or (for/or ([t (in-list found)] [next (in-list (if (pair? found) (cdr found) '()))])
        (< (- next t) 1e-6))
      (for/or ([t (in-list (sign-changes slope))])
        (<= (abs (evaluate coefficients t)) (* 1/2 (abs (evaluate bend t)) (expt 1/2000000 2))))))

;; Where an exact polynomial changes sign within -6 to 6, from a grid, bisected to 2^-57.
(define (sign-changes polynomial)
  (define (sign t) (sgn (evaluate polynomial t)))
  (for/list ([k (in-range -600 600)] #:when (< (* (sign (/ k 100)) (sign (/ (+ k 1) 100))) 0))
    (for/fold ([low (/ k 100)] [high (/ (+ k 1) 100)] #:result low) ([_ 50])
      (define middle (/ (round (* (expt 2 60) (/ (+ low high) 2))) (expt 2 60)))
      (if (< (* (sign low) (sign middle)) 0) (values low middle) (values middle high)))))

;; What was seen of lines: odd numbers of roots, the worst residual, pairs that were missed, the sum
;; of the numbers of roots and of their squares.
(struct seen (lines odd residual missed sum squares))

;; At most `exactly` of the lines are also counted by Sturm's theorem.
(define (examine count next-line minor exactly)
  (define p (probe:probe (probe:torus '(0.0 0.0 0.0) '(0.0 0.0 1.0) 1.0 minor)))
  (define r (inexact->exact minor))
  (for/fold ([s (seen 0 0 0.0 0 0 0)]) ([k (in-range count)])
    (define-values (o d) (next-line))
    (define-values (O D) (values (exact o) (exact d)))
    (define found (probe:crossings p o d))
    (define n (length found))
    (define missed?
      (and (< k exactly)
           (let ([coefficients (quartic r O D)])
             (and (not (= n (sturm-root-count coefficients)))
                  (not (near-double? coefficients found))))))
    (seen (+ 1 (seen-lines s))
          (+ (seen-odd s) (if (odd? n) 1 0))
          (for/fold ([worst (seen-residual s)]) ([t (in-list found)])
            (max worst (residual r O D (inexact->exact t))))
          (+ (seen-missed s) (if missed? 1 0))
          (+ (seen-sum s) n)
          (+ (seen-squares s) (* n n)))))

(define (along target d) (values (subtract target (scale 2.0 d)) d))

(define (torus size)
  (define uniform (seeded 10))
  (define-values (count exactly) (values (amount 1000000 size 4000) (amount 200000 size 800)))
  (define random-lines
    (examine count
             (lambda ()
               (define d (random-unit uniform))
               (define side (cross d (random-unit uniform)))
               (along (scale (/ (* 1.25 (sqrt (uniform))) (norm side)) side) d))
             0.25 exactly))
  ;; r / R = 1e-4, lines close to the ring
  (define thin
    (examine (quotient count 5)
             (lambda ()
               (define angle (uniform 0.0 (* 2.0 pi)))
               (along (add (list (cos angle) (sin angle) 0.0)
                           (scale 1.5e-4 (random-in-ball uniform)))
                      (random-unit uniform)))
             1e-4 (quotient exactly 5)))
  ;; within 1e-14 to 1e-3 of a tangent, on either side
  (define tangents
    (examine (quotient count 5)
             (lambda ()
               (define-values (u v) (values (uniform 0.0 (* 2.0 pi)) (uniform 0.0 (* 2.0 pi))))
               (define normal (list (* (cos v) (cos u)) (* (cos v) (sin u)) (sin v)))
               (define depth
                 (* (if (< (uniform) 0.5) -1.0 1.0) (exp (uniform (log 1e-14) (log 1e-3)))))
               (along (add (list (cos u) (sin u) 0.0) (scale (- 0.25 depth) normal))
                      (unit (cross normal (random-unit uniform)))))
             0.25 (quotient exactly 5)))
  ;; H14, a tangent of the inner equator: 3, 7 and 5 twice or not at all
  (define touching
    (probe:crossings (probe:probe (probe:torus '(0.0 0.0 0.0) '(0.0 0.0 1.0) 2.0 0.5))
                     '(1.5 -5.0 0.0) '(0.0 1.0 0.0)))
  (define touching?
    (and (even? (length touching)) (<= (ulps (first touching) 3) 4.0)
         (<= (ulps (last touching) 7) 4.0)))
  (define mean (/ (seen-sum random-lines) 1.0 count))
  (define deviations
    (/ (- mean 1.0053096491487339) ; 2 S_torus / S_ball
       (sqrt (/ (- (/ (seen-squares random-lines) 1.0 count) (* mean mean)) count))))
  (define all (list random-lines thin tangents))
  (define-values (odd missed worst)
    (values (apply + (map seen-odd all)) (apply + (map seen-missed all))
            (apply max (map seen-residual all))))
  (values (format (string-append "~a odd, ~a pairs missed, residual ~a R, crossings ~a standard "
                                 "errors off, ~a lines, tangent ~a")
                  odd missed (rounded worst) (rounded deviations) (apply + (map seen-lines all))
                  (if touching? "right" "wrong"))
          (and (= 0 odd missed) (<= worst 1e-12) (< (abs deviations) 4.0) touching?
               (> (seen-sum thin) 0))))

(define cases
  (list (stress-case "S09 quadratics" "8 ulp" quadratics)
        (stress-case "S10 torus quartic" "even counts, 1e-12 R, 4 standard errors, no pair missed"
                     torus)))
