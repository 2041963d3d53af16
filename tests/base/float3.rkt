#lang racket/base
;; Float3: every operation as a function and fused, against rational arithmetic, for components of
;; every magnitude.

(module+ test
  (require racket/list racket/match rackunit "../../main.rkt" "../statistics.rkt"
           "float3-operations.rkt" "roots.rkt")

  (define uniform (seeded 1))
  (define (pick l) (list-ref l (inexact->exact (floor (uniform 0.0 (length l))))))
  (define edges
    '(0.0 -0.0 1.0 -1.0 4.9e-324 -4.9e-324 2.2e-308 1e-200 1e200 -1e200 1.7e308 -1.7e308))
  (define beyond '(+inf.0 -inf.0 +nan.0))
  (define (of-any-magnitude) (* (uniform -1.0 1.0) (expt 2.0 (uniform -1070.0 1020.0))))
  ;; a third ordinary, a third of any magnitude, a third edge cases; few infinite or no numbers
  (define (component)
    (case (inexact->exact (floor (uniform 0.0 3.1)))
      [(0) (uniform -2.0 2.0)]
      [(1) (of-any-magnitude)]
      [(2) (pick edges)]
      [else (pick beyond)]))
  (define (ordinary) (list (uniform -2.0 2.0) (uniform -2.0 2.0) (uniform -2.0 2.0)))
  (define (anything) (list (component) (component) (component)))
  (define (vec l) (apply Float3 l))
  (define (nums v) (list (Float3-x v) (Float3-y v) (Float3-z v)))
  (define (exact l) (map inexact->exact l))
  (define (dot a b) (apply + (map * a b)))
  (define u (expt 2 -53))

  (test-case "fused in a kernel and as a function: the same bits, 1,000 arguments an operation"
    (check-equal? (length operations) 22)
    (for ([operation operations])
      (match-define (list name kinds function fused) operation)
      (define wrong
        (for*/first ([k (stressed 1000 20000)]
                     [arguments (in-value (for/list ([kind kinds])
                                            (if (eq? kind 'v) (anything) (list (component)))))]
                     #:unless (equal? (function arguments) (fused arguments)))
          (list arguments (function arguments) (fused arguments))))
      (check-false wrong (format "~a differs: ~a" name wrong))))

  (define (function-of name)
    (define operation (assq name operations))
    (lambda arguments ((third operation) arguments)))

  (test-case "component by component, each result is the rounded exact one"
    (for ([k 1000])
      (define-values (a b s) (values (anything) (anything) (component)))
      (when (andmap (lambda (x) (< (abs x) +inf.0)) (list* s (append a b)))
        (define (check-rounded operation result)
          (for ([x (nums result)] [p a] [q b])
            (check-= x (real->double-flonum (operation (inexact->exact p) (inexact->exact q))) 0.0)))
        (define (finite? x) (< (abs x) +inf.0))
        (define-syntax-rule (when-finite v check) (when (andmap finite? (nums v)) check))
        (define-values (sum difference product)
          (values (Float3-add (vec a) (vec b)) (Float3-subtract (vec a) (vec b))
                  (Float3-scale-by-vector (vec a) (vec b))))
        (when-finite sum (check-rounded + sum))
        (when-finite difference (check-rounded - difference))
        (when-finite product (check-rounded * product))
        (define scaled (Float3-scale-by-scalar (vec a) s))
        (when-finite scaled
          (check-equal? (nums scaled) (map (lambda (x) (* x s)) a))))
      (check-equal? (nums (Float3-negate (vec a))) (map - a))))

  (test-case "dot, lengths and distance: to 3 roundings of the sum of magnitudes; symmetric"
    (for ([k 1000])
      (define-values (a b) (values (ordinary) (ordinary)))
      (define-values (ea eb) (values (exact a) (exact b)))
      (define (check-sum computed terms)
        (check-true (<= (abs (- (inexact->exact computed) (apply + terms)))
                        (* 3 u (apply + (map abs terms))))))
      (check-sum (Float3-dot (vec a) (vec b)) (map * ea eb))
      (check-sum (Float3-length-squared (vec a)) (map * ea ea))
      (check-equal? (Float3-dot (vec a) (vec b)) (Float3-dot (vec b) (vec a)))
      (define (check-length computed squares)
        (define right (exact-square-root (apply + squares)))
        (check-true (<= (abs (- (inexact->exact computed) right)) (* 3 u right))))
      (check-length (Float3-length (vec a)) (map * ea ea))
      (check-equal? (Float3-distance (vec a) (vec b)) (Float3-distance (vec b) (vec a)))
      (check-equal? (Float3-distance (vec a) (vec b))
                    (Float3-length (Float3-subtract (vec a) (vec b))))))

  (test-case "cross: right-handed, across both, opposite when turned round"
    (define-values (x y z) (values (Float3 1 0 0) (Float3 0 1 0) (Float3 0 0 1)))
    (check-equal? (map nums (list (Float3-cross x y) (Float3-cross y z) (Float3-cross z x)))
                  (map nums (list z x y)))
    (for ([k 1000])
      (define-values (a b) (values (ordinary) (ordinary)))
      (define c (nums (Float3-cross (vec a) (vec b))))
      (for ([p c] [q (nums (Float3-cross (vec b) (vec a)))]) (check-= p (- q) 0.0))
      (match-define (list (list ax ay az) (list bx by bz)) (list (exact a) (exact b)))
      (for ([computed c] [first (list (* ay bz) (* az bx) (* ax by))]
            [second (list (* az by) (* ax bz) (* ay bx))])
        (check-true (<= (abs (- (inexact->exact computed) (- first second)))
                        (* 3 u (+ (abs first) (abs second))))))
      (check-= (dot c a) 0.0 1e-14)
      (check-= (dot c b) 0.0 1e-14)))

  (test-case "normalized: length 1 and the same direction to 4 roundings at any magnitude"
    (for ([k 1000])
      (define a (map (lambda (x) (* x (expt 2.0 (floor (uniform -1000.0 1000.0))))) (ordinary)))
      (define n (nums (Float3-normalized (vec a))))
      (define length (exact-square-root (dot (exact a) (exact a))))
      (for ([computed n] [x a])
        (check-true (<= (abs (- (inexact->exact computed) (/ (inexact->exact x) length)))
                        (* 4 u)))))
    (for ([tiny '(4.9e-324 1e-310 1.7e308)])
      (check-equal? (nums (Float3-normalized (Float3 0 (- tiny) 0))) '(0.0 -1.0 0.0)))
    (for ([bad (list (Float3 0 -0.0 0) (Float3 1 +nan.0 0) (Float3 +inf.0 0 0))])
      (check-exn #rx"^Float3-normalized: [^\n]*other than zero" (lambda () (Float3-normalized bad)))))

  (test-case "reflect: turned back by a second time, as long, as far along the normal; either side"
    (for ([k 1000])
      (define-values (v n) (values (vec (ordinary)) (Float3-normalized (vec (ordinary)))))
      (define r (Float3-reflect v n))
      (check-= (Float3-distance (Float3-reflect r n) v) 0.0 1e-14)
      (check-= (Float3-length r) (Float3-length v) 1e-14)
      (check-= (Float3-dot r n) (Float3-dot v n) 1e-14)
      (check-= (Float3-distance (Float3-reflect v (Float3-negate n)) r) 0.0 0.0))
    (check-equal? (nums (Float3-reflect (Float3 1 2 3) (Float3 0 1 0))) '(-1.0 2.0 -3.0)))

  (test-case "clamped stays inside and moves nothing that is; interpolation meets its ends"
    (for ([k 1000])
      (define-values (a b) (values (ordinary) (ordinary)))
      (for ([c (nums (Float3-clamped (vec a) -0.5 0.75))] [x a])
        (check-equal? c (max -0.5 (min 0.75 x))))
      (for ([s '(0.0 1.0 0.5)] [right (list a b (map (lambda (x y) (* 0.5 (+ x y))) a b))])
        (for ([c (nums (Float3-linear-interpolate (vec a) (vec b) s))] [x right])
          (check-= c x (* 4 u))))))

  (test-case "multiply-add and largest component, which only kernels use"
    (for ([k 2000])
      (define-values (a b s) (values (ordinary) (ordinary) (uniform -2.0 2.0)))
      (check-equal? ((function-of 'Float3-multiply-add) a (list s) b)
                    (map (lambda (x y) (+ x (* s y))) a b))
      (check-equal? ((function-of 'Float3-largest-component) a) (list (apply max a)))
      (check-equal? ((function-of 'Float3-largest-magnitude) a)
                    (list (apply max (map abs a))))))

  (test-case "any real number is a component or a scalar; anything else is refused"
    (check-equal? (nums (Float3 1 1/2 -3)) '(1.0 0.5 -3.0))
    (check-equal? (nums (Float3-scale-by-scalar (Float3 1 2 3) 1/2)) '(0.5 1.0 1.5))
    (check-equal? (match (Float3 1 2 3) [(Float3 x y z) (list z y x)]) '(3.0 2.0 1.0))
    (check-equal? (Float3 1 2 3) (Float3 1.0 2.0 3.0))
    (check-exn exn:fail:contract? (lambda () (Float3 1 2 "3")))
    (check-exn exn:fail:contract? (lambda () (Float3-add (Float3 1 2 3) 4)))))
