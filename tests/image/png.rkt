#lang racket/base
;; PNG files: the encoder's bytes against the standard and racket/draw, and reading PNG and JPEG.
(module+ test
  (require file/gunzip racket/class racket/draw racket/flonum racket/port rackunit "support.rkt"
           "../../private/image/image.rkt" "../../private/image/png.rkt"
           "../../private/image/tone.rkt")

  (define (png-bytes image)
    (define out (open-output-bytes))
    (Image-write-png image out)
    (get-output-bytes out))

  ;; the RGB bytes racket/draw sees in a file
  (define (drawn-bytes png width height)
    (define bitmap (read-bitmap (open-input-bytes png)))
    (check-equal? (list (send bitmap get-width) (send bitmap get-height)) (list width height))
    (define argb (make-bytes (* 4 width height)))
    (send bitmap get-argb-pixels 0 0 width height argb)
    (apply bytes-append (for/list ([i (in-range (* width height))])
                          (subbytes argb (+ (* 4 i) 1) (+ (* 4 i) 4)))))

  ;; signature, IHDR with its known checksum for 2x2, 8 bits, RGB, and IEND with its known one
  (define small (png-bytes small-image))
  (check-equal? (subbytes small 0 33)
                (bytes-append #"\211PNG\r\n\32\n" #"\0\0\0\rIHDR" #"\0\0\0\2" #"\0\0\0\2"
                              (bytes 8 2 0 0 0) (bytes #xFD #xD4 #x9A #x73)))
  (check-equal? (subbytes small (- (bytes-length small) 12))
                (bytes-append (bytes 0 0 0 0) #"IEND" (bytes #xAE #x42 #x60 #x82)))

  ;; the zlib stream: header divisible by 31, rows of filter 4, Adler-32 of them
  (define data-start
    (+ 4 (caar (regexp-match-positions #rx#"IDAT" small))))
  (define data
    (subbytes small data-start
              (+ data-start
                 (integer-bytes->integer small #f #t (- data-start 8) (- data-start 4)))))
  (check-equal? (remainder (integer-bytes->integer data #f #t 0 2) 31) 0)
  (define inflated
    (let ([out (open-output-bytes)])
      (inflate (open-input-bytes (subbytes data 2 (- (bytes-length data) 4))) out)
      (get-output-bytes out)))
  (check-equal? inflated
                (bytes-append (bytes 4 255 0 0 1 255 0) (bytes 4 1 0 255 255 0 0)))
  (check-equal? (integer-bytes->integer data #f #t (- (bytes-length data) 4))
                (let ([a (apply + 1 (bytes->list inflated))]
                      [b (for/fold ([sum 0] [a 1] #:result sum) ([byte (in-bytes inflated)])
                           (values (+ sum a byte) (+ a byte)))])
                  (+ (* 65536 b) a)))

  ;; exact: racket/draw reads our bytes back, for noise, gradients and a single pixel
  (define gradient
    (make-Image 61 37 (for*/flvector ([y (in-range 37)] [x (in-range 61)] [c (in-range 3)])
                        (/ (exact->inexact (+ x (* y c))) 110.0))))
  (define images
    (list small-image gradient (random-image 53 29 1 -0.1 1.1) (random-image 1 1 2)
          (random-image 1 40 3) (make-Image 300 200 (make-flvector 180000 0.18))))
  (for ([image (in-list images)])
    (check-equal? (drawn-bytes (png-bytes image) (Image-width image) (Image-height image))
                  (linear->sRGB-bytes (Image-pixels image))))

  (check-equal? (repaired small) small)

  (call-with-folder
   (lambda (folder)
     (define path (build-path folder "picture"))
     (define (read-back bytes) (Image-read-png (write-file path bytes)))
     (define (decoded bytes)
       (for/flvector #:length (bytes-length bytes) ([b (in-bytes bytes)]) (sRGB-decode (/ b 255.0))))
     (define (file-bytes bitmap kind)
       (define out (open-output-bytes))
       (send bitmap save-file out kind)
       (get-output-bytes out))

     ;; exact: read back as decoded bytes
     (check-equal? (read-back small) small-image)
     (for ([image (in-list images)])
       (check-equal? (Image-pixels (read-back (png-bytes image)))
                     (decoded (linear->sRGB-bytes (Image-pixels image)))))
     ;; a PNG by another encoder, with transparency, which is ignored
     (define bitmap (make-bitmap 2 1))
     (send bitmap set-argb-pixels 0 0 2 1 (bytes 255 10 20 30 255 40 50 60))
     (check-equal? (Image-pixels (read-back (file-bytes bitmap 'png)))
                   (decoded (bytes 10 20 30 40 50 60)))

     ;; a JPEG of one colour: every byte within 3 of it
     (define flat (make-bitmap 40 24 #f))
     (define dc (new bitmap-dc% [bitmap flat]))
     (send dc set-background (make-color 180 90 45))
     (send dc clear)
     (define jpeg (file-bytes flat 'jpeg))
     (define photo (Image-read-jpeg (write-file path jpeg)))
     (check-equal? (list (Image-width photo) (Image-height photo)) '(40 24))
     (for ([byte (in-bytes (linear->sRGB-bytes (Image-pixels photo)))] [i (in-naturals)])
       (unless (<= (abs (- byte (list-ref '(180 90 45) (remainder i 3)))) 3)
         (fail (format "byte ~a is ~a" i byte))))

     ;; refused, with file and what was expected
     (define (with-size bytes at size count)
       (bytes-append (subbytes bytes 0 at) size (subbytes bytes (+ at count))))
     (check-one-line (lambda () (read-back #"\211PNG")) "picture: byte 0" "PNG signature")
     (check-one-line (lambda () (read-back (subbytes small 0 20))) "picture: byte 8" "whole")
     (check-one-line (lambda () (read-back (subbytes small 0 33))) "picture: byte 33" "whole")
     (check-one-line (lambda () (read-back (with-size small 40 #"x" 1))) "byte 42" "checksum")
     (define (sized width height) (repaired (with-size small 16 (bytes-append width height) 8)))
     (check-one-line (lambda () (read-back (sized #"\177\377\377\377" #"\177\377\377\377")))
                     "picture: byte 16" "2147483647x2147483647")
     (check-one-line (lambda () (read-back (sized #"\0\0\0\0" #"\0\0\0\1")))
                     "picture: byte 16" "0x1")
     (check-one-line (lambda () (read-back (sized #"\0\0\0\2" #"\0\0\0\3")))
                     "picture: " "PNG of 2x3 pixels" "damaged")
     (define (read-jpeg bytes) (Image-read-jpeg (write-file path bytes)))
     (check-one-line (lambda () (read-jpeg #"\377\330\377")) "picture: byte 2" "JPEG")
     (define frame (caar (regexp-match-positions #rx#"\377\300" jpeg)))
     (check-one-line (lambda () (read-jpeg (with-size jpeg (+ frame 5) #"\377\377\377\377" 4)))
                     (format "picture: byte ~a" frame) "65535x65535")

     ;; mutations: each loads or is refused on one line; with their checksums repaired they reach
     ;; the decoder and do both
     (define image (png-bytes gradient))
     (check-mutations image Image-read-png 200 40)
     (define (read-repaired path)
       (Image-read-png (write-file path (repaired (call-with-input-file path port->bytes)))))
     (define loaded-png (check-mutations image read-repaired 300 300))
     (check-true (< 2 loaded-png 290) (format "~a of 300 mutations loaded" loaded-png))
     (define loaded-jpeg (check-mutations jpeg Image-read-jpeg 200 200))
     (check-true (< 20 loaded-jpeg 180) (format "~a of 200 mutations loaded" loaded-jpeg)))))
