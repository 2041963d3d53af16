#lang racket/base
;; Groups: the same hits as trying every part, ties, parts without a box, shared parts.

(module+ test
  (require racket/flonum racket/list rackunit
           (except-in "../../private/base/float3.rkt" Float3)
           "../../private/base/transform.rkt" "../../private/shape/mesh.rkt"
           "../../private/shape/sphere.rkt" "../../private/shape/plane.rkt"
           "../../private/shape/instance.rkt" "../../private/shape/group.rkt"
           "../../private/shape/kernels.rkt" "../../private/shape/kernel.rkt"
           "mesh-examples.rkt" "rays.rkt")

  (define (float3 p) (apply make-Float3 p))

  ;; The nearest of the parts' own hits and the first part that has it.
  (define (by-scan parts shot)
    (define each (for/list ([part parts]) (results-t (shoot part shot))))
    (for/list ([k (quotient (flvector-length shot) 6)])
      (for/fold ([best (cons +inf.0 -1)]) ([ts each] [part (in-naturals)])
        (define t (list-ref ts k))
        (if (< t (car best)) (cons t part) best))))

  (define (results->pairs results) (map cons (results-t results) (results-first results)))

  (test-case "what the group finds is the nearest of what its parts find, and the first of equals"
    (define g (make-generator 31))
    (define (somewhere) (float3 (map (lambda (c) (* 5.0 c)) (random-direction g))))
    (define mesh (icosphere 1 g))
    (for ([extra (list '() (list (make-Plane (make-Float3 0 -4 0) (make-Float3 0 1 0))))])
      (define parts
        (append
         (for/list ([_ 20]) (make-Sphere (somewhere) (uniform-in g 0.3 1.5)))
         extra
         (for/list ([_ 20])
           (make-Instance mesh (Transform-compose (Transform-translate (somewhere))
                                                  (Transform-scale (uniform-in g 0.3 1.0)))))))
      ;; every part twice: each hit is a tie
      (define group (make-Group (append parts parts)))
      (define shot
        (rays 400 (lambda ()
                    (define o (map (lambda (c) (* 9.0 c)) (random-direction g)))
                    (define p (map (lambda (c) (* 4.0 c)) (random-direction g)))
                    (values o (map - p o)))))
      (define expected (by-scan parts shot))
      (for ([found (results->pairs (shoot group shot))] [e expected]) (check-equal? found e))
      (check-equal? (shoot-occluded group shot) (count (lambda (e) (>= (cdr e) 0)) expected))
      ;; nothing at the limit, with the limit at a hit
      (check-true (> (count (lambda (e) (>= (cdr e) 0)) expected) 100))))

  (test-case "an empty group, and a group of empty groups"
    (define shot (rays 1 (lambda () (values '(0 0 -9) '(0 0 1)))))
    (check-equal? (hit-count (make-Group '()) shot) 0)
    (check-equal? (hit-count (make-Group (list (make-Group '()) (make-Group '()))) shot) 0)
    (check-equal? (shoot-occluded (make-Group '()) shot) 0))

  (test-case "groups in groups keep the path and the stack apart"
    (define g (make-generator 32))
    (define (ball x y z) (make-Sphere (make-Float3 x y z) 0.4))
    (define balls
      (for*/list ([x 4] [y 4] [z 4]) (ball (* 1.0 x) (* 1.0 y) (* 1.0 z))))
    (define flat (make-Group balls))
    (define-values (groups-of-4)
      (let loop ([rest balls])
        (if (null? rest) '() (cons (make-Group (take rest 4)) (loop (drop rest 4))))))
    (define deep
      (for/fold ([inner (make-Group groups-of-4)]) ([_ 4])
        (make-Group (list inner (ball 1e3 0.0 0.0)))))
    (define shot
      (rays 1000 (lambda ()
                   (define o (map (lambda (c) (+ 1.5 (* 9.0 c))) (random-direction g)))
                   (define p (map (lambda (c) (+ 1.5 (* 2.0 c))) (random-direction g)))
                   (values o (map - p o)))))
    (check-equal? (results-t (shoot flat shot)) (results-t (shoot deep shot)))
    (check-equal? (shoot-occluded flat shot) (shoot-occluded deep shot))
    ;; the surface found through the path is the one the ray met
    (for ([_ 200])
      (define o (map (lambda (c) (+ 1.5 (* 9.0 c))) (random-direction g)))
      (define d (map (lambda (c) (- 1.5 c)) o))
      (check-equal? (shoot-surface flat (float3 o) (float3 d))
                    (shoot-surface deep (float3 o) (float3 d)))))

  (test-case "the stack fits, at the deepest nesting of the deepest hierarchies"
    (define many (points->mesh '((0 0 0) (1 0 0) (0 1 0)) (for/list ([_ 5000]) '(0 1 2))))
    (define deep
      (for/fold ([inner many]) ([_ 7])
        (make-Group (append (for/list ([_ 50]) (make-Sphere (make-Float3 0 0 0) 1)) (list inner)))))
    (define kernel (Shape-kernel deep))
    (check-true (<= (ShapeKernel-stack kernel) 900))
    (define shot (rays 1 (lambda () (values '(0.25 0.25 -2.0) '(0 0 1)))))
    (check-= (first (results-t (shoot deep shot))) (- 2.0 (sqrt (- 1.0 0.125))) 1e-15))

  (test-case "10^4 instances of one mesh share it: less than 2000 bytes for each one more"
    (define mesh (icosphere 4))
    (Shape-kernel mesh)
    (collect-garbage)
    (define before (current-memory-use))
    (define group
      (make-Group (for*/list ([x 100] [z 100])
                    (make-Instance mesh (Transform-translate (* 3.0 x) 0.0 (* 3.0 z))))))
    (define kernel (Shape-kernel group))
    (collect-garbage)
    (define used (- (current-memory-use) before))
    (printf "instances: ~a bytes each\n" (quotient used 10000))
    (check-true (< used (* 2000 10000)))
    (check-true (procedure? (ShapeKernel-nearest kernel)))
    (define g (make-generator 33))
    (define shot
      (rays 2000 (lambda ()
                   (define target (list (* 3.0 (random 100 g)) 0.0 (* 3.0 (random 100 g))))
                   (define o (map + target '(0.1 5.0 0.2)))
                   (values o (map - target o)))))
    (check-equal? (hit-count group shot) 2000)))
