#lang racket/base
;; Meshes and rays the tests of meshes, instances and solids share. Points are lists of three.

(provide make-generator uniform-in random-direction
         tetrahedron icosphere bumpy-sphere points->mesh mesh-vertices mesh-edges
         rays aimed-rays results-t results-first)

(require racket/flonum racket/fixnum racket/list racket/math
         "../../private/shape/mesh.rkt")

(define (make-generator seed)
  (define g (make-pseudo-random-generator))
  (parameterize ([current-pseudo-random-generator g]) (random-seed seed))
  g)
(define (uniform-in g low high) (+ low (* (- high low) (random g))))

;; Uniform over the sphere.
(define (random-direction g)
  (define z (uniform-in g -1.0 1.0))
  (define phi (uniform-in g 0.0 (* 2.0 pi)))
  (define s (sqrt (- 1.0 (* z z))))
  (list (* s (cos phi)) (* s (sin phi)) z))

(define (add p q) (map + p q))
(define (scale s p) (map (lambda (c) (* s c)) p))

(define (points->mesh points triangles #:offset [offset '(0.0 0.0 0.0)] #:scale [size 1.0])
  (make-Mesh (apply flvector
                    (append* (for/list ([p points])
                               (map (lambda (c o) (real->double-flonum (+ o (* size c)))) p offset))))
             (apply fxvector (append* triangles))))

(define (mesh-vertices mesh)
  (define positions (Mesh-positions mesh))
  (for/vector ([k (in-range 0 (flvector-length positions) 3)])
    (for/list ([axis 3]) (flvector-ref positions (+ k axis)))))

;; Pairs of vertex numbers, each edge of each triangle.
(define (mesh-edges mesh)
  (define triangles (Mesh-triangles mesh))
  (for*/list ([k (in-range 0 (fxvector-length triangles) 3)] [e 3])
    (cons (fxvector-ref triangles (+ k e)) (fxvector-ref triangles (+ k (modulo (+ e 1) 3))))))

;; A random tetrahedron around the origin moved to `offset`, faces outward.
(define (tetrahedron g #:offset [offset '(0.0 0.0 0.0)])
  (define corners
    (for/list ([p '((1 1 1) (1 -1 -1) (-1 1 -1) (-1 -1 1))])
      (add p (scale 0.4 (random-direction g)))))
  (points->mesh corners '((0 1 2) (0 2 3) (0 3 1) (1 3 2)) #:offset offset))

;; A star-shaped body around the origin: each triangle of an icosahedron split in four `levels`
;; times, vertices at random distances from 0.8 to 1.2 where a generator is given, else 1.
(define (icosphere levels [g #f] #:offset [offset '(0.0 0.0 0.0)] #:scale [size 1.0])
  (define golden (/ (+ 1.0 (sqrt 5.0)) 2.0))
  (define start
    (for*/list ([s '(-1.0 1.0)] [t (list (- golden) golden)] [turn 3])
      (define p (list 0.0 s t))
      (append (drop p turn) (take p turn))))
  (define start-triangles
    (let ([v (list->vector start)])
      (define (near? a b)
        (< (apply + (map (lambda (x y) (sqr (- x y))) (vector-ref v a) (vector-ref v b))) 4.1))
      (for*/list ([a 12] [b (in-range (+ a 1) 12)] [c (in-range (+ b 1) 12)]
                  #:when (and (near? a b) (near? b c) (near? a c)))
        (if (positive? (triple (vector-ref v a) (vector-ref v b) (vector-ref v c)))
            (list a b c)
            (list a c b)))))
  (define-values (points triangles)
    (for/fold ([points (map unit start)] [triangles start-triangles]) ([_ levels])
      (split points triangles)))
  (points->mesh (for/list ([p points]) (scale (if g (uniform-in g 0.8 1.2) 1.0) p)) triangles
                #:offset offset #:scale size))

(define (unit p) (scale (/ 1.0 (sqrt (apply + (map sqr p)))) p))
(define (triple a b c)
  (define-values (bx by bz cx cy cz) (apply values (append b c)))
  (apply + (map * a (list (- (* by cz) (* bz cy)) (- (* bz cx) (* bx cz)) (- (* bx cy) (* by cx))))))

(define (split points triangles)
  (define all (list->vector points))
  (define middles (make-hash))
  (define added '())
  (define (middle! a b)
    (hash-ref! middles (cons (min a b) (max a b))
               (lambda ()
                 (set! added (cons (unit (add (vector-ref all a) (vector-ref all b))) added))
                 (+ (vector-length all) (length added) -1))))
  (define smaller
    (append*
     (for/list ([t triangles])
       (define-values (a b c) (apply values t))
       (define-values (ab bc ca) (values (middle! a b) (middle! b c) (middle! c a)))
       (list (list a ab ca) (list b bc ab) (list c ca bc) (list ab bc ca)))))
  (values (append points (reverse added)) smaller))

;; r = 1 + 0.05 sin 20 theta sin 20 phi by `stacks` times `slices`: 2 slices (stacks - 1) triangles.
(define (bumpy-sphere stacks slices)
  (define (at s k) (+ 2 (* (- s 1) slices) (modulo k slices)))
  (define (point s k)
    (define-values (theta phi) (values (* pi (/ s stacks)) (* 2.0 pi (/ k slices))))
    (define r (+ 1.0 (* 0.05 (sin (* 20.0 theta)) (sin (* 20.0 phi)))))
    (list (* r (sin theta) (cos phi)) (* r (cos theta)) (* r (sin theta) (sin phi))))
  (points->mesh
   (list* '(0.0 1.0 0.0) '(0.0 -1.0 0.0)
          (for*/list ([s (in-range 1 stacks)] [k slices]) (point s k)))
   (append
    (append* (for/list ([k slices])
               (list (list 0 (at 1 (+ k 1)) (at 1 k))
                     (list 1 (at (- stacks 1) k) (at (- stacks 1) (+ k 1))))))
    (append* (for*/list ([s (in-range 1 (- stacks 1))] [k slices])
               (list (list (at s k) (at s (+ k 1)) (at (+ s 1) (+ k 1)))
                     (list (at s k) (at (+ s 1) (+ k 1)) (at (+ s 1) k))))))))

;; An flvector of rays, six numbers each, from a thunk that returns origin and direction.
(define (rays count next)
  (define v (make-flvector (* 6 count)))
  (for ([k count])
    (define-values (o d) (next))
    (for ([x (in-list o)] [j 3]) (flvector-set! v (+ j (* 6 k)) (real->double-flonum x)))
    (for ([x (in-list d)] [j 3]) (flvector-set! v (+ j 3 (* 6 k)) (real->double-flonum x))))
  v)

;; Rays from near the middle of a mesh, exactly at its vertices or at points of its edges, with
;; directions as they come or of unit length.
(define (aimed-rays g mesh count target raw? #:offset [offset '(0.0 0.0 0.0)] #:inside [inside 0.1])
  (define vertices (mesh-vertices mesh))
  (define edges (list->vector (mesh-edges mesh)))
  (rays count
        (lambda ()
          (define o (add offset (scale (uniform-in g 0.0 inside) (random-direction g))))
          (define p
            (case target
              [(vertex) (vector-ref vertices (random (vector-length vertices) g))]
              [(edge)
               (define e (vector-ref edges (random (vector-length edges) g)))
               (define s (random g))
               (add (scale (- 1.0 s) (vector-ref vertices (car e)))
                    (scale s (vector-ref vertices (cdr e))))]))
          (define d (map - p o))
          (values o (if raw? d (unit d))))))

;; From what `shoot` returns: the parameters, and the triangles.
(define (results-t results)
  (for/list ([k (in-range 0 (flvector-length results) 2)]) (flvector-ref results k)))
(define (results-first results)
  (for/list ([k (in-range 1 (flvector-length results) 2)])
    (fl->exact-integer (flvector-ref results k))))
