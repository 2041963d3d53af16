#lang racket/base
;; Watertight triangles against the textbook's test, which lets rays through at edges.

(module+ test
  (require racket/flonum rackunit "../../main.rkt" "../bench/moller-trumbore.rkt"
           (only-in "mesh-examples.rkt" bumpy-sphere make-generator random-direction rays
                    aimed-rays))

  (define model (bumpy-sphere 60 50))
  (define-values (watertight leaky)
    (values (shape-kernels model) (leaky-kernels (Mesh-positions model) (Mesh-triangles model))))
  (define g (make-generator 3))
  (define shot
    (rays 50000
          (lambda ()
            (define o (map (lambda (c) (* 2.0 c)) (random-direction g)))
            (define target (map (lambda (c) (* 2.0 (random g) c)) (random-direction g)))
            (values o (map - target o)))))

  (test-case "random rays from outside: the same hits, t to 1e-10, but for 1 in 10,000 at edges"
    (define-values (right found)
      (values (hit-parameters (car leaky) shot) (hit-parameters (car watertight) shot)))
    (define-values (hits different)
      (for/fold ([hits 0] [different 0]) ([a (in-flvector right)] [b (in-flvector found)])
        (values (if (< a +inf.0) (+ hits 1) hits)
                (if (or (= a b) (<= (abs (- a b)) 1e-10)) different (+ different 1)))))
    (check-true (> 45000 hits 20000) (format "~a hits" hits))
    (check-true (<= different 5) (format "~a rays differ" different)))

  (test-case "any-hit kernels count the same hits, but for 1 in 10,000"
    (define-values (a b) (values (count-hits (cadr leaky) shot) (count-hits (cadr watertight) shot)))
    (check-= a b 5))

  (test-case "rays from inside at vertices: none leaves, but between the textbook's triangles"
    (define aimed (aimed-rays g model 20000 'vertex #f))
    (check-equal? (count-hits (car watertight) aimed) 20000)
    (check-equal? (count-hits (cadr watertight) aimed) 20000)
    (check-true (< (count-hits (car leaky) aimed) 19900))))
