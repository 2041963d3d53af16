#lang racket/base
;; Cylinders: hits against exact arithmetic, self-intersection, bounds, axes, caps and open tubes.
(module+ test
  (require rackunit math/flonum "probe.rkt" "axial-checks.rkt" "../base/roots.rkt")

  ;; of height 2 and radius 0.75, times the size
  (define (make size center axis)
    (cylinder (subtract center (scale size axis)) (add center (scale size axis)) (* 0.75 size)))

  (define count (if stress? 1000000 10000))

  ;; The nearest t of a closed cylinder in exact arithmetic, or #f. All arguments exact.
  (define (exact-nearest base top radius o d)
    (define axis (subtract top base))
    (define along (dot axis axis))
    (define from-base (subtract o base))
    (define (across v) (subtract v (scale (/ (dot v axis) along) axis)))
    (define-values (oa da) (values (across from-base) (across d)))
    (define sides
      (exact-quadratic-roots (dot da da) (* 2 (dot oa da)) (- (dot oa oa) (* radius radius))))
    (define ends
      (sort (list (/ (- (dot from-base axis)) (dot d axis))
                  (/ (- along (dot from-base axis)) (dot d axis)))
            <))
    (and (pair? sides)
         (let ([near (max (car sides) (car ends))] [far (min (cadr sides) (cadr ends))])
           (and (<= near far)
                (if (positive? near) near (and (positive? far) far))))))

  ;; The distance of a point from the surface of an infinite cylinder and the two planes, exactly
  ;; enough: the least of the three.
  (define (surface-distance base top radius point)
    (define axis (subtract top base))
    (define length (exact-square-root (dot axis axis)))
    (define from-base (subtract point base))
    (define z (/ (dot from-base axis) length))
    (define across (exact-square-root (- (dot from-base from-base) (* z z))))
    (min (abs (- across radius)) (abs z) (abs (- z length))))

  (test-case "hits of an upright cylinder, exactly"
    (define p (probe (cylinder '(0.0 -1.0 0.0) '(0.0 1.0 0.0) 1.0)))
    (define (check-hit o d t normal u v)
      (check-equal? (shoot p o d) t)
      (define s (surface-at p))
      (check-equal? (map (lambda (x) (+ 0.0 x)) (Surface-normal s)) normal)
      (check-equal? (Surface-point s) (add o (scale t d)))
      (check-= (Surface-u s) u 1e-15)
      (check-= (Surface-v s) v 1e-15))
    (check-hit '(3.0 0.0 0.0) '(-1.0 0.0 0.0) 2.0 '(1.0 0.0 0.0) 0.5 0.5)
    (check-hit '(3.0 0.5 0.0) '(-0.5 0.0 0.0) 4.0 '(1.0 0.0 0.0) 0.5 0.75)
    (check-hit '(0.0 0.0 0.0) '(0.0 0.0 1.0) 1.0 '(0.0 0.0 1.0) 0.25 0.5)
    (check-hit '(0.5 3.0 0.0) '(0.0 -1.0 0.0) 2.0 '(0.0 1.0 0.0) 0.5 0.5)
    (check-hit '(0.5 -3.0 0.0) '(0.0 1.0 0.0) 2.0 '(0.0 -1.0 0.0) 0.5 0.5)
    (check-hit '(0.25 0.0 0.0) '(0.0 1.0 0.0) 1.0 '(0.0 1.0 0.0) 0.5 0.25)
    (check-false (shoot p '(3.0 0.0 0.0) '(1.0 0.0 0.0)))
    (check-false (shoot p '(3.0 0.0 1.5) '(-1.0 0.0 0.0)))
    (check-false (shoot p '(3.0 2.0 0.0) '(-1.0 0.0 0.0)))
    (check-false (shoot p '(1.5 3.0 0.0) '(0.0 -1.0 0.0)))
    (check-false (shoot p '(3.0 0.0 0.0) '(-1.0 0.0 0.0) 2.0))
    (check-true (shoot-occluded p '(3.0 0.0 0.0) '(-1.0 0.0 0.0) 2.5))
    (check-false (shoot-occluded p '(3.0 0.0 0.0) '(-1.0 0.0 0.0) 1.5)))

  (test-case "an open cylinder is a tube seen from both sides"
    (define p (probe (cylinder '(0.0 -1.0 0.0) '(0.0 1.0 0.0) 1.0 #f)))
    (check-equal? (shoot p '(-3.0 0.0 0.0) '(1.0 0.0 0.0)) 2.0)
    (check-equal? (shoot p '(0.0 0.0 0.0) '(1.0 0.0 0.0)) 1.0)
    (check-false (shoot p '(0.5 3.0 0.0) '(0.0 -1.0 0.0)))
    ;; in through one end, out through the side
    (check-equal? (shoot p '(0.0 2.0 0.0) '(0.5 -1.0 0.0)) 2.0)
    (check-equal? (map (lambda (x) (+ 0.0 x)) (Surface-normal (surface-at p))) '(1.0 0.0 0.0))
    ;; in and out through the ends
    (check-false (shoot p '(0.0 2.0 0.0) '(0.25 -1.0 0.0))))

  (test-case "constructor errors name the argument"
    (check-exn #rx"^Cylinder: .*radius" (lambda () (cylinder '(0.0 0.0 0.0) '(0.0 1.0 0.0) 0.0)))
    (check-exn #rx"^Cylinder: .*radius" (lambda () (cylinder '(0.0 0.0 0.0) '(0.0 1.0 0.0) +nan.0)))
    (check-exn #rx"^Cylinder: .*top" (lambda () (cylinder '(1.0 0.0 0.0) '(1.0 0.0 0.0) 1.0)))
    (check-exn #rx"^Cylinder: .*base" (lambda () (cylinder '(+inf.0 0.0 0.0) '(1.0 0.0 0.0) 1.0))))

  ;; relative to the ray's way to the centre, as for spheres, and times the cosine at the surface,
  ;; because a rounding of the direction moves a grazing hit by that much
  (test-case "random rays against exact arithmetic, from near and from 1e8 radii away"
    (define uniform (make-random 11))
    (for ([distance '(4.0 1e4 1e8)])
      (define-values (worst-scaled worst-ulp missed)
        (for/fold ([worst-scaled 0.0] [worst-ulp 0.0] [missed 0]) ([k (in-range 1000)])
          (define axis (random-unit uniform))
          (define base (subtract '(0.0 0.0 0.0) axis))
          (define p (probe (cylinder base axis 0.75)))
          (define o (scale distance (random-unit uniform)))
          (define d (subtract (random-in-ball uniform) o))
          (define t (shoot p o d))
          (define expected
            (exact-nearest (exact base) (exact axis) (inexact->exact 0.75) (exact o) (exact d)))
          (cond
            [(and t expected)
             (define cosine (/ (abs (dot (Surface-normal (surface-at p)) d)) (norm d)))
             (values (max worst-scaled (* cosine (flulp-error t expected)))
                     (if (> cosine 0.5) (max worst-ulp (flulp-error t expected)) worst-ulp)
                     missed)]
            [(or t expected) (values worst-scaled worst-ulp (+ missed 1))]
            [else (values worst-scaled worst-ulp missed)])))
      (printf "cylinder from ~a: ~a ulp times cosine, ~a ulp where the cosine is over 1/2\n"
              distance worst-scaled worst-ulp)
      (check-true (<= worst-scaled 6.0))
      (check-true (<= missed 1))))

  (test-case "computed points are within surface-error of the surface"
    (define uniform (make-random 12))
    (define worst
      (for*/fold ([worst 0.0]) ([size '(1e-9 1.0 1e9)] [offset '(0.0 1.0 1e8)]
                                [stretch '(0.01 1.0 1000.0)] [k (in-range 20)])
        (define base (scale (* size offset) (random-unit uniform)))
        (define top (add base (scale (* stretch size) (random-unit uniform))))
        (define p (probe (cylinder base top size)))
        (define middle (scale 0.5 (add base top)))
        (define o (add middle (scale (* size 10.0 (+ 1.0 stretch)) (random-unit uniform))))
        (define d (subtract (add middle (scale (* 0.5 size) (random-in-ball uniform))) o))
        (cond
          [(shoot p o d)
           (define s (surface-at p))
           (check-= (norm (Surface-normal s)) 1.0 1e-15)
           (max worst
                (real->double-flonum
                 (/ (surface-distance (exact base) (exact top) (inexact->exact size)
                                      (exact (Surface-point s)))
                    (Surface-error s))))]
          [else worst])))
    (printf "cylinder: points within ~a of surface-error\n" worst)
    (check-true (<= worst 1.0)))

  (test-case "spawned rays" (check-spawned-rays make #:convex? #t #:seed 13 #:count count))
  (test-case "bounds hold all hits" (check-hits-in-bounds make #:seed 14 #:count 4000))
  (test-case "any axis" (check-axes-agree make #:seed 15 #:count 1000))
  (test-case "powers of two" (check-power-of-two-scaling make #:seed 16 #:count 300))
  (test-case "crossings" (check-crossings-alternate make #:seed 17 #:count 1000)))
