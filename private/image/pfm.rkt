#lang racket/base
;; Portable float map: linear 32-bit floats, bottom row first. Writes colour (PF) with the low byte
;; first, reads colour and grey (Pf) in both byte orders.
(provide Image-write-pfm Image-read-pfm)
(require racket/flonum racket/fixnum "image.rkt" "source.rkt")

;; Image-write-pfm : writes the image to an output port, linear, rounded to single precision;
;; numbers beyond its range become infinite.
(define (Image-write-pfm image out)
  (define width (Image-width image))
  (define height (Image-height image))
  (define pixels (Image-pixels image))
  (define row-length (* 3 width))
  (define buffer (make-bytes (* 4 row-length)))
  (write-string (format "PF\n~a ~a\n-1.0\n" width height) out)
  (for ([y (in-range (- height 1) -1 -1)])
    (define start (fx* y row-length))
    (for ([i (in-range row-length)])
      (real->floating-point-bytes (flvector-ref pixels (fx+ start i)) 4 #f buffer (fx* 4 i)))
    (write-bytes buffer out))
  (void))

;; Image-read-pfm : the Image in a PF or Pf file; grey fills all three channels. The sign of the
;; scale tells the byte order (negative: low byte first), its magnitude multiplies the samples.
;; Raises exn:fail:user with the file and the byte offset when it is malformed.
(define (Image-read-pfm path)
  (define bytes (read-picture-file path '(#"PF" #"Pf") "PF or Pf"))
  (define channels (if (equal? (magic-word path bytes) #"PF") 3 1))
  (define-values (width after-width) (positive-word path bytes 2 "width"))
  (define-values (height after-height) (positive-word path bytes after-width "height"))
  (define-values (scale stop) (scale-word path bytes after-height))
  (define start (check-sample-bytes path bytes stop width height (* 4 channels)))
  (define big-endian? (positive? scale))
  (define magnitude (abs scale))
  (define pixels (make-flvector (* 3 width height)))
  (for ([y (in-range height)])
    (define row (fx* 3 (fx* width (fx- (fx- height 1) y))))
    (define row-start (fx+ start (fx* y (fx* width (fx* 4 channels)))))
    (for ([i (in-range (* 3 width))])
      (define sample (if (eqv? channels 3) i (fxquotient i 3)))
      (define at (fx+ row-start (fx* 4 sample)))
      (define value (floating-point-bytes->real bytes big-endian? at (fx+ at 4)))
      (flvector-set! pixels (fx+ row i) (fl* magnitude value))))
  (make-Image width height pixels))

;; The header's scale, a finite decimal number other than 0, and the offset after it.
(define (scale-word path bytes start)
  (define begin (word-start bytes start))
  (define stop (word-end bytes begin))
  (define word (subbytes bytes begin stop))
  (define scale (finite-decimal word))
  (unless (and scale (< 0.0 (abs scale)))
    (picture-error path "byte ~a: expected a scale, a finite number other than 0, found ~a"
                   begin (show-bytes word)))
  (values scale stop))
