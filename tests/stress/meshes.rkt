#lang racket/base
;; S05, S06, S07, S11, S32: closed meshes let no ray through, hierarchies change nothing,
;; degenerate triangles are never hit, lines cross closed surfaces an even number of times.

(provide cases)

(require racket/flonum racket/fixnum racket/list "case.rkt" "../../main.rkt"
         "../shape/mesh-examples.rkt" "../shape/rays.rkt"
         (prefix-in probe: "../shape/probe.rkt")
         "../world/worlds.rkt" (only-in "../world/rays.rkt" compare-with-scan))

(define BATCH 50000)

;; --- S05, S06 ---

;; Rays from strictly inside closed bodies exactly at points of edges or at vertices: those that
;; the nearest-hit kernel misses, and those the any-hit kernel does.
(define ((watertight target seed) size)
  (define g (make-generator seed))
  (define kinds 24) ; offsets, raw and unit directions, bodies
  (define each (amount (quotient 10000000 kinds) size 400))
  (define-values (missed unoccluded)
    (for*/fold ([missed 0] [unoccluded 0])
               ([offset (in-list '(0.0 1e3 1e6))] [raw? (in-list '(#t #f))] [kind (in-range 4)]
                [start (in-range 0 each BATCH)])
      (define at (list offset (* 0.5 offset) (- offset)))
      (define mesh
        (case kind
          [(0 1) (tetrahedron g #:offset at)]
          [(2) (icosphere 2 g #:offset at)]
          [else (icosphere 3 g #:offset at)]))
      (define count (min BATCH (- each start)))
      (define shot (aimed-rays g mesh count target raw? #:offset at))
      (values (+ missed (- count (hit-count mesh shot)))
              (+ unoccluded (- count (shoot-occluded mesh shot))))))
  (values (format "~a leaks, ~a of occlusion, of ~a rays" missed unoccluded (* kinds each))
          (= 0 missed unoccluded)))

;; --- S07 ---

(define (differences-of-meshes size)
  (define g (make-generator 7))
  (define count (amount 300000 size 300))
  (define meshes (list (icosphere 3 g) (icosphere 2 g #:offset '(1e6 3e5 -1e6))
                       (icosphere 2 #:scale 1e-9) (bumpy-sphere 12 20)))
  (for*/fold ([different 0] [rays-shot 0] [hits 0])
             ([mesh (in-list meshes)] [kind (in-list '(vertex edge random axis))]
              [start (in-range 0 count BATCH)])
    (define vertices (mesh-vertices mesh))
    (define (pick) (vector-ref vertices (random (vector-length vertices) g)))
    (define extent (norm (subtract (pick) (pick))))
    (define far (add (pick) (scale (* 5.0 extent) (random-direction g))))
    (define n (min BATCH (- count start)))
    (define (component) (list-ref '(0.0 -0.0 1.0 -1.0) (random 4 g)))
    (define shot
      (case kind
        [(vertex edge) (aimed-rays g mesh n kind (even? start) #:offset far #:inside 0.0)]
        [(random)
         (rays n (lambda ()
                   (define o (add (pick) (scale (* extent (random g)) (random-direction g))))
                   (values o (subtract (pick) (add o (scale (* 0.1 extent) (random-direction g)))))))]
        [else
         ;; from a vertex's coordinates along an axis or a plane of two
         (rays n (lambda ()
                   (define-values (p d)
                     (values (pick) (list (component) (component) (component))))
                   (define along (if (andmap zero? d) '(0.0 -0.0 1.0) d))
                   (values (subtract p (scale (* 3.0 extent (random 2 g)) along)) along)))]))
    (define-values (fast slow) (values (shoot mesh shot) (shoot-by-scan mesh shot)))
    (define-values (wrong met)
      (for/fold ([wrong 0] [met 0]) ([k (in-range 0 (* 2 n) 2)])
        (define same? (and (eqv? (flvector-ref fast k) (flvector-ref slow k))
                           (eqv? (flvector-ref fast (+ k 1)) (flvector-ref slow (+ k 1)))))
        (values (if same? wrong (+ wrong 1))
                (if (< (flvector-ref slow k) +inf.0) (+ met 1) met))))
    (values (+ different wrong) (+ rays-shot n) (+ hits met))))

(define (differences-of-worlds size)
  (define uniform (seeded 8))
  (define count (amount 5200000 size 5200))
  (define round-size (min 2000 (quotient count 24)))
  (define makers
    (list (cons 2.0 (lambda () (list (Sphere (Float3 0.5 -0.25 1) 1))))
          (cons 10.0 (lambda () (random-spheres uniform 300)))
          (cons 10.0 (lambda () (random-spheres uniform 300 10.0 4.0)))
          (cons 5.0 (lambda () (nested-duplicates uniform 6)))
          (cons 1.0 (lambda () (many-scales uniform 200)))
          (cons 6.0 (lambda () (mixed-shapes uniform 20)))))
  (for*/fold ([different 0] [rays 0] [hits 0])
             ([round (in-range (quotient count (* 24 round-size)))] [maker (in-list makers)])
    (define-values (extent world) (values (car maker) (World ((cdr maker)))))
    (for/fold ([different different] [rays rays] [hits hits])
              ([shot (in-list (list (random-rays uniform round-size extent)
                                    (axis-parallel-rays uniform round-size extent)
                                    (grazing-rays uniform round-size world extent)
                                    (on-face-rays uniform round-size world)))])
      (define found (compare-with-scan world shot))
      (values (+ different (length (second found)) (length (third found))) (+ rays round-size)
              (+ hits (first found))))))

(define (hierarchy size)
  (define-values (d1 n1 h1) (differences-of-meshes size))
  (define-values (d2 n2 h2) (differences-of-worlds size))
  (values (format "~a and ~a differences of ~a rays at meshes and ~a at worlds, ~a hits"
                  d1 d2 n1 n2 (+ h1 h2))
          (and (= 0 d1 d2) (> (+ h1 h2) (* 0.1 (+ n1 n2))))))

;; --- S11 ---

;; Triangles on small whole coordinates times a power of two, exactly without area.
(define (flat-triangle g)
  (define (whole) (exact->inexact (- (random 33 g) 16)))
  (define (corner) (list (whole) (whole) (whole)))
  (define-values (a d) (values (corner) (corner)))
  (define (along) (add a (scale (exact->inexact (- (random 9 g) 4)) d)))
  (define corners
    (case (random 4 g)
      [(0) (list a a a)]
      [(1) (list a a (along))]
      [else (list a (along) (along))]))
  (define factor (expt 2.0 (- (random 61 g) 30)))
  (for/list ([p (in-list (shuffle-with g corners))]) (scale factor p)))

(define (shuffle-with g l) (sort l < #:key (lambda (x) (random g)) #:cache-keys? #t))

;; A triangle 1e12 times as long as it is wide.
(define (sliver g)
  (define-values (a d e) (values (random-direction g) (random-direction g) (random-direction g)))
  (list a (add a d) (add (add a (scale (random g) d)) (scale 1e-12 e))))

(define (weighted g corners)
  (define-values (u v) (values (random g) (random g)))
  (for/list ([a (first corners)] [b (second corners)] [c (third corners)])
    (+ a (* u (- b a)) (* v (- c a)))))

;; From rays at the corners and at points between them: hits, and hits whose t is no finite number.
(define (hits-of g corners count)
  (define extent (apply max 1e-300 (map (lambda (p) (norm (subtract p (first corners)))) corners)))
  (define (target k)
    (case (modulo k 3)
      [(0) (list-ref corners (random 3 g))]
      [(1) (weighted g corners)]
      [else (weighted g (list (first corners) (second corners) (first corners)))]))
  (define k 0)
  (define shot
    (rays count
          (lambda ()
            (set! k (+ k 1))
            (define p (target k))
            (define d
              (let ([whole (lambda () (exact->inexact (- (random 7 g) 3)))])
                (if (even? k) (random-direction g) (list (whole) (whole) (+ 0.5 (whole))))))
            (values (subtract p (scale (* 2.0 extent) d)) (scale extent d)))))
  (define-values (mesh triangle)
    (values (points->mesh corners '((0 1 2))) (apply Triangle (map point corners))))
  (for*/fold ([hits 0] [strange 0])
             ([shape (in-list (list mesh triangle))]
              [t (in-list (results-t (shoot shape shot)))])
    (values (if (= t +inf.0) hits (+ hits 1))
            (if (or (= t +inf.0) (and (> t 0.0) (< t +inf.0))) strange (+ strange 1)))))

(define (degenerate size)
  (define g (make-generator 11))
  (define count (amount 100000 size 300))
  (define-values (flat-hits flat-strange)
    (for/fold ([hits 0] [strange 0]) ([k (in-range count)])
      (define-values (h s) (hits-of g (flat-triangle g) 12))
      (values (+ hits h) (+ strange s))))
  (define-values (sliver-hits sliver-strange)
    (for/fold ([hits 0] [strange 0]) ([k (in-range count)])
      (define-values (h s) (hits-of g (sliver g) 12))
      (values (+ hits h) (+ strange s))))
  (define empty (Mesh (flvector) (fxvector)))
  (define shot (rays 100 (lambda () (values (random-direction g) (random-direction g)))))
  (define empty-hits (+ (hit-count empty shot) (shoot-occluded empty shot)))
  (define strange (+ flat-strange sliver-strange))
  (values (format (string-append "~a hits of triangles without area, ~a of no triangles, "
                                 "~a strange t among ~a hits of slivers")
                  flat-hits empty-hits strange sliver-hits)
          (and (= 0 flat-hits empty-hits strange) (> sliver-hits 0))))

;; --- S32 ---

;; How often a ray crosses the surface, followed from hit to hit; 1000 where it does not end.
(define (crossings p o d)
  (let follow ([o o] [crossed 0])
    (cond
      [(= crossed 1000) crossed]
      [(probe:shoot p o d)
       (define s (probe:surface-at p))
       (define side (if (< (dot (probe:Surface-normal s) d) 0.0) -1.0 1.0))
       (follow (add (probe:Surface-point s)
                    (scale (* side (probe:Surface-error s)) (probe:Surface-normal s)))
               (+ crossed 1))]
      [else crossed])))

;; Lines from a point both ways: those with an odd number of crossings; for the torus also points
;; whose parity tells inside from outside wrongly.
(define (parity size)
  (define-values (uniform g) (values (seeded 32) (make-generator 32)))
  (define count (amount 200000 size 200))
  (define bodies
    (list (tetrahedron g) (icosphere 2 g) (icosphere 3 g) (bumpy-sphere 20 30)
          (Torus (Float3 0 0 0) (Float3 0 0 1) 1 0.25)))
  (define (in-torus? p)
    (define-values (x y z) (apply values (exact p)))
    (define k (+ (* x x) (* y y) (* z z) 15/16))
    (< (* k k) (* 4 (+ (* x x) (* y y)))))
  (define-values (odd wrong)
    (for/fold ([odd 0] [wrong 0]) ([body (in-list bodies)])
      (define p (probe:probe body))
      (for/fold ([odd odd] [wrong wrong]) ([k (in-range count)])
        (define-values (o d) (values (scale 1.4 (random-in-ball uniform)) (random-unit uniform)))
        (define-values (ahead behind) (values (crossings p o d) (crossings p o (scale -1.0 d))))
        (values (if (even? (+ ahead behind)) odd (+ odd 1))
                (if (or (Mesh? body) (eq? (odd? ahead) (in-torus? o))) wrong (+ wrong 1))))))
  (values (format "~a odd, ~a points of the torus on the wrong side, of ~a rays"
                  odd wrong (* 2 5 count))
          (= 0 odd wrong)))

(define cases
  (list (stress-case "S05 watertight shared edges" "0 leaks" (watertight 'edge 5))
        (stress-case "S06 watertight shared vertices" "0 leaks" (watertight 'vertex 6))
        (stress-case "S07 hierarchy and linear scan" "the same primitive and bits of t" hierarchy)
        (stress-case "S11 degenerate triangles" "never hit without area, t always finite"
                     degenerate)
        (stress-case "S32 parity of closed meshes and a torus" "0 odd counts" parity)))
