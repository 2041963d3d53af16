#lang racket/base
;; Cones: hits against exact arithmetic, self-intersection, bounds, axes, cap and open cones.
(module+ test
  (require rackunit math/flonum "probe.rkt" "axial-checks.rkt" "../base/roots.rkt")

  ;; of height 2 and base radius 1, times the size
  (define (make size center axis)
    (cone (subtract center (scale size axis)) size (add center (scale size axis))))

  (define count (if stress? 1000000 10000))

  ;; The nearest t of a closed cone in exact arithmetic, or #f. All arguments exact. Inside is
  ;; |across|^2 L^4 <= r^2 (along)^2 between apex and base, L the height, along = (p - apex).axis.
  (define (exact-nearest base radius apex o d)
    (define axis (subtract base apex))
    (define height-squared (dot axis axis))
    (define from-apex (subtract o apex))
    (define slope (/ (* radius radius) (* height-squared height-squared)))
    (define (across v) (subtract v (scale (/ (dot v axis) height-squared) axis)))
    (define-values (oa da) (values (across from-apex) (across d)))
    (define-values (oz dz) (values (dot from-apex axis) (dot d axis)))
    (define sides
      (exact-quadratic-roots (- (dot da da) (* slope dz dz))
                             (* 2 (- (dot oa da) (* slope oz dz)))
                             (- (dot oa oa) (* slope oz oz))))
    (define ends (list (/ (- oz) dz) (/ (- height-squared oz) dz)))
    (define (z-at t) (+ oz (* t dz)))
    (define candidates
      (append (filter (lambda (t) (<= 0 (z-at t) height-squared)) sides)
              (let* ([t (cadr ends)] [p (add oa (scale t da))])
                (if (<= (dot p p) (* radius radius)) (list t) '()))))
    (define ahead (filter positive? candidates))
    (and (pair? ahead) (apply min ahead)))

  ;; The distance of a point from the infinite side or the base plane, the less of both.
  (define (surface-distance base radius apex point)
    (define axis (subtract base apex))
    (define height (exact-square-root (dot axis axis)))
    (define slant (exact-square-root (+ (dot axis axis) (* radius radius))))
    (define from-apex (subtract point apex))
    (define z (/ (dot from-apex axis) height))
    (define across (exact-square-root (- (dot from-apex from-apex) (* z z))))
    (min (abs (/ (- (* across height) (* z radius)) slant)) (abs (- z height))))

  ;; H10: one nappe of x^2 + z^2 = y^2, wide enough for both of the hits
  (test-case "H10: both t to 4 ulp, normal to 1e-14"
    (define p (probe (cone '(0.0 -40.0 0.0) 40.0 '(0.0 0.0 0.0))))
    (define o '(1.0 1.0 -5.0))
    (define d '(-0.5 -1.0 1.0))
    (define t (shoot p o d))
    (define error-1 (flulp-error t (string->number "#e3.0333704529042345")))
    (for ([n (Surface-normal (surface-at p))]
          [e '(-0.17967784809766091 0.70710678118654752 -0.68389755877835526)])
      (check-= n e 1e-14))
    ;; from a place inside, 16 on: exactly representable
    (define t-2 (shoot p (add o (scale 16.0 d)) d))
    (define error-2 (flulp-error t-2 (- (string->number "#e32.966629547095766") 16)))
    ;; from the other side
    (define t-3 (shoot p (add o (scale 64.0 d)) (scale -1.0 d)))
    (define error-3 (flulp-error t-3 (- 64 (string->number "#e32.966629547095766"))))
    (printf "H10: ~a, ~a, ~a ulp\n" error-1 error-2 error-3)
    (check-true (<= (max error-1 error-2 error-3) 4.0))
    ;; unit direction
    (define u (scale (/ 1.0 1.5) d))
    (check-= (shoot p o u) 4.55005567935635 1e-13))

  (test-case "hits of an upright cone, exactly"
    ;; y = 1 - 2 |x|
    (define p (probe (cone '(0.0 -1.0 0.0) 1.0 '(0.0 1.0 0.0))))
    (check-equal? (shoot p '(3.0 0.0 0.0) '(-1.0 0.0 0.0)) 2.5)
    (define s (surface-at p))
    (check-= (Surface-u s) 0.5 1e-15)
    (check-= (Surface-v s) 0.5 1e-15)
    (check-= (car (Surface-normal s)) (/ 2 (sqrt 5)) 1e-15)
    (check-= (cadr (Surface-normal s)) (/ 1 (sqrt 5)) 1e-15)
    (check-equal? (shoot p '(0.0 -0.5 0.0) '(0.0 0.0 1.0)) 0.75)
    (check-= (Surface-u (surface-at p)) 0.25 1e-15)
    (check-equal? (shoot p '(0.5 -3.0 0.0) '(0.0 1.0 0.0)) 2.0)
    (check-equal? (map (lambda (x) (+ 0.0 x)) (Surface-normal (surface-at p))) '(0.0 -1.0 0.0))
    (check-= (Surface-v (surface-at p)) 0.5 1e-15)
    (check-equal? (shoot p '(0.5 3.0 0.0) '(0.0 -1.0 0.0)) 3.0)
    (check-equal? (shoot p '(0.25 0.0 0.0) '(0.0 -1.0 0.0)) 1.0)
    (check-false (shoot p '(3.0 1.5 0.0) '(-1.0 0.0 0.0)))
    (check-false (shoot p '(3.0 -1.5 0.0) '(-1.0 0.0 0.0)))
    (check-false (shoot p '(1.5 3.0 0.0) '(0.0 -1.0 0.0)))
    ;; along the axis through the tip: the normal there is the axis
    (check-equal? (shoot p '(0.0 3.0 0.0) '(0.0 -1.0 0.0)) 2.0)
    (check-equal? (map (lambda (x) (+ 0.0 x)) (Surface-normal (surface-at p))) '(0.0 1.0 0.0))
    ;; parallel to a line of the side, where the quadratic is linear
    (check-equal? (shoot p '(-2.0 2.0 0.0) '(1.0 -2.0 0.0)) 1.25)
    (check-equal? (shoot p '(0.75 2.0 0.0) '(-0.5 -1.0 0.0)) 1.25)
    (check-false (shoot p '(0.25 2.0 0.0) '(-0.5 -1.0 0.0))))

  (test-case "an open cone is seen from both sides"
    (define p (probe (cone '(0.0 -1.0 0.0) 1.0 '(0.0 1.0 0.0) #f)))
    (check-equal? (shoot p '(3.0 0.0 0.0) '(-1.0 0.0 0.0)) 2.5)
    (check-equal? (shoot p '(0.0 0.0 0.0) '(-1.0 0.0 0.0)) 0.5)
    (check-equal? (shoot p '(0.5 -3.0 0.0) '(0.0 1.0 0.0)) 3.0)
    (check-true (> (car (Surface-normal (surface-at p))) 0.0))
    (check-false (shoot p '(0.5 0.5 0.0) '(0.0 1.0 0.0)))
    (check-false (shoot p '(0.25 0.0 0.0) '(0.0 -1.0 0.0))))

  (test-case "constructor errors name the argument"
    (check-exn #rx"^Cone: .*radius" (lambda () (cone '(0.0 0.0 0.0) -1.0 '(0.0 1.0 0.0))))
    (check-exn #rx"^Cone: .*apex" (lambda () (cone '(1.0 0.0 0.0) 1.0 '(1.0 0.0 0.0))))
    (check-exn #rx"^Cone: .*base" (lambda () (cone '(+nan.0 0.0 0.0) 1.0 '(1.0 0.0 0.0)))))

  (test-case "random rays against exact arithmetic, from near and from 1e8 radii away"
    (define uniform (make-random 21))
    (for ([distance '(4.0 1e4 1e8)])
      (define-values (worst-scaled worst-ulp missed)
        (for/fold ([worst-scaled 0.0] [worst-ulp 0.0] [missed 0]) ([k (in-range 1000)])
          (define apex (random-unit uniform))
          (define base (subtract '(0.0 0.0 0.0) apex))
          (define p (probe (cone base 0.75 apex)))
          (define o (scale distance (random-unit uniform)))
          (define d (subtract (random-in-ball uniform) o))
          (define t (shoot p o d))
          (define expected
            (exact-nearest (exact base) (inexact->exact 0.75) (exact apex) (exact o) (exact d)))
          (cond
            [(and t expected)
             (define cosine (/ (abs (dot (Surface-normal (surface-at p)) d)) (norm d)))
             (values (max worst-scaled (* cosine (flulp-error t expected)))
                     (if (> cosine 0.5) (max worst-ulp (flulp-error t expected)) worst-ulp)
                     missed)]
            [(or t expected) (values worst-scaled worst-ulp (+ missed 1))]
            [else (values worst-scaled worst-ulp missed)])))
      (printf "cone from ~a: ~a ulp times cosine, ~a ulp where the cosine is over 1/2\n"
              distance worst-scaled worst-ulp)
      (check-true (<= worst-scaled 6.0))
      (check-true (<= missed 1))))

  (test-case "computed points are within surface-error of the surface"
    (define uniform (make-random 22))
    (define worst
      (for*/fold ([worst 0.0]) ([size '(1e-9 1.0 1e9)] [offset '(0.0 1.0 1e8)]
                                [stretch '(0.01 1.0 1000.0)] [k (in-range 20)])
        (define base (scale (* size offset) (random-unit uniform)))
        (define apex (add base (scale (* stretch size) (random-unit uniform))))
        (define p (probe (cone base size apex)))
        (define middle (scale 0.5 (add base apex)))
        (define o (add middle (scale (* size 10.0 (+ 1.0 stretch)) (random-unit uniform))))
        (define d (subtract (add middle (scale (* 0.5 size) (random-in-ball uniform))) o))
        (cond
          [(shoot p o d)
           (define s (surface-at p))
           (check-= (norm (Surface-normal s)) 1.0 1e-15)
           (max worst
                (real->double-flonum
                 (/ (surface-distance (exact base) (inexact->exact size) (exact apex)
                                      (exact (Surface-point s)))
                    (Surface-error s))))]
          [else worst])))
    (printf "cone: points within ~a of surface-error\n" worst)
    (check-true (<= worst 1.0)))

  (test-case "spawned rays" (check-spawned-rays make #:convex? #t #:seed 23 #:count count))
  (test-case "bounds hold all hits" (check-hits-in-bounds make #:seed 24 #:count 4000))
  (test-case "any axis" (check-axes-agree make #:seed 25 #:count 1000))
  (test-case "powers of two" (check-power-of-two-scaling make #:seed 26 #:count 300))
  (test-case "crossings" (check-crossings-alternate make #:seed 27 #:count 1000)))
