#lang racket/base
;; PNG: a small encoder (8-bit RGB, sRGB) that needs no drawing library; PNG and JPEG files are
;; read by racket/draw, which is loaded at the first such file.
(provide Image-write-png encode-png Image-read-png Image-read-jpeg)
(require file/gzip racket/flonum racket/fixnum racket/lazy-require
         "image.rkt" "tone.rkt" "source.rkt")

(lazy-require ["draw.rkt" (decode-picture)])

;; Image-write-png : writes the image to an output port, 8 bits, sRGB-encoded.
(define (Image-write-png image out)
  (write-bytes (encode-png (Image-width image) (Image-height image)
                           (linear->sRGB-bytes (Image-pixels image)))
               out)
  (void))

;; ----------------------------------------------------------------------------------------------
;; Encoding (ISO/IEC 15948)

;; encode-png : a PNG file's bytes from width x height sRGB pixels, three bytes each, top row first.
(define (encode-png width height rgb)
  (define (big-endian n) (integer->integer-bytes n 4 #f #t))
  (bytes-append
   SIGNATURE
   (chunk #"IHDR" (bytes-append (big-endian width) (big-endian height) (bytes 8 2 0 0 0)))
   (chunk #"sRGB" (bytes 0))
   (chunk #"IDAT" (zlib-compress (filter-rows width height rgb)))
   (chunk #"IEND" #"")))

(define SIGNATURE (bytes #x89 #x50 #x4E #x47 #x0D #x0A #x1A #x0A))

(define (chunk type data)
  (define body (bytes-append type data))
  (bytes-append (integer->integer-bytes (bytes-length data) 4 #f #t)
                body
                (integer->integer-bytes (crc32 body) 4 #f #t)))

;; Each row after its filter's number, here always 4: what remains of a byte after the Paeth
;; prediction from its left, upper and upper left neighbours, which compresses best as a rule.
(define (filter-rows width height rgb)
  (define row-length (* 3 width))
  (define filtered (make-bytes (* height (+ row-length 1)) 4))
  (for ([y (in-range height)])
    (define from (fx* y row-length))
    (define to (fx+ 1 (fx* y (fx+ row-length 1))))
    (define above (fx- from row-length))
    (for ([i (in-range row-length)])
      (define left (if (fx< i 3) 0 (bytes-ref rgb (fx+ from (fx- i 3)))))
      (define up (if (eqv? y 0) 0 (bytes-ref rgb (fx+ above i))))
      (define up-left
        (if (or (eqv? y 0) (fx< i 3)) 0 (bytes-ref rgb (fx+ above (fx- i 3)))))
      (bytes-set! filtered (fx+ to i)
                  (fxand 255 (fx- (bytes-ref rgb (fx+ from i)) (paeth left up up-left))))))
  filtered)

;; The neighbour nearest to left + up - up-left; ties go in the order of the arguments.
(define (paeth left up up-left)
  (define from-left (fxabs (fx- up up-left)))
  (define from-up (fxabs (fx- left up-left)))
  (define from-up-left (fxabs (fx- (fx+ left up) (fx* 2 up-left))))
  (cond [(and (fx<= from-left from-up) (fx<= from-left from-up-left)) left]
        [(fx<= from-up from-up-left) up]
        [else up-left]))

;; A zlib stream (RFC 1950): header for deflate with a 32 KiB window, the data, its checksum.
(define (zlib-compress data)
  (define out (open-output-bytes))
  (write-bytes (bytes #x78 #x9C) out)
  (deflate (open-input-bytes data) out)
  (write-bytes (integer->integer-bytes (adler32 data) 4 #f #t) out)
  (get-output-bytes out #t))

(define (adler32 data)
  (for/fold ([sum 1] [sum-of-sums 0] #:result (+ (* 65536 sum-of-sums) sum))
            ([byte (in-bytes data)])
    (define next (fxmodulo (fx+ sum byte) 65521))
    (values next (fxmodulo (fx+ sum-of-sums next) 65521))))

(define crc-table
  (for/vector #:length 256 ([n (in-range 256)])
    (for/fold ([c n]) ([_ (in-range 8)])
      (if (odd? c)
          (bitwise-xor #xEDB88320 (arithmetic-shift c -1))
          (arithmetic-shift c -1)))))

(define (crc32 data)
  (for/fold ([crc #xFFFFFFFF] #:result (bitwise-xor crc #xFFFFFFFF)) ([byte (in-bytes data)])
    (fxxor (vector-ref crc-table (fxand 255 (fxxor crc byte))) (fxrshift crc 8))))

;; ----------------------------------------------------------------------------------------------
;; Reading

;; The decoders behind racket/draw do not end when a file does, so what they are given is whole:
;; checked here chunk by chunk or segment by segment. Deflate spends at least one byte on 1032,
;; JPEG at least one bit on 64 samples, so a header that claims more than the file can hold is
;; refused before memory follows it.
(define PNG-RATIO 1032)
(define JPEG-RATIO 512)

;; Image-read-png : the Image in a PNG file, taken as sRGB and decoded to linear; transparency is
;; ignored. Raises exn:fail:user with the file and the byte offset when it is malformed.
(define (Image-read-png path)
  (define bytes (read-picture-file path (list SIGNATURE) "a PNG signature"))
  (define chunks (png-chunks path bytes))
  (unless (and (equal? (chunk-type (car chunks)) #"IHDR") (= (bytes-length (car chunks)) 25))
    (picture-error path "byte 8: expected the IHDR chunk of a PNG"))
  (define width (integer-bytes->integer bytes #f #t 16 20))
  (define height (integer-bytes->integer bytes #f #t 20 24))
  (define channels (case (bytes-ref bytes 25) [(2) 3] [(4) 2] [(6) 4] [else 1]))
  (define bits-per-pixel (* (bytes-ref bytes 24) channels))
  (check-claim path bytes 16 width height (quotient (+ (* width bits-per-pixel) 7) 8) PNG-RATIO)
  ;; the other chunks are advice, some of which the decoder follows according to the environment
  (define wanted
    (for/list ([c (in-list chunks)]
               #:when (member (chunk-type c) '(#"IHDR" #"PLTE" #"tRNS" #"IDAT" #"IEND")))
      c))
  (decode path (apply bytes-append SIGNATURE wanted) "a PNG" width height))

;; All chunks up to IEND, each with its length, type and checksum.
(define (png-chunks path bytes)
  (define end (bytes-length bytes))
  (let next-chunk ([at 8] [chunks '()])
    (define stop
      (if (<= (+ at 12) end) (+ at 12 (integer-bytes->integer bytes #f #t at (+ at 4))) +inf.0))
    (unless (<= stop end)
      (picture-error path "byte ~a: expected a whole PNG chunk, found the end of the file" at))
    (unless (= (crc32 (subbytes bytes (+ at 4) (- stop 4)))
               (integer-bytes->integer bytes #f #t (- stop 4) stop))
      (picture-error path "byte ~a: expected the checksum of a PNG chunk, found another" (- stop 4)))
    (define this (subbytes bytes at stop))
    (if (equal? (chunk-type this) #"IEND")
        (reverse (cons this chunks))
        (next-chunk stop (cons this chunks)))))

(define (chunk-type chunk)
  (subbytes chunk 4 8))

;; Image-read-jpeg : the same for a JPEG file.
(define (Image-read-jpeg path)
  (define bytes (read-picture-file path '(#"\377\330") "a JPEG start marker"))
  (define frame (jpeg-frame path bytes))
  (define width (integer-bytes->integer bytes #f #t (+ frame 7) (+ frame 9)))
  (define height (integer-bytes->integer bytes #f #t (+ frame 5) (+ frame 7)))
  (check-claim path bytes frame width height width JPEG-RATIO)
  ;; end markers follow, further than any segment reaches
  (define padding (apply bytes-append (for/list ([_ (in-range 40000)]) #"\377\331")))
  (decode path (bytes-append bytes padding) "a JPEG" width height))

;; The offset of the frame header (SOF) in a sequence of segments that lasts to the end marker.
(define (jpeg-frame path bytes)
  (define end (bytes-length bytes))
  (define (fail at)
    (picture-error path "byte ~a: expected a JPEG segment, found ~a"
                   (min at end) (show-bytes (subbytes bytes (min at end) (min (+ at 2) end)))))
  (let next-segment ([at 2] [frame #f])
    (unless (and (<= (+ at 2) end) (eqv? (bytes-ref bytes at) #xFF)) (fail at))
    (define marker (bytes-ref bytes (+ at 1)))
    (define (segment-end)
      (unless (<= (+ at 4) end) (fail at))
      (define stop (+ at 2 (integer-bytes->integer bytes #f #t (+ at 2) (+ at 4))))
      (unless (<= (+ at 4) stop end) (fail at))
      stop)
    (cond [(eqv? marker #xFF) (next-segment (+ at 1) frame)] ; padding
          [(eqv? marker #xD9) (or frame (fail at))]
          [(eqv? marker #xDA) (next-segment (scan-end bytes (segment-end)) frame)]
          [(and (<= #xC0 marker #xCF) (not (memv marker '(#xC4 #xC8 #xCC))))
           (unless (>= (- (segment-end) at) 10) (fail at))
           (next-segment (segment-end) (or frame at))]
          [(>= marker #xC0) (next-segment (segment-end) frame)]
          [else (fail at)])))

;; Where the coded data that begin at an offset end: at a marker that is neither a stuffed zero
;; nor a restart, or at the end of the file.
(define (scan-end bytes start)
  (define last (- (bytes-length bytes) 1))
  (let loop ([at start])
    (cond [(>= at last) (+ last 1)]
          [(and (eqv? (bytes-ref bytes at) #xFF)
                (not (or (eqv? (bytes-ref bytes (+ at 1)) 0)
                         (<= #xD0 (bytes-ref bytes (+ at 1)) #xD7))))
           at]
          [else (loop (+ at 1))])))

(define (check-claim path bytes offset width height bytes-per-row ratio)
  (unless (and (positive? width) (positive? height)
               (<= (* height bytes-per-row) (* ratio (bytes-length bytes))))
    (picture-error path "byte ~a: expected a size that ~a bytes can hold, found ~ax~a pixels"
                   offset (bytes-length bytes) width height)))

(define (decode path bytes what width height)
  (define rgb (decode-picture bytes width height))
  (unless rgb
    (picture-error path "expected ~a of ~ax~a pixels, found damaged data" what width height))
  (define decoded (sRGB-decoding-table 255))
  (make-Image width height
              (for/flvector #:length (* 3 width height) ([byte (in-bytes rgb)])
                (flvector-ref decoded byte))))
