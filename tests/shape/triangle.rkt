#lang racket/base
;; Triangles: known hits, watertight closed surfaces, degenerate ones, rays that leave the surface.

(module+ test
  (require racket/list racket/math racket/sequence rackunit
           "../../private/shape/triangle.rkt"
           "../../private/integrate/query.rkt" "../../private/world/ray.rkt"
           "probe.rkt" "axial-checks.rkt" "spawned-rays.rkt")

  (define roundoff (expt 2.0 -53))
  (define (stressed count) (if stress? (* 100 count) count))
  (define (triangle a b c) (make-Triangle (float3 a) (float3 b) (float3 c)))
  (define (triangle-probe corners) (probe (apply triangle corners)))
  (define (normal-of corners)
    (define n (apply triangle-normal (map float3 corners)))
    (and n (float3->list n)))
  (define (check-near expected actual tolerance)
    (for ([e expected] [a actual])
      (check-= a e (* tolerance (max 1.0 (abs e))))))

  (test-case "H06: t, weights and normal to 1e-12"
    (define shape (triangle '(0.0 0.0 0.0) '(1.0 0.0 0.0) '(0.0 1.0 0.5)))
    (define found
      (Shape-intersect shape (make-Ray (float3 '(0.25 0.25 2.0)) (float3 '(0.1 -0.05 -1.0)))))
    (check-near '(1.9230769230769231) (list (Intersection-t found)) 1e-12)
    (check-near '(0.0 -0.4472135954999579 0.8944271909999159)
                (float3->list (Intersection-normal found)) 1e-12)
    (define p (probe shape))
    (check-equal? (shoot p '(0.25 0.25 2.0) '(0.1 -0.05 -1.0)) (Intersection-t found))
    (define s (surface-at p))
    (check-near '(0.4423076923076923 0.15384615384615385) (list (Surface-u s) (Surface-v s)) 1e-12))

  (test-case "both faces are hit, the normal stays; behind the origin, beyond the limit nothing is"
    (define p (triangle-probe '((0.0 0.0 0.0) (1.0 0.0 0.0) (0.0 1.0 0.0))))
    (for ([z '(1.0 -1.0)])
      (define o (list 0.25 0.25 z))
      (check-equal? (shoot p o (list 0.0 0.0 (- z))) 1.0)
      (check-equal? (Surface-normal (surface-at p)) '(0.0 0.0 1.0))
      (check-false (shoot p o (list 0.0 0.0 z)))
      (check-false (shoot p o (list 0.0 0.0 (- z)) 0.999))
      (check-false (shoot-occluded p o (list 0.0 0.0 (- z)) 0.999))
      (check-true (shoot-occluded p o (list 0.0 0.0 (- z)) 1.001))))

  ;; In rational arithmetic: t of the plane, and whether the ray passes inside.
  (define (exact-hit origin direction corners)
    (define-values (o d) (values (exact origin) (exact direction)))
    (define-values (a b c) (apply values (map exact corners)))
    (define n (cross (subtract b a) (subtract c a)))
    (define t (/ (dot n (subtract a o)) (dot n d)))
    (define x (add o (scale t d)))
    (define (inside? p q) (positive? (dot n (cross (subtract q p) (subtract x p)))))
    (values t (and (inside? a b) (inside? b c) (inside? c a))))

  (define (area corners)
    (define-values (a b c) (apply values corners))
    (* 0.5 (norm (cross (subtract b a) (subtract c a)))))

  (test-case "t against rational arithmetic: the same hits, t to 16 roundings over cosine and area"
    (define uniform (make-random 1))
    (define (random-corner) (list (uniform -1.0 1.0) (uniform -1.0 1.0) (uniform -1.0 1.0)))
    (define worst
      (for/fold ([worst 0.0]) ([k (stressed 2000)])
        (define corners (list (random-corner) (random-corner) (random-corner)))
        (define p (triangle-probe corners))
        (define origin (scale 4.0 (random-unit uniform)))
        (define direction
          (subtract (add (scale 1/3 (apply map + corners)) (scale 0.4 (random-corner))) origin))
        (define-values (t inside?) (exact-hit origin direction corners))
        (define found (shoot p origin direction))
        (check-equal? (and found #t) inside?)
        (cond
          [found
           (define cosine (/ (abs (dot (Surface-normal (surface-at p)) direction)) (norm direction)))
           (max worst (/ (* (abs (- found t)) cosine (min 1.0 (area corners))) roundoff))]
          [else worst])))
    (printf "triangle: worst error of t ~a roundings times cosine and area\n" worst)
    (check-true (< worst 16.0)))

  ;; --- closed surfaces, as lists of three corners ---

  ;; 80 triangles on the unit sphere.
  (define icosphere
    (let ()
      (define g (/ (+ 1.0 (sqrt 5.0)) 2.0))
      (define corners
        (for*/vector ([turn 3] [s '(-1.0 1.0)] [l (list (- g) g)])
          (unit (case turn [(0) (list s l 0.0)] [(1) (list 0.0 s l)] [else (list l 0.0 s)]))))
      (define (near? p q) (< (norm (subtract p q)) 1.1))
      (define (middle p q) (unit (add p q)))
      (append*
       (for*/list ([(p j) (in-indexed corners)] [(q k) (in-indexed corners)] #:when (< j k)
                   [(s l) (in-indexed corners)] #:when (< k l)
                   #:when (and (near? p q) (near? q s) (near? s p)))
         (define-values (a b c) (values (middle p q) (middle q s) (middle s p)))
         (list (list p a c) (list q b a) (list s c b) (list a b c))))))

  (define (random-tetrahedron uniform)
    (define corners
      (for/list ([p '((1.0 1.0 1.0) (1.0 -1.0 -1.0) (-1.0 1.0 -1.0) (-1.0 -1.0 1.0))])
        (add p (scale 0.3 (random-unit uniform)))))
    (for/list ([skip 4]) (append (take corners skip) (drop corners (+ skip 1)))))

  ;; How many rays from inside, aimed exactly at edges and corners, meet no triangle. Each
  ;; triangle has its corners in an order of its own.
  (define (count-leaks faces rays uniform offset unit?)
    (define moved
      (for/vector ([face faces])
        (define turned (if (< (uniform) 0.5) face (reverse face)))
        (placed (if (< (uniform) 0.5) turned (append (cdr turned) (list (car turned)))) 1.0 offset)))
    (define probes (for/vector ([face moved]) (triangle-probe face)))
    (for/sum ([k rays])
      (define face (exact-floor (uniform 0 (vector-length moved))))
      (define-values (a b c) (apply values (vector-ref moved face)))
      (define origin
        (map (lambda (x) (+ offset x)) (scale (uniform 0.0 0.3) (random-unit uniform))))
      (define target (if (< (uniform) 0.3) a (add a (scale (uniform) (subtract b a)))))
      (define aimed (subtract target origin))
      (define direction (if unit? (unit aimed) aimed))
      (define (hits? p) (shoot-occluded p origin direction 1e300))
      (if (or (hits? (vector-ref probes face)) (for/or ([p probes]) (hits? p))) 0 1)))

  (test-case "S05, S06: 10^5 rays at edges and corners of closed surfaces, 0 leaks"
    (define uniform (make-random 2))
    (check-equal? (length icosphere) 80)
    (for* ([offset '(0.0 1e3 1e6)] [unit? '(#f #t)])
      (for ([k 10])
        (check-equal?
         (count-leaks (random-tetrahedron uniform) (stressed 850) uniform offset unit?) 0))
      (check-equal? (count-leaks icosphere (stressed 8500) uniform offset unit?) 0)))

  ;; --- rays that leave the surface ---

  ;; Rays at the middle of the triangle from all around.
  (define (aimed-at corners uniform size)
    (define-values (a b c) (apply values corners))
    (lambda ()
      (define-values (u v) (values (uniform 0.1 0.4) (uniform 0.1 0.4)))
      (define target (add (scale (- 1.0 u v) a) (add (scale u b) (scale v c))))
      (define direction (random-unit uniform))
      (values (subtract target (scale (* 2.0 size) direction)) direction)))

  (test-case "S04: no ray meets the triangle it leaves, nor passes one 1000 ulp away"
    (define uniform (make-random 3))
    (for* ([size '(1e-9 1.0 1e9)] [offset '(0.0 1.0 1e4 1e8)])
      (define corners
        (placed '((0.3 -0.2 0.1) (1.1 0.4 -0.2) (-0.1 0.9 0.4)) size offset))
      (define normal (normal-of corners))
      (define gap (* 1000.0 2.0 roundoff size (max 1.0 offset)))
      (define (shifted side)
        (triangle-probe (for/list ([p corners]) (add p (scale (* side gap) normal)))))
      (define-values (above below) (values (shifted 1.0) (shifted -1.0)))
      (define total
        (count-spawned (triangle-probe corners) (stressed 700) uniform
                       (aimed-at corners uniform size)
                       #:beyond (lambda (side) (if (> side 0.0) above below))))
      (check-true (> (counts-rays total) 1000))
      (check-equal? (counts-again total) 0 (format "~a ~a" size offset))
      (check-equal? (counts-leaked total) 0 (format "~a ~a" size offset))))

  (test-case "S04: slivers of aspect 10^2 to 10^10 are not met again either"
    (define uniform (make-random 4))
    (for* ([aspect '(1e2 1e4 1e6 1e8 1e10)] [offset '(0.0 1.0)])
      (define corners
        (placed (list '(0.3 -0.2 0.1) '(1.1 0.4 -0.2)
                      (list (+ 0.7 (/ 0.3 aspect)) (+ 0.1 (/ -0.2 aspect)) -0.05))
                1.0 offset))
      (define total
        (count-spawned (triangle-probe corners) (stressed 500) uniform
                       (aimed-at corners uniform 1.0)))
      (check-true (> (counts-rays total) 50) (format "~a ~a" aspect offset))
      (check-equal? (counts-again total) 0 (format "~a ~a" aspect offset))))

  ;; --- degenerate ones ---

  (test-case "S11: triangles without area are never hit"
    (define uniform (make-random 5))
    (define-values (p q) (values '(0.1 0.2 0.3) '(0.7 0.1 0.2)))
    (for ([corners (list (list p p p) (list p p q) (list q p p) (list p q p)
                         (list p (scale 2.0 p) (scale 4.0 p))
                         (list '(0.0 0.0 0.0) (scale -1.0 p) (scale 8.0 p))
                         '((1e8 1.0 0.0) (100000003.0 1.0 0.0) (100000001.0 1.0 0.0))
                         '((1.0 1.0 1.0) (4.0 4.0 4.0) (-7.0 -7.0 -7.0)))])
      (define t-probe (triangle-probe corners))
      (check-false (normal-of corners))
      (for ([k (stressed 500)])
        (define-values (a c) (values (first corners) (third corners)))
        (define origin (add a (random-unit uniform)))
        (define target (add a (scale (uniform) (subtract c a))))
        (check-false (shoot t-probe origin (subtract target origin))))))

  (test-case "S11: slivers give finite hits in front, weights from 0 to 1 and a unit normal"
    (define uniform (make-random 6))
    (define hits
      (for*/sum ([aspect '(1e6 1e12 1e15)] [size '(1e-150 1e-9 1.0 1e9 1e100)]
                 [k (stressed 200)])
        (define b (random-unit uniform))
        (define c (add (scale 0.6 b) (scale (/ 1.0 aspect) (random-unit uniform))))
        (define p (triangle-probe (for/list ([x (list '(0.0 0.0 0.0) b c)]) (scale size x))))
        (define origin (scale (* 3.0 size) (random-unit uniform)))
        (define t (shoot p origin (subtract (scale (/ size 3.0) (add b c)) origin)))
        (cond
          [t
           (define s (surface-at p))
           (check-true (< 0.0 t 10.0))
           (check-true (<= 0.0 (Surface-u s) 1.0))
           (check-true (<= 0.0 (Surface-v s) 1.0))
           (check-= (norm (Surface-normal s)) 1.0 1e-15)
           1]
          [else 0])))
    (check-true (> hits 100)))

  (test-case "the normal is right to 2 ulp where the flonum cross product has no digits"
    ;; along (1 1 1) x (0 0 1)
    (check-near (list (sqrt 0.5) (- (sqrt 0.5)) 0.0)
                (normal-of (list '(1.0 1.0 1.0) '(2.0 2.0 2.0) (list 3.0 3.0 (+ 3.0 (expt 2.0 -51)))))
                4e-16))

  ;; --- scale, bounds, input ---

  (test-case "scaled by a power of two, every number is the same to the bit"
    (define uniform (make-random 7))
    (for ([k (stressed 200)])
      (define corners (for/list ([j 3]) (random-unit uniform)))
      (define origin (scale 3.0 (random-unit uniform)))
      (define direction (subtract (scale (/ 1.0 3.0) (apply map + corners)) origin))
      (define (numbers size)
        (define p (triangle-probe (for/list ([x corners]) (scale size x))))
        (define t (shoot p (scale size origin) (scale size direction)))
        (define s (surface-at p))
        (list t (Surface-u s) (Surface-v s) (scale (/ 1.0 size) (Surface-point s))
              (Surface-normal s) (/ (Surface-error s) size)))
      (check-equal? (numbers 1.0) (numbers (expt 2.0 40)))
      (check-equal? (numbers 1.0) (numbers (expt 2.0 -40)))))

  (test-case "the box holds every hit, to the error the hit states"
    (define uniform (make-random 8))
    (for ([k (stressed 300)])
      (define corners (for/list ([j 3]) (random-unit uniform)))
      (define p (triangle-probe corners))
      (define-values (origin direction) ((aimed-at corners uniform 1.0)))
      (when (shoot p origin direction)
        (define s (surface-at p))
        (for ([low (first (bounds p))] [x (Surface-point s)] [high (second (bounds p))])
          (check-true (<= (- low (Surface-error s)) x (+ high (Surface-error s))))))))

  (test-case "a bad corner is named"
    (check-exn #rx"Triangle: expected three finite coordinates as b"
               (lambda () (triangle '(0.0 0.0 0.0) '(0.0 +nan.0 0.0) '(0.0 1.0 0.0))))))
