#lang racket/base
;; Shapes of users' own: a sphere and a ground written as a user would, against the library's.

(module+ test
  (require racket/list racket/math rackunit
           (except-in "../../private/base/float3.rkt" Float3)
           "../../private/base/transform.rkt"
           "../../private/shape/custom.rkt" "../../private/shape/sphere.rkt"
           "../../private/shape/box.rkt" "../../private/shape/solid.rkt"
           "../../private/shape/instance.rkt" "../../private/shape/kernels.rkt"
           "../../private/material/phong.rkt"
           "../../private/integrate/query.rkt" "../../private/world/ray.rkt"
           "../../private/world/world.rkt"
           "probe.rkt" "axial-checks.rkt" "spawned-rays.rkt")

  (define (stressed count) (if stress? (* 100 count) count))
  (define zero (make-Float3 0 0 0))

  ;; The smaller root in range of |o + t d|^2 = radius^2, by the quadratic formula without
  ;; cancellation.
  (define ((ball radius) origin direction t-max)
    (define-values (o d) (values (float3->list origin) (float3->list direction)))
    (define-values (a b c) (values (dot d d) (dot o d) (* (- (norm o) radius) (+ (norm o) radius))))
    (define nearest (subtract o (scale (/ b a) d)))
    (define discriminant (- (* radius radius) (dot nearest nearest)))
    (cond
      [(< discriminant 0.0) #f]
      [else
       (define s (sqrt (* a discriminant)))
       (define q (if (> b 0.0) (- (+ b s)) (- s b)))
       (define roots (sort (list (/ q a) (/ c q)) <))
       (define t (findf (lambda (t) (< 0.0 t t-max)) roots))
       (and t (list t (float3 (scale (/ 1.0 radius) (add o (scale t d))))))]))
  (define unit-ball
    (make-CustomShape (make-Float3 -1 -1 -1) (make-Float3 1 1 1) (ball 1.0)))
  (define unit-sphere (make-Sphere zero 1))

  (define (random-ray uniform)
    (define target (scale 0.9 (random-in-ball uniform)))
    (define o (scale (uniform 0.0 4.0) (random-unit uniform)))
    (values o (subtract target o)))

  (test-case "a sphere: the t its procedure gives, within 8 roundings of Sphere; normal, uv"
    (define uniform (make-random 71))
    (define-values (p q) (values (probe unit-ball) (probe unit-sphere)))
    (define hits
      (for/sum ([_ (stressed 1000)])
        (define-values (o d) (random-ray uniform))
        (define t (shoot p o d))
        (define expected (shoot q o d))
        (check-equal? (and t #t) (and expected #t))
        (cond
          [expected
           (check-equal? t (first ((ball 1.0) (float3 o) (float3 d) +inf.0)))
           (define-values (s e) (values (surface-at p) (surface-at q)))
           ;; how far apart the two points are along the normal
           (define apart (abs (* (- t expected) (dot (Surface-normal e) d))))
           (check-true (<= apart (* 8.0 (expt 2.0 -53) (+ 1.0 (norm o)))) (format "~a ~a" t expected))
           (check-= (norm (subtract (Surface-point s) (Surface-point e))) 0.0 4e-15)
           (check-= (norm (subtract (Surface-normal s) (Surface-normal e))) 0.0 1e-14)
           (check-= (Surface-u s) (Surface-u e) 1e-13)
           (check-= (Surface-v s) (Surface-v e) 1e-12)
           1]
          [else 0])))
    (check-true (> hits 800))
    (check-equal? (bounds p) '((-1.0 -1.0 -1.0) (1.0 1.0 1.0))))

  (test-case "a hit at the limit or outside of (0, t-max), NaN, and #f are no hits"
    (define (gives t)
      (probe (make-CustomShape (make-Float3 -1 -1 -1) (make-Float3 1 1 1)
                               (lambda (o d t-max) (and t (list t (make-Float3 0 0 -1)))))))
    (for ([t '(2.0 2.5 0.0 -1.0 +nan.0 +inf.0 #f)])
      (check-false (shoot (gives t) '(0.0 0.0 -2.0) '(0.0 0.0 1.0) 2.0)))
    (check-equal? (shoot (gives 1.5) '(0.0 0.0 -2.0) '(0.0 0.0 1.0) 2.0) 1.5))

  (test-case "the procedure is told where the ray ends"
    (define told '())
    (define p (probe (make-CustomShape (make-Float3 -1 -1 -1) (make-Float3 1 1 1)
                                       (lambda (o d t-max) (set! told (cons t-max told)) #f))))
    (for ([limit '(2.0 +inf.0)]) (shoot p '(0.0 0.0 -2.0) '(0.0 0.0 1.0) limit))
    (check-equal? (first told) +inf.0)
    (check-true (<= 2.0 (second told) 2.000000000000001)))

  (test-case "rays that leave the sphere outwards do not meet it again"
    (define uniform (make-random 72))
    (define found (count-spawned (probe unit-ball) (stressed 1000) uniform
                                 (lambda ()
                                   (define o (scale 3.0 (random-unit uniform)))
                                   (values o (subtract (scale 0.9 (random-in-ball uniform)) o)))
                                 #:sides '(1.0)))
    (check-equal? (counts-rays found) (stressed 1000))
    (check-equal? (counts-again found) 0))

  (test-case "#:error is added to the error of the point"
    (define-values (p q)
      (values (probe unit-ball)
              (probe (make-CustomShape (make-Float3 -1 -1 -1) (make-Float3 1 1 1) (ball 1.0)
                                       #:error 0.5))))
    (define (error-of p) (shoot p '(0.0 0.0 -3.0) '(0.0 0.0 1.0)) (Surface-error (surface-at p)))
    (check-true (< (error-of p) 1e-13))
    (check-= (error-of q) 0.5 1e-13))

  (test-case "texture coordinates of its own, and a normal that is made a unit vector"
    (define p (probe (make-CustomShape
                      (make-Float3 -1 -1 -1) (make-Float3 1 1 1)
                      (lambda (o d t-max) (list 1.5 (make-Float3 0 0 -4)))
                      #:uv (lambda (point normal)
                             (values (Float3-z/function point) (Float3-z/function normal))))))
    (shoot p '(0.0 0.0 -2.0) '(0.0 0.0 1.0))
    (define s (surface-at p))
    (check-equal? (list (Surface-normal s) (Surface-u s) (Surface-v s))
                  '((0.0 0.0 -1.0) -0.5 -1.0)))

  (test-case "in instances and solids: a lens of it and the library's sphere, as of two of those"
    (define uniform (make-random 73))
    (define move (Transform-compose (Transform-translate 1 0 0) (Transform-scale 1 2 1)))
    (define (lens shape) (probe (make-SolidIntersection unit-sphere (make-Instance shape move))))
    (define-values (p q) (values (lens unit-ball) (lens unit-sphere)))
    (define hits
      (for/sum ([_ (stressed 300)])
        (define-values (o d) (random-ray uniform))
        (define-values (t expected) (values (shoot p o d) (shoot q o d)))
        (check-equal? (and t #t) (and expected #t))
        (when t (check-= t expected (* 1e-13 expected)))
        (if t 1 0)))
    (check-true (> hits 100)))

  (test-case "in a world: a ground that goes on for ever, seen before or behind a ball"
    (define green (make-Phong (make-Float3 0 1 0)))
    (define ground
      (make-CustomShape
       (make-Float3 -inf.0 0 -inf.0) (make-Float3 +inf.0 0 +inf.0)
       (lambda (o d t-max)
         (define t (/ (- (Float3-y/function o)) (Float3-y/function d)))
         (and (< 0.0 t t-max) (list t (make-Float3 0 1 0))))
       #:material green))
    (define red (make-Phong (make-Float3 1 0 0)))
    (define world
      (make-World (list ground (make-Sphere (make-Float3 0 2 0) 1 #:material red))))
    (define (look o d) (World-nearest-hit world (make-Ray (float3 o) (float3 d))))
    (define down '(0.0 -1.0 0.0))
    (check-equal? (Intersection-t (look '(0.0 5.0 0.0) down)) 2.0)
    (check-equal? (Intersection-color (look '(0.0 5.0 0.0) down)) (make-Float3 1 0 0))
    (check-equal? (Intersection-t (look '(1e6 5.0 0.0) down)) 5.0)
    (check-equal? (Intersection-color (look '(1e6 5.0 0.0) down)) (make-Float3 0 1 0))
    (check-equal? (Intersection-normal (look '(0.0 0.5 0.0) down)) (make-Float3 0 1 0))
    (check-true (World-occluded? world (make-Ray (make-Float3 9 5 0) (float3 down))))
    (check-false (World-occluded? world (make-Ray (make-Float3 9 5 0) (make-Float3 0 1 0))))
    (check-equal? (Shape-material ground) green))

  (test-case "corners the wrong way round, NaN and a negative error are errors that name them"
    (define (make low high #:error [error 0])
      (make-CustomShape (float3 low) (float3 high) (ball 1.0) #:error error))
    (check-exn #rx"^CustomShape: expected three coordinates not less than those of low as high"
               (lambda () (make '(0.0 0.0 0.0) '(1.0 -1.0 1.0))))
    (check-exn #rx"^CustomShape: expected three coordinates not less than those of low as high"
               (lambda () (make '(0.0 +nan.0 0.0) '(1.0 1.0 1.0))))
    (check-exn #rx"^CustomShape: expected a finite number of at least 0 as error"
               (lambda () (make '(0.0 0.0 0.0) '(1.0 1.0 1.0) #:error -1)))))
