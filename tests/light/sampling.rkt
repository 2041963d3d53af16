#lang racket/base
;; Directions sampled towards every kind of light against their density: chi-square at level .01 for
;; the whole family (Sidak), independent samples; the density integrates to 1 (2e-3 where most of the
;; sphere's bins have an edge of the light in them), and is the one that a ray that hits the light is
;; told, to a relative 1e-6. 50,000 samples, 10^6 in four times the bins when RAYTRACE_STRESS is set.

(module+ test
  (require racket/flonum racket/fixnum racket/list racket/math rackunit "../../main.rkt"
           "../statistics.rkt"
           "../material/chi-square.rkt" "light-samples.rkt" "light-densities.rkt")

  (define black (Float3 0 0 0))
  (define shining (Emitter (Float3 1 1 1)))
  (define both (Emitter (Float3 1 1 1) #:two-sided? #t))
  (define origin black)

  ;; a roof of two triangles that faces down
  (define roof
    (Mesh (flvector -1.0 0.0 0.5  1.0 0.0 0.5  0.9 1.2 1.4  -1.0 1.0 1.0  0.8 -1.5 0.9)
          (fxvector 0 2 1 0 3 2 0 1 4) #:material both))
  (define turn
    (Transform-compose (Transform-translate 0.3 0.2 0.4) (Transform-rotate (Float3 1 -2 1) 0.5)
                       (Transform-scale 1.4)))

  ;; name, the light's shape, the point it is seen from
  (define family
    (list (list "sphere, outside" (Sphere (Float3 0.4 0.3 1.2) 1 shining) origin)
          (list "sphere, far" (Sphere (Float3 3 2 6) 1 shining) origin)
          (list "sphere, inside" (Sphere (Float3 0.3 0.1 0.5) 1 both) origin)
          (list "rectangle"
                (Quad (Float3 -1 -0.7 0.6) (Float3 0 2 0) (Float3 1.5 0 0) shining) origin)
          (list "rectangle, wide"
                (Quad (Float3 -3 -2 0.3) (Float3 0 6 0) (Float3 5 0 0) shining) origin)
          (list "rectangle, from behind"
                (Quad (Float3 -1 -0.7 0.6) (Float3 1.5 0 0) (Float3 0 2 0) both) origin)
          (list "parallelogram" (Quad (Float3 -1 -1 0.8) (Float3 0.3 2 0) (Float3 2 0.4 0.5) both)
                origin)
          (list "disk" (Disk (Float3 0.4 -0.3 0.7) (Float3 0.2 0.3 -1) 1 shining) origin)
          (list "triangle" (Triangle (Float3 -1 -1 0.5) (Float3 0.2 1.2 1) (Float3 1.3 -0.6 0.8) both)
                origin)
          (list "box, three faces" (Box (Float3 0.3 0.4 0.5) (Float3 1.5 1.2 1.3) shining) origin)
          (list "box, one face" (Box (Float3 -0.6 -0.4 0.5) (Float3 0.8 0.5 1.3) shining) origin)
          (list "box, inside" (Box (Float3 -0.6 -0.4 -0.5) (Float3 0.8 0.5 1.3) both) origin)
          (list "mesh" roof (Float3 0.1 0.2 -0.2))
          (list "rectangle in an instance"
                (Instance (Quad (Float3 -1 -0.7 0.6) (Float3 0 2 0) (Float3 1.5 0 0) both) turn)
                origin)
          (list "mesh in an instance in a group" (Group (list (Instance roof turn)))
                (Float3 0.1 0.2 -0.4))))

  (define count (stressed 50000 1000000))
  (define-values (theta-bins phi-bins) (if stress? (values 40 80) (values 20 40)))
  (define level (sidak-level 0.01 (length family)))

  (for ([member (in-list family)] [seed (in-naturals)])
    (define-values (name shape point) (apply values member))
    (test-case name
      (define world (World (list shape) '() black))
      (define density (make-light-density world point))
      (define uniform (seeded seed))
      (define unlike 0)
      (define result
        (chi-square-test
         (lambda (k)
           (define s (sample-light world point (uniform) (uniform)))
           (define-values (x y z) (values (first s) (second s) (third s)))
           (define own (eighth s))
           (unless (<= (abs (- (density x y z) own)) (* 1e-6 own)) (set! unlike (+ unlike 1)))
           (and (> own 0.0) (flvector x y z)))
         density count #:theta-bins theta-bins #:phi-bins phi-bins
         #:halvings 5))
      (define p (chi-square-result-p result))
      (when stress?
        (printf "~a: p = ~a, density sums to ~a\n" name p (chi-square-result-integral result)))
      (check-equal? (chi-square-result-missing result) 0)
      ;; a ray to the very edge may miss
      (check-true (<= unlike (* 1e-4 count)) (format "~a of ~a told otherwise" unlike count))
      (check-= (chi-square-result-integral result) 1.0 2e-3)
      (check-true (> p level) (format "p = ~a" p)))))
