#lang racket/base
;; Planes: hits against rational arithmetic, the projected point, rays that leave the surface.

(module+ test
  (require racket/list rackunit
           "../../private/shape/plane.rkt"
           "../../private/integrate/query.rkt" "../../private/world/ray.rkt"
           "probe.rkt" "axial-checks.rkt" "spawned-rays.rkt")

  (define roundoff (expt 2.0 -53))
  (define (stressed count) (if stress? (* 100 count) count))
  (define (plane point normal) (make-Plane (float3 point) (float3 normal)))

  (test-case "a floor seen from above and from below, exactly"
    (define floor (plane '(0.0 -1.0 0.0) '(0.0 3.0 0.0)))
    (define found
      (Shape-intersect floor (make-Ray (float3 '(1.0 2.0 3.0)) (float3 '(0.5 -1.0 1.0)))))
    (check-equal? (Intersection-t found) 3.0)
    (check-equal? (float3->list (Intersection-point found)) '(2.5 -1.0 6.0))
    (check-equal? (float3->list (Intersection-normal found)) '(0.0 1.0 0.0))
    (define p (probe floor))
    (check-equal? (shoot p '(0.0 -3.0 0.0) '(0.0 1.0 0.0)) 2.0)
    (check-equal? (Surface-normal (surface-at p)) '(0.0 1.0 0.0))
    (check-false (shoot p '(0.0 2.0 0.0) '(0.0 1.0 0.0)))
    (check-false (shoot p '(0.0 2.0 0.0) '(0.0 -1.0 0.0) 2.9)))

  (test-case "a ray along the plane misses it, in it or above it"
    (define p (probe (plane '(0.0 0.0 0.0) '(0.0 1.0 0.0))))
    (for* ([y '(0.0 -0.0 1.0 -1.0)] [zero '(0.0 -0.0)])
      (check-false (shoot p (list 0.3 y 0.2) (list 1.0 zero 0.5) +inf.0))))

  (test-case "t within 16 roundings of the distances over the cosine; the point within its error"
    (define uniform (make-random 11))
    (define worst
      (for/fold ([worst 0.0]) ([k (stressed 2000)])
        (define point (scale (expt 10.0 (uniform -3.0 3.0)) (random-unit uniform)))
        (define normal (float3->list (Plane-normal (plane point (random-unit uniform)))))
        (define p (probe (plane point normal)))
        (define o (scale (expt 10.0 (uniform -3.0 3.0)) (random-unit uniform)))
        (define d (random-unit uniform))
        (define t (shoot p o d))
        (cond
          [t
           (define s (surface-at p))
           (define n (exact (Surface-normal s)))
           (define true-t
             (/ (dot n (subtract (exact point) (exact o))) (dot n (exact d))))
           (define height (dot n (subtract (exact (Surface-point s)) (exact point))))
           (check-true (<= (abs height) (Surface-error s)))
           (max worst (/ (* (abs (- t true-t)) (abs (dot normal d)))
                         (* roundoff (+ (norm o) (norm point) t))))]
          [else worst])))
    (printf "plane: worst error of t ~a roundings times cosine\n" (exact->inexact worst))
    (check-true (< worst 16.0)))

  (test-case "S04: no ray meets the plane it leaves, nor passes one 1000 ulp away"
    (define uniform (make-random 12))
    (for* ([size '(1e-9 1.0 1e9)] [offset '(0.0 1.0 1e4 1e8)]
           [normal '((0.0 1.0 0.0) (0.3 -0.8 0.5))])
      (define at (car (placed '((0.2 -0.3 0.4)) size offset)))
      (define p (probe (plane at normal)))
      (define gap (* 1000.0 2.0 roundoff size (max 1.0 offset)))
      (define (shifted side) (probe (plane (add at (scale (* side gap) (unit normal))) normal)))
      (define-values (above below) (values (shifted 1.0) (shifted -1.0)))
      (define (aim)
        (define direction (random-unit uniform))
        (define target (add at (scale (* 0.5 size) (unit (cross normal (random-unit uniform))))))
        (values (subtract target (scale (* 2.0 size) direction)) direction))
      (define total
        (count-spawned p (stressed 300) uniform aim
                       #:beyond (lambda (side) (if (> side 0.0) above below))))
      (check-true (> (counts-rays total) 500))
      (check-equal? (counts-again total) 0 (format "~a ~a ~a" size offset normal))
      (check-equal? (counts-leaked total) 0 (format "~a ~a ~a" size offset normal))))

  (test-case "S04: nor do rays that leave the horizon of a tilted plane"
    (define uniform (make-random 13))
    (define p (probe (plane '(0.1 0.2 0.3) '(0.3 -0.8 0.5))))
    (define (aim)
      (define n (unit '(0.3 -0.8 0.5)))
      (define across (unit (cross n (random-unit uniform))))
      (values (add '(0.1 0.2 0.3) n)
              (unit (subtract across (scale (expt 10.0 (uniform -9.0 0.0)) n)))))
    (define total (count-spawned p (stressed 3000) uniform aim))
    (check-equal? (counts-rays total) (* 2 (stressed 3000)))
    (check-equal? (counts-again total) 0))

  (test-case "texture coordinates are distances along two orthogonal directions"
    (define uniform (make-random 14))
    (define p (probe (plane '(1.0 2.0 3.0) '(0.3 -0.8 0.5))))
    (for ([k 200])
      (define d (random-unit uniform))
      (when (and (shoot p '(0.0 0.0 0.0) d) (> (abs (dot d (unit '(0.3 -0.8 0.5)))) 0.01))
        (define s (surface-at p))
        (define distance (norm (subtract (Surface-point s) '(1.0 2.0 3.0))))
        (check-= (norm (list (Surface-u s) (Surface-v s))) distance (* 1e-14 (+ 1.0 distance))))))

  (test-case "scaled by a power of two, every number is the same to the bit"
    (define uniform (make-random 15))
    (for ([k 200])
      (define-values (at normal o d)
        (values (random-unit uniform) (random-unit uniform) (random-unit uniform)
                (random-unit uniform)))
      (define (numbers size)
        (define p (probe (plane (scale size at) (scale size normal))))
        (define t (shoot p (scale size o) (scale size d)))
        (define s (and t (surface-at p)))
        (and t (list t (scale (/ 1.0 size) (Surface-point s)) (/ (Surface-error s) size))))
      (check-equal? (numbers 1.0) (numbers (expt 2.0 40)))))

  (test-case "a plane has no box, and a zero normal is named"
    (check-equal? (bounds (probe (plane '(0.0 0.0 0.0) '(0.0 1.0 0.0))))
                  '((-inf.0 -inf.0 -inf.0) (+inf.0 +inf.0 +inf.0)))
    (check-exn #rx"Plane: expected a direction other than zero as normal"
               (lambda () (plane '(0.0 0.0 0.0) '(0.0 0.0 0.0))))
    (check-exn #rx"Plane: expected three finite coordinates as point"
               (lambda () (plane '(0.0 +inf.0 0.0) '(0.0 1.0 0.0))))))
