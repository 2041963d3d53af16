#lang racket/base
;; The header of a PLY file: the format, the elements with their counts, their properties.

(provide read-ply-header
         (struct-out ply-header)
         (struct-out ply-element)
         (struct-out ply-property)
         ply-type-size
         ply-float-type?)

(require racket/fixnum
         "cursor.rkt")

;; format: 'ascii, 'little or 'big; body: the byte offset at which the data starts.
(struct ply-header (format elements body))

;; name: bytes; count: rows; properties: list of ply-property; line: where it stands.
(struct ply-element (name count properties line))

;; name: bytes; type: that of the value, or of the items of a list; count-type: of a list, else #f.
(struct ply-property (name type count-type))

(define types
  (hash #"char" 'int8 #"int8" 'int8 #"uchar" 'uint8 #"uint8" 'uint8
        #"short" 'int16 #"int16" 'int16 #"ushort" 'uint16 #"uint16" 'uint16
        #"int" 'int32 #"int32" 'int32 #"uint" 'uint32 #"uint32" 'uint32
        #"float" 'float32 #"float32" 'float32 #"double" 'float64 #"float64" 'float64))

;; Bytes of one value in the binary formats.
(define (ply-type-size type)
  (case type
    [(int8 uint8) 1]
    [(int16 uint16) 2]
    [(int32 uint32 float32) 4]
    [else 8]))

(define (ply-float-type? type)
  (and (memq type '(float32 float64)) #t))

;; Reads the header and leaves the cursor at the start of the data. Counts are checked against the
;; bytes that follow, so what is allocated later is in proportion to the file.
(define (read-ply-header c)
  (unless (and (cursor-token! c) (cursor-token=? c #"ply") (= 0 (cursor-start c)))
    (cursor-fail c "expected ply as the first word of the file, found ~a" (cursor-found c)))
  (end-line! c)
  (define format (read-format c))
  (end-line! c)
  (define elements (read-elements c))
  (check-counts c format elements)
  (ply-header format elements (cursor-pos c)))

(define (end-line! c)
  (when (cursor-token! c)
    (cursor-fail c "expected the end of the line, found ~a" (cursor-found c)))
  (when (cursor-at-end? c)
    (cursor-fail c "expected the rest of the header, found the end of the file"))
  (cursor-next-line! c))

;; Moves to the first word of the next line that is neither blank nor a comment.
(define (next-statement! c)
  (let loop ()
    (cond
      [(not (cursor-token! c))
       (end-line! c)
       (loop)]
      [(or (cursor-token=? c #"comment") (cursor-token=? c #"obj_info"))
       (cursor-rest! c)
       (end-line! c)
       (loop)])))

(define (read-format c)
  (next-statement! c)
  (unless (cursor-token=? c #"format")
    (cursor-fail c "expected format, found ~a" (cursor-found c)))
  (cursor-token! c)
  (define format
    (cond
      [(cursor-token=? c #"ascii") 'ascii]
      [(cursor-token=? c #"binary_little_endian") 'little]
      [(cursor-token=? c #"binary_big_endian") 'big]
      [else (cursor-fail c "expected ascii, binary_little_endian or binary_big_endian, found ~a"
                         (cursor-found c))]))
  (unless (and (cursor-token! c) (cursor-token=? c #"1.0"))
    (cursor-fail c "expected format version 1.0, found ~a" (cursor-found c)))
  format)

(define (read-elements c)
  (define seen (make-hash))
  (define (check-new! key what)
    (when (hash-ref seen key #f)
      (cursor-fail c "expected each ~a once, found ~a again" what (cursor-found c)))
    (hash-set! seen key #t))
  ;; The element at hand has its properties last first.
  (let loop ([current #f] [done '()])
    (define (finished)
      (if current
          (cons (struct-copy ply-element current
                             [properties (reverse (ply-element-properties current))])
                done)
          done))
    (next-statement! c)
    (cond
      [(cursor-token=? c #"element")
       (define before (finished))
       (define line (cursor-line c))
       (define name (read-name c "the element"))
       (check-new! name "element")
       (define count (cursor-integer! c "the number of rows"))
       (when (< count 0)
         (cursor-fail c "expected a number of rows from 0, found ~a" count))
       (end-line! c)
       (loop (ply-element name count '() line) before)]
      [(cursor-token=? c #"property")
       (unless current
         (cursor-fail c "expected element before property"))
       (define property (read-property c))
       (check-new! (cons (ply-element-name current) (ply-property-name property)) "property")
       (end-line! c)
       (define properties (cons property (ply-element-properties current)))
       (loop (struct-copy ply-element current [properties properties]) done)]
      [(cursor-token=? c #"end_header")
       (define elements (reverse (finished)))
       (end-header! c)
       elements]
      [else
       (cursor-fail c "expected element, property, comment, obj_info or end_header, found ~a"
                    (cursor-found c))])))

(define (read-name c what)
  (unless (cursor-token! c)
    (cursor-fail c "expected the name of ~a, found ~a" what (cursor-found c)))
  (subbytes (cursor-bytes c) (cursor-start c) (cursor-stop c)))

(define (read-type c)
  (define name (read-name c "a type"))
  (or (hash-ref types name #f)
      (cursor-fail c "expected a type such as float, int or uchar, found ~a" (cursor-found c))))

(define (read-property c)
  (cond
    [(and (cursor-token! c) (cursor-token=? c #"list"))
     (define count-type (read-type c))
     (define type (read-type c))
     (ply-property (read-name c "the property") type count-type)]
    [else
     (cursor-rewind-token! c)
     (define type (read-type c))
     (ply-property (read-name c "the property") type #f)]))

;; The data starts right after the line end: its first bytes may look like blanks.
(define (end-header! c)
  (define bytes (cursor-bytes c))
  (define (byte-at i) (if (fx< i (bytes-length bytes)) (bytes-ref bytes i) -1))
  (define stop (cursor-stop c))
  (define newline (if (eqv? 13 (byte-at stop)) (fx+ stop 1) stop))
  (unless (or (eqv? 10 (byte-at newline)) (fx= newline (bytes-length bytes)))
    (cursor-fail c "expected the end of the line after end_header"))
  (cursor-start-line-at! c (fxmin (fx+ newline 1) (bytes-length bytes))))

;; No element may claim more rows than could fit in the bytes after the header.
(define (check-counts c format elements)
  (define (smallest-row element)
    (for/sum ([p (in-list (ply-element-properties element))])
      (cond
        [(eq? format 'ascii) 2]
        [(ply-property-count-type p) => ply-type-size]
        [else (ply-type-size (ply-property-type p))])))
  ;; The last number of a text needs no blank after it.
  (define available
    (+ (fx- (bytes-length (cursor-bytes c)) (cursor-pos c)) (if (eq? format 'ascii) 1 0)))
  (for/fold ([left available]) ([e (in-list elements)])
    (define needed (* (ply-element-count e) (smallest-row e)))
    (when (> needed left)
      (cursor-fail-at c (ply-element-line e)
                      "expected ~a rows of at least ~a bytes, found only ~a bytes left for them"
                      (ply-element-count e) (smallest-row e) left))
    (- left needed))
  (void))
