#lang racket/base
;; The solid angles of triangles: where rays from a point stop hitting them.

(module+ test
  (require racket/math rackunit "../../main.rkt")

  (define (plus a b) (Float3-add a b))
  (define (times s v) (Float3-scale-by-scalar v s))

  ;; Nodes and weights of Gauss's rule of n points on 0 to 1: the roots of Legendre's polynomial by
  ;; Newton's iteration.
  (define (gauss n)
    (for/list ([k n])
      (let loop ([x (cos (* pi (/ (+ k 0.75) (+ n 0.5))))] [left 8])
        (define-values (p before)
          (for/fold ([p x] [before 1.0]) ([j (in-range 2 (+ n 1))])
            (values (/ (- (* (- (* 2 j) 1) x p) (* (- j 1) before)) j) p)))
        (define slope (/ (* n (- (* x p) before)) (- (* x x) 1.0)))
        (if (= left 0)
            (cons (* 0.5 (+ 1.0 x)) (/ 1.0 (* (- 1.0 (* x x)) slope slope)))
            (loop (- x (/ p slope)) (- left 1))))))

  ;; The solid angle of a triangle seen from the origin: around an axis through it, the edge is at an
  ;; angle t(azimuth), found by bisection of rays that hit and miss; the integral of 1 - cos t.
  (define (solid-angle . corners)
    (define world (World (list (apply Triangle corners))))
    (define axis (Float3-normalized (plus (car corners) (plus (cadr corners) (caddr corners)))))
    (define aside (Float3-normalized (Float3-cross axis (Float3 0.3 0.5 -0.7))))
    (define across (Float3-cross axis aside))
    (define (hit? t azimuth)
      (define d
        (plus (times (cos t) axis)
              (times (sin t) (plus (times (cos azimuth) aside) (times (sin azimuth) across)))))
      (< (Intersection-t (World-nearest-hit world (Ray (Float3 0 0 0) d))) INTERSECTION-T-MAX))
    (define (edge azimuth)
      (for/fold ([low 0.0] [high pi] #:result low) ([_ 54])
        (define middle (* 0.5 (+ low high)))
        (if (hit? middle azimuth) (values middle high) (values low middle))))
    (define azimuths
      (sort (for/list ([c corners]) (atan (Float3-dot c across) (Float3-dot c aside))) <))
    (for*/sum ([piece (list (cons (car azimuths) (cadr azimuths))
                            (cons (cadr azimuths) (caddr azimuths))
                            (cons (caddr azimuths) (+ (car azimuths) (* 2.0 pi))))]
               [node (gauss 40)])
      (define width (- (cdr piece) (car piece)))
      (define half-sine (sin (* 0.5 (edge (+ (car piece) (* width (car node)))))))
      (* width (cdr node) 2.0 half-sine half-sine)))

  (test-case "G10: a triangle to 1e-12, an octant is pi / 2"
    (check-= (/ (solid-angle (Float3 1 0 2) (Float3 2 1.5 3) (Float3 -1 1 1.5)) 0.242710190673643)
             1.0 1e-12)
    (check-= (/ (solid-angle (Float3 1 0 0) (Float3 0 1 0) (Float3 0 0 1)) (/ pi 2)) 1.0 1e-12)))
