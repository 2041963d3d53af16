#lang racket/base
;; Wavefront OBJ: vertices, polygons and the materials they use.

(provide read-obj)

(require racket/fixnum
         racket/flonum
         "cursor.rkt"
         "file.rkt"
         "growable.rkt"
         "index-table.rkt"
         "mesh-data.rkt"
         "mtl.rkt"
         "polygon.rkt"
         "warnings.rkt")

;; Reads an OBJ file: v vt vn f usemtl mtllib, in time linear in its bytes. Polygons are triangulated;
;; vertices are merged by (v, vt, vn). o g s l p are passed over, other words give one warning each.
;; progress is called with the fraction read. Raises a one-line user error that names file and line.
;; Format: Wavefront Advanced Visualizer manual, appendix B1.
(define (read-obj path #:progress [progress #f])
  (define bytes (load-file path))
  (define c (make-cursor path bytes #:comment #\# #:continue? #t))
  (define report! (make-progress-meter progress (bytes-length bytes)))
  (define draft (make-draft))
  (let loop ()
    (unless (cursor-at-end? c)
      (when (cursor-token! c)
        (read-statement! c draft))
      (cursor-next-line! c)
      (report! (cursor-pos c))
      (loop)))
  (define mesh (draft->mesh c draft))
  (report! (bytes-length bytes))
  mesh)

;; What has been read so far. corners holds (v, vt, vn) of three corners per triangle, -1 when
;; absent; face-* the same of the face at hand; libraries are the identities of the material files
;; read, so that none is read twice; runs is (cons material first-triangle), last first.
(struct draft (positions uvs normals corners face-positions face-uvs face-normals warnings libraries
                         [runs #:mutable] [materials #:mutable])
  #:authentic)

(define (make-draft)
  (draft (make-flonums) (make-flonums) (make-flonums) (make-fixnums)
         (make-fixnums) (make-fixnums) (make-fixnums) (make-warnings) (make-hasheqv)
         (list (cons #f 0)) (hash)))

;; The line whose first word is the cursor's token.
(define (read-statement! c d)
  (define (word? word) (cursor-token=? c word))
  (cond
    [(word? #"v")
     (define positions (draft-positions d))
     (flonums-push! positions (cursor-finite! c "x"))
     (flonums-push! positions (cursor-finite! c "y"))
     (flonums-push! positions (cursor-finite! c "z"))]
    [(word? #"f") (read-face! c d)]
    [(word? #"vn")
     (define normals (draft-normals d))
     (flonums-push! normals (cursor-decimal! c "the normal's x"))
     (flonums-push! normals (cursor-decimal! c "the normal's y"))
     (flonums-push! normals (cursor-decimal! c "the normal's z"))]
    [(word? #"vt")
     (define uvs (draft-uvs d))
     (flonums-push! uvs (cursor-finite! c "u"))
     (flonums-push! uvs (cond [(cursor-token! c) (cursor-rewind-token! c) (cursor-finite! c "v")]
                              [else 0.0]))]
    [(or (word? #"o") (word? #"g") (word? #"s") (word? #"l") (word? #"p")) (void)]
    [(word? #"usemtl")
     (define name (cursor-rest! c))
     (set-draft-runs! d (cons (cons (and (not (equal? name #"")) (name-string name))
                                    (triangle-count d))
                              (draft-runs d)))]
    [(word? #"mtllib")
     (define line (cursor-line c))
     (read-libraries! c d (cursor-rest! c) line)]
    [else
     (warn-once! (draft-warnings d) (subbytes (cursor-bytes c) (cursor-start c) (cursor-stop c))
                 (cursor-path c) (cursor-line c) "unknown word ~a is ignored" (cursor-found c))]))

(define (triangle-count d)
  (fxquotient (fixnums-count (draft-corners d)) 9))

;; One face: its corners, then its triangles.
(define (read-face! c d)
  (define line (cursor-line c))
  (define vertices (draft-face-positions d))
  (define uvs (draft-face-uvs d))
  (define normals (draft-face-normals d))
  (fixnums-clear! vertices)
  (fixnums-clear! uvs)
  (fixnums-clear! normals)
  (let loop ()
    (when (cursor-token! c)
      (read-corner! c d)
      (loop)))
  (define count (fixnums-count vertices))
  (when (fx< count 3)
    (cursor-fail c "expected a face of at least 3 corners, found ~a" count))
  (define corners (draft-corners d))
  (define (emit-corner! k)
    (fixnums-push! corners (fxvector-ref (fixnums-data vertices) k))
    (fixnums-push! corners (fxvector-ref (fixnums-data uvs) k))
    (fixnums-push! corners (fxvector-ref (fixnums-data normals) k)))
  (define outcome
    (triangulate-polygon (flonums-data (draft-positions d)) (fixnums-data vertices) count
                         (λ (i j k) (emit-corner! i) (emit-corner! j) (emit-corner! k))))
  (case outcome
    [(crossing)
     (warn-once! (draft-warnings d) 'crossing (cursor-path c) line
                 "a face's outline crosses itself: its triangles are arbitrary")]
    [(intricate)
     (cursor-fail c "expected an outline that can be triangulated, found ~a corners too entangled"
                  count)]))

;; The cursor's token as v, v/vt, v//vn or v/vt/vn: three indices from 0, -1 when absent.
(define (read-corner! c d)
  (define bytes (cursor-bytes c))
  (define stop (cursor-stop c))
  ;; Pushes the index that starts at start and returns where it stops.
  (define (read-index! start indices defined name)
    (define negative? (and (fx< start stop) (fx= 45 (bytes-ref bytes start))))
    (define first (if negative? (fx+ start 1) start))
    (let loop ([i first] [n 0])
      (define b (if (fx< i stop) (bytes-ref bytes i) 47))
      (cond
        [(and (fx>= b 48) (fx<= b 57))
         (loop (fx+ i 1) (fxmin 1000000000000000 (fx+ (fx* 10 n) (fx- b 48))))]
        [(not (fx= b 47)) (fail-corner)]
        [(fx= i start)
         (if (eq? name 'v) (fail-corner) (fixnums-push! indices -1))
         i]
        [(or (fx= i first) (fx= n 0)) (fail-corner)]
        [(fx> n defined)
         (cursor-fail c "expected a ~a index within the ~a defined so far, found ~a in ~a"
                      name defined (if negative? (fx- 0 n) n) (cursor-found c))]
        [else
         (fixnums-push! indices (if negative? (fx- defined n) (fx- n 1)))
         i])))
  (define (fail-corner)
    (cursor-fail c "expected a corner v, v/vt, v//vn or v/vt/vn counted from 1, found ~a"
                 (cursor-found c)))
  (define (after i) (if (fx< i stop) (fx+ i 1) i))
  (define v-stop
    (read-index! (cursor-start c) (draft-face-positions d)
                 (fxquotient (flonums-count (draft-positions d)) 3) 'v))
  (define vt-stop
    (read-index! (after v-stop) (draft-face-uvs d)
                 (fxquotient (flonums-count (draft-uvs d)) 2) 'vt))
  (define vn-stop
    (read-index! (after vt-stop) (draft-face-normals d)
                 (fxquotient (flonums-count (draft-normals d)) 3) 'vn))
  (unless (fx= vn-stop stop) (fail-corner)))

;; mtllib: one file whose name may have blanks, or several. A missing one is only a warning.
(define (read-libraries! c d names line)
  (define folder
    (let-values ([(base name directory?) (split-path (path->complete-path (cursor-path c)))])
      base))
  (define (library name)
    (and (not (equal? name #""))
         (not (for/or ([b (in-bytes name)]) (eqv? b 0)))
         (let ([path (path->complete-path (bytes->path name) folder)])
           (and (file-exists? path) path))))
  (define warnings (draft-warnings d))
  (define (read-library! name)
    (define path (library name))
    (define identity (and path (file-or-directory-identity path)))
    (cond
      [(not path)
       (warn-once! warnings (list 'mtllib name) (cursor-path c) line
                   "material file ~a is missing" (quote-bytes name 0 (bytes-length name)))]
      [(not (hash-ref (draft-libraries d) identity #f))
       (hash-set! (draft-libraries d) identity #t)
       (set-draft-materials! d (read-mtl path (draft-materials d) warnings))]))
  (if (library names)
      (read-library! names)
      (for-each read-library! (regexp-split #rx#"[ \t]+" names))))

;; Vertices merged by (v, vt, vn), as far as the file gives every corner a normal.
(define (draft->mesh c d)
  (define corners (draft-corners d))
  (define count (fixnums-count corners))
  (define data (fixnums-data corners))
  (define (count-absent offset)
    (for/fold ([n 0]) ([i (in-range offset count 3)])
      (if (fx< (fxvector-ref data i) 0) (fx+ n 1) n)))
  (define corner-count (fxquotient count 3))
  (define without-uv (count-absent 1))
  (define without-normal (count-absent 2))
  (define uvs? (fx< without-uv corner-count))
  (define normals? (and (fx= without-normal 0) (fx> corner-count 0)))
  (define (warn! kind . message)
    (apply warn-once! (draft-warnings d) kind (cursor-path c) (cursor-line c) message))
  (when (and uvs? (fx> without-uv 0))
    (warn! 'some-uvs "~a of ~a corners have no texture coordinates: 0 0 is used"
           without-uv corner-count))
  (when (and (not normals?) (fx< without-normal corner-count))
    (warn! 'some-normals "~a of ~a corners have no normal: the file's normals are ignored"
           without-normal corner-count))
  (for ([run (in-list (reverse (draft-runs d)))])
    (define name (car run))
    (when (and name (not (hash-ref (draft-materials d) name #f)))
      (warn! (list 'usemtl name) "material ~s is not defined"
             (path-label name))))
  (define-values (positions uvs normals triangles) (merge-corners d uvs? normals?))
  (finish-mesh (path-label (cursor-path c)) positions normals uvs triangles
               (reverse (draft-runs d)) (draft-materials d) (warnings->list (draft-warnings d))
               (λ ()
                 (cursor-fail c "expected at least one face with an area, found none"))))

(define (merge-corners d uvs? normals?)
  (define data (fixnums-data (draft-corners d)))
  (define corner-count (fxquotient (fixnums-count (draft-corners d)) 3))
  (define table (make-index-table))
  (define seen (make-fixnums))
  (define triangles (make-fxvector corner-count))
  (for ([i (in-range corner-count)])
    (define v (fxvector-ref data (fx* 3 i)))
    (define vt (if uvs? (fxvector-ref data (fx+ 1 (fx* 3 i))) -1))
    (define vn (if normals? (fxvector-ref data (fx+ 2 (fx* 3 i))) -1))
    (define index
      (index-table-intern! table (mix-hash v vt vn)
                           (λ (k)
                             (define keys (fixnums-data seen))
                             (and (fx= v (fxvector-ref keys (fx* 3 k)))
                                  (fx= vt (fxvector-ref keys (fx+ 1 (fx* 3 k))))
                                  (fx= vn (fxvector-ref keys (fx+ 2 (fx* 3 k))))))))
    (when (fx= (fx* 3 index) (fixnums-count seen))
      (fixnums-push! seen v)
      (fixnums-push! seen vt)
      (fixnums-push! seen vn))
    (fxvector-set! triangles i index))
  (define keys (fixnums->fxvector seen))
  (values (gather (draft-positions d) keys 0 3)
          (and uvs? (gather (draft-uvs d) keys 1 2))
          (and normals? (gather (draft-normals d) keys 2 3))
          triangles))

;; width numbers for each merged vertex, by the index at offset of its key; zeros for -1.
(define (gather source keys offset width)
  (define data (flonums-data source))
  (define count (fxquotient (fxvector-length keys) 3))
  (define result (make-flvector (fx* width count)))
  (for ([k (in-range count)])
    (define from (fx* width (fxvector-ref keys (fx+ offset (fx* 3 k)))))
    (when (fx>= from 0)
      (for ([j (in-range width)])
        (flvector-set! result (fx+ j (fx* width k)) (flvector-ref data (fx+ from j))))))
  result)
