#lang racket/base
;; Moving shapes: at any time the same as an instance in that place.

(module+ test
  (require racket/flonum racket/list rackunit
           (except-in "../../private/base/float3.rkt" Float3)
           "../../private/base/transform.rkt" "../../private/shape/sphere.rkt"
           "../../private/shape/instance.rkt" "../../private/shape/moving.rkt"
           "../../private/shape/kernels.rkt" "../../private/shape/kernel.rkt"
           "mesh-examples.rkt" "rays.rkt")

  (define (float3 p) (apply make-Float3 p))
  (define unit-sphere (make-Sphere (make-Float3 0 0 0) 1))

  ;; The transform between two at a time, entry by entry.
  (define (between from to time)
    (apply make-Transform
           (append* (for/list ([a (Transform-matrix-rows from)] [b (Transform-matrix-rows to)])
                      (map (lambda (x y) (+ (* (- 1.0 time) x) (* time y))) a b)))))

  (test-case "a sphere that falls is where its time says, exactly"
    (define falling
      (make-Moving unit-sphere (Transform-translate 0 8 0) (Transform-translate 0 0 0)))
    (for ([time '(0.0 0.25 0.5 1.0)])
      (define surface
        (shoot-surface falling (make-Float3 0 20 0) (make-Float3 0 -1 0) #:time time))
      (check-equal? (first surface) (+ 11.0 (* 8.0 time)))))

  (test-case "at any time as an instance there: t to 1e-12, surface to 1e-11"
    (define g (make-generator 41))
    (define body (icosphere 2 g))
    (for ([_ 100])
      (define (place)
        (Transform-compose (Transform-translate (float3 (random-direction g)))
                           (Transform-rotate (float3 (random-direction g)) (random g))
                           (Transform-scale (+ 0.5 (random g)) (+ 0.5 (random g)) 1.0)))
      (define-values (from to time) (values (place) (place) (random g)))
      (define moving (make-Moving body from to))
      (define still (make-Instance body (between from to time)))
      (define box (ShapeKernel-bounds (Shape-kernel moving)))
      (define inner (ShapeKernel-bounds (Shape-kernel still)))
      (for ([axis 3])
        (check-true (<= (flvector-ref box axis) (flvector-ref inner axis)))
        (check-true (>= (flvector-ref box (+ 3 axis)) (flvector-ref inner (+ 3 axis)))))
      (for ([_ 10])
        (define o (map (lambda (c) (* 9.0 c)) (random-direction g)))
        (define d (map - (map (lambda (c) (* 0.7 c)) (random-direction g)) o))
        (define a (shoot-surface moving (float3 o) (float3 d) #:time time))
        (define b (shoot-surface still (float3 o) (float3 d)))
        (check-equal? (and a #t) (and b #t))
        (when a
          (check-= (first a) (first b) 1e-12)
          (for ([x (take (cdr a) 11)] [y (take (cdr b) 11)]) (check-= x y 1e-11))
          ;; the error bounds are of a size
          (check-true (< 0.5 (/ (last a) (last b)) 5.0))
          ;; a ray that leaves does not meet the surface again
          (define-values (point normal) (values (take (drop a 1) 3) (take (drop a 4) 3)))
          (define leaving (map + normal (map (lambda (c) (* 0.999 c)) (random-direction g))))
          (define start (map (lambda (p n) (+ p (* (last a) n))) point normal))
          (define again (shoot-surface moving (float3 start) (float3 leaving) #:time time))
          (when again (check-true (> (first again) 1e-3)))))))

  (test-case "a way on which the shape would be flat is refused in one line"
    (define up (make-Float3 0 1 0))
    (check-exn #rx"^Moving: expected a transform near enough[^\n]*$"
               (lambda ()
                 (make-Moving unit-sphere (Transform-identity) (Transform-rotate up #:degrees 180))))
    (check-exn #rx"^Moving:"
               (lambda () (make-Moving unit-sphere (Transform-identity) (Transform-scale -1 1 1))))
    (check-not-exn
     (lambda ()
       (make-Moving unit-sphere (Transform-identity) (Transform-rotate up #:degrees 179))))))
