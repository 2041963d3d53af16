#lang racket/base
;; STL, text and binary: loose triangles, whose equal corners become one vertex.

(provide read-stl)

(require racket/fixnum
         racket/flonum
         "cursor.rkt"
         "file.rkt"
         "growable.rkt"
         "index-table.rkt"
         "mesh-data.rkt")

;; Reads an STL file. Corners with equal coordinates (0.0 and -0.0 are equal) become one vertex; the
;; facets' normals are ignored. Linear in the file's bytes; progress is called with the fraction
;; read. Raises a one-line user error that names file and line, or byte offset.
;; Format: 3D Systems, Stereolithography Interface Specification, 1989.
(define (read-stl path #:progress [progress #f])
  (define bytes (load-file path))
  (define report! (make-progress-meter progress (bytes-length bytes)))
  (define vertices (make-vertices))
  (define fail-empty
    (if (text? bytes)
        (read-text! path bytes vertices report!)
        (read-binary! path bytes vertices report!)))
  (define mesh
    (finish-mesh (path-label path)
                 (flonums->flvector (vertices-positions vertices)) #f #f
                 (fixnums->fxvector (vertices-triangles vertices))
                 (list (cons #f 0)) (hash) '() fail-empty))
  (report! (bytes-length bytes))
  mesh)

;; Many binary files start with solid as well: then their length, or a zero byte, tells.
(define (text? bytes)
  (define length (bytes-length bytes))
  (define binary-length
    (and (fx>= length 84) (+ 84 (* 50 (integer-bytes->integer bytes #f #f 80 84)))))
  (and (not (eqv? length binary-length))
       (regexp-match? #px#"^\\s*(?i:solid)" bytes 0 (fxmin length 512))
       (not (for/or ([b (in-bytes bytes 0 (fxmin length 512))]) (eqv? b 0)))))

;; Merged vertices and the triangles over them.
(struct vertices (table positions triangles) #:authentic)

(define (make-vertices)
  (vertices (make-index-table) (make-flonums) (make-fixnums)))

;; Appends a corner of the triangle at hand; hash depends on its coordinates alone.
(define (add-corner! v x y z hash)
  (define positions (vertices-positions v))
  (define index
    (index-table-intern! (vertices-table v) hash
                         (λ (k)
                           (define data (flonums-data positions))
                           (and (fl= x (flvector-ref data (fx* 3 k)))
                                (fl= y (flvector-ref data (fx+ 1 (fx* 3 k))))
                                (fl= z (flvector-ref data (fx+ 2 (fx* 3 k))))))))
  (when (fx= (fx* 3 index) (flonums-count positions))
    (flonums-push! positions x)
    (flonums-push! positions y)
    (flonums-push! positions z))
  (fixnums-push! (vertices-triangles v) index))

;; A hash of all bits of the coordinates; scratch is 24 bytes.
(define (hash-coordinates scratch x y z)
  (real->floating-point-bytes x 8 #f scratch 0)
  (real->floating-point-bytes y 8 #f scratch 8)
  (real->floating-point-bytes z 8 #f scratch 16)
  (define (half i) (integer-bytes->integer scratch #f #f i (fx+ i 4)))
  (mix-hash (mix-hash (half 0) (half 4) (half 8)) (mix-hash (half 12) (half 16) (half 20)) 0))

;; Binary: 80 bytes of anything, the number of triangles, 50 bytes for each. Returns what to call
;; when no triangle has an area.
(define (read-binary! path bytes v report!)
  (define length (bytes-length bytes))
  (when (fx< length 84)
    (fail-at-byte path 0 "expected the word solid, or the 84 bytes that start a binary STL, found ~a"
                  (if (fx= length 0) "an empty file" (quote-bytes bytes 0 length))))
  (define count (integer-bytes->integer bytes #f #f 80 84))
  (define needed (+ 84 (* 50 count)))
  (unless (= needed length)
    (fail-at-byte path 80 "expected ~a bytes for the ~a triangles announced, found a file of ~a bytes"
                  needed count length))
  ;; Adding 0.0 makes -0.0 the same as 0.0, and so does leaving out its sign bit.
  (define (coordinate i)
    (define x (floating-point-bytes->real bytes #f i (fx+ i 4)))
    (unless (fl= 0.0 (fl- x x))
      (fail-at-byte path i "expected a finite coordinate, found ~a" x))
    (fl+ 0.0 x))
  (define (bits i)
    (define n (integer-bytes->integer bytes #f #f i (fx+ i 4)))
    (if (fx= n #x80000000) 0 n))
  (for ([facet (in-range 84 length 50)])
    (for ([x (in-range (fx+ facet 12) (fx+ facet 48) 12)])
      (define-values (y z) (values (fx+ x 4) (fx+ x 8)))
      (add-corner! v (coordinate x) (coordinate y) (coordinate z)
                   (mix-hash (bits x) (bits y) (bits z))))
    (report! facet))
  (λ () (fail-at-byte path length "expected at least one triangle with an area, found none")))

;; Text: words, in any number of lines; the letters' case does not matter. Returns what to call when
;; no triangle has an area.
(define (read-text! path bytes v report!)
  (define c (make-cursor path bytes))
  (define scratch (make-bytes 24))
  ;; The next word, on this line or a later one; #f at the end of the file.
  (define (word!)
    (cond
      [(cursor-token! c) #t]
      [(cursor-at-end? c) #f]
      [else (cursor-next-line! c) (word!)]))
  (define (word=? word) (cursor-token=? c word #t))
  (define (fail what) (cursor-fail c "expected ~a, found ~a" what (cursor-found c)))
  (define (expect! . words)
    (for ([word (in-list words)])
      (unless (and (word!) (word=? word))
        (fail word))))
  (define (coordinate! what)
    (when (word!) (cursor-rewind-token! c))
    (fl+ 0.0 (cursor-finite! c what)))
  (define (read-facet!)
    (expect! #"normal")
    (for ([_ (in-range 3)])
      (unless (word!) (fail "a normal")))
    (expect! #"outer" #"loop")
    (for ([_ (in-range 3)])
      (expect! #"vertex")
      (define x (coordinate! "x"))
      (define y (coordinate! "y"))
      (define z (coordinate! "z"))
      (add-corner! v x y z (hash-coordinates scratch x y z)))
    (expect! #"endloop" #"endfacet")
    (report! (cursor-pos c)))
  (define (read-facets!)
    (unless (word!) (fail "facet or endsolid"))
    (cond
      [(word=? #"facet")
       (read-facet!)
       (read-facets!)]
      [(word=? #"endsolid") (cursor-rest! c)]
      [else (fail "facet or endsolid")]))
  ;; One solid after the other; the name is the rest of the line.
  (let loop ()
    (expect! #"solid")
    (cursor-rest! c)
    (read-facets!)
    (when (word!)
      (cursor-rewind-token! c)
      (loop)))
  (λ () (fail "at least one facet with an area")))
