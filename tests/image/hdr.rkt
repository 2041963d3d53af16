#lang racket/base
;; Radiance pictures: golden bytes, precision, both kinds of run-length encoding, all orientations,
;; header settings, and what is refused.
(module+ test
  (require racket/flonum racket/list rackunit "support.rkt"
           "../../private/image/image.rkt" "../../private/image/hdr.rkt")

  (define (hdr-bytes image)
    (define out (open-output-bytes))
    (Image-write-hdr image out)
    (get-output-bytes out))
  (define (numbers image) (for/list ([x (in-flvector (Image-pixels image))]) x))
  (define (image-of width height numbers) (make-Image width height (apply flvector numbers)))
  (define (header width height)
    (string->bytes/latin-1
     (format "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ~a +X ~a\n" height width)))
  (define (picture width height . data) (apply bytes-append (header width height) data))

  ;; 1.0 is 128*2^(129-136); four columns are too few for run lengths
  (define golden
    (picture 2 2 #"\200\0\0\201" #"\0\200\0\201" #"\0\0\200\201" #"\200\200\200\201"))
  (check-equal? (hdr-bytes small-image) golden)

  ;; ten pixels: seven of 1/2 1/2 1/2, then 1 0 2, 3/4 0 0, black
  (define encoded-image
    (image-of 10 1 (append (make-list 21 0.5) '(1.0 0.0 2.0 0.75 0.0 0.0 0.0 0.0 0.0))))
  (define encoded
    (picture 10 1 (bytes 2 2 0 10)
             (bytes (+ 128 7) 128 3 64 192 0)
             (bytes (+ 128 7) 128 (+ 128 3) 0)
             (bytes (+ 128 8) 128 (+ 128 2) 0)
             (bytes (+ 128 7) 128 3 130 128 0)))
  (check-equal? (hdr-bytes encoded-image) encoded)

  (call-with-folder
   (lambda (folder)
     (define path (build-path folder "picture.hdr"))
     (define (read-back bytes) (Image-read-hdr (write-file path bytes)))
     (define (check-exact image) (check-equal? (read-back (hdr-bytes image)) image))
     (check-equal? (read-back golden) small-image)
     (check-equal? (read-back encoded) encoded-image)

     ;; exact: 1 to 255 times a power of two, wherever the largest of a pixel takes 8 bits
     (check-exact (image-of 5 1 (list 255.0 1.0 0.0  0.0 0.0 0.0  (expt 2.0 -128) 0.0 0.0
                                      (* 255.0 (expt 2.0 119)) (expt 2.0 119) 0.0  3.0 3.0 3.0)))
     ;; clamped: beyond the range, infinite, negative, NaN, too dark
     (define largest (* 255.0 (expt 2.0 119)))
     (check-equal?
      (numbers (read-back (hdr-bytes (image-of 3 1 (list 1e300 +inf.0 0.0  -1.0 +nan.0 2.0
                                                         (expt 2.0 -129) 5e-324 -inf.0)))))
      (list largest largest 0.0  0.0 0.0 2.0  0.0 0.0 0.0))

     ;; any other numbers: less than 1/256 of the pixel's largest, flat and encoded, many magnitudes
     (for* ([width (in-list '(1 7 8 37 400))] [power (in-list '(-100 -1 0 1 100))])
       (define factor (flexpt 2.0 (->fl power)))
       (define even (random-image width 9 (+ width 100 power)))
       (define image
         (image-of width 9 (map (lambda (x) (* x x x factor)) (numbers even))))
       (define found (numbers (read-back (hdr-bytes image))))
       (let next ([from (numbers image)] [to found])
         (unless (null? from)
           (define largest (apply max (take from 3)))
           (for ([x (in-list (take from 3))] [y (in-list (take to 3))])
             (unless (< (abs (- x y)) (/ largest 256.0))
               (fail (format "~a below ~a is read as ~a" x largest y))))
           (next (drop from 3) (drop to 3)))))
     ;; what is read once is read again exactly
     (let ([once (read-back (hdr-bytes (random-image 61 5 11)))])
       (check-exact once))

     ;; runs of every length to 260, after and before literals of every length to 3, and literals
     (define (grey-line values)
       (image-of (length values) 1 (append-map (lambda (v) (list v v v)) values)))
     (define (distinct count) (for/list ([k (in-range count)]) (+ 128.0 (modulo (* 37 k) 101))))
     (for* ([run (in-range 1 261)] [before (in-list '(0 1 2 3))] [after (in-list '(5 8))])
       (check-exact (grey-line (append (distinct before) (make-list run 255.0) (distinct after)))))
     (for ([count (in-range 8 400)])
       (check-exact (grey-line (distinct count))))
     ;; lines of random runs, of black too; never longer than flat ones by more than the marks
     (random-seed 7)
     (for ([_ (in-range 100)])
       (define line
         (append* (for/list ([_ (in-range (+ 8 (random 40)))])
                    (make-list (+ 1 (random (vector-ref #(1 3 5 200) (random 4))))
                               (vector-ref #(0.0 128.0 129.0 200.0) (random 4))))))
       (define image (grey-line line))
       (check-exact image)
       (define size (- (bytes-length (hdr-bytes image))
                       (bytes-length (header (length line) 1))))
       (define marks (+ 2 (quotient (length line) 128))) ; for a channel
       (check-true (<= size (* 4 (+ (length line) marks))) (format "~s" line)))
     ;; a grey line is short: 4 bytes, and 2 for every 127 pixels of each channel
     (check-equal? (bytes-length (hdr-bytes (grey-line (make-list 1000 128.0))))
                   (+ (bytes-length (header 1000 1)) 4 (* 4 2 8)))
     ;; the longest line with run lengths, and a longer one without
     (define (wide width) (make-Image width 1 (make-flvector (* 3 width) 0.25)))
     (for ([width (in-list '(32767 32768))] [size (in-list (list (+ 4 (* 4 2 259)) (* 4 32768)))])
       (check-exact (wide width))
       (check-equal? (bytes-length (hdr-bytes (wide width)))
                     (+ size (bytes-length (header width 1)))))

     ;; packets as other writers make them: runs of 1, literals of 128
     (define (reads-as bytes . values)
       (check-equal? (numbers (read-back bytes)) (append-map (lambda (v) (list v v v)) values)))
     (define channel (apply bytes-append (for/list ([_ (in-range 8)]) (bytes 129 128))))
     (apply reads-as (picture 8 1 (bytes 2 2 0 8) channel channel channel (bytes 136 129))
            (make-list 8 1.0))
     (define literal (bytes-append (bytes 128) (make-bytes 128 128) (bytes 2 128 128)))
     (apply reads-as (picture 130 1 (bytes 2 2 0 130) literal literal literal
                              (bytes 255 129 131 129))
            (make-list 130 1.0))

     ;; flat lines and repeated pixels, where lines might be encoded as well
     (define (grey m) (bytes m m m 129))
     (define (greys . numbers) (apply bytes-append (map grey numbers)))
     (define (reads-as-greys bytes numbers)
       (apply reads-as bytes (map (lambda (m) (/ (->fl m) 128.0)) numbers)))
     (reads-as-greys (picture 8 2
                              (greys 3 2 129 255 0 2 4 5)
                              (greys 64) (bytes 1 1 1 5) (greys 32) (bytes 1 1 1 1))
                     '(3 2 129 255 0 2 4 5  64 64 64 64 64 64 32 32))
     ;; 2 2 and at least 128 is a pixel
     (check-equal? (take (numbers (read-back (picture 8 1 (bytes 2 2 128 129) (bytes 1 1 1 7)))) 4)
                   (map (lambda (m) (/ m 128.0)) '(2 2 128 2)))
     ;; marks that follow each other are digits: 2 + 256*1 + 65536*0, and again after a pixel
     (reads-as-greys (picture 262 1 (greys 9) (bytes 1 1 1 2 1 1 1 1 1 1 1 0)
                              (greys 7) (bytes 1 1 1 0 1 1 1 0) (greys 6) (bytes 1 1 1 1))
                     (append (make-list 259 9) '(7 6 6)))
     ;; encoded and flat lines in one picture
     (reads-as-greys (picture 8 2 (bytes 2 2 0 8) channel channel channel (bytes 136 129)
                              (greys 9) (bytes 1 1 1 7))
                     (append (make-list 8 128) (make-list 8 9)))

     ;; all orientations of a picture of 3 x 2: red tells the column, green the row
     (define upright
       (image-of 3 2 '(1.0 1.0 0.0  2.0 1.0 0.0  3.0 1.0 0.0  1.0 2.0 0.0  2.0 2.0 0.0  3.0 2.0 0.0)))
     (define (pixel column row) (bytes (* 64 column) (* 64 row) 0 130))
     (define (in-order order) (apply bytes-append (map (lambda (p) (apply pixel p)) order)))
     (for ([line (in-list '("-Y 2 +X 3" "-Y 2 -X 3" "+Y 2 +X 3" "+Y 2 -X 3"
                            "+X 3 -Y 2" "-X 3 -Y 2" "+X 3 +Y 2" "-X 3 +Y 2"))]
           [order (in-list '(((1 1) (2 1) (3 1) (1 2) (2 2) (3 2))
                             ((3 1) (2 1) (1 1) (3 2) (2 2) (1 2))
                             ((1 2) (2 2) (3 2) (1 1) (2 1) (3 1))
                             ((3 2) (2 2) (1 2) (3 1) (2 1) (1 1))
                             ((1 1) (1 2) (2 1) (2 2) (3 1) (3 2))
                             ((3 1) (3 2) (2 1) (2 2) (1 1) (1 2))
                             ((1 2) (1 1) (2 2) (2 1) (3 2) (3 1))
                             ((3 2) (3 1) (2 2) (2 1) (1 2) (1 1))))])
       (check-equal? (read-back (bytes-append #"#?RADIANCE\n\n" (string->bytes/latin-1 line) #"\n"
                                              (in-order order)))
                     upright
                     line))

     ;; what the header says was applied is divided by; the rest is nothing to the picture
     (define (with-header lines)
       (numbers (read-back (bytes-append lines #"\n-Y 1 +X 1\n\200\100\300\202"))))
     (check-equal? (with-header #"#?RGBE\n") '(2.0 1.0 3.0))
     (check-equal? (with-header #"#?RADIANCE\r\nrview -vp 1\nFORMAT= 32-bit_rle_rgbe \r\n\r")
                   '(2.0 1.0 3.0))
     (check-equal? (with-header #"#?RADIANCE\nEXPOSURE=4.000000e+00\nEXPOSURE= .5\n") '(1.0 0.5 1.5))
     (check-equal? (with-header #"#?RADIANCE\nCOLORCORR= 2 4 0.5\nEXPOSURE=2\n") '(0.5 0.125 3.0))
     (check-equal? (with-header (bytes-append #"#?RADIANCE\n\tEXPOSURE=9\n\tFORMAT=x\n#EXPOSURE=x\n"
                                              #"GAMMA=2\nPRIMARIES=.64 .33 .3 .6 0 0 .3 .3\n"))
                   '(2.0 1.0 3.0))

     ;; refused, with file, place and what was expected
     (define (refused bytes . parts)
       (apply check-one-line (lambda () (read-back bytes)) (path->string path) parts))
     (refused #"" "byte 0" "#?RADIANCE" "end of the file")
     (refused #"P6\n1 1\n255\nabc" "byte 0" "#?RADIANCE" "P6")
     (refused #"#?RADIANCE" "byte 0" "whole header")
     (refused #"#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\nabcd"
              "byte 18" "expected the format 32-bit_rle_rgbe" "\"32-bit_rle_xyze\"")
     (for ([value (in-list '(#"" #"0" #"-1" #"nan" #"inf" #"1e101" #"1e-101"
                             #"1e999" #"1e-999" #"1/2" #"1 2" #"x"))])
       (refused (bytes-append #"#?RADIANCE\nEXPOSURE=" value #"\n\n-Y 1 +X 1\nabcd")
                "byte 20" "expected an exposure of 1e-100 to 1e100"))
     (refused #"#?RADIANCE\nEXPOSURE=1e060\nEXPOSURE=1e060\n\n-Y 1 +X 1\nabcd" "byte 35" "1e060")
     (for ([value (in-list '(#"1" #"1 2" #"1 2 0" #"1 2 3 4" #"1 2 x"))])
       (refused (bytes-append #"#?RADIANCE\nCOLORCORR=" value #"\n\n-Y 1 +X 1\nabcd")
                "byte 21" "a colour correction, three factors of 1e-100 to 1e100"))
     (for ([line (in-list '(#"" #"-Y 1" #"-Y 1 +Y 1" #"-Y 0 +X 1" #"Y 1 X 1" #"-Y 1 +X 1x"
                            #"-Y -1 +X 1" #"-Y 1000000000000000000000 +X 1" #"-Z 1 +X 1"))])
       (refused (bytes-append #"#?RADIANCE\n\n" line #"\nabcd") "byte 12" "a resolution such as"))
     (for ([size (in-list '((1000000000 1000000000) (1 1000000000) (1000000000 1) (100 1000)))])
       (define start (apply header size))
       (refused (bytes-append start (greys 9) (bytes 1 1 1 255))
                (format "byte 35: expected a size that ~a bytes can hold, found ~ax~a pixels"
                        (+ 8 (bytes-length start)) (car size) (cadr size))))
     (define (refused-line width data . parts)
       (define at (bytes-length (header width 1)))
       (apply refused (picture width 1 data)
              (for/list ([p (in-list parts)]) (if (number? p) (format "byte ~a: " (+ at p)) p))))
     (refused-line 2 (greys 9) 4 "whole line of pixels" "end of the file")
     (refused-line 2 (bytes 1 1 1 1 9 9 9 9) 0 "expected a pixel, found its repetition")
     (refused-line 2 (bytes-append (greys 9) (bytes 1 1 1 2)) 4 "at most 1 pixels, found 2")
     (refused-line 300 (bytes-append (greys 9) (bytes 1 1 1 0 1 1 1 2)) 8 "at most 299" "found 512")
     (refused-line 8 (bytes 2 2 0 9 136 1) 2 "a line of 8 pixels, found one of 9")
     (refused-line 8 (bytes 2 2 0 8 137 1 136 1) 4 "a run of 1 to 8 pixels, found one of 9")
     (refused-line 8 (bytes 2 2 0 8 135 1 0 1) 6 "a run of 1 to 1 pixels, found one of 0")
     (refused-line 8 (bytes 2 2 0 8 135 1 2 1 1) 6 "a run of 1 to 1 pixels, found one of 2")
     (refused-line 8 (bytes 2 2 0 8 136 1 136 1 136 1 136) 10 "whole line of pixels")

     ;; cut off anywhere
     (for* ([whole (in-list (list golden encoded
                                  (picture 8 2 (greys 64) (bytes 1 1 1 5) (greys 32) (bytes 1 1 1 1)
                                           (greys 9) (bytes 1 1 1 7))))]
            [size (in-range (bytes-length whole))])
       (refused (subbytes whole 0 size) "byte " "expected "))))

  ;; mutations: each loads or is refused on one line, and the mutations do both
  (for ([original (in-list (list encoded (hdr-bytes (random-image 9 4 3))))])
    (define loaded (check-mutations original Image-read-hdr 250 48))
    (check-true (< 12 loaded 238) (format "~a of 250 mutations loaded" loaded))))

