#lang racket/base
;; PLY, the polygon file format: text and both binary orders.

(provide read-ply)

(require racket/fixnum
         racket/flonum
         "cursor.rkt"
         "file.rkt"
         "growable.rkt"
         "mesh-data.rkt"
         "ply-header.rkt"
         "ply-source.rkt"
         "polygon.rkt"
         "warnings.rkt")

;; Reads a PLY file: of element vertex the properties x y z, nx ny nz and u v (or s t, or texture_u
;; texture_v), of element face the list vertex_indices (or vertex_index); all else is passed over.
;; Vertices keep the file's order. Linear in the file's bytes; progress is called with the fraction
;; read. Raises a one-line user error that names file and line, or byte offset.
;; Format: Turk, The PLY Polygon File Format, 1994.
(define (read-ply path #:progress [progress #f])
  (define bytes (load-file path))
  (define c (make-cursor path bytes))
  (define report! (make-progress-meter progress (bytes-length bytes)))
  (define header (read-ply-header c))
  (define elements (ply-header-elements header))
  (define s
    (if (eq? 'ascii (ply-header-format header))
        (make-text-source c)
        (make-binary-source path bytes (ply-header-body header)
                            (eq? 'big (ply-header-format header)))))
  (define vertex (find-element c elements #"vertex"))
  (define face (find-element c elements #"face"))
  (define columns (vertex-columns c vertex))
  (check-face c elements face)
  (define count (ply-element-count vertex))
  (define (used? slot) (for/or ([column (in-vector columns)]) (eqv? slot column)))
  (define positions (make-flvector (fx* 3 count)))
  (define normals (and (used? 3) (make-flvector (fx* 3 count))))
  (define uvs (and (used? 6) (make-flvector (fx* 2 count))))
  (define triangles (make-fixnums))
  (define warnings (make-warnings))
  (for ([element (in-list elements)])
    (cond
      [(eq? element vertex) (read-vertices! s element columns positions normals uvs report!)]
      [(eq? element face)
       (define (warn! message)
         (warn-once! warnings 'crossing path (ply-element-line face) message))
       (read-faces! s element positions triangles warn! report!)]
      [else (skip-rows! s element report!)]))
  ((source-finish! s))
  (define mesh
    (finish-mesh (path-label path) positions normals uvs (fixnums->fxvector triangles)
                 (list (cons #f 0)) (hash) (warnings->list warnings)
                 (λ ()
                   (cursor-fail-at c (ply-element-line face)
                                   "expected at least one face with an area, found none"))))
  (report! (bytes-length bytes))
  mesh)

;; The vertex properties that are kept, under each of their names: slots 0-2, 3-5 and 6-7.
(define slot-choices
  '(((#"x" #"y" #"z"))
    ((#"nx" #"ny" #"nz"))
    ((#"u" #"v") (#"s" #"t") (#"texture_u" #"texture_v"))))

(define (find-element c elements name)
  (or (for/first ([e (in-list elements)] #:when (equal? name (ply-element-name e))) e)
      (fail-header c "expected element ~a in the header" name)))

;; The header as a whole is at fault: the error names its last line.
(define (fail-header c . message)
  (apply cursor-fail-at c (fx- (cursor-line c) 1) message))

;; For each vertex property the slot its number goes to, or #f; a property that is a list has none.
(define (vertex-columns c vertex)
  (define properties (ply-element-properties vertex))
  (define (scalar? name)
    (for/or ([p (in-list properties)])
      (and (equal? name (ply-property-name p)) (not (ply-property-count-type p)))))
  (define chosen
    (for/list ([choices (in-list slot-choices)])
      (for/first ([names (in-list choices)] #:when (andmap scalar? names)) names)))
  (unless (car chosen)
    (cursor-fail-at c (ply-element-line vertex) "expected element vertex to have numbers x, y and z"))
  (define slots
    (for*/hash ([(names start) (in-parallel chosen '(0 3 6))] #:when names
                [(name i) (in-parallel names '(0 1 2))])
      (values name (+ start i))))
  (for/vector ([p (in-list properties)])
    (hash-ref slots (ply-property-name p) #f)))

;; A face needs its list of vertices, and the vertices before it.
(define (check-face c elements face)
  (unless (for/or ([p (in-list (ply-element-properties face))]) (index-list? p))
    (cursor-fail-at c (ply-element-line face)
                    "expected element face to have a list vertex_indices or vertex_index"))
  (unless (for/or ([e (in-list elements)] #:break (eq? e face))
            (equal? #"vertex" (ply-element-name e)))
    (cursor-fail-at c (ply-element-line face) "expected element vertex before element face")))

(define (index-list? p)
  (and (ply-property-count-type p)
       (member (ply-property-name p) '(#"vertex_indices" #"vertex_index"))
       #t))

;; Fills positions, and normals and uvs where the columns lead there.
(define (read-vertices! s vertex columns positions normals uvs report!)
  (define properties (list->vector (ply-element-properties vertex)))
  (define real! (source-real! s))
  (define (read-number! p slot row)
    (define name (vector-ref slot-names slot))
    (define x (real! (ply-property-type p) name))
    (define normal? (and (fx<= 3 slot) (fx<= slot 5)))
    (unless (or normal? (fl= 0.0 (fl- x x)))
      ((source-fail s) "expected a finite number for ~a of vertex ~a, found ~a" name row x))
    (cond
      [normal? (flvector-set! normals (fx+ (fx- slot 3) (fx* 3 row)) x)]
      [(fx< slot 3) (flvector-set! positions (fx+ slot (fx* 3 row)) x)]
      [else (flvector-set! uvs (fx+ (fx- slot 6) (fx* 2 row)) x)]))
  (for ([row (in-range (ply-element-count vertex))])
    ((source-start-row! s))
    (for ([p (in-vector properties)] [slot (in-vector columns)])
      (if slot
          (read-number! p slot row)
          (skip-property! s p)))
    ((source-end-row! s))
    (report! ((source-position s)))))

(define slot-names #("x" "y" "z" "nx" "ny" "nz" "u" "v"))

;; Appends the triangles of every face. positions: 3 numbers for each vertex.
(define (read-faces! s face positions triangles warn! report!)
  (define vertex-count (fxquotient (flvector-length positions) 3))
  (define properties (ply-element-properties face))
  (define indices (make-fixnums))
  (define integer! (source-integer! s))
  (define fail (source-fail s))
  (define (emit! i j k)
    (define corners (fixnums-data indices))
    (fixnums-push! triangles (fxvector-ref corners i))
    (fixnums-push! triangles (fxvector-ref corners j))
    (fixnums-push! triangles (fxvector-ref corners k)))
  (define (read-face! row count-type type)
    (define count (integer! count-type "the number of corners"))
    (when (fx< count 3)
      (fail "expected at least 3 corners for face ~a, found ~a" row count))
    (fixnums-clear! indices)
    (for ([_ (in-range count)])
      (define index (integer! type "a vertex index"))
      (unless (and (fx<= 0 index) (fx< index vertex-count))
        (fail "expected a vertex index from 0 to ~a, found ~a" (fx- vertex-count 1) index))
      (fixnums-push! indices index))
    (case (triangulate-polygon positions (fixnums-data indices) count emit!)
      [(crossing) (warn! "a face's outline crosses itself: its triangles are arbitrary")]
      [(intricate)
       (fail "expected an outline that can be triangulated, found ~a corners too entangled" count)]))
  ;; The first list of vertices counts.
  (define chosen (for/first ([p (in-list properties)] #:when (index-list? p)) p))
  (for ([row (in-range (ply-element-count face))])
    ((source-start-row! s))
    (for ([p (in-list properties)])
      (if (eq? p chosen)
          (read-face! row (ply-property-count-type p) (ply-property-type p))
          (skip-property! s p)))
    ((source-end-row! s))
    (report! ((source-position s)))))

;; Passes over an element; one without properties has no bytes, whatever its count.
(define (skip-rows! s element report!)
  (define properties (ply-element-properties element))
  (unless (null? properties)
    (for ([row (in-range (ply-element-count element))])
      ((source-start-row! s))
      (for ([p (in-list properties)])
        (skip-property! s p))
      ((source-end-row! s))
      (report! ((source-position s))))))

(define (skip-property! s p)
  (define count-type (ply-property-count-type p))
  (define count
    (if count-type
        ((source-integer! s) count-type "the length of a list")
        1))
  (when (< count 0)
    ((source-fail s) "expected the length of a list, found ~a" count))
  ((source-skip! s) (ply-property-type p) count))
