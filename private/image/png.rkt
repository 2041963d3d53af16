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

;; Deflate spends at least one byte on 1032, JPEG at least one bit on a block of 64 samples, so a
;; header that claims more than the file can hold is refused before any memory follows it.
(define PNG-RATIO 1032)
(define JPEG-RATIO 512)

;; Image-read-png : the Image in a PNG file, sRGB decoded to linear, transparency ignored. Raises
;; exn:fail:user with the file and what was expected when it is malformed.
(define (Image-read-png path)
  (define bytes (read-picture-file path (list SIGNATURE) "a PNG signature"))
  (unless (and (>= (bytes-length bytes) 33) (equal? (subbytes bytes 12 16) #"IHDR"))
    (picture-error path "byte 8: expected the IHDR chunk of a PNG"))
  (define width (integer-bytes->integer bytes #f #t 16 20))
  (define height (integer-bytes->integer bytes #f #t 20 24))
  (define channels (case (bytes-ref bytes 25) [(2) 3] [(4) 2] [(6) 4] [else 1]))
  (define bits-per-pixel (* (bytes-ref bytes 24) channels))
  (check-claim path bytes 16 width height (quotient (+ (* width bits-per-pixel) 7) 8) PNG-RATIO)
  (decode path bytes "a PNG" width height))

;; Image-read-jpeg : the same for a JPEG file.
(define (Image-read-jpeg path)
  (define bytes (read-picture-file path '(#"\377\330") "a JPEG start marker"))
  (define-values (frame width height) (jpeg-size path bytes))
  (check-claim path bytes frame width height width JPEG-RATIO)
  (decode path bytes "a JPEG" width height))

(define (check-claim path bytes offset width height bytes-per-row ratio)
  (unless (and (positive? width) (positive? height)
               (<= (* height bytes-per-row) (* ratio (bytes-length bytes))))
    (picture-error path "byte ~a: expected a size that ~a bytes can hold, found ~ax~a pixels"
                   offset (bytes-length bytes) width height)))

;; Where the frame header (SOF) stands, and the width and height in it.
(define (jpeg-size path bytes)
  (define end (bytes-length bytes))
  (define (fail at)
    (picture-error path "byte ~a: expected a JPEG segment or frame header" at))
  (let next-segment ([at 2])
    (unless (and (< (+ at 9) end) (eqv? (bytes-ref bytes at) #xFF)) (fail at))
    (define marker (bytes-ref bytes (+ at 1)))
    (cond [(eqv? marker #xFF) (next-segment (+ at 1))] ; padding
          [(and (<= #xC0 marker #xCF) (not (memv marker '(#xC4 #xC8 #xCC))))
           (values at
                   (integer-bytes->integer bytes #f #t (+ at 7) (+ at 9))
                   (integer-bytes->integer bytes #f #t (+ at 5) (+ at 7)))]
          [(or (<= #xD0 marker #xDA) (< marker #xC0)) (fail at)]
          [else (next-segment (+ at 2 (integer-bytes->integer bytes #f #t (+ at 2) (+ at 4))))])))

;; decode-picture gives the red, green and blue bytes, or #f.
(define (decode path bytes what width height)
  (define rgb (decode-picture bytes width height))
  (unless rgb
    (picture-error path "expected ~a of ~ax~a pixels, found damaged data" what width height))
  (define decoded (sRGB-decoding-table 255))
  (make-Image width height
              (for/flvector #:length (* 3 width height) ([byte (in-bytes rgb)])
                (flvector-ref decoded byte))))
