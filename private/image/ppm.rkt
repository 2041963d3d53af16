#lang racket/base
;; Netpbm's portable pixmap: writes binary P6 with sRGB bytes, reads P6 and plain P3.
(provide Image-write-ppm Image-read-ppm)
(require racket/flonum racket/fixnum "image.rkt" "tone.rkt" "source.rkt")

;; Numbers encoded at once: large enough to be fast, small enough to stay in the cache.
(define CHUNK 49152)

;; Image-write-ppm : writes the image to an output port as P6, 8 bits, sRGB-encoded, top row first.
(define (Image-write-ppm image out)
  (define pixels (Image-pixels image))
  (define width (Image-width image))
  (define height (Image-height image))
  (define count (* 3 width height))
  (define buffer (make-bytes (min CHUNK count)))
  (write-string (format "P6\n~a ~a\n255\n" width height) out)
  (for ([start (in-range 0 count CHUNK)])
    (define size (min CHUNK (- count start)))
    (linear->sRGB-bytes! buffer 0 pixels start size)
    (write-bytes buffer out 0 size))
  (void))

;; Image-read-ppm : the Image in a P6 or P3 file, sRGB decoded to linear; white is the file's
;; maximum, 1 to 65535. Of a sequence of pictures it reads the first. Raises exn:fail:user with
;; the file and the byte offset (P6 and headers) or line (samples of P3) when it is malformed.
(define (Image-read-ppm path)
  (define bytes (read-picture-file path '(#"P6" #"P3") "P6 or P3"))
  (define binary? (equal? (magic-word path bytes) #"P6"))
  (define-values (width after-width) (positive-word path bytes 2 "width"))
  (define-values (height after-height) (positive-word path bytes after-width "height"))
  (define-values (maximum stop) (positive-word path bytes after-height "maximum of at most 65535"))
  (when (> maximum 65535)
    (picture-error path "byte ~a: expected a maximum of at most 65535, found ~a"
                   after-height maximum))
  (make-Image width height
              (if binary?
                  (binary-samples path bytes stop width height maximum)
                  (plain-samples path bytes stop width height maximum))))

;; The samples after the header of a P6 file: one byte each, or two with the high one first.
(define (binary-samples path bytes stop width height maximum)
  (define sample-size (if (< maximum 256) 1 2))
  (define start (check-sample-bytes path bytes stop width height (* 3 sample-size)))
  (define decoded (sRGB-decoding-table maximum))
  (define pixels (make-flvector (* 3 width height)))
  (for ([i (in-range (flvector-length pixels))])
    (define at (fx+ start (fx* sample-size i)))
    (define sample
      (if (eqv? sample-size 1)
          (bytes-ref bytes at)
          (fxior (fxlshift (bytes-ref bytes at) 8) (bytes-ref bytes (fx+ at 1)))))
    (when (fx> sample maximum)
      (picture-error path "byte ~a: expected a sample of at most ~a, found ~a" at maximum sample))
    (flvector-set! pixels i (flvector-ref decoded sample)))
  pixels)

;; The samples after the header of a P3 file: decimal numbers. Each takes two bytes at least, with
;; the white space before it, which bounds the memory by the file's size.
(define (plain-samples path bytes stop width height maximum)
  (define count (* 3 width height))
  (when (< (- (bytes-length bytes) stop) (* 2 count))
    (picture-error path "byte ~a: expected ~a samples for ~ax~a pixels, found ~a bytes"
                   stop count width height (- (bytes-length bytes) stop)))
  (define decoded (sRGB-decoding-table maximum))
  (define pixels (make-flvector count))
  (for/fold ([at stop]) ([i (in-range count)])
    (define start (word-start bytes at))
    (define end (word-end bytes start))
    (define sample (decimal bytes start end maximum))
    (unless sample
      (picture-error path "line ~a: expected a sample of 0 to ~a, found ~a"
                     (line-of bytes start) maximum (show-bytes (subbytes bytes start end))))
    (flvector-set! pixels i (flvector-ref decoded sample))
    end)
  pixels)

;; The decimal number between two offsets, or #f if it is none or exceeds the maximum.
(define (decimal bytes start end maximum)
  (and (fx< start end)
       (let loop ([i start] [value 0])
         (cond [(fx> value maximum) #f]
               [(fx= i end) value]
               [(fx<= 48 (bytes-ref bytes i) 57)
                (loop (fx+ i 1) (fx+ (fx* 10 value) (fx- (bytes-ref bytes i) 48)))]
               [else #f]))))

(define (line-of bytes offset)
  (for/fold ([line 1]) ([byte (in-bytes bytes 0 offset)] #:when (eqv? byte 10))
    (+ line 1)))
