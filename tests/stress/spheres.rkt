#lang racket/base
;; S01 to S04: rays and spheres far, huge and off the origin, and rays that leave any shape.

(provide cases)

(require racket/match "case.rkt" "../../main.rkt" "../base/roots.rkt" "../shape/sphere-rays.rkt"
         (only-in "../shape/mesh-examples.rkt" icosphere))

;; A point of the ray's line across the direction d, up to `reach` away.
(define (aside uniform d reach)
  (scale (* reach (sqrt (uniform))) (unit (cross d (random-unit uniform)))))

(define (hit center radius o d)
  (Sphere-intersect (Sphere (point center) radius) (Ray (point o) (point d))))

;; The roots of the ray as it is, to 200 bits.
(define (exact-roots o d center radius)
  (define-values (eo ed) (values (subtract (exact o) (exact center)) (exact d)))
  (define r (inexact->exact radius))
  (exact-quadratic-roots (dot ed ed) (* 2 (dot eo ed)) (- (dot eo eo) (* r r))))

(define origin '(0.0 0.0 0.0))

;; --- S01 ---

(define (far-small size)
  (define uniform (seeded 1))
  (define count (amount 10000 size 300))
  (define-values (worst misses)
    (for*/fold ([worst 0.0] [misses 0]) ([decade (in-range 1 8)] [k (in-range count)])
      (define distance (expt 10.0 (uniform decade (+ decade 1.0))))
      (define d (random-unit uniform))
      (define o (add (scale (- distance) d) (aside uniform d 0.99)))
      (define t (Intersection-t (hit origin 1.0 o d)))
      (if (= t INTERSECTION-T-MAX)
          (values worst (+ misses 1))
          (values (max worst (ulps t (car (exact-roots o d origin 1.0)))) misses))))
  (values (format "~a ulp, ~a false misses of ~a rays" (rounded worst) misses (* 7 count))
          (and (<= worst 4.0) (= misses 0))))

;; --- S02 ---

(define (huge-near size)
  (define uniform (seeded 2))
  (define count (amount 10000 size 300))
  (define-values (worst wrong rays)
    (for*/fold ([worst 0.0] [wrong 0] [rays 0])
               ([decade (in-range 3 11)] [k (in-range count)])
      (define radius (expt 10.0 decade))
      (define-values (center o) (values (list 0.0 (- radius) 0.0) '(0.0 1.0 0.0)))
      (define d (random-unit uniform))
      (define t (Intersection-t (hit center radius o d)))
      (match (exact-roots o d center radius)
        [(list near far)
         #:when (positive? near)
         (if (= t INTERSECTION-T-MAX)
             (values worst (+ wrong 1) (+ rays 1))
             (values (max worst (exact->inexact (/ (abs (- (inexact->exact t) near)) near)))
                     wrong (+ rays 1)))]
        [_ (values worst (if (= t INTERSECTION-T-MAX) wrong (+ wrong 1)) rays)])))
  (values (format "relative ~a of ~a hits, ~a hit wrongly or not at all" (rounded worst) rays wrong)
          (and (<= worst 5e-14) (= wrong 0))))

;; --- S03 ---

;; The distance from the surface over what is allowed: 2 ulp of the largest coordinate, 2.3e-16 at
;; offset 0.
(define (residual size)
  (define uniform (seeded 3))
  (define parts
    (for/list ([offset (in-list '(0.0 1e3 1e6 1e8))])
      (define center (list offset (- offset) (* 0.5 offset)))
      (for/fold ([worst 0.0]) ([k (in-range (amount 10000 size 300))])
        (define d (random-unit uniform))
        (define o (add center (add (scale -5.0 d) (aside uniform d 0.9))))
        (define p (numbers (Intersection-point (hit center 1.0 o d))))
        (define from-center (subtract (exact p) (exact center)))
        (define off (abs (- (exact-square-root (dot from-center from-center)) 1)))
        (define unit-of (if (= offset 0.0) 1.0 (spacing (apply max (map abs p)))))
        (max worst (exact->inexact (/ off (inexact->exact unit-of)))))))
  (values (format "~a at offset 0; ~a ulp(coordinate) at 1e3, 1e6, 1e8" (rounded (car parts))
                  (map rounded (cdr parts)))
          (and (<= (car parts) 2.3e-16) (andmap (lambda (x) (<= x 2.0)) (cdr parts)))))

;; --- S04 ---

;; A shape of that size around the center in a random orientation, and a list of what lies `gap`
;; outside of it: an enclosing shape, or a parallel one on each side of a flat one.
(define (body kind size center uniform gap)
  (match-define (list x y z) (random-rotation uniform))
  (define (at a b c) (add center (add (scale a x) (add (scale b y) (scale c z)))))
  (define wide (+ size gap))
  (define (both make)
    (list (make 0.0 size) (list (make gap (* 2.0 size)) (make (- gap) (* 2.0 size)))))
  (define (box grow)
    (Box (point (subtract center (for/list ([c '(0.7 0.4 0.9)]) (+ (* c size) grow))))
         (point (add center (for/list ([c '(0.6 0.8 0.5)]) (+ (* c size) grow))))))
  (define (cylinder grow)
    (define half (+ (* 0.7 size) grow))
    (Cylinder (point (at 0.0 0.0 (- half))) (point (at 0.0 0.0 half)) (+ (* 0.6 size) grow)))
  ;; an apex moved by five gaps and a base by one leave more than one gap between the walls
  (define (cone grow)
    (Cone (point (at 0.0 0.0 (- (* -0.6 size) grow))) (+ (* 0.6 size) (* 5.0 grow))
          (point (at 0.0 0.0 (+ size (* 5.0 grow))))))
  (define (torus grow) (Torus (point center) (point z) (* 0.7 size) (+ (* 0.3 size) grow)))
  (case kind
    [(sphere) (list (Sphere (point center) size) (list (Sphere (point center) wide)))]
    [(box) (list (box 0.0) (list (box gap)))]
    [(cylinder) (list (cylinder 0.0) (list (cylinder gap)))]
    [(cone) (list (cone 0.0) (list (cone gap)))]
    [(torus) (list (torus 0.0) (list (torus gap)))]
    [(mesh)
     (list (icosphere 1 #:offset center #:scale size)
           (list (icosphere 1 #:offset center #:scale (+ wide gap))))]
    [(plane) (both (lambda (up s) (Plane (point (at 0.0 0.0 up)) (point z))))]
    [(disk) (both (lambda (up s) (Disk (point (at 0.0 0.0 up)) (point z) s)))]
    [(quad) (both (lambda (up s) (Quad (point (at (- s) (- s) up)) (point (scale (* 2.0 s) x))
                                       (point (scale (* 2.0 s) y)))))]
    [(triangle) (both (lambda (up s) (Triangle (point (at (- s) (- s) up)) (point (at s (- s) up))
                                               (point (at 0.0 s up)))))]))

;; Rays of one kind of shape: how many left a hit, met the same shape again although it is convex,
;; or did not meet the second surface first. A hit of a plane far away, where an ulp is more than
;; the gap, does not count.
(define (spawned kind size seed)
  (define uniform (seeded seed))
  (define hits (amount 1000 size 4)) ; of 50 rays each for 5 scales and 4 offsets
  (define bodies (min hits 10))
  (for*/fold ([rays 0] [again 0] [leaked 0])
             ([s (in-list '(1e-9 1e-3 1.0 1e3 1e9))] [offset (in-list '(0.0 1e3 1e6 1e8))]
              [_ (in-range bodies)])
    (define center (list (* s offset) (* -0.3 s offset) (* 0.7 s offset)))
    (define gap (* 1000.0 (spacing (+ s (* s offset)))))
    (match-define (list shape others) (body kind s center uniform gap))
    (define-values (one two) (values (World (list shape)) (World (cons shape others))))
    (for/fold ([rays rays] [again again] [leaked leaked]) ([k (in-range (quotient hits bodies))])
      (define o (add center (scale (* 5.0 s) (random-unit uniform))))
      (define d (subtract (add center (scale (* 0.3 s) (random-unit uniform))) o))
      (define first-hit (World-nearest-hit one (Ray (point o) (point d))))
      (define near?
        (< (norm (subtract (numbers (Intersection-point first-hit)) center)) (* 10.0 s)))
      (define alone (spawned-hits one one (point o) (point d) 50))
      (define enclosed (spawned-hits one two (point o) (point d) 50))
      (if (and alone near?)
          (values (+ rays 50)
                  (if (eq? kind 'torus) again (+ again (cadr alone)))
                  (+ leaked (car enclosed) (cadr enclosed)))
          (values rays again leaked)))))

(define (self-intersection size)
  (define-values (rays again leaked)
    (for/fold ([rays 0] [again '()] [leaked '()])
              ([kind (in-list '(sphere box cylinder cone plane disk quad triangle mesh torus))]
               [seed (in-naturals 40)])
      (define-values (n a l) (spawned kind size seed))
      (values (+ rays n)
              (if (> a 0) (cons (cons kind a) again) again)
              (if (> l 0) (cons (cons kind l) leaked) leaked))))
  (values (format "self-hits ~a, leaks ~a, of ~a rays from 10 kinds of shapes"
                  (if (null? again) 0 again) (if (null? leaked) 0 leaked) rays)
          (and (null? again) (null? leaked) (> rays (* 0.8 200 50 (amount 1000 size 4))))))

(define cases
  (list (stress-case "S01 ray and sphere, far and small" "4 ulp, 0 false misses" far-small)
        (stress-case "S02 ray and sphere, huge and near" "relative 5e-14" huge-near)
        (stress-case "S03 hit point residual" "2.3e-16 at offset 0, 2 ulp(coordinate) elsewhere"
                     residual)
        (stress-case "S04 self-intersection" "0 self-hits, 0 leaks" self-intersection)))
