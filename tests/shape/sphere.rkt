#lang racket/base
;; Spheres: known hits, roots and points against exact arithmetic, rays that leave the surface.

(module+ test
  (require racket/flonum racket/match racket/math rackunit "../../main.rkt" "../statistics.rkt"
           "../base/roots.rkt" "sphere-rays.rkt")

  (define uniform (seeded 1))
  (define (nums v) (list (Float3-x v) (Float3-y v) (Float3-z v)))
  (define (exact v) (map inexact->exact (nums v)))
  (define (dot a b) (apply + (map * a b)))
  (define (scaled v s) (Float3-scale-by-scalar v s))
  (define (random-unit)
    (define v (Float3 (uniform -1.0 1.0) (uniform -1.0 1.0) (uniform -1.0 1.0)))
    (if (< 0.1 (Float3-length v) 1.0) (Float3-normalized v) (random-unit)))
  (define (ulp x) (- (floating-point-next (abs x)) (abs x)))
  (define (floating-point-next x)
    (floating-point-bytes->real (integer->integer-bytes
                                 (+ 1 (integer-bytes->integer (real->floating-point-bytes x 8) #f))
                                 8 #f)))

  ;; The roots of the ray as it is, to 200 bits.
  (define (exact-roots o d center radius)
    (define-values (eo ed) (values (map - (exact o) (exact center)) (exact d)))
    (define r (inexact->exact radius))
    (exact-quadratic-roots (dot ed ed) (* 2 (dot eo ed)) (- (dot eo eo) (* r r))))

  (define (hit center radius o d) (Sphere-intersect (Sphere center radius) (Ray o d)))
  (define origin (Float3 0 0 0))

  (test-case "H02: from inside, t and the outward normal to 1e-15"
    (define found (hit origin 1 origin (Float3 1 1 1)))
    (for ([x (cons (Intersection-t found) (nums (Intersection-normal found)))])
      (check-= x 0.5773502691896257 1e-15)))

  (test-case "H03: a small sphere 1e8 away, to one ulp; H04: a huge near one, to 1e-12"
    (check-= (Intersection-t (hit origin 1 (Float3 0.6 0 -1e8) (Float3 0 0 1))) 99999999.2 1.5e-8)
    (check-= (Intersection-t (hit (Float3 0 -1e8 0) 1e8 (Float3 0 1 0) (Float3 0.6 -0.8 0)))
             1.2500000035156251 1.25e-12))

  (test-case "before, inside, behind, beside, touching"
    (define (t o d) (Intersection-t (hit (Float3 0 0 0) 1 o d)))
    (check-equal? (t (Float3 0 0 3) (Float3 0 0 -1)) 2.0)
    (check-equal? (t (Float3 0 0 3) (Float3 0 0 -2)) 1.0)
    (check-equal? (t (Float3 0 0 0) (Float3 0 0 -1)) 1.0)
    (check-equal? (t (Float3 0 0 3) (Float3 0 0 1)) INTERSECTION-T-MAX)
    (check-equal? (t (Float3 0 2 3) (Float3 0 0 -1)) INTERSECTION-T-MAX)
    (check-= (t (Float3 0 1 3) (Float3 0 0 -1)) 3.0 1e-15)
    (check-equal? (t (Float3 0 0 1) (Float3 0 0 -1)) 2.0)
    (check-equal? (t (Float3 0 0 1) (Float3 0 0 1)) INTERSECTION-T-MAX))

  (test-case "S01: t to 4 ulp and no miss for distances of 1e1 to 1e8 radii, 10^3 rays a decade"
    (define worst
      (for*/fold ([worst 0.0]) ([decade (in-range 1 8)] [k (stressed 1000 10000)])
        (define distance (expt 10.0 (uniform decade (+ decade 1.0))))
        (define d (random-unit))
        (define aside (Float3-normalized (Float3-cross d (random-unit))))
        (define o (Float3-add (scaled d (- distance)) (scaled aside (* 0.99 (sqrt (uniform))))))
        (define t (Intersection-t (hit origin 1 o d)))
        (define right (car (exact-roots o d origin 1.0)))
        (max worst (exact->inexact (/ (abs (- (inexact->exact t) right)) (inexact->exact (ulp t)))))))
    (check-true (<= worst 4.0) (format "~a ulp" worst)))

  ;; Nearer to the horizon than this, t itself depends on the ray's last bits.
  (define (steep? d) (<= (Float3-y d) -0.1))
  (test-case "S02: from one unit above spheres of 1e3 to 1e10, t to 5e-14; who misses, misses"
    (for ([decade (in-range 3 11)])
      (define radius (expt 10.0 decade))
      (define-values (center o) (values (Float3 0 (- radius) 0) (Float3 0 1 0)))
      (define-values (worst hits)
        (for/fold ([worst 0.0] [hits 0]) ([k (stressed 1000 10000)])
          (define d (random-unit))
          (match (exact-roots o d center radius)
            [(list near far)
             #:when (positive? near)
             (define t (inexact->exact (Intersection-t (hit center radius o d))))
             (if (steep? d)
                 (values (max worst (exact->inexact (/ (abs (- t near)) near))) (+ hits 1))
                 (values worst hits))]
            [_ (check-equal? (Intersection-t (hit center radius o d)) INTERSECTION-T-MAX)
               (values worst hits)])))
      (check-true (> hits 300))
      (check-true (<= worst 5e-14) (format "radius ~a: ~a" radius worst))))

  (test-case "S03: hit points lie on the sphere: to 2.3e-16 at the origin, 2 ulp of the coordinates"
    (for ([offset '(0.0 1e3 1e6 1e8)])
      (define center (Float3 offset (- offset) (* 0.5 offset)))
      (define allowed (if (= offset 0.0) 2.3e-16 (* 2.0 (ulp offset))))
      (define worst
        (for/fold ([worst 0.0]) ([k (stressed 1000 10000)])
          (define d (random-unit))
          (define aside (Float3-normalized (Float3-cross d (random-unit))))
          (define o (Float3-add center (Float3-add (scaled d -5.0) (scaled aside (uniform 0.0 0.9)))))
          (define p (map - (exact (Intersection-point (hit center 1 o d))) (exact center)))
          (max worst (exact->inexact (abs (- (exact-square-root (dot p p)) 1))))))
      (check-true (<= worst allowed) (format "offset ~a: ~a" offset worst))))

  (test-case "S04: no ray that leaves a hit meets its sphere again from outside; from inside, only
the far side; and none slips through a second sphere 10^3 ulp away. 10^5 rays, scales 1e-9 to 1e9"
    (for* ([scale '(1e-9 1e-3 1.0 1e3 1e9)] [offset '(0.0 1e3 1e6 1e8)])
      (define center (Float3 (* scale offset) (* -0.3 scale offset) (* 0.7 scale offset)))
      (define radius scale)
      (define gap (* 1000.0 (ulp (+ radius (* scale offset)))))
      (define one (World (list (Sphere center radius))))
      (define two (World (list (Sphere center radius) (Sphere center (+ radius gap)))))
      (for ([k (stressed 100 1000)])
        (define d (random-unit))
        (define aside (scaled (Float3-cross d (random-unit)) (* 0.9 scale)))
        (define outside (Float3-add center (Float3-add (scaled d (* -5.0 scale)) aside)))
        (match-define (list none own _ _) (spawned-hits one one outside d 50))
        (check-equal? own 0 (format "self-hits, scale ~a offset ~a" scale offset))
        (check-equal? none 50)
        (match-define (list leaked _ second _) (spawned-hits one two outside d 50))
        (check-equal? (list leaked second) '(0 50) (format "leaks, scale ~a offset ~a" scale offset))
        ;; towards the inside a chord is 2 r cos: of 50 cosine-distributed ones the shortest of
        ;; those not within 1e-3 of the tangent plane is longer than a thousandth of the radius
        (define within (Float3-add center (scaled (random-unit) (* 0.5 scale))))
        (match-define (list none-inside own-inside _ shortest) (spawned-hits one one within d 50))
        (check-equal? (list none-inside own-inside) '(0 50))
        (check-true (> shortest (* 1e-3 scale)) (format "a chord of ~a" (/ shortest scale))))))

  (test-case "bounding: every hit lies in the box; the colour is the material's"
    (define s (Sphere (Float3 1 2 3) 2 (Float3 0.1 0.2 0.3)))
    (check-equal? (Sphere-color s) (Float3 0.1 0.2 0.3))
    (for ([k 500])
      (define d (random-unit))
      (define found (Sphere-intersect s (Ray (Float3-add (Float3 1 2 3) (scaled d -9.0)) d)))
      (check-equal? (Intersection-color found) (Float3 0.1 0.2 0.3))
      (check-= (Intersection-t found) 7.0 1e-14)
      (check-= (Float3-distance (Intersection-normal found) (Float3-negate d)) 0.0 1e-14)
      (for ([p (nums (Intersection-point found))] [c '(1 2 3)])
        (check-true (<= (- c 2.0 1e-15) p (+ c 2.0 1e-15)))))))
