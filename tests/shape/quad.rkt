#lang racket/base
;; Quads: hits, the seam inside and the edges between, rays that leave the surface, bounds.

(module+ test
  (require racket/list racket/math rackunit
           "../../private/shape/quad.rkt"
           "../../private/integrate/query.rkt" "../../private/world/ray.rkt"
           "probe.rkt" "axial-checks.rkt" "spawned-rays.rkt")

  (define roundoff (expt 2.0 -53))
  (define (stressed count) (if stress? (* 100 count) count))
  (define (quad corner u v) (make-Quad (float3 corner) (float3 u) (float3 v)))

  (test-case "a wall hit from both sides, on its edges and corners, exactly"
    (define shape (quad '(-1.0 0.0 2.0) '(2.0 0.0 0.0) '(0.0 4.0 0.0)))
    (define found (Shape-intersect shape (make-Ray (float3 '(0.5 1.0 5.0)) (float3 '(0.0 0.0 -1.0)))))
    (check-equal? (Intersection-t found) 3.0)
    (check-equal? (float3->list (Intersection-point found)) '(0.5 1.0 2.0))
    (check-equal? (float3->list (Intersection-normal found)) '(0.0 0.0 1.0))
    (define p (probe shape))
    (for* ([x '(-1.0 -0.5 0.0 1.0)] [y '(0.0 1.0 4.0)] [side '(1.0 -1.0)])
      (check-equal? (shoot p (list x y (+ 2.0 side)) (list 0.0 0.0 (- side))) 1.0)
      (define s (surface-at p))
      (check-equal? (Surface-point s) (list x y 2.0))
      (check-equal? (Surface-normal s) '(0.0 0.0 1.0))
      (check-equal? (list (Surface-u s) (Surface-v s)) (list (/ (+ x 1.0) 2.0) (/ y 4.0))))
    (for ([outside '((-1.0000000000000002 1.0) (1.0000000000000002 1.0) (0.0 -1e-300)
                     (0.0 4.000000000000001))])
      (check-false (shoot p (append outside '(3.0)) '(0.0 0.0 -1.0))))
    (check-false (shoot p '(0.0 1.0 3.0) '(0.0 0.0 1.0)))
    (check-false (shoot p '(0.0 1.0 3.0) '(0.0 0.0 -1.0) 0.999))
    (check-false (shoot p '(0.0 1.0 2.0) '(1.0 0.0 0.0))))

  (test-case "the same hits, t and coordinates as in rational arithmetic"
    (define uniform (make-random 31))
    (define worst
      (for/fold ([worst 0.0]) ([k (stressed 2000)])
        (define-values (corner u v)
          (values (random-unit uniform) (random-unit uniform) (random-unit uniform)))
        (define p (probe (quad corner u v)))
        (define o (scale 4.0 (random-unit uniform)))
        (define target
          (add corner (add (scale (uniform -0.3 1.3) u) (scale (uniform -0.3 1.3) v))))
        (define d (subtract target o))
        (define-values (c eu ev eo ed)
          (apply values (map exact (list corner u v o d))))
        (define n (cross eu ev))
        (define t (/ (dot n (subtract c eo)) (dot n ed)))
        (define h (subtract (add eo (scale t ed)) c))
        (define a (/ (dot n (cross h ev)) (dot n n)))
        (define b (/ (dot n (cross eu h)) (dot n n)))
        (define found (shoot p o d))
        (check-equal? (and found #t) (and (< 0 a 1) (< 0 b 1)))
        (cond
          [found
           (define s (surface-at p))
           (define height (/ (dot n (subtract (exact (Surface-point s)) c)) (norm n)))
           (check-true (<= (abs height) (Surface-error s)))
           (define conditioning (* (/ (abs (dot n ed)) (norm n) (norm d)) (norm n)))
           (max worst (/ (* conditioning (max (abs (- found t)) (abs (- (Surface-u s) a))
                                              (abs (- (Surface-v s) b))))
                         roundoff))]
          [else worst])))
    (printf "quad: worst error of t, u, v ~a roundings times cosine and area\n" worst)
    (check-true (< worst 64.0)))

  ;; The six walls of a sheared room whose corners are sums without rounding.
  (define (random-room uniform offset)
    (define (dyadic) (/ (exact-round (uniform -1024.0 1024.0)) 1024.0))
    (define (near v) (add v (scale 0.25 (list (dyadic) (dyadic) (dyadic)))))
    (define-values (u v w)
      (values (near '(2.0 0.0 0.0)) (near '(0.0 2.0 0.0)) (near '(0.0 0.0 2.0))))
    (define c (map (lambda (x) (+ offset x)) (near '(-1.0 -1.0 -1.0))))
    (list (list c u v) (list (add c w) u v) (list c v w) (list (add c u) v w)
          (list c w u) (list (add c v) w u)))

  ;; Another corner of the same quad, the same way round or the other.
  (define (turned-around wall uniform)
    (define-values (c u v) (apply values wall))
    (case (exact-floor (uniform 0.0 3.0))
      [(0) wall]
      [(1) (list c v u)]
      [else (list (add (add c u) v) (scale -1.0 u) (scale -1.0 v))]))

  (test-case "10^5 rays at edges, corners and diagonals of rooms of quads, 0 leaks"
    (define uniform (make-random 32))
    (for* ([offset '(0.0 1024.0 1048576.0)] [unit? '(#f #t)] [k 17])
      (define walls (for/vector ([wall (random-room uniform offset)]) (turned-around wall uniform)))
      (define probes (for/vector ([wall walls]) (probe (apply quad wall))))
      (define leaks
        (for/sum ([k (stressed 1000)])
          (define wall (exact-floor (uniform 0.0 6.0)))
          (define-values (c u v) (apply values (vector-ref walls wall)))
          (define kind (uniform))
          (define s (uniform))
          (define target
            (cond
              [(< kind 0.3) c]
              [(< kind 0.6) (add c (scale s u))]
              [(< kind 0.8) (add c (add u (scale s v)))]
              [else (add c (scale s (add u v)))]))
          (define o
            (map (lambda (x) (+ offset x)) (scale (uniform 0.0 0.4) (random-unit uniform))))
          (define aimed (subtract target o))
          (define d (if unit? (unit aimed) aimed))
          (define (hits? p) (shoot-occluded p o d 1e300))
          (if (or (hits? (vector-ref probes wall)) (for/or ([p probes]) (hits? p))) 0 1)))
      (check-equal? leaks 0)))

  (test-case "S04: no ray meets the quad it leaves, nor passes one 1000 ulp away"
    (define uniform (make-random 33))
    (for* ([size '(1e-9 1.0 1e9)] [offset '(0.0 1.0 1e4 1e8)]
           [edges '(((1.0 0.0 0.0) (0.0 1.0 0.0)) ((0.9 0.3 -0.2) (-0.3 1.1 0.4)))])
      (define-values (u v) (apply values (map (lambda (e) (scale size e)) edges)))
      (define corner (car (placed '((0.2 -0.3 0.4)) size offset)))
      (define normal (unit (apply cross edges)))
      (define gap (* 1000.0 2.0 roundoff size (max 1.0 offset)))
      (define (shifted side) (probe (quad (add corner (scale (* side gap) normal)) u v)))
      (define-values (above below) (values (shifted 1.0) (shifted -1.0)))
      (define (aim)
        (define direction (random-unit uniform))
        (define target
          (add corner (add (scale (uniform 0.2 0.8) u) (scale (uniform 0.2 0.8) v))))
        (values (subtract target (scale (* 2.0 size) direction)) direction))
      (define total
        (count-spawned (probe (quad corner u v)) (stressed 300) uniform aim
                       #:beyond (lambda (side) (if (> side 0.0) above below))))
      (check-true (> (counts-rays total) 500))
      (check-equal? (counts-again total) 0 (format "~a ~a ~a" size offset edges))
      (check-equal? (counts-leaked total) 0 (format "~a ~a ~a" size offset edges))))

  (test-case "the box holds every hit, to the error the hit states"
    (define uniform (make-random 34))
    (for ([k (stressed 500)])
      (define-values (corner u v)
        (values (random-unit uniform) (random-unit uniform) (random-unit uniform)))
      (define p (probe (quad corner u v)))
      (define o (scale 4.0 (random-unit uniform)))
      (when (shoot p o (subtract (add corner (scale 0.5 (add u v))) o))
        (define s (surface-at p))
        (for ([low (first (bounds p))] [x (Surface-point s)] [high (second (bounds p))])
          (check-true (<= (- low (Surface-error s)) x (+ high (Surface-error s))))))))

  (test-case "scaled by a power of two, every number is the same to the bit"
    (define uniform (make-random 35))
    (for ([k 200])
      (define-values (corner u v)
        (values (random-unit uniform) (random-unit uniform) (random-unit uniform)))
      (define o (scale 3.0 (random-unit uniform)))
      (define d (subtract (add corner (scale 0.4 (add u v))) o))
      (define (numbers size)
        (define p (probe (quad (scale size corner) (scale size u) (scale size v))))
        (define t (shoot p (scale size o) (scale size d)))
        (define s (surface-at p))
        (list t (Surface-u s) (Surface-v s) (scale (/ 1.0 size) (Surface-point s))
              (Surface-normal s) (/ (Surface-error s) size)))
      (check-equal? (numbers 1.0) (numbers (expt 2.0 40)))))

  (test-case "a quad without area is an error that names the edge"
    (check-exn #rx"Quad: expected a direction other than zero as edge-u"
               (lambda () (quad '(0.0 0.0 0.0) '(0.0 0.0 0.0) '(0.0 1.0 0.0))))
    (check-exn #rx"Quad: expected an edge that spans an area with edge-u .* as edge-v"
               (lambda () (quad '(0.0 0.0 0.0) '(0.1 0.2 0.3) '(-0.2 -0.4 -0.6))))
    (check-exn #rx"as edge-v"
               (lambda () (quad '(1e17 0.0 0.0) '(1.0 0.0 0.0) '(0.0 1.0 0.0))))))
