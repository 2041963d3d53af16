#lang racket/base
;; Instances: known ellipsoids, agreement with geometry transformed beforehand, nesting, texture
;; coordinates, materials, and rays that leave.

(module+ test
  (require racket/flonum racket/fixnum racket/list rackunit math/flonum
           (except-in "../../private/base/float3.rkt" Float3)
           "../../private/base/transform.rkt" "../../private/shape/mesh.rkt"
           "../../private/shape/sphere.rkt" "../../private/shape/instance.rkt"
           "../../private/shape/group.rkt" "../../private/shape/kernels.rkt"
           "../../private/shape/kernel.rkt" "../../private/material/phong.rkt"
           "mesh-examples.rkt" "rays.rkt")

  (define stress? (getenv "RAYTRACE_STRESS"))
  (define (float3 p) (apply make-Float3 p))
  (define (float3->list p)
    (list (Float3-x/function p) (Float3-y/function p) (Float3-z/function p)))
  (define unit-sphere (make-Sphere (make-Float3 0 0 0) 1))
  (define (surface-t s) (first s))
  (define (surface-point s) (take (drop s 1) 3))
  (define (surface-normal s) (take (drop s 4) 3))
  (define (surface-error s) (list-ref s 12))

  (test-case "H15: an ellipsoid, t to 4 ulp, normal to 1e-14"
    (define ellipsoid (make-Instance unit-sphere (Transform-scale 2 1 3)))
    (define surface (shoot-surface ellipsoid (make-Float3 5 3 4) (make-Float3 -1 -0.5 -0.7)))
    (check-true (<= (flulp-error (surface-t surface) 4.266414623965378) 4.0))
    (for ([n (surface-normal surface)]
          [e '(0.2053457748559897 0.9705330666352895 0.12608996516889792)])
      (check-= n e 1e-14))
    ;; the second root, from the point at t = 5
    (define inside (shoot-surface ellipsoid (make-Float3 0 0.5 0.5) (make-Float3 -1 -0.5 -0.7)))
    (check-true (<= (flulp-error (+ 5.0 (surface-t inside)) 6.775669544371295) 4.0)))

  (test-case "H19: a sphere scaled by 2, t = 3 and 7 along the unit direction; moved aside, a miss"
    (define big (make-Instance unit-sphere (Transform-scale 2)))
    (define z (make-Float3 0 0 1))
    (check-equal? (surface-t (shoot-surface big (make-Float3 0 0 -5) z)) 3.0)
    (check-equal? (+ 4.0 (surface-t (shoot-surface big (make-Float3 0 0 -1) z))) 7.0)
    (check-false (shoot-surface (make-Instance unit-sphere (Transform-translate 5 0 0))
                                (make-Float3 0 0 -5) z))
    ;; along a direction of another length
    (check-equal? (surface-t (shoot-surface big (make-Float3 0 0 -5) (make-Float3 0 0 4))) 0.75))

  (test-case "H20: normal of a squeezed, turned sphere, to 1e-12"
    (define squeezed
      (make-Instance unit-sphere
                     (Transform-compose (Transform-scale 1 0.5 1)
                                        (Transform-rotate (make-Float3 0 0 1)
                                                          (/ 3.141592653589793 5)))))
    ;; a ray from afar to the point (0, s, -s) scaled onto the surface: the normal is the same
    (define s (sqrt 0.5))
    (define surface
      (shoot-surface squeezed (make-Float3 0 (* 10 s) (* -10 s)) (make-Float3 0 (- s) s)))
    (for ([n (surface-normal surface)] [e '(0.0 0.9701425001453319 -0.24253562503633297)])
      (check-= n e 1e-12)))

  (define (random-transform g #:spread [spread 2.0])
    (define (u) (uniform-in g -1.0 1.0))
    (Transform-compose
     (Transform-translate (* spread (u)) (* spread (u)) (* spread (u)))
     (Transform-rotate (float3 (random-direction g)) (* 4.0 (u)))
     (Transform-scale (exp (u)) (* (if (< (u) 0.0) -1.0 1.0) (exp (u))) (exp (u)))
     (Transform-shear #:x-by-y (* 0.4 (u)) #:y-by-z (* 0.4 (u)))))

  (define (transformed-mesh mesh transform)
    (define vertices (mesh-vertices mesh))
    (make-Mesh (apply flvector
                      (append* (for/list ([v vertices])
                                 (float3->list (Transform-point transform (float3 v))))))
               (Mesh-triangles mesh)))

  (define (determinant transform)
    (define-values (a b c) (apply values (map (lambda (row) (take row 3))
                                              (Transform-matrix-rows transform))))
    (define (cross p q)
      (define-values (px py pz qx qy qz) (apply values (append p q)))
      (list (- (* py qz) (* pz qy)) (- (* pz qx) (* px qz)) (- (* px qy) (* py qx))))
    (apply + (map * a (cross b c))))

  ;; A ray at a random point of the transformed mesh, from outside.
  (define ((ray-at g mesh))
    (define vertices (mesh-vertices mesh))
    (define (pick) (vector-ref vertices (random (vector-length vertices) g)))
    (define target (map (lambda (p q s) (/ (+ p q s) 3.0)) (pick) (pick) (pick)))
    (define o (map (lambda (c d) (+ c (* 12.0 d))) target (random-direction g)))
    (values o (map - target o)))

  (test-case "an instance and the mesh transformed beforehand agree: t to 1e-11, surface to 1e-9"
    (define g (make-generator 21))
    (for ([_ 20])
      (define mesh (icosphere 2 g))
      (define transform (random-transform g))
      (define direct (transformed-mesh mesh transform))
      (define instance (make-Instance mesh transform))
      (define shot (rays 200 (ray-at g direct)))
      (define a (results-t (shoot direct shot)))
      (define b (results-t (shoot instance shot)))
      (check-true (> (count (lambda (t) (< t +inf.0)) a) 100))
      (for ([s a] [t b])
        ;; a ray along a silhouette may differ; none of these does
        (check-equal? (< s +inf.0) (< t +inf.0))
        (when (< s +inf.0) (check-= s t (* 1e-11 s))))
      (check-equal? (shoot-occluded direct shot) (shoot-occluded instance shot))
      ;; a mirrored mesh seen as an instance keeps its outside outside
      (define mirrored? (negative? (determinant transform)))
      (for ([k 50])
        (define-values (o d) ((ray-at g direct)))
        (define s1 (shoot-surface direct (float3 o) (float3 d)))
        (define s2 (shoot-surface instance (float3 o) (float3 d)))
        (when s1
          (for ([p (surface-point s1)] [q (surface-point s2)]) (check-= p q 1e-9))
          (for ([p (surface-normal s1)] [q (surface-normal s2)])
            (check-= (if mirrored? (- p) p) q 1e-9))))))

  (test-case "the identity changes nothing, to the bit"
    (define g (make-generator 22))
    (define mesh (icosphere 2 g))
    (define shot (rays 500 (ray-at g mesh)))
    (check-equal? (results-t (shoot mesh shot))
                  (results-t (shoot (make-Instance mesh (Transform-identity)) shot))))

  (test-case "instances of groups of instances, six deep, agree with one transform"
    (define g (make-generator 23))
    (define mesh (icosphere 1 g))
    (define transforms (for/list ([_ 3]) (random-transform g #:spread 1.0)))
    (define far-away (make-Instance unit-sphere (Transform-translate 1e3 1e3 1e3)))
    (define nested
      (for/fold ([inner mesh]) ([transform (reverse transforms)])
        (make-Group (list far-away (make-Instance inner transform)))))
    (define direct (transformed-mesh mesh (apply Transform-compose transforms)))
    (define shot (rays 500 (ray-at g direct)))
    (define-values (a b) (values (results-t (shoot direct shot)) (results-t (shoot nested shot))))
    (check-true (> (count (lambda (t) (< t +inf.0)) a) 200))
    (for ([s a] [t b])
      (check-equal? (< s +inf.0) (< t +inf.0))
      (when (< s +inf.0) (check-= s t (* 1e-11 s))))
    (check-equal? (shoot-occluded direct shot) (shoot-occluded nested shot))
    (for ([_ 50])
      (define-values (o d) ((ray-at g direct)))
      (define s1 (shoot-surface direct (float3 o) (float3 d)))
      (define s2 (shoot-surface nested (float3 o) (float3 d)))
      (when s1
        (for ([p (surface-point s1)] [q (surface-point s2)]) (check-= p q 1e-9)))))

  (test-case "nesting has an end, said in one line"
    (define (nest n)
      (for/fold ([shape unit-sphere]) ([_ n]) (make-Instance shape (Transform-scale 0.5))))
    (define deepest (nest 7))
    (check-= (surface-t (shoot-surface deepest (make-Float3 0 0 -5) (make-Float3 0 0 1)))
             (- 5.0 (/ 1.0 128)) 1e-15)
    (check-exn #rx"^Instance: expected shapes nested at most 7 levels deep" (lambda () (nest 8)))
    (check-exn #rx"^Group: expected shapes nested" (lambda () (make-Group (list deepest)))))

  (test-case "texture coordinates are those of the shape"
    (define g (make-generator 24))
    (for ([_ 100])
      (define transform (random-transform g))
      (define instance (make-Instance (make-Instance unit-sphere transform) (random-transform g)))
      (define p (random-direction g))
      (define d (map - p))
      (define local
        (shoot-surface unit-sphere (float3 (map (lambda (c) (* 2.0 c)) p)) (float3 d)))
      (define outer (Instance-transform instance))
      (define (out p) (Transform-point outer (Transform-point transform (float3 p))))
      (define o (out (map (lambda (c) (* 2.0 c)) p)))
      (define world
        (shoot-surface instance o (Transform-vector outer (Transform-vector transform (float3 d)))))
      (check-= (list-ref local 10) (list-ref world 10) 1e-12)
      (check-= (list-ref local 11) (list-ref world 11) 1e-12)))

  (test-case "rays that leave an instance do not meet it again, wherever it is and however small"
    (define g (make-generator 25))
    (define body (icosphere 2))
    (define count (if stress? 100000 3000))
    (for* ([offset '(0.0 1e3 1e6)] [size '(1e-3 1.0 1e3)] [shape (list body unit-sphere)])
      (define at (list offset (* -0.3 offset) (* 0.7 offset)))
      (define instance
        (make-Instance
         shape
         (Transform-compose (Transform-translate (float3 at))
                            (Transform-scale size)
                            (Transform-rotate (float3 (random-direction g)) 1.0)
                            (Transform-scale 1 0.1 3))))
      (define shot
        (rays count
              (lambda ()
                (define aim (map (lambda (c d) (+ c (* 0.05 size d))) at (random-direction g)))
                (define o (map (lambda (c d) (+ c (* 9.0 size d))) at (random-direction g)))
                (values o (map - aim o)))))
      (define leaving (make-flvector (* 3 count)))
      (for ([k count])
        (for ([x (random-direction g)] [axis 3]) (flvector-set! leaving (+ axis (* 3 k)) x)))
      (check-true (> (hit-count instance shot) (* 0.9 count)))
      (check-equal? (leave-count instance shot leaving) 0)))

  (test-case "the bound on the point's error is met and not large"
    (define g (make-generator 26))
    (for ([_ 200])
      (define offset (vector-ref #(0.0 1e6) (random 2 g)))
      (define transform
        (Transform-compose (Transform-translate offset offset offset) (random-transform g)))
      (define mesh (icosphere 0))
      (define instance (make-Instance mesh transform))
      (define center (float3->list (Transform-point transform (make-Float3 0 0 0))))
      (define o (map (lambda (c d) (+ c (* 12.0 d))) center (random-direction g)))
      (define surface (shoot-surface instance (float3 o) (float3 (map - center o))))
      ;; distance from the plane of the exactly transformed triangle
      (define rows (map (lambda (row) (map inexact->exact row)) (Transform-matrix-rows transform)))
      (define (image p)
        (for/list ([row rows])
          (+ (apply + (map * (take row 3) (map inexact->exact p))) (cadddr row))))
      (define vertices (mesh-vertices mesh))
      (define point (map inexact->exact (surface-point surface)))
      (define distances
        (for/list ([k 20])
          (define-values (a b c)
            (apply values
                   (for/list ([j 3])
                     (define vertex (fxvector-ref (Mesh-triangles mesh) (+ j (* 3 k))))
                     (image (vector-ref vertices vertex)))))
          (define-values (u v) (values (map - b a) (map - c a)))
          (define across
            (list (- (* (second u) (third v)) (* (third u) (second v)))
                  (- (* (third u) (first v)) (* (first u) (third v)))
                  (- (* (first u) (second v)) (* (second u) (first v)))))
          (/ (abs (exact->inexact (apply + (map * across (map - point a)))))
             (sqrt (exact->inexact (apply + (map * across across)))))))
      (define distance (apply min distances))
      (check-true (<= distance (* 0.5 (surface-error surface))))
      (check-true (< (surface-error surface) (* 3e-13 (+ 10.0 offset))))))

  (test-case "materials: the part's own, or the instance's instead"
    (define-values (red green blue)
      (values (make-Phong (make-Float3 1 0 0)) (make-Phong (make-Float3 0 1 0))
              (make-Phong (make-Float3 0 0 1))))
    (define (number material)
      (cond [(eq? material red) 0] [(eq? material green) 1] [(eq? material blue) 2] [else 9]))
    (define a (make-Sphere (make-Float3 0 0 0) 1 #:material red))
    (define b (make-Sphere (make-Float3 5 0 0) 1 #:material green))
    (define (look shape x)
      (shoot-material shape (make-Float3 x 0 -9) (make-Float3 0 0 1) number))
    (define group (make-Group (list a b)))
    (check-equal? (list (look group 0) (look group 5) (look group 2.5)) '(0 1 #f))
    (check-equal? (look a 0) -2)
    (define moved (make-Instance group (Transform-translate 1 0 0)))
    (check-equal? (list (look moved 1) (look moved 6)) '(0 1))
    (define painted (make-Instance group (Transform-translate 1 0 0) #:material blue))
    (check-equal? (list (look painted 1) (look painted 6)) '(2 2))
    (define mixed (make-Group (list (make-Instance painted (Transform-translate 0 3 0)) moved
                                    (make-Instance a (Transform-translate 9 0 0)))))
    (check-equal? (list (look mixed 1) (look mixed 6) (look mixed 9)) '(0 1 0)))

  (test-case "scaled by a power of two, every hit is the same to the bit"
    (define (scene size)
      (make-Instance (icosphere 1 (make-generator 1))
                     (Transform-compose (Transform-translate (* 3.0 size) 0.0 size)
                                        (Transform-scale size)
                                        (Transform-rotate (make-Float3 1 2 3) 0.5))))
    (define (shot size)
      (define g (make-generator 2))
      (rays 500 (lambda ()
                  (define d (random-direction g))
                  (values (map (lambda (x c) (* size (- c (* 6.0 x)))) d '(3.0 0.0 1.0)) d))))
    (define size (expt 2.0 30))
    (define-values (one two)
      (values (results-t (shoot (scene 1.0) (shot 1.0)))
              (results-t (shoot (scene size) (shot size)))))
    (check-true (> (count (lambda (t) (< t +inf.0)) one) 400))
    (check-equal? (map (lambda (t) (* size t)) one) two)))
