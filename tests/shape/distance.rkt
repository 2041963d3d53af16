#lang racket/base
;; Shapes given by a distance: a sphere against Sphere, a torus against Torus, stated errors and
;; rates, rays from inside and from the surface, functions that misbehave.

(module+ test
  (require racket/list racket/math rackunit
           (except-in "../../private/base/float3.rkt" Float3)
           "../../private/shape/distance.rkt" "../../private/shape/sphere.rkt"
           "../../private/shape/solid.rkt" "../../private/shape/box.rkt"
           "probe.rkt" "axial-checks.rkt" "spawned-rays.rkt")

  (define (stressed count) (if stress? (* 100 count) count))
  (define ((ball radius) x y z) (- (sqrt (+ (* x x) (* y y) (* z z))) radius))
  (define (corner s) (make-Float3 s s s))
  (define (unit-ball #:error [error #f] #:rate [rate 1.0] #:half [half 1.5])
    (make-DistanceShape (lambda (x y z) (* rate ((ball 1.0) x y z)))
                        (corner (- half)) (corner half) #:error error #:lipschitz rate))
  (define exact-ball (probe (make-Sphere (corner 0.0) 1.0)))

  (define (random-ray uniform)
    (define target (scale 0.9 (random-in-ball uniform)))
    (define o (scale (uniform 0.0 4.0) (random-unit uniform)))
    (values o (subtract target o)))

  ;; Where the ray stops it is within the error of the surface: along the ray that is longer by the
  ;; cosine. Returns whether there was a hit.
  (define (check-like p exact o d error)
    (define t (shoot p o d))
    (define expected (shoot exact o d))
    (check-equal? (and t #t) (and expected #t) (format "~a ~a" o d))
    (when (and t expected)
      (define s (surface-at p))
      (define along (abs (dot (Surface-normal s) d)))
      (check-true (<= (abs (- t expected)) (/ (* 1.5 error) along)) (format "~a ~a" t expected))
      (check-= (norm (subtract (Surface-normal s) (Surface-normal (surface-at exact)))) 0.0
               (+ 1e-9 (/ (* 4.0 error (norm d)) along))))
    (and t #t))

  (test-case "a sphere: the ray stops within the stated error, from outside and inside, at any rate"
    (define uniform (make-random 61))
    (for* ([error '(1e-4 1e-8 1e-12)] [rate '(1.0 0.25 8.0)])
      (define p (probe (unit-ball #:error error #:rate rate)))
      (define hits
        (for/sum ([_ (stressed 200)])
          (define-values (o d) (random-ray uniform))
          (if (or (> (abs (- 1.0 (norm o))) 0.01))
              (if (check-like p exact-ball o d error) 1 0)
              0)))
      (check-true (> hits 150))))

  (test-case "the default error is a millionth of the diagonal"
    (check-= (DistanceShape-error (unit-ball)) (* 3e-6 (sqrt 3.0)) 1e-18)
    (define p (probe (unit-ball)))
    (define t (shoot p '(0.0 0.0 -5.0) '(0.0 0.0 1.0)))
    (check-true (<= (- 4.0 6e-6) t 4.0))
    (define s (surface-at p))
    (check-= (norm (subtract (Surface-normal s) '(0.0 0.0 -1.0))) 0.0 1e-9)
    (check-equal? (bounds p) '((-1.5 -1.5 -1.5) (1.5 1.5 1.5))))

  (test-case "from very far, and along directions of any length, to the stated error"
    (define p (probe (unit-ball #:error 1e-9)))
    (for ([far '(1e3 1e6)] [length '(1e-5 1e5)])
      (define t (shoot p (list 0.0 0.3 (- far)) (list 0.0 0.0 length)))
      (define s (surface-at p))
      (check-= (norm (Surface-point s)) 1.0 1.1e-9)
      (check-= (/ (* t length) far) 1.0 (/ 1.0 far))))

  (test-case "a torus, to the stated error"
    (define uniform (make-random 62))
    (define error 1e-7)
    (define p (probe (make-DistanceShape
                      (lambda (x y z)
                        (define beyond (- (sqrt (+ (* x x) (* y y))) 1.0))
                        (- (sqrt (+ (* beyond beyond) (* z z))) 0.4))
                      (make-Float3 -1.5 -1.5 -0.5) (make-Float3 1.5 1.5 0.5) #:error error)))
    (define exact (probe (torus '(0.0 0.0 0.0) '(0.0 0.0 1.0) 1.0 0.4)))
    (define hits
      (for/sum ([_ (stressed 500)])
        (define angle (uniform 0.0 (* 2.0 pi)))
        (define target (add (list (cos angle) (sin angle) 0.0)
                            (scale 0.3 (random-in-ball uniform))))
        (define o (add target (scale 4.0 (random-unit uniform))))
        (define d (subtract target o))
        (if (check-like p exact o d error) 1 0)))
    (check-equal? hits (stressed 500)))

  (test-case "rays that leave on either side do not stop where they are"
    (define uniform (make-random 63))
    (for ([error '(1e-3 1e-6 1e-10)])
      (define p (probe (unit-ball #:error error)))
      (for ([side '(1.0 -1.0)])
        (define found
          (count-spawned p (stressed 300) uniform
                         (lambda () (let ([u (random-unit uniform)])
                                      (values (scale 3.0 u)
                                              (subtract (scale 0.9 (random-in-ball uniform))
                                                        (scale 3.0 u)))))
                         #:sides (list side)
                         #:again? (lambda (left met)
                                    (or (= side 1.0)
                                        (< (norm (subtract (Surface-point left) (Surface-point met)))
                                           (* 5.0 error))))))
        (check-equal? (counts-rays found) (stressed 300))
        (check-equal? (counts-again found) 0 (format "~a ~a" error side)))))

  (test-case "a ray from the very surface goes on to the other side, or away"
    (define p (probe (unit-ball #:error 1e-6)))
    (check-= (shoot p '(0.0 0.0 -1.0) '(0.0 0.0 1.0)) 2.0 1.1e-6)
    (check-false (shoot p '(0.0 0.0 1.0) '(0.0 0.0 1.0))))

  (test-case "limits: a hit before it only; the box cuts off what is outside"
    (define p (probe (unit-ball)))
    (check-false (shoot p '(0.0 0.0 -5.0) '(0.0 0.0 1.0) 3.9))
    (check-true (and (shoot p '(0.0 0.0 -5.0) '(0.0 0.0 1.0) 4.1) #t))
    (define half (probe (make-DistanceShape (ball 1.0) (corner -2.0) (make-Float3 2 2 0))))
    (check-true (and (shoot half '(0.0 0.0 -5.0) '(0.0 0.0 1.0)) #t))
    (check-false (shoot half '(5.0 0.0 0.5) '(-1.0 0.0 0.0)))
    ;; axis-parallel beside the box, either zero
    (for ([zero '(0.0 -0.0)])
      (check-false (shoot half '(3.0 0.0 -5.0) (list zero zero 1.0)))))

  (test-case "a solid of a distance and a box: a half ball, t to twice the error"
    (define p (probe (make-SolidDifference (unit-ball #:error 1e-9)
                                           (make-Box (make-Float3 -2 -2 0) (make-Float3 2 2 2)))))
    (check-= (shoot p '(0.3 0.2 5.0) '(0.0 0.0 -1.0)) 5.0 1e-15)
    (check-equal? (Surface-normal (surface-at p)) '(-0.0 -0.0 1.0))
    (check-= (shoot p '(0.0 0.0 -5.0) '(0.0 0.0 1.0)) 4.0 2e-9)
    (check-= (shoot p '(0.0 0.0 -0.5) '(0.0 0.0 1.0)) 0.5 1e-15)
    (check-false (shoot p '(-5.0 0.0 0.5) '(1.0 0.0 0.0))))

  (test-case "NaN, infinity and a distance that never shrinks end the ray"
    (define (of f) (probe (make-DistanceShape f (corner -1.0) (corner 1.0))))
    (for ([f (list (lambda (x y z) +nan.0) (lambda (x y z) +inf.0) (lambda (x y z) -inf.0)
                   (lambda (x y z) 1e-5)
                   ;; NaN from half-way on
                   (lambda (x y z) (if (< z 0.0) 0.1 +nan.0)))])
      (check-false (shoot (of f) '(0.0 0.0 -5.0) '(0.0 0.0 1.0)))
      (check-false (shoot (of f) '(0.0 0.0 0.0) '(0.0 0.0 1.0))))
    ;; a normal where the distance has no gradient: against the ray
    (define p (of (lambda (x y z) 0.0)))
    (check-equal? (shoot p '(0.0 0.0 -5.0) '(0.0 0.0 2.0)) 2.0)
    (check-equal? (Surface-normal (surface-at p)) '(-0.0 -0.0 -1.0)))

  (test-case "scaled by a power of two, every number is the same to the bit"
    (define uniform (make-random 64))
    (define size (expt 2.0 30))
    (define (numbers size o d)
      (define p (probe (make-DistanceShape (ball size) (corner (* -1.5 size)) (corner (* 1.5 size)))))
      (define t (shoot p (scale size o) (scale size d)))
      (define s (and t (surface-at p)))
      (and t (list t (scale (/ 1.0 size) (Surface-point s)) (Surface-normal s)
                   (/ (Surface-error s) size))))
    (for ([_ 100])
      (define-values (o d) (random-ray uniform))
      (check-equal? (numbers 1.0 o d) (numbers size o d))))

  (test-case "arguments that cannot be are errors that name them"
    (define (make . more) (apply make-DistanceShape (ball 1.0) more))
    (check-exn #rx"^DistanceShape: expected three coordinates greater than those of low as high"
               (lambda () (make (corner 1.0) (corner 1.0))))
    (check-exn #rx"^DistanceShape: expected three finite coordinates as low"
               (lambda () (make (corner -inf.0) (corner 1.0))))
    (define (with-error e) (make-DistanceShape (ball 1.0) (corner -1.0) (corner 1.0) #:error e))
    (check-exn #rx"^DistanceShape: expected a positive finite number as error"
               (lambda () (with-error 0.0)))
    (check-exn #rx"^DistanceShape: expected at least .* roundings of the box's coordinates, as error"
               (lambda () (with-error 1e-16)))
    (check-exn #rx"^DistanceShape: expected a positive finite number as lipschitz"
               (lambda () (make-DistanceShape (ball 1.0) (corner -1.0) (corner 1.0)
                                              #:lipschitz -1)))))
