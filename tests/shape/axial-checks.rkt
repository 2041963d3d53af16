#lang racket/base
;; What the tests of cylinder, cone and torus share: vectors, random rays, and the checks that hold
;; for any closed shape around an axis.

(provide stress? make-random random-unit random-in-ball random-hit cosine-direction
         random-rotation rotate
         add subtract scale dot cross norm exact
         check-spawned-rays check-hits-in-bounds check-axes-agree check-power-of-two-scaling
         check-crossings-alternate)

(require rackunit racket/math "probe.rkt")

(define stress? (and (getenv "RAYTRACE_STRESS") #t))

;; --- vectors: lists of three numbers, flonums or exact ---

(define (add a b) (map + a b))
(define (subtract a b) (map - a b))
(define (scale s a) (map (lambda (x) (* s x)) a))
(define (dot a b) (apply + (map * a b)))
(define (cross a b)
  (define-values (ax ay az bx by bz) (apply values (append a b)))
  (list (- (* ay bz) (* az by)) (- (* az bx) (* ax bz)) (- (* ax by) (* ay bx))))
(define (norm a) (sqrt (dot a a)))
(define (exact a) (map inexact->exact a))

;; --- random numbers ---

;; A function from (low high) to a uniform number between them.
(define (make-random seed)
  (define generator (vector->pseudo-random-generator (vector seed 2 3 4 5 6)))
  (lambda ([low 0.0] [high 1.0]) (+ low (* (- high low) (random generator)))))

(define (random-unit uniform)
  (define z (uniform -1.0 1.0))
  (define angle (uniform 0.0 (* 2.0 pi)))
  (define radius (sqrt (- 1.0 (* z z))))
  (list (* radius (cos angle)) (* radius (sin angle)) z))

(define (random-in-ball uniform)
  (define p (list (uniform -1.0 1.0) (uniform -1.0 1.0) (uniform -1.0 1.0)))
  (if (< (dot p p) 1.0) p (random-in-ball uniform)))

;; A unit direction around a unit normal with density cos / pi.
(define (cosine-direction uniform normal)
  (define v (add normal (random-unit uniform)))
  (if (> (norm v) 1e-3) (scale (/ 1.0 (norm v)) v) (cosine-direction uniform normal)))

;; Three orthonormal rows, right-handed.
(define (random-rotation uniform)
  (define x (random-unit uniform))
  (define side (cross x (random-unit uniform)))
  (define y (scale (/ 1.0 (norm side)) side))
  (list x y (cross x y)))

(define (rotate rows v) (for/list ([row (in-list rows)]) (dot row v)))

;; --- checks; `make` is a function from a size, a centre and a unit axis to a shape that lies in a
;; ball of twice the size around the centre ---

(define sizes '(1e-9 1e-3 1.0 1e3 1e9))
(define offsets '(0.0 1.0 1e4 1e8))

;; A hit of a random ray from outside: its t, origin and direction; #f for a miss.
(define (random-hit uniform p size center)
  (define o (add center (scale (* 4.0 size) (random-unit uniform))))
  (define target (add center (scale size (random-in-ball uniform))))
  (define d (scale (/ (uniform 0.5 2.0) size) (subtract target o)))
  (define t (shoot p o d))
  (and t (list t o d)))

;; S04: rays spawned from a hit's point, moved out along the normal by its error bound, do not hit
;; the shape before `clear` error bounds, at every size and offset (a multiple of the size), nor at
;; all if the shape is convex; moved in, they hit the shape they are inside of.
(define (check-spawned-rays make #:convex? convex? #:seed seed #:count count)
  (define uniform (make-random seed))
  (define-values (spawned self-hits escapes)
    (for*/fold ([spawned 0] [self-hits 0] [escapes 0])
               ([size (in-list sizes)]
                [offset (in-list offsets)]
                [shape (in-range (quotient (quotient count 20) 10))])
      (define center (scale (* size offset) (random-unit uniform)))
      (define p (probe (make size center (random-unit uniform))))
      (for/fold ([spawned spawned] [self-hits self-hits] [escapes escapes]) ([k (in-range 10)])
        (cond
          [(random-hit uniform p size center)
           (define s (surface-at p))
           (define normal (Surface-normal s))
           (define err (Surface-error s))
           (define (moved distance) (add (Surface-point s) (scale distance normal)))
           (define out (shoot p (moved err) (cosine-direction uniform normal)))
           (define in
             (shoot p (moved (- err)) (scale -1.0 (cosine-direction uniform normal))))
           (values (+ spawned 1)
                   (if (and out (or convex? (< out (* 8.0 err)))) (+ self-hits 1) self-hits)
                   (if in escapes (+ escapes 1)))]
          [else (values spawned self-hits escapes)]))))
  (printf "S04: ~a hits, ~a self-hits, ~a escapes from inside\n" spawned self-hits escapes)
  (check-true (> spawned (* 0.2 count)))
  (check-equal? self-hits 0)
  (check-equal? escapes 0))

;; Every computed surface point is in the box widened by 8 roundings, as worlds widen it, and the
;; box is not loose: on each side some point comes within 3% of the box's edge.
(define (check-hits-in-bounds make #:seed seed #:count count)
  (define uniform (make-random seed))
  (for ([size (in-list '(1e-9 1.0 1e9))])
    (define center (scale (* 10.0 size) (random-unit uniform)))
    (define p (probe (make size center (random-unit uniform))))
    (define box (bounds p))
    (define extent (subtract (cadr box) (car box)))
    (define points
      (for*/list ([k (in-range count)] [hit (in-value (random-hit uniform p size center))]
                  #:when hit)
        (Surface-point (surface-at p))))
    (for ([axis (in-range 3)])
      (define (component v) (list-ref v axis))
      (define low (component (car box)))
      (define high (component (cadr box)))
      (define pad (* 8 (expt 2.0 -53) (max (abs low) (abs high))))
      (define coordinates (map component points))
      (define-values (least greatest) (values (apply min coordinates) (apply max coordinates)))
      (check-true (<= (- low pad) least))
      (check-true (>= (+ high pad) greatest))
      (check-true (< (- least low) (* 0.03 (component extent))))
      (check-true (< (- high greatest) (* 0.03 (component extent)))))))

;; The shape along a random axis gives what the shape along z gives for the rotated ray: parameters
;; within 200 roundings of the scene's size over the cosine at the surface, and no more than a few
;; of the rays, that graze an edge, hit in one and miss in the other.
(define (check-axes-agree make #:seed seed #:count count)
  (define uniform (make-random seed))
  (define upright (probe (make 1.0 '(0.0 0.0 0.0) '(0.0 0.0 1.0))))
  (define-values (worst differing)
    (for/fold ([worst 0.0] [differing 0]) ([k (in-range count)])
      (define rows (random-rotation uniform))
      (define turned (probe (make 1.0 '(0.0 0.0 0.0) (map caddr rows))))
      (define o (scale 4.0 (random-unit uniform)))
      (define target (random-in-ball uniform))
      (define d (scale (/ 1.0 (norm (subtract target o))) (subtract target o)))
      (define t (shoot upright o d))
      (define normal (and t (Surface-normal (surface-at upright))))
      (define t* (shoot turned (rotate rows o) (rotate rows d)))
      (cond
        [(and t t*) (values (max worst (* (abs (- t t*)) (abs (dot normal d)))) differing)]
        [(or t t*) (values worst (+ differing 1))]
        [else (values worst differing)])))
  (printf "axes: worst difference ~a roundings\n" (/ worst (expt 2.0 -53)))
  (check-true (< worst (* 200 (expt 2.0 -53))))
  (check-true (<= differing 2)))

;; A shape and rays 2^k times as large give the same parameters, bit for bit.
(define (check-power-of-two-scaling make #:seed seed #:count count)
  (define uniform (make-random seed))
  (for ([k (in-range count)])
    (define axis (random-unit uniform))
    (define center (random-unit uniform))
    (define o (add center (scale 4.0 (random-unit uniform))))
    (define d (subtract (add center (random-in-ball uniform)) o))
    (define t (shoot (probe (make 1.0 center axis)) o d))
    (for ([factor (in-list (list (expt 2.0 -31) (expt 2.0 40)))])
      (check-equal? (shoot (probe (make factor (scale factor center) axis))
                           (scale factor o) (scale factor d))
                    t))))

;; Following a line through the shape from hit to hit, each ray spawned on the far side of the
;; surface just met, the crossings go in and out in turn and their number is even.
(define (check-crossings-alternate make #:seed seed #:count count)
  (define uniform (make-random seed))
  (define odd
    (for/sum ([k (in-range count)])
      (define p (probe (make 1.0 '(0.0 0.0 0.0) (random-unit uniform))))
      (define d (random-unit uniform))
      (define start (subtract (random-in-ball uniform) (scale 4.0 d)))
      (let follow ([o start] [crossed 0])
        (cond
          [(> crossed 5) 1]
          [(shoot p o d)
           (define s (surface-at p))
           (define entering? (< (dot (Surface-normal s) d) 0.0))
           (if (eq? entering? (even? crossed))
               (follow (add (Surface-point s)
                            (scale (* (if entering? -1.0 1.0) (Surface-error s))
                                   (Surface-normal s)))
                       (+ crossed 1))
               1)]
          [else (if (even? crossed) 0 1)]))))
  (check-equal? odd 0))
