#lang racket/base
;; Tori: the quartic's roots against exact arithmetic, crossings of random and of tangent lines,
;; self-intersection, bounds and axes.
(module+ test
  (require rackunit racket/math racket/list math/flonum
           "probe.rkt" "axial-checks.rkt" "../base/roots.rkt")

  ;; of radii 1 and 0.4, times the size
  (define (make size center axis) (torus center axis size (* 0.4 size)))

  (define count (if stress? 1000000 10000))

  (define (check-within-ulps name found digits allowed)
    (define errors (for/list ([t (in-list found)] [e (in-list digits)])
                     (flulp-error t (string->number (string-append "#e" e)))))
    (printf "~a: ~a ulp\n" name errors)
    (check-equal? (length found) (length digits))
    (check-true (<= (apply max errors) allowed) (format "~a" found)))

  (define (check-normal p expected tolerance)
    (for ([n (Surface-normal (surface-at p))] [e expected])
      (check-= n e tolerance)))

  (test-case "H11: through the hole, t to 4 ulp, normal to 1e-14"
    (define p (probe (torus '(0.0 0.0 0.0) '(0.0 0.0 1.0) 2.0 0.5)))
    (define-values (o d) (values '(-5.0 0.0 0.0) '(1.0 0.0 0.0)))
    (check-within-ulps "H11" (crossings p o d) '("2.5" "3.5" "6.5" "7.5") 4.0)
    (check-equal? (shoot p o d) 2.5)
    (check-normal p '(-1.0 0.0 0.0) 1e-14)
    (check-equal? (shoot p '(-2.0 0.0 0.0) d) 0.5)
    (check-equal? (shoot p '(0.0 0.0 0.0) d) 1.5)
    (check-normal p '(-1.0 0.0 0.0) 1e-14)
    (check-equal? (shoot p '(2.0 0.0 0.0) d) 0.5)
    (check-false (shoot p '(3.0 0.0 0.0) d))
    (check-false (shoot p o d 2.5))
    (check-true (shoot-occluded p o d 3.0)))

  (test-case "a root between neighbouring numbers, where steps went to and fro for ever"
    (define p (probe (torus '(1.4 0.35 -1.6) '(0.0 1.0 0.0) 1.1 0.35)))
    (define-values (o d)
      (values '(1.5 5.5 9.0) '(-0.07831999295706488 -0.48088494227889733 -0.873278678883566)))
    (define found (make-channel))
    (define search (thread (lambda () (channel-put found (or (shoot p o d) 'none)))))
    (define t (sync/timeout 20 found))
    (kill-thread search)
    (check-true (and t #t))
    ;; whether it is met or not, the line is tangent there to a few roundings
    (unless (eq? t 'none)
      (define-values (x y z)
        (apply values (map (lambda (o d c) (- (+ o (* t d)) c)) o d '(1.4 0.35 -1.6))))
      (define beyond (- (sqrt (+ (* x x) (* z z))) 1.1))
      (check-= (+ (* beyond beyond) (* y y)) (* 0.35 0.35) 1e-14)))

  (test-case "H12: generic, t to 4 ulp, normal to 1e-14"
    (define p (probe (torus '(0.0 0.0 0.0) '(0.0 0.0 1.0) 2.0 0.5)))
    (define-values (o d) (values '(-4.0 0.3 0.1) '(1.0 0.1 0.02)))
    (define digits '("1.5597545295338335" "2.5824042144939843" "5.3022976011849547"
                     "6.2641739002345751"))
    (check-within-ulps "H12" (crossings p o d) digits 4.0)
    (check-within-ulps "H12 nearest" (list (shoot p o d)) (take digits 1) 4.0)
    (check-normal p '(-0.94854457135015986 0.17724161187982367 0.26239018118135334) 1e-14))

  (test-case "H14: tangent to the inner equator, t to 4 ulp and the double root to 1e-12"
    (define p (probe (torus '(0.0 0.0 0.0) '(0.0 0.0 1.0) 2.0 0.5)))
    (define-values (o d) (values '(1.5 -5.0 0.0) '(0.0 1.0 0.0)))
    (define found (crossings p o d))
    (check-within-ulps "H14" (list (first found) (last found)) '("3.0" "7.0") 4.0)
    ;; the touch is met twice or not at all
    (check-true (even? (length found)))
    (for ([t (in-list (drop-right (rest found) 1))])
      (check-= t 5.0 5e-12))
    (check-equal? (shoot p o d) 3.0))

  (test-case "touching lines from outside meet the torus twice or not at all"
    (define p (probe (torus '(0.0 0.0 0.0) '(0.0 0.0 1.0) 2.0 0.5)))
    (for ([o '((2.5 -5.0 0.0) (2.0 -5.0 0.5) (-5.0 0.0 0.5) (1.5 0.0 -5.0) (2.5 0.0 -5.0))]
          [d '((0.0 1.0 0.0) (0.0 1.0 0.0) (1.0 0.0 0.0) (0.0 0.0 1.0) (0.0 0.0 1.0))])
      (check-true (even? (length (crossings p o d))) (format "~a ~a" o d))))

  (test-case "uv runs around the axis and around the ring"
    (define p (probe (torus '(0.0 0.0 0.0) '(0.0 1.0 0.0) 2.0 0.5)))
    (define (check-uv o d u v)
      (shoot p o d)
      (define s (surface-at p))
      (check-= (Surface-u s) u 1e-12)
      (check-= (Surface-v s) v 1e-12))
    (check-uv '(5.0 0.0 0.0) '(-1.0 0.0 0.0) 0.5 0.5)
    (check-uv '(0.0 0.0 5.0) '(0.0 0.0 -1.0) 0.25 0.5)
    (check-uv '(2.0 5.0 0.0) '(0.0 -1.0 0.0) 0.5 0.75)
    (check-uv '(2.0 -5.0 0.0) '(0.0 1.0 0.0) 0.5 0.25))

  (test-case "constructor errors name the argument"
    (define (bad . arguments) (lambda () (apply torus arguments)))
    (check-exn #rx"^Torus: .*minor" (bad '(0.0 0.0 0.0) '(0.0 0.0 1.0) 1.0 1.0))
    (check-exn #rx"^Torus: .*minor" (bad '(0.0 0.0 0.0) '(0.0 0.0 1.0) 1.0 0.0))
    (check-exn #rx"^Torus: .*major" (bad '(0.0 0.0 0.0) '(0.0 0.0 1.0) -1.0 0.5))
    (check-exn #rx"^Torus: .*axis" (bad '(0.0 0.0 0.0) '(0.0 0.0 0.0) 1.0 0.5))
    (check-exn #rx"^Torus: .*center" (bad '(0.0 +nan.0 0.0) '(0.0 0.0 1.0) 1.0 0.5)))

  ;; --- S10 and N03 ---

  ;; (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + y^2) along an exact line, as coefficients of t^4 .. 1.
  (define (quartic major minor o d)
    (define k (+ (dot o o) (* major major) (- (* minor minor))))
    (define-values (dd od) (values (dot d d) (dot o d)))
    (define (flat a b) (+ (* (car a) (car b)) (* (cadr a) (cadr b))))
    (define four (* 4 major major))
    (list (* dd dd)
          (* 4 dd od)
          (+ (* 2 dd k) (* 4 od od) (- (* four (flat d d))))
          (- (* 4 od k) (* 2 four (flat o d)))
          (- (* k k) (* four (flat o o)))))

  (define (evaluate coefficients t)
    (for/fold ([value 0]) ([c (in-list coefficients)]) (+ c (* t value))))

  ;; |F| / |grad F| at the computed parameter, in exact arithmetic but for the last step.
  (define (residual major minor o d t)
    (define p (add o (scale t d)))
    (define k (+ (dot p p) (* major major) (- (* minor minor))))
    (define four (* 4 major major))
    (define gradient (subtract (scale (* 4 k) p)
                               (list (* 2 four (car p)) (* 2 four (cadr p)) 0)))
    (/ (abs (real->double-flonum
             (- (* k k) (* four (+ (* (car p) (car p)) (* (cadr p) (cadr p)))))))
       (norm (map real->double-flonum gradient))))

  ;; Whether the line has two crossings closer than 1e-6 to each other: where the quartic has an
  ;; extreme within half of that of a change of sign of its derivative, and next to no depth.
  (define (near-double? coefficients found)
    (or (for/or ([t (in-list found)] [next (in-list (if (pair? found) (cdr found) '()))])
          (< (- next t) 1e-6))
        (let* ([slope (list (* 4 (first coefficients)) (* 3 (second coefficients))
                            (* 2 (third coefficients)) (fourth coefficients))]
               [bend (list (* 3 (first slope)) (* 2 (second slope)) (third slope))])
          ;; an extreme that the computed roots skip, with roots (if any) within 1e-6 of it
          (for/or ([t (in-list (extremes slope))])
            (define depth (abs (evaluate coefficients t)))
            (define curvature (abs (/ (evaluate bend t) 2)))
            (<= depth (* curvature (expt 5e-7 2)))))))

  ;; Sign changes of an exact cubic on a fine grid, bisected.
  (define (extremes slope)
    (define grid (for/list ([k (in-range -600 601)]) (/ k 100)))
    (for/list ([low (in-list grid)] [high (in-list (cdr grid))]
               #:when (< (* (evaluate slope low) (evaluate slope high)) 0))
      (let loop ([low low] [high high] [n 0])
        (define middle (/ (round (* (expt 2 60) (/ (+ low high) 2))) (expt 2 60)))
        (cond
          [(= n 50) middle]
          [(< (* (evaluate slope low) (evaluate slope middle)) 0) (loop low middle (+ n 1))]
          [else (loop middle high (+ n 1))]))))

  (define (random-line uniform radius)
    (define d (random-unit uniform))
    (define side (cross d (random-unit uniform)))
    (define across (scale (/ (* radius (sqrt (uniform 0.0 1.0))) (norm side)) side))
    (values (subtract across (scale (uniform 1.0 3.0) d)) d))

  ;; Odd counts, worst residual, lines where the count is not the exact one although no two roots
  ;; are within 1e-6; `exactly` of the lines are counted by Sturm's theorem. Then the sum of the
  ;; counts and of their squares.
  (define (examine count next-line major minor exactly)
    (define p (probe (torus '(0.0 0.0 0.0) '(0.0 0.0 1.0) major minor)))
    (define-values (M m) (values (inexact->exact major) (inexact->exact minor)))
    (for/fold ([odd 0] [worst 0.0] [wrong 0] [sum 0] [squares 0])
              ([k (in-range count)])
      (define-values (o d) (next-line))
      (define-values (O D) (values (exact o) (exact d)))
      (define found (crossings p o d))
      (define n (length found))
      (define worst* (for/fold ([worst worst]) ([t (in-list found)] #:when (< k exactly))
                       (max worst (residual M m O D (inexact->exact t)))))
      (define wrong?
        (and (< k exactly)
             (let ([coefficients (quartic M m O D)])
               (and (not (= n (sturm-root-count coefficients)))
                    (not (near-double? coefficients found))))))
      (values (if (odd? n) (+ odd 1) odd) worst* (if wrong? (+ wrong 1) wrong)
              (+ sum n) (+ squares (* n n)))))

  ;; fails beyond 4 standard errors
  (test-case "S10 and N03: random lines through the bounding ball"
    (define uniform (make-random 31))
    (define-values (odd worst wrong sum squares)
      (examine count (lambda () (random-line uniform 1.25)) 1.0 0.25 (if stress? 100000 4000)))
    (define mean (/ sum 1.0 count))
    (define standard-error (sqrt (/ (- (/ squares 1.0 count) (* mean mean)) count)))
    (define z (/ (- mean 1.0053096491487339) standard-error))
    (printf "S10: ~a lines, ~a odd, ~a wrong, residual ~a R; N03: mean ~a, z = ~a\n"
            count odd wrong worst mean z)
    (check-equal? odd 0)
    (check-equal? wrong 0)
    (check-true (<= worst 1e-12))
    (check-true (< (abs z) 4.0)))

  (test-case "S10: a thin torus, r / R = 1e-4, lines close to its circle"
    (define uniform (make-random 32))
    (define-values (odd worst wrong sum squares)
      (examine (quotient count 5)
               (lambda ()
                 (define angle (uniform 0.0 (* 2.0 pi)))
                 (define d (random-unit uniform))
                 (define target (add (list (cos angle) (sin angle) 0.0)
                                     (scale 1.5e-4 (random-in-ball uniform))))
                 (values (subtract target (scale 2.0 d)) d))
               1.0 1e-4 (if stress? 20000 1000)))
    (printf "S10 thin: ~a crossings, ~a odd, ~a wrong, residual ~a R\n" sum odd wrong worst)
    (check-true (> sum (quotient count 5)))
    (check-equal? odd 0)
    (check-equal? wrong 0)
    (check-true (<= worst 1e-12)))

  (test-case "S10: lines within 1e-14 to 1e-3 of a tangent"
    (define uniform (make-random 33))
    (define-values (odd worst wrong sum squares)
      (examine (quotient count 5)
               (lambda ()
                 (define-values (u v) (values (uniform 0.0 (* 2.0 pi)) (uniform 0.0 (* 2.0 pi))))
                 (define normal (list (* (cos v) (cos u)) (* (cos v) (sin u)) (sin v)))
                 (define point (add (list (cos u) (sin u) 0.0) (scale 0.25 normal)))
                 (define side (cross normal (random-unit uniform)))
                 (define d (scale (/ 1.0 (norm side)) side))
                 (define depth (* (if (< (uniform) 0.5) -1.0 1.0)
                                  (exp (uniform (log 1e-14) (log 1e-3)))))
                 (values (subtract (subtract point (scale depth normal)) (scale 2.0 d)) d))
               1.0 0.25 (if stress? 20000 1000)))
    (printf "S10 tangents: ~a crossings, ~a odd, ~a wrong, residual ~a R\n" sum odd wrong worst)
    (check-equal? odd 0)
    (check-equal? wrong 0)
    (check-true (<= worst 1e-12)))

  ;; Any distance of the point from the surface, exactly but for the square roots.
  (define (surface-distance center axis major minor point)
    (define from-center (subtract point center))
    (define z-squared (/ (expt (dot from-center axis) 2) (dot axis axis)))
    (define across (exact-square-root (- (dot from-center from-center) z-squared)))
    (abs (- (exact-square-root (+ (expt (- across major) 2) z-squared)) minor)))

  (test-case "computed points are within surface-error of the surface"
    (define uniform (make-random 34))
    (define worst
      (for*/fold ([worst 0.0]) ([size '(1e-9 1.0 1e9)] [offset '(0.0 1.0 1e8)]
                                [ratio '(0.01 0.4 0.99)] [k (in-range 40)])
        (define center (scale (* size offset) (random-unit uniform)))
        (define axis (random-unit uniform))
        (define p (probe (torus center axis size (* ratio size))))
        (cond
          [(random-hit uniform p size center)
           (define s (surface-at p))
           (check-= (norm (Surface-normal s)) 1.0 1e-15)
           (max worst
                (real->double-flonum
                 (/ (surface-distance (exact center) (exact axis) (inexact->exact size)
                                      (inexact->exact (* ratio size)) (exact (Surface-point s)))
                    (Surface-error s))))]
          [else worst])))
    (printf "torus: points within ~a of surface-error\n" worst)
    (check-true (<= worst 1.0)))

  (test-case "spawned rays" (check-spawned-rays make #:convex? #f #:seed 35 #:count count))
  (test-case "bounds hold all hits" (check-hits-in-bounds make #:seed 36 #:count 4000))
  (test-case "any axis" (check-axes-agree make #:seed 37 #:count 1000))
  (test-case "powers of two" (check-power-of-two-scaling make #:seed 38 #:count 300))
  (test-case "crossings" (check-crossings-alternate make #:seed 39 #:count 1000)))
