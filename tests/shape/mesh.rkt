#lang racket/base
;; Meshes: no ray slips through, the hierarchy changes nothing, surfaces, and what is refused.

(module+ test
  (require racket/flonum racket/fixnum racket/list rackunit
           (except-in "../../private/base/float3.rkt" Float3)
           "../../private/shape/mesh.rkt" "../../private/shape/kernels.rkt"
           "../../private/shape/kernel.rkt" "../../private/shape/triangle.rkt"
           "mesh-examples.rkt" "rays.rkt")

  (define stress? (getenv "RAYTRACE_STRESS"))

  (define (cross p q)
    (define-values (px py pz qx qy qz) (apply values (append p q)))
    (list (- (* py qz) (* pz qy)) (- (* pz qx) (* px qz)) (- (* px qy) (* py qx))))

  (test-case "S05, S06: rays from inside at edges and vertices: 0 leaks"
    (define g (make-generator 5))
    (define shots 0)
    (define count (if stress? 100000 1500))
    (define leaks
      (for*/sum ([offset '(0.0 1e3 1e6)] [raw? '(#t #f)] [target '(edge vertex)]
                 [body (in-range (if stress? 10 6))])
        (define at (list offset (* 0.5 offset) (- offset)))
        (define mesh
          (if (even? body) (tetrahedron g #:offset at) (icosphere 2 g #:offset at)))
        (define shot (aimed-rays g mesh count target raw? #:offset at))
        (set! shots (+ shots count))
        (define missed (- count (hit-count mesh shot)))
        (define unoccluded (- count (shoot-occluded mesh shot)))
        (+ missed unoccluded)))
    (printf "watertight: ~a leaks among ~a rays at edges and vertices\n" leaks shots)
    (check-equal? leaks 0))

  (test-case "rays from inside a bumpy sphere: 0 leaks among 10^5"
    (define g (make-generator 6))
    (define mesh (bumpy-sphere 40 60))
    (define count (if stress? 10000000 100000))
    (define leaks
      (for/sum ([_ (quotient count 100000)])
        (define shot
          (rays 100000 (lambda () (values (map (lambda (c) (* 0.5 c)) (random-direction g))
                                          (random-direction g)))))
        (- 100000 (hit-count mesh shot))))
    (printf "watertight: ~a leaks among ~a rays from inside\n" leaks count)
    (check-equal? leaks 0))

  (test-case "the hierarchy finds what trying every triangle finds: t and triangle identical"
    (define g (make-generator 7))
    (for ([mesh (list (icosphere 3) (icosphere 3 g)
                      (icosphere 2 g #:offset '(1e6 3e5 -1e6))
                      (icosphere 2 #:scale 1e-9) (bumpy-sphere 12 20))])
      (define vertices (mesh-vertices mesh))
      (define middle
        (map (lambda (c) (/ c (vector-length vertices)))
             (for/fold ([sum '(0.0 0.0 0.0)]) ([v vertices]) (map + sum v))))
      (define size
        (sqrt (apply + (map (lambda (a b) (* (- a b) (- a b))) (vector-ref vertices 0) middle))))
      (define (random-point s)
        (map (lambda (m d) (+ m (* s size d))) middle (random-direction g)))
      (define random-rays
        (rays 2000 (lambda ()
                     (define o (random-point (uniform-in g 0.0 3.0)))
                     (values o (map - (random-point (random g)) o)))))
      ;; at vertices and edges from far outside, where triangles tie
      (define ties
        (for/list ([target '(vertex edge)])
          (aimed-rays g mesh 2000 target #t #:offset (random-point 5.0) #:inside 0.0)))
      (for ([shot (cons random-rays ties)])
        (define fast (shoot mesh shot))
        (define slow (shoot-by-scan mesh shot))
        (check-true (> (count (lambda (k) (>= k 0)) (results-first slow)) 200))
        (check-equal? fast slow)
        ;; occlusion agrees
        (check-equal? (shoot-occluded mesh shot)
                      (count (lambda (k) (>= k 0)) (results-first slow))))))

  (test-case "of equally near triangles the lowest number is hit, whatever their order"
    (define corners '((0 0 0) (1 0 0) (0 1 0) (0 0 9) (1 0 9) (0 1 9)))
    (define shot (rays 1 (lambda () (values '(0.2 0.2 -1.0) '(0.0 0.0 1.0)))))
    (for ([n '(2 3 5 40)])
      (define mesh
        (points->mesh corners (append '((3 4 5)) (for/list ([_ n]) '(0 1 2)))))
      (check-equal? (shoot mesh shot) (flvector 1.0 1.0))))

  (test-case "the limit ends a ray: nothing at it, something before it"
    (define mesh (points->mesh '((0 0 0) (1 0 0) (0 1 0)) '((0 1 2))))
    (define shot (rays 1 (lambda () (values '(0.25 0.25 -2.0) '(0.0 0.0 1.0)))))
    (check-equal? (list (hit-count mesh shot 2.0) (hit-count mesh shot 2.0000000000000004)
                        (shoot-occluded mesh shot 2.0)
                        (shoot-occluded mesh shot 2.0000000000000004))
                  '(0 1 0 1)))

  (test-case "rays that leave the surface do not meet it again: 0 of 10^4 on a convex body"
    (define g (make-generator 8))
    (for ([mesh (list (icosphere 2) (icosphere 2 #:offset '(1e6 -3e5 1e5))
                      (icosphere 2 #:scale 1e-9) (tetrahedron g))]
          [offset '((0.0 0.0 0.0) (1e6 -3e5 1e5) (0.0 0.0 0.0) (0.0 0.0 0.0))]
          [size '(1.0 1.0 1e-9 1.0)])
      (define count (if stress? 100000 10000))
      (define shot
        (rays count (lambda ()
                      (define d (random-direction g))
                      (define o (map (lambda (c x) (+ c (* -5.0 size x))) offset d))
                      (define aim (map (lambda (c x) (+ c (* 0.5 size x))) offset
                                       (random-direction g)))
                      (values o (map - aim o)))))
      (define leaving (make-flvector (* 3 count)))
      (for ([k count])
        (for ([x (random-direction g)] [axis 3]) (flvector-set! leaving (+ axis (* 3 k)) x)))
      (check-equal? (leave-count mesh shot leaving) 0)))

  (test-case "the surface: point within its error bound, normals, uv"
    (define g (make-generator 9))
    (for ([_ 300])
      (define offset (vector-ref #(0.0 10.0 1e6) (random 3 g)))
      (define (corner) (map (lambda (x) (+ offset x)) (random-direction g)))
      (define-values (a b c) (values (corner) (corner) (corner)))
      (define (float3 p) (apply make-Float3 p))
      (define normals
        (apply flvector
               (append* (for/list ([_ 3]) (map (lambda (x) (* 3.0 x)) (random-direction g))))))
      (define mesh
        (make-Mesh (apply flvector (append a b c)) (fxvector 0 1 2) #:normals normals
                   #:uvs (flvector 0.0 0.0 2.0 0.0 0.0 3.0)))
      (define-values (v w) (let ([x (random g)] [y (random g)])
                             (if (> (+ x y) 1.0) (values (- 1.0 x) (- 1.0 y)) (values x y))))
      (define target
        (map (lambda (a b c) (+ (* (- 1.0 v w) a) (* v b) (* w c))) a b c))
      (define d (random-direction g))
      (define o (map (lambda (p x) (- p (* 4.0 x))) target d))
      (define surface (shoot-surface mesh (float3 o) (float3 d)))
      (define normal (triangle-normal (float3 a) (float3 b) (float3 c)))
      (define facing (abs (Float3-dot/function normal (float3 d))))
      (when (and surface (> facing 0.05))
        (define-values (t point n s u v* bound)
          (values (first surface) (take (drop surface 1) 3) (take (drop surface 4) 3)
                  (take (drop surface 7) 3) (list-ref surface 10) (list-ref surface 11)
                  (list-ref surface 12)))
        ;; distance from the plane, exactly
        (define exact (map inexact->exact point))
        (define-values (ea eb ec) (values (map inexact->exact a) (map inexact->exact b)
                                          (map inexact->exact c)))
        (define across (cross (map - eb ea) (map - ec ea)))
        (define distance
          (/ (abs (exact->inexact (apply + (map * across (map - exact ea)))))
             (sqrt (exact->inexact (apply + (map * across across))))))
        (check-true (<= distance (* 0.75 bound)))
        (check-true (< bound (* 1e-14 (+ 3.0 (abs offset)))))
        (for ([x n] [e (list (Float3-x/function normal) (Float3-y/function normal)
                             (Float3-z/function normal))])
          (check-= x e 1e-9))
        (check-true (>= (apply + (map * n s)) 0.0))
        (check-= (apply + (map * s s)) 1.0 1e-14)
        ;; the weights, within what the ray's own rounding at this distance allows
        (define slack (* 1e-13 (+ 1.0 offset) 100.0))
        (check-= u (* 2.0 v) slack)
        (check-= v* (* 3.0 w) slack))))

  (test-case "without normals and uvs: flat, and the weights; opposed normals are turned"
    (define positions (flvector 0.0 0.0 0.0 1.0 0.0 0.0 0.0 1.0 0.0))
    (define (look mesh) (shoot-surface mesh (make-Float3 0.25 0.5 3) (make-Float3 0 0 -1)))
    (check-equal? (look (make-Mesh positions (fxvector 0 1 2)))
                  (append '(3.0 0.25 0.5 0.0 0.0 0.0 1.0 0.0 0.0 1.0 0.25 0.5)
                          (list (* 16 (expt 2.0 -53) 2.0))))
    (define turned
      (look (make-Mesh positions (fxvector 0 1 2)
                       #:normals (flvector 0.0 0.0 -1.0 0.0 0.0 -2.0 0.0 0.0 -3.0))))
    (check-equal? (take (drop turned 7) 3) '(-0.0 -0.0 1.0))
    ;; blended normals that cancel leave the geometric one
    (define cancelled
      (shoot-surface (make-Mesh positions (fxvector 0 1 2)
                                #:normals (flvector 0.0 0.0 0.0 1.0 0.0 0.0 -1.0 0.0 0.0))
                     (make-Float3 0.25 0.25 3) (make-Float3 0 0 -1)))
    (check-equal? (take (drop cancelled 7) 3) '(0.0 0.0 1.0)))

  (test-case "an empty mesh, triangles without area, one triangle: all can be asked"
    (define shot (rays 1 (lambda () (values '(0.25 0.25 -2.0) '(0.0 0.0 1.0)))))
    (check-equal? (hit-count (make-Mesh (flvector) (fxvector)) shot) 0)
    (define lines
      (points->mesh '((0 0 0) (1 1 0) (0.5 0.5 0) (1 0 0) (0 1 0)) '((0 1 2) (0 0 1) (3 3 3))))
    (check-equal? (hit-count lines shot) 0)
    (define mixed
      (points->mesh '((0 0 0) (1 1 0) (0.5 0.5 0) (1 0 0) (0 1 0)) '((0 1 2) (0 0 1) (0 3 4))))
    (check-equal? (shoot mixed shot) (flvector 2.0 2.0)))

  (test-case "10^4 triangles in one place do not make a deep hierarchy"
    (define mesh
      (points->mesh '((0 0 0) (1 0 0) (0 1 0)) (for/list ([_ 10000]) '(0 1 2))))
    (check-true (< (ShapeKernel-stack (Shape-kernel mesh)) 70))
    (check-equal? (hit-count mesh (rays 1 (lambda () (values '(0.25 0.25 -2.0) '(0 0 1))))) 1))

  (test-case "scaled by a power of two, every hit is the same to the bit"
    (define g (make-generator 10))
    (define mesh (icosphere 2 (make-generator 1)))
    (define small (icosphere 2 (make-generator 1) #:scale (expt 2.0 -40)))
    (define (shot size)
      (define g (make-generator 11))
      (rays 1000 (lambda ()
                   (values (map (lambda (x) (* 3.0 size x)) (random-direction g))
                           (random-direction g)))))
    (define one (shoot mesh (shot 1.0)))
    (define two (shoot small (shot (expt 2.0 -40))))
    (check-equal? (results-first one) (results-first two))
    (check-equal? (results-t one) (map (lambda (t) (* t (expt 2.0 40))) (results-t two))))

  (test-case "what is refused, in one line"
    (define-syntax-rule (check-refused pattern form)
      (check-exn (lambda (e)
                   (and (exn:fail:contract? e)
                        (regexp-match? pattern (exn-message e))
                        (not (regexp-match? #rx"\n" (exn-message e)))))
                 (lambda () form)))
    (define positions (flvector 0.0 0.0 0.0 1.0 0.0 0.0 0.0 1.0 0.0))
    (check-refused #rx"^Mesh: expected three coordinates a vertex as positions, given 4"
                   (make-Mesh (flvector 1.0 2.0 3.0 4.0) (fxvector)))
    (check-refused #rx"three vertices a triangle" (make-Mesh positions (fxvector 0 1)))
    (check-refused #rx"a vertex number below 3 at place 2 as triangles, given 3"
                   (make-Mesh positions (fxvector 0 1 3)))
    (check-refused #rx"a vertex number below 3" (make-Mesh positions (fxvector 0 -1 2)))
    (check-refused #rx"a finite number at place 1 as positions"
                   (make-Mesh (flvector 1.0 +nan.0 1.0) (fxvector)))
    (check-refused #rx"three numbers a vertex as #:normals"
                   (make-Mesh positions (fxvector 0 1 2) #:normals (flvector 1.0)))
    (check-refused #rx"two numbers a vertex as #:uvs"
                   (make-Mesh positions (fxvector 0 1 2) #:uvs (flvector 1.0))))

  (test-case "it prints without its vectors"
    (check-equal? (format "~a" (icosphere 1)) "#<Mesh: 80 triangles, 42 vertices>")))
