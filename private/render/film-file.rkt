#lang racket/base
;; A film on disk, for a checkpoint and for a part of a picture: a header that says what render it is of,
;; then tiles, all under checksums. It is written and read tile by tile, so that its size takes no memory.
;;   16 bytes "raytrace film 1\n"; length of the header, 4 bytes; the header in fasl; its SHA-1.
;;   A tile: its number, 4 bytes; its tally and its pixels as doubles; the SHA-1 of the header's SHA-1
;;   and these. Numbers are little-endian.
(require racket/fasl racket/flonum ffi/unsafe/vm "film.rkt" "pixel.rkt" "../image/source.rkt")

(provide (struct-out header) film-file-write film-file-header film-file-load!)

;; kind: 'checkpoint or 'part. settings: pairs of a word and a value, in the order in which a difference
;; is told. part: (list I N) or #f. places: numbers a pixel. state: of the passes. tiles: how many.
(struct header (kind settings part places state tiles) #:prefab)

(define MAGIC #"raytrace film 1\n")
(define LONGEST-HEADER 1000000)
(define CHECKSUM 20)

;; ----------------------------------------------------------------------------------------------
;; Flonums and bytes

;; Copies count flonums from a place in a flvector to a place in bytes, and back.
(define-values (flonums->bytes! bytes->flonums!)
  (with-handlers ([exn:fail?
                   (lambda (e)
                     (values
                      (lambda (bytes at v from count)
                        (for ([k (in-range count)])
                          (real->floating-point-bytes (flvector-ref v (+ from k)) 8 #f bytes
                                                      (+ at (* 8 k)))))
                      (lambda (v to bytes at count)
                        (for ([k (in-range count)])
                          (define start (+ at (* 8 k)))
                          (flvector-set! v (+ to k)
                                         (floating-point-bytes->real bytes #f start (+ start 8)))))))])
    (values
     (vm-eval '(lambda (bytes at v from count)
                 (let loop ([k 0])
                   (when (fx< k count)
                     (bytevector-ieee-double-set! bytes (fx+ at (fx* 8 k)) (flvector-ref v (fx+ from k))
                                                  'little)
                     (loop (fx+ k 1))))))
     (vm-eval '(lambda (v to bytes at count)
                 (let loop ([k 0])
                   (when (fx< k count)
                     (flvector-set! v (fx+ to k)
                                    (bytevector-ieee-double-ref bytes (fx+ at (fx* 8 k)) 'little))
                     (loop (fx+ k 1)))))))))

;; ----------------------------------------------------------------------------------------------
;; Tiles

;; The flvectors that hold a target's pixels, each with its numbers a pixel.
(define (target-planes target)
  (define errors (Target-errors target))
  (cond
    [(not errors) (list (cons (Target-film target) pixel-places))]
    [(zero? (flvector-length errors)) (list (cons (Target-film target) 3))]
    [else (list (cons (Target-film target) 3) (cons errors 3))]))

(define (target-places target) (apply + (map cdr (target-planes target))))

(define (tile-pixels tiling tile)
  (define-values (x0 y0 x1 y1) (Tiling-bounds tiling tile))
  (* (- x1 x0) (- y1 y0)))

;; Calls act with every row of a tile: a flvector, where the row is there, its length, and where it is
;; among the bytes of a record.
(define (for-each-row tiling target tile act)
  (define-values (x0 y0 x1 y1) (Tiling-bounds tiling tile))
  (define width (caddr (Tiling-crop tiling)))
  (for*/fold ([at (+ 4 (* 8 tally-places))])
             ([plane (in-list (target-planes target))] [y (in-range y0 y1)])
    (define count (* (cdr plane) (- x1 x0)))
    (act (car plane) (* (cdr plane) (+ x0 (* y width))) count at)
    (+ at (* 8 count))))

;; Puts a tile as it is into the record; returns the record's length without its checksum.
(define (tile->bytes! record tiling target tile)
  (integer->integer-bytes tile 4 #f #f record 0)
  (flonums->bytes! record 4 (Target-tallies target) (* tile tally-places) tally-places)
  (for-each-row tiling target tile
                (lambda (v from count at) (flonums->bytes! record at v from count))))

(define TRIES 1000)

;; The same between two writes of the tile by its worker; #f where it is being written all the time.
(define (settled-tile->bytes! record tiling target tile)
  (let try ([left TRIES])
    (define before (Target-version target tile))
    (memory-order-acquire)
    (define length (and (even? before) (tile->bytes! record tiling target tile)))
    (memory-order-acquire)
    (cond
      [(and length (= before (Target-version target tile))) length]
      [(zero? left) #f]
      [else (sleep 0.001) (try (- left 1))])))

(define (largest-record tiling target)
  (define side (Tiling-tile tiling))
  (define crop (Tiling-crop tiling))
  (+ 4 (* 8 tally-places)
     (* 8 (target-places target) (min side (caddr crop)) (min side (cadddr crop)))))

;; ----------------------------------------------------------------------------------------------
;; Writing

;; film-file-write : writes what is done to an output port. Where pixels are finished in one pass that
;; is the tiles that are done, else all of them as they are. Returns whether all could be read.
(define (film-file-write out kind settings part state tiling target)
  (define finished? (and (Target-errors target) #t))
  (define tiles
    (for/list ([tile (in-range (tile-count tiling))]
               #:when (or (not finished?)
                          (let ([version (Target-version target tile)])
                            (and (positive? version) (even? version)))))
      tile))
  (define head
    (let* ([body (s-exp->fasl (header kind settings part (target-places target) state (length tiles)))])
      (bytes-append MAGIC (integer->integer-bytes (bytes-length body) 4 #f #f) body)))
  (define head-sum (sha1-bytes head))
  (write-bytes head out)
  (write-bytes head-sum out)
  (define record (make-bytes (largest-record tiling target)))
  (for/and ([tile (in-list tiles)])
    (define length (settled-tile->bytes! record tiling target tile))
    (when length
      (write-bytes record out 0 length)
      (write-bytes (record-sum head-sum record length) out))
    (and length #t)))

(define (record-sum head-sum record length)
  (sha1-bytes (bytes-append head-sum (sha1-bytes record 0 length))))

;; ----------------------------------------------------------------------------------------------
;; Reading

;; film-file-header : the header of a file. what: "a checkpoint" or alike. Raises exn:fail:user with one
;; line that names the file where it is none.
(define (film-file-header path what)
  (call-with-film-file path (lambda (in) (let-values ([(head sum) (read-header path in what)]) head))))

;; film-file-load! : puts the tiles of a file into the target; returns the numbers of them. Raises
;; exn:fail:user where the file is damaged or does not fit the target.
(define (film-file-load! path what tiling target)
  (call-with-film-file
   path
   (lambda (in)
     (define-values (head head-sum) (read-header path in what))
     (define count (tile-count tiling))
     (define record (make-bytes (largest-record tiling target)))
     (unless (= (header-places head) (target-places target))
       (damaged path in what))
     (define tiles
       (for/fold ([tiles '()]) ([k (in-range (header-tiles head))])
         (define start (file-position in))
         (unless (eqv? 4 (read-bytes! record in 0 4)) (truncated path in what))
         (define tile (integer-bytes->integer record #f #f 0 4))
         (unless (< (if (null? tiles) -1 (car tiles)) tile count) (damaged path start what))
         (define length
           (+ 4 (* 8 tally-places) (* 8 (target-places target) (tile-pixels tiling tile))))
         (unless (eqv? (- length 4) (read-bytes! record in 4 length)) (truncated path in what))
         (define sum (read-bytes CHECKSUM in))
         (unless (and (bytes? sum) (= (bytes-length sum) CHECKSUM)) (truncated path in what))
         (unless (equal? sum (record-sum head-sum record length)) (damaged path start what))
         (bytes->flonums! (Target-tallies target) (* tile tally-places) record 4 tally-places)
         (for-each-row tiling target tile
                       (lambda (v to count at) (bytes->flonums! v to record at count)))
         (cons tile tiles)))
     (unless (eof-object? (peek-byte in))
       (picture-error path "byte ~a: expected the end of ~a, found more" (file-position in) what))
     (reverse tiles))))

(define (call-with-film-file path use)
  (define in
    (with-handlers ([exn:fail:filesystem?
                     (lambda (e) (picture-error path "cannot be read (~a)" (error-reason e)))])
      (open-input-file path)))
  (dynamic-wind void (lambda () (use in)) (lambda () (close-input-port in))))

(define (read-header path in what)
  (define magic (read-bytes (bytes-length MAGIC) in))
  (unless (equal? magic MAGIC)
    (picture-error path "byte 0: expected ~a, found another kind of file" what))
  (define length-bytes (read-bytes 4 in))
  (unless (and (bytes? length-bytes) (= 4 (bytes-length length-bytes))) (truncated path in what))
  (define length (integer-bytes->integer length-bytes #f #f))
  (unless (<= length LONGEST-HEADER) (damaged path (bytes-length MAGIC) what))
  (define body (read-bytes length in))
  (unless (and (bytes? body) (= length (bytes-length body))) (truncated path in what))
  (define sum (read-bytes CHECKSUM in))
  (unless (and (bytes? sum) (= CHECKSUM (bytes-length sum))) (truncated path in what))
  (unless (equal? sum (sha1-bytes (bytes-append magic length-bytes body))) (damaged path 0 what))
  (define head (fasl->s-exp body))
  (unless (header? head) (damaged path 0 what))
  (values head sum))

(define (truncated path in what)
  (picture-error path "byte ~a: expected more of ~a, found the end of the file"
                 (file-position in) what))

(define (damaged path at what)
  (picture-error path "byte ~a: expected ~a, found damaged data"
                 (if (input-port? at) (file-position at) at) what))
