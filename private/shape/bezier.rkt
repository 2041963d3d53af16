#lang racket/base
;; Bicubic Bézier patches to a triangle mesh within a stated distance of them; the Utah teapot.

(provide bezier-patches->mesh teapot-mesh-vectors)

(require racket/fixnum racket/flonum racket/list "../read/teapot-patches.rkt")

;; The mesh of bicubic Bézier patches: positions (flvector, 3 a vertex), unit normals (flvector, 3 a
;; vertex), uvs (flvector, 2 a vertex) and triangles (fxvector, 3 vertex indices a triangle).
;;   points     flvector, 3 finite coordinates a control point
;;   patches    fxvector, 16 indices into the points a patch: four rows of four; the patch's u runs
;;              along a row, its v down the rows, both over [0, 1], and its outside is ∂u × ∂v
;;   tolerance  > 0, in the units of the points: no point of the surface is farther from the mesh,
;;              and no point of the mesh farther from the surface
;;   uv?        true: uvs are the patch's (u, v), so a vertex on the edge between two patches is
;;              there once for each, with bit-equal position and normal; false: such vertices are
;;              one, and the uvs are empty
;; Edges with equal control points, in either direction, are divided equally: no cracks. Vertices
;; equal in position but not in normal (a crease) stay apart. Triangles without area, which arise
;; where an edge is collapsed to a point, are dropped.
;; Error bound: Filip, Magedson and Markot, "Surface algorithms using bounds on derivatives", 1986.
;; Raises exn:fail:user for arguments out of range and for more than 2^26 triangles.
(define (bezier-patches->mesh points patches #:tolerance tolerance #:uv? [uv? #t])
  (check-arguments points patches tolerance)
  (define nets
    (for/list ([first-index (in-range 0 (fxvector-length patches) 16)])
      (control-net points patches first-index)))
  (define-values (corners boundaries) (find-boundaries nets))
  (define counts (choose-counts nets boundaries (real->double-flonum tolerance)))
  (define-values (vertex-limit triangle-limit)
    (for/fold ([vertices 0] [triangles 0]) ([count (in-list counts)])
      (define-values (nu nv) (values (car count) (cdr count)))
      (values (+ vertices (* (+ nu 1) (+ nv 1))) (+ triangles (* 2 nu nv)))))
  (when (> triangle-limit TRIANGLES-MAX)
    (raise-user-error 'bezier-patches->mesh
                      "tolerance ~a needs more than ~a triangles" tolerance TRIANGLES-MAX))

  (define positions (make-flvector (* 3 vertex-limit)))
  (define normals (make-flvector (* 3 vertex-limit)))
  (define uvs (make-flvector (if uv? (* 2 vertex-limit) 0)))
  (define triangles (make-fxvector (* 3 triangle-limit)))
  (define vertices-at (make-hash)) ; key of a place on a boundary -> the vertices there
  (define vertex-count 0)
  (define triangle-count 0)

  ;; The index of the vertex with this key, position, normal and uv; `key` is #f off boundaries.
  (define (vertex-index! key position normal u v)
    (define here (if key (hash-ref vertices-at key '()) '()))
    (define smooth (filter (lambda (i) (same-normal? normals i normal)) here))
    (define (same-uv? i)
      (or (not uv?)
          (and (fl= u (flvector-ref uvs (* 2 i))) (fl= v (flvector-ref uvs (+ 1 (* 2 i)))))))
    (or (findf same-uv? smooth)
        (let ([i vertex-count])
          (flvector-set3! positions i position)
          (flvector-set3! normals i (if (null? smooth) normal (flvector-ref3 normals (car smooth))))
          (when uv?
            (flvector-set! uvs (* 2 i) u)
            (flvector-set! uvs (+ 1 (* 2 i)) v))
          (when key (hash-set! vertices-at key (cons i here)))
          (set! vertex-count (+ vertex-count 1))
          i)))

  (define (add-triangle! a b c)
    (define origin (flvector-ref3 positions a))
    (define area (cross (subtract (flvector-ref3 positions b) origin)
                        (subtract (flvector-ref3 positions c) origin)))
    (unless (fl= 0.0 (flmax3 area))
      (define start (* 3 triangle-count))
      (fxvector-set! triangles start a)
      (fxvector-set! triangles (+ 1 start) b)
      (fxvector-set! triangles (+ 2 start) c)
      (set! triangle-count (+ triangle-count 1))))

  (for ([position-net (in-list nets)] [corner (in-list corners)] [boundary (in-list boundaries)]
        [count (in-list counts)])
    (define-values (nu nv) (values (car count) (cdr count)))
    (define derivatives (net->surface position-net))
    (define weights-u (weights-table nu))
    (define weights-v (weights-table nv))
    (define grid
      (for*/vector #:length (* (+ nu 1) (+ nv 1)) ([j (in-range (+ nv 1))] [i (in-range (+ nu 1))])
        (define-values (wu wv) (values (vector-ref weights-u i) (vector-ref weights-v j)))
        (define-values (u v) (values (parameter i nu) (parameter j nv)))
        (define shared (grid-place corner boundary i j nu nv))
        (vertex-index! (and shared (place-key shared))
                       (if shared (place-position shared) (net-evaluate position-net wu wv))
                       (surface-normal derivatives u v wu wv)
                       u v)))
    (for* ([j (in-range nv)] [i (in-range nu)])
      (define start (+ i (* j (+ nu 1))))
      (define-values (a b) (values (vector-ref grid start) (vector-ref grid (+ start 1))))
      (define d (vector-ref grid (+ start nu 1)))
      (define c (vector-ref grid (+ start nu 2)))
      (add-triangle! a b c)
      (add-triangle! a c d)))

  (values (flvector-copy positions 0 (* 3 vertex-count))
          (flvector-copy normals 0 (* 3 vertex-count))
          (flvector-copy uvs 0 (if uv? (* 2 vertex-count) 0))
          (fxvector-copy triangles 0 (* 3 triangle-count))))

;; The teapot as bezier-patches->mesh gives it, y up, standing on y = 0, its body's axis the y axis:
;; 3.15 high, handle towards -x, spout towards +x. u runs counterclockwise seen from above and v up.
(define (teapot-mesh-vectors #:tolerance [tolerance 0.01] #:uv? [uv? #t])
  (define-values (positions normals uvs triangles)
    (bezier-patches->mesh teapot-points teapot-patches #:tolerance tolerance #:uv? uv?))
  (values (z-up->y-up positions) (z-up->y-up normals)
          (for/flvector #:length (flvector-length uvs) ([c (in-flvector uvs)]) (fl- 1.0 c))
          triangles))

(define TRIANGLES-MAX (expt 2 26))

(define (z-up->y-up vectors)
  (define result (make-flvector (flvector-length vectors)))
  (for ([i (in-range (quotient (flvector-length vectors) 3))])
    (define p (flvector-ref3 vectors i))
    (flvector-set3! result i (flvector (flvector-ref p 0) (flvector-ref p 2)
                                       (fl- 0.0 (flvector-ref p 1)))))
  result)

(define (check-arguments points patches tolerance)
  (define (bad format-string . arguments)
    (raise-user-error 'bezier-patches->mesh (apply format format-string arguments)))
  (unless (and (rational? tolerance) (positive? (real->double-flonum tolerance)))
    (bad "tolerance is ~e, expected a finite positive number" tolerance))
  (define point-count (quotient (flvector-length points) 3))
  (unless (zero? (remainder (flvector-length points) 3))
    (bad "points has ~a numbers, expected 3 a point" (flvector-length points)))
  (for ([coordinate (in-flvector points)] [i (in-naturals)])
    (unless (rational? coordinate)
      (bad "coordinate ~a of points is ~a, expected a finite number" i coordinate)))
  (unless (zero? (remainder (fxvector-length patches) 16))
    (bad "patches has ~a indices, expected 16 a patch" (fxvector-length patches)))
  (for ([index (in-fxvector patches)] [i (in-naturals)])
    (unless (< -1 index point-count)
      (bad "index ~a of patches is ~a, expected 0 to ~a" i index (- point-count 1)))))

;; --- Small vectors: flvectors of three ---

(define (flvector-ref3 vectors i)
  (flvector (flvector-ref vectors (* 3 i)) (flvector-ref vectors (+ 1 (* 3 i)))
            (flvector-ref vectors (+ 2 (* 3 i)))))

(define (flvector-set3! vectors i p)
  (for ([axis (in-range 3)])
    (flvector-set! vectors (+ axis (* 3 i)) (flvector-ref p axis))))

(define (subtract p q) (combine 1.0 p -1.0 q))

;; a p + b q
(define (combine a p b q)
  (for/flvector #:length 3 ([s (in-flvector p)] [t (in-flvector q)]) (fl+ (fl* a s) (fl* b t))))

(define (cross p q)
  (define-values (px py pz) (values (flvector-ref p 0) (flvector-ref p 1) (flvector-ref p 2)))
  (define-values (qx qy qz) (values (flvector-ref q 0) (flvector-ref q 1) (flvector-ref q 2)))
  (flvector (fl- (fl* py qz) (fl* pz qy))
            (fl- (fl* pz qx) (fl* px qz))
            (fl- (fl* px qy) (fl* py qx))))

;; The greatest component in magnitude.
(define (flmax3 p)
  (flmax (flabs (flvector-ref p 0)) (flmax (flabs (flvector-ref p 1)) (flabs (flvector-ref p 2)))))

(define (norm p)
  (flsqrt (for/fold ([sum 0.0]) ([c (in-flvector p)]) (fl+ sum (fl* c c)))))

(define (normalized p)
  (define length (norm p))
  (for/flvector #:length 3 ([c (in-flvector p)]) (fl/ c length)))

;; Equal up to rounding, far below any crease one can see.
(define (same-normal? normals i normal)
  (fl< (flmax3 (subtract normal (flvector-ref3 normals i))) 1e-6))

;; --- Nets: a tensor-product Bézier surface of points or of derivatives, 1 to 4 columns and rows ---

(struct net (columns rows points)) ; points: vector of flvectors of three, row by row

(define (control-net points patches first-index)
  (net 4 4 (for/vector #:length 16 ([k (in-range 16)])
             ;; adding 0.0 makes -0.0 equal to 0.0
             (combine 1.0 (flvector-ref3 points (fxvector-ref patches (+ first-index k)))
                      0.0 (flvector 0.0 0.0 0.0)))))

(define (net-ref n column row) (vector-ref (net-points n) (+ column (* row (net-columns n)))))

;; The net of the partial derivative by u, or by v: differences of neighbours times the degree.
(define (net-derivative n #:by direction)
  (define-values (du dv) (if (eq? direction 'u) (values 1 0) (values 0 1)))
  (define-values (columns rows) (values (- (net-columns n) du) (- (net-rows n) dv)))
  (define degree (->fl (if (eq? direction 'u) columns rows)))
  (net columns rows
       (for*/vector #:length (* columns rows) ([row (in-range rows)] [column (in-range columns)])
         (combine degree (net-ref n (+ column du) (+ row dv))
                  (fl- 0.0 degree) (net-ref n column row)))))

;; No value of the surface is longer: values are convex combinations of the net's points.
(define (net-bound n)
  (for/fold ([bound 0.0]) ([p (in-vector (net-points n))]) (flmax bound (norm p))))

;; The value where the Bernstein polynomials have these weights (tables by degree).
(define (net-evaluate n weights-u weights-v)
  (define wu (vector-ref weights-u (- (net-columns n) 1)))
  (define wv (vector-ref weights-v (- (net-rows n) 1)))
  (define result (make-flvector 3 0.0))
  (for* ([row (in-range (net-rows n))] [column (in-range (net-columns n))])
    (define weight (fl* (flvector-ref wu column) (flvector-ref wv row)))
    (for ([axis (in-range 3)] [c (in-flvector (net-ref n column row))])
      (flvector-set! result axis (fl+ (flvector-ref result axis) (fl* weight c)))))
  result)

(define (parameter i count) (fl/ (->fl i) (->fl count)))

;; The Bernstein polynomials of degrees 0 to 3 at t, an flvector a degree.
(define (bernstein-weights t)
  (define (raise-degree weights)
    (define degree (flvector-length weights))
    (for/flvector #:length (+ degree 1) ([i (in-range (+ degree 1))])
      (fl+ (if (< i degree) (fl* (fl- 1.0 t) (flvector-ref weights i)) 0.0)
           (if (> i 0) (fl* t (flvector-ref weights (- i 1))) 0.0))))
  (define constant (flvector 1.0))
  (define linear (raise-degree constant))
  (define quadratic (raise-degree linear))
  (vector constant linear quadratic (raise-degree quadratic)))

(define (weights-table count)
  (for/vector #:length (+ count 1) ([i (in-range (+ count 1))])
    (bernstein-weights (parameter i count))))

;; --- Normals ---

(struct surface (du dv duu duv dvv scale)) ; nets; scale: no ∂u × ∂v is longer

(define (net->surface n)
  (define-values (du dv) (values (net-derivative n #:by 'u) (net-derivative n #:by 'v)))
  (surface du dv (net-derivative du #:by 'u) (net-derivative du #:by 'v) (net-derivative dv #:by 'v)
           (fl* (net-bound du) (net-bound dv))))

;; The unit normal along ∂u × ∂v. Where that vanishes, as on a collapsed edge, its limit from the
;; patch's middle: the direction of its first derivative that way (l'Hôpital), or where
;; that vanishes too, its direction 2^-10 of the way. (0, 0, 1) where the patch is but a curve.
(define (surface-normal s u v weights-u weights-v)
  (define negligible (fl* 1e-12 (surface-scale s)))
  (define (at partial) (net-evaluate (partial s) weights-u weights-v))
  (define-values (du dv) (values (at surface-du) (at surface-dv)))
  (define n (cross du dv))
  (cond
    [(fl> (norm n) negligible) (normalized n)]
    [else
     (define-values (to-u to-v) (values (fl- 0.5 u) (fl- 0.5 v)))
     (define duv (at surface-duv))
     (define limit (combine 1.0 (cross (combine to-u (at surface-duu) to-v duv) dv)
                            1.0 (cross du (combine to-u duv to-v (at surface-dvv)))))
     (cond
       [(fl> (norm limit) negligible) (normalized limit)]
       [else
        (define (inside t to-middle) (bernstein-weights (fl+ t (fl/ to-middle 1024.0))))
        (define-values (inside-u inside-v) (values (inside u to-u) (inside v to-v)))
        (define near (cross (net-evaluate (surface-du s) inside-u inside-v)
                            (net-evaluate (surface-dv s) inside-u inside-v)))
        (if (fl> (norm near) 0.0) (normalized near) (flvector 0.0 0.0 1.0))])]))

;; --- Boundaries: which edges are one, so that both sides are divided and evaluated alike ---

;; A patch's edge: the numbers of its control points in the order all its patches agree on, and the
;; curve as a net of one row; `backward?` when the patch's own order is the other one.
(struct edge (numbers curve backward?))

;; What is true of a point on a boundary for all its patches: a key to know it by, and its position.
(struct place (key position))

;; For every net the places of its corners (u fast) and its edges (v = 0, v = 1, u = 0, u = 1).
(define (find-boundaries nets)
  (define numbers (make-hash)) ; a point -> its number: equal points are one
  (define (number p) (hash-ref! numbers p (lambda () (hash-count numbers))))
  (define (make-edge n columns-and-rows)
    (define points (for/list ([at (in-list columns-and-rows)]) (net-ref n (car at) (cdr at))))
    (define forward (map number points))
    (define backward? (let loop ([a forward] [b (reverse forward)])
                        (and (pair? a) (or (> (car a) (car b))
                                           (and (= (car a) (car b)) (loop (cdr a) (cdr b)))))))
    (define (in-order l) (if backward? (reverse l) l))
    (edge (in-order forward) (net 4 1 (list->vector (in-order points))) backward?))
  (define steps '(0 1 2 3))
  (values
   (for/list ([n (in-list nets)])
     (for*/list ([row '(0 3)] [column '(0 3)])
       (define p (net-ref n column row))
       (place (number p) p)))
   (for/list ([n (in-list nets)])
     (list (make-edge n (map (lambda (k) (cons k 0)) steps))
           (make-edge n (map (lambda (k) (cons k 3)) steps))
           (make-edge n (map (lambda (k) (cons 0 k)) steps))
           (make-edge n (map (lambda (k) (cons 3 k)) steps))))))

;; The place of grid vertex (i, j) of nu × nv cells, #f in the interior.
(define (grid-place corners edges i j nu nv)
  (define (on e k count)
    (define steps (if (edge-backward? e) (- count k) k))
    (define weights (bernstein-weights (parameter steps count)))
    (place (cons steps (edge-numbers e)) (net-evaluate (edge-curve e) weights weights)))
  (define-values (corner-u corner-v)
    (values (cond [(= i 0) 0] [(= i nu) 1] [else #f]) (cond [(= j 0) 0] [(= j nv) 1] [else #f])))
  (define-values (edge-v edge-u)
    (values (and corner-v (list-ref edges corner-v)) (and corner-u (list-ref edges (+ 2 corner-u)))))
  (define (collapsed? e) (and e (apply = (edge-numbers e))))
  (cond
    [(or (and corner-u corner-v) (and corner-v (collapsed? edge-v)))
     (list-ref corners (+ (or corner-u 0) (* 2 corner-v)))]
    [(and corner-u (collapsed? edge-u)) (list-ref corners corner-u)]
    [corner-v (on edge-v i nu)]
    [corner-u (on edge-u j nv)]
    [else #f]))

;; For every net its counts of cells (nu . nv): its error bound is at most the tolerance, and edges
;; with equal control points have equal counts.
(define (choose-counts nets boundaries tolerance)
  ;; Directions 2p (u of net p) and 2p + 1 (v) that share an edge form a class with one count.
  (define parents (build-vector (* 2 (length nets)) values))
  (define (class direction)
    (define parent (vector-ref parents direction))
    (if (= parent direction) direction (class parent)))
  (define direction-of (make-hash)) ; numbers of an edge's points -> a direction along it
  (for ([edges (in-list boundaries)] [p (in-naturals)])
    (for ([e (in-list edges)] [direction (in-list (list (* 2 p) (* 2 p) (+ 1 (* 2 p)) (+ 1 (* 2 p))))]
          #:unless (apply = (edge-numbers e)))
      (vector-set! parents (class direction)
                   (class (hash-ref! direction-of (edge-numbers e) direction)))))
  ;; Two at least, or the halves of a tube could lie on each other.
  (define counts (make-vector (* 2 (length nets)) 2))
  (define (count direction) (vector-ref counts (class direction)))
  ;; By steps of 1/32, so that the number of steps grows with the logarithm of the counts.
  (define (increase! direction)
    (define n (count direction))
    (when (> n TRIANGLES-MAX)
      (raise-user-error 'bezier-patches->mesh "tolerance ~a needs more than ~a triangles"
                        tolerance TRIANGLES-MAX))
    (vector-set! counts (class direction) (+ n 1 (quotient n 32))))
  ;; Counts only grow and the bound falls with each, so a net once within the tolerance stays so.
  (for ([n (in-list nets)] [p (in-naturals)])
    (define s (net->surface n))
    (define-values (uu uv vv)
      (values (net-bound (surface-duu s)) (net-bound (surface-duv s)) (net-bound (surface-dvv s))))
    (define-values (u-direction v-direction) (values (* 2 p) (+ 1 (* 2 p))))
    (let loop ()
      (define-values (nu nv) (values (->fl (count u-direction)) (->fl (count v-direction))))
      (define-values (error-u error-v) (values (fl/ uu (fl* nu nu)) (fl/ vv (fl* nv nv))))
      (unless (fl<= (fl/ (fl+ (fl+ error-u error-v) (fl/ (fl* 2.0 uv) (fl* nu nv))) 8.0) tolerance)
        (increase! (if (or (fl> error-u error-v) (and (fl= error-u error-v) (fl<= nu nv)))
                       u-direction v-direction))
        (loop))))
  (for/list ([p (in-range (length nets))])
    (cons (count (* 2 p)) (count (+ 1 (* 2 p))))))
