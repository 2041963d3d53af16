#lang racket/base
;; Reading by extension: spheres in every format, progress, linear time, and what is no mesh file.

(module+ test
  (require rackunit
           racket/file
           racket/fixnum
           racket/flonum
           "../../private/read/mesh.rkt"
           "mesh-files.rkt"
           "sphere-files.rkt")

  (define (extension kind)
    (string-append "." (substring (symbol->string kind) 0 3)))

  (define (call-with-sphere kind rings proc)
    (call-with-folder '()
                      (λ (folder)
                        (define path (build-path folder (string-append "sphere" (extension kind))))
                        (write-sphere kind rings path)
                        (proc path))))

  ;; Six times the volume the triangles enclose, turning the same way round all of them.
  (define (volume mesh)
    (define p (mesh-data-positions mesh))
    (define t (mesh-data-triangles mesh))
    (define (at corner axis) (flvector-ref p (+ axis (* 3 (fxvector-ref t corner)))))
    (for/sum ([i (in-range 0 (fxvector-length t) 3)])
      (define-values (ax ay az) (values (at i 0) (at i 1) (at i 2)))
      (define-values (bx by bz) (values (at (+ i 1) 0) (at (+ i 1) 1) (at (+ i 1) 2)))
      (define-values (cx cy cz) (values (at (+ i 2) 0) (at (+ i 2) 1) (at (+ i 2) 2)))
      (+ (* ax (- (* by cz) (* bz cy)))
         (* ay (- (* bz cx) (* bx cz)))
         (* az (- (* bx cy) (* by cx))))))

  (test-case "the same sphere in every format; volumes agree to 1e-6, single precision"
    (define rings 12)
    (define expected-volume
      (call-with-sphere 'obj-plain rings (λ (path) (volume (read-mesh path)))))
    ;; Inscribed in the unit sphere, whose six volumes are 8 pi, and seen from outside.
    (check-true (< 20.0 expected-volume 25.14))
    (for ([kind (in-list sphere-kinds)])
      (call-with-sphere
       kind rings
       (λ (path)
         (define fractions '())
         (define mesh
           (read-mesh path #:progress (λ (fraction) (set! fractions (cons fraction fractions)))))
         (check-equal? (fxvector-length (mesh-data-triangles mesh))
                       (* 3 (sphere-triangle-count rings)))
         (check-equal? (flvector-length (mesh-data-positions mesh))
                       (* 3 (sphere-vertex-count rings)))
         (check-equal? (mesh-data-warnings mesh) '())
         (check-equal? (and (mesh-data-normals mesh) #t) (eq? kind 'obj-normals))
         (check-= (volume mesh) expected-volume 1e-6)
         (check-equal? (car fractions) 1.0)
         (check-true (<= 10 (length fractions) 110))
         (check-true (apply >= fractions))
         (check-true (andmap (λ (f) (<= 0.0 f 1.0)) fractions))))))

  ;; Allocation counts every push, box and growth: it would quadruple if any of them were quadratic.
  ;; Time is printed, not judged.
  (define (measure kind rings)
    (call-with-sphere
     kind rings
     (λ (path)
       (collect-garbage)
       (define bytes-before (current-memory-use 'cumulative))
       (define time-before (current-process-milliseconds))
       (read-mesh path)
       (define time (- (current-process-milliseconds) time-before))
       (define allocated (- (current-memory-use 'cumulative) bytes-before))
       (printf "~a: ~a triangles, ~a MB, ~a ms, ~a bytes allocated\n" kind
               (sphere-triangle-count rings) (quotient (file-size path) 1000000) time allocated)
       allocated)))

  (test-case "twice the triangles, at most 2.6 times the allocation (doubling growth included)"
    (for ([kind (in-list '(obj-plain ply-little stl-binary))])
      (define small (measure kind 224))
      (define large (measure kind 317))
      (check-true (< (/ large small) 2.6))))

  (when (getenv "RAYTRACE_STRESS")
    (test-case "a million triangles in every format"
      (for ([kind (in-list sphere-kinds)])
        (check-true (< (measure kind 708) 4000000000)))))

  (test-case "what is no mesh file"
    (define (check path pattern)
      (check-exn (λ (e) (and (exn:fail:user? e) (regexp-match? pattern (exn-message e))))
                 (λ () (read-mesh path))))
    (for ([name (in-list '("a.png" "a" ".obj" "a.obj.gz"))])
      (check name #rx"^[^\n]*: expected a mesh file whose name ends in .obj, .ply or .stl$"))
    (for ([name (in-list '("none.obj" "none.PLY" "no\nne.stl"))])
      (check name #rx"^no.?ne.[a-zA-Z]*: no such file$"))
    (call-with-folder
     (list (cons "sphere.OBJ" #"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"))
     (λ (folder)
       (check-equal? (triangle-list (read-mesh (path->string (build-path folder "sphere.OBJ"))))
                     '((0 1 2)))
       (make-directory (build-path folder "folder.obj"))
       (check (build-path folder "folder.obj") #rx"^[^\n]*: expected a file, found a directory$")))))
