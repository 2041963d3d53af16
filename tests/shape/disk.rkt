#lang racket/base
;; Disks: H16, the rim, rays that leave the surface, bounds.

(module+ test
  (require racket/list rackunit
           "../../private/shape/disk.rkt"
           "../../private/integrate/query.rkt" "../../private/world/ray.rkt"
           "probe.rkt" "axial-checks.rkt" "spawned-rays.rkt")

  (define roundoff (expt 2.0 -53))
  (define (stressed count) (if stress? (* 100 count) count))
  (define (disk point normal radius) (make-Disk (float3 point) (float3 normal) radius))

  (test-case "H16: t to 1e-12, and the miss"
    (define shape (disk '(0.0 0.0 0.0) '(0.0 0.0 1.0) 1))
    (define (found d) (Shape-intersect shape (make-Ray (float3 '(0.3 0.4 2.0)) (float3 d))))
    (define hit (found '(0.1 0.2 -1.0)))
    (check-= (Intersection-t hit) 2.0 2e-12)
    (for ([x (float3->list (Intersection-point hit))] [expected '(0.5 0.8 0.0)])
      (check-= x expected 1e-12))
    (check-equal? (float3->list (Intersection-normal hit)) '(0.0 0.0 1.0))
    (check-equal? (Intersection-t (found '(0.1 0.3 -1.0))) INTERSECTION-T-MAX))

  (test-case "the rim belongs to the disk; both sides are hit; uv runs from the centre out"
    (define p (probe (disk '(0.0 0.0 0.0) '(0.0 0.0 2.0) 1)))
    (for ([rim '((1.0 0.0) (-1.0 0.0) (0.0 1.0) (0.6 0.8))] [z '(1.0 -1.0 1.0 -1.0)])
      (check-equal? (shoot p (append rim (list z)) (list 0.0 0.0 (- z))) 1.0)
      (check-equal? (Surface-normal (surface-at p)) '(0.0 0.0 1.0))
      (check-= (Surface-v (surface-at p)) 1.0 1e-15))
    (check-false (shoot p '(1.0000000000000002 0.0 1.0) '(0.0 0.0 -1.0)))
    (check-equal? (shoot p '(0.25 0.0 1.0) '(0.0 0.0 -1.0)) 1.0)
    (check-equal? (Surface-v (surface-at p)) 0.25)
    (check-false (shoot p '(0.0 0.0 1.0) '(0.0 0.0 1.0)))
    (check-false (shoot p '(0.0 0.0 1.0) '(0.0 0.0 -1.0) 0.999)))

  (test-case "the same hits as in rational arithmetic, the point in the plane to its error"
    (define uniform (make-random 21))
    (for ([k (stressed 2000)])
      (define center (random-unit uniform))
      (define shape (disk center (random-unit uniform) 0.5))
      (define p (probe shape))
      (define o (scale 4.0 (random-unit uniform)))
      (define d (subtract (add center (scale (uniform 0.0 0.7) (random-unit uniform))) o))
      (define n (exact (float3->list (Disk-normal shape))))
      (define t (/ (dot n (subtract (exact center) (exact o))) (dot n (exact d))))
      (define from-center (subtract (add (exact o) (scale t (exact d))) (exact center)))
      (check-equal? (and (shoot p o d) #t) (< (dot from-center from-center) 1/4))
      (when (shoot p o d)
        (define s (surface-at p))
        (check-true (<= (abs (dot n (subtract (exact (Surface-point s)) (exact center))))
                        (Surface-error s))))))

  (test-case "S04: no ray meets the disk it leaves, nor passes one 1000 ulp away"
    (define uniform (make-random 22))
    (for* ([size '(1e-9 1.0 1e9)] [offset '(0.0 1.0 1e4 1e8)]
           [normal '((0.0 1.0 0.0) (0.3 -0.8 0.5))])
      (define at (car (placed '((0.2 -0.3 0.4)) size offset)))
      (define gap (* 1000.0 2.0 roundoff size (max 1.0 offset)))
      (define (shifted side) (probe (disk (add at (scale (* side gap) (unit normal))) normal size)))
      (define-values (above below) (values (shifted 1.0) (shifted -1.0)))
      (define (aim)
        (define direction (random-unit uniform))
        (define target (add at (scale (* 0.5 size) (unit (cross normal (random-unit uniform))))))
        (values (subtract target (scale (* 2.0 size) direction)) direction))
      (define total
        (count-spawned (probe (disk at normal size)) (stressed 300) uniform aim
                       #:beyond (lambda (side) (if (> side 0.0) above below))))
      (check-true (> (counts-rays total) 500))
      (check-equal? (counts-again total) 0 (format "~a ~a ~a" size offset normal))
      (check-equal? (counts-leaked total) 0 (format "~a ~a ~a" size offset normal))))

  (test-case "the box holds every hit, and every side of it is reached to 1%"
    (define uniform (make-random 23))
    (for ([k 10])
      (define-values (center normal) (values (random-unit uniform) (random-unit uniform)))
      (define p (probe (disk center normal 2.0)))
      (define points
        (for*/list ([j (stressed 1000)]
                    [across (in-value (unit (cross normal (random-unit uniform))))]
                    [target (in-value (add center (scale (uniform 1.99 2.0) across)))]
                    #:when (shoot p (add target normal) (scale -1.0 normal)))
          (Surface-point (surface-at p))))
      (for ([axis 3])
        (define xs (map (lambda (point) (list-ref point axis)) points))
        (define-values (low high) (apply values (map (lambda (c) (list-ref c axis)) (bounds p))))
        (define slack (* 32.0 roundoff 3.0))
        (check-true (<= (- low slack) (apply min xs) (+ low 0.02)))
        (check-true (<= (- high 0.02) (apply max xs) (+ high slack))))))

  (test-case "scaled by a power of two, every number is the same to the bit"
    (define uniform (make-random 24))
    (for ([k 200])
      (define-values (at normal o)
        (values (random-unit uniform) (random-unit uniform) (scale 3.0 (random-unit uniform))))
      (define d (subtract at o))
      (define (numbers size)
        (define p (probe (disk (scale size at) normal (* 0.5 size))))
        (define t (shoot p (scale size o) (scale size d)))
        (define s (surface-at p))
        (list t (scale (/ 1.0 size) (Surface-point s)) (/ (Surface-error s) size)))
      (check-equal? (numbers 1.0) (numbers (expt 2.0 40)))))

  (test-case "bad arguments are named"
    (check-exn #rx"Disk: expected a direction other than zero as normal"
               (lambda () (disk '(0.0 0.0 0.0) '(0.0 0.0 0.0) 1)))
    (for ([radius '(0 -1 +inf.0 +nan.0)])
      (check-exn #rx"Disk: expected a positive finite number as radius"
                 (lambda () (disk '(0.0 0.0 0.0) '(0.0 0.0 1.0) radius))))))
