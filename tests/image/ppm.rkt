#lang racket/base
;; PPM files: golden bytes, what is read back, and what is refused.
(module+ test
  (require racket/flonum rackunit "support.rkt"
           "../../private/image/image.rkt" "../../private/image/ppm.rkt"
           "../../private/image/tone.rkt")

  (define (ppm-bytes image)
    (define out (open-output-bytes))
    (Image-write-ppm image out)
    (get-output-bytes out))

  (define golden #"P6\n2 2\n255\n\377\0\0\0\377\0\0\0\377\377\377\377")
  (check-equal? (ppm-bytes small-image) golden)
  ;; the transfer function, clamping and NaN reach the file
  (check-equal? (ppm-bytes (make-Image 2 1 (flvector 0.18 0.5 0.9 -1.0 7.0 +nan.0)))
                #"P6\n2 1\n255\n\166\274\363\0\377\0")
  ;; longer than one chunk and not a multiple of it
  (define long-image (random-image 259 131 7 -0.1 1.1))
  (check-equal? (subbytes (ppm-bytes long-image) 15)
                (linear->sRGB-bytes (Image-pixels long-image)))

  (call-with-folder
   (lambda (folder)
     (define path (build-path folder "picture"))
     (define (read-back bytes) (Image-read-ppm (write-file path bytes)))
     (define (numbers bytes) (for/list ([x (in-flvector (Image-pixels (read-back bytes)))]) x))

     ;; exact: what was written, after rounding to bytes
     (check-equal? (read-back golden) small-image)
     (check-equal? (ppm-bytes (read-back (ppm-bytes long-image))) (ppm-bytes long-image))
     (for ([byte (in-bytes (linear->sRGB-bytes (Image-pixels long-image)))]
           [x (in-flvector (Image-pixels (read-back (ppm-bytes long-image))))])
       (unless (= x (sRGB-decode (/ byte 255.0))) (fail (format "~a read as ~a" byte x))))

     ;; comments, any white space, other maxima, two bytes a sample, a picture after the first
     (check-equal? (read-back (bytes-append #"P6 # red green\n2# two\n\t2\r\n# and\n255\n"
                                            #"\377\0\0\0\377\0\0\0\377\377\377\377"))
                   small-image)
     (check-equal? (read-back (bytes-append golden #"P6\n1 1\n255\nxyz")) small-image)
     (check-equal? (numbers #"P6 1 1 100\n\0\62\144") (list 0.0 (sRGB-decode 0.5) 1.0))
     (check-equal? (numbers #"P6 1 1 65535\n\0\0\200\0\377\377")
                   (list 0.0 (sRGB-decode (/ 32768.0 65535.0)) 1.0))
     (check-equal? (numbers #"P6 1 1 256\n\0\0\0\200\1\0") (list 0.0 (sRGB-decode 0.5) 1.0))

     ;; plain
     (check-equal? (read-back #"P3\n2 2\n255\n255 0 0  0 255 0\n0 0 255 # blue\n 255 255 255\n")
                   small-image)
     (check-equal? (numbers #"P3 1 1 65535 0 13107 65535")
                   (list 0.0 (sRGB-decode 0.2) 1.0))
     (check-equal? (numbers #"P3 1 1 1\n0 1 1") '(0.0 1.0 1.0))

     ;; refused, with file, place and what was expected
     (define (refused bytes . parts)
       (apply check-one-line (lambda () (read-back bytes)) (path->string path) parts))
     (refused #"" "byte 0" "P6 or P3" "end of the file")
     (refused #"P5\n1 1\n255\n\0" "byte 0" "P6 or P3" "P5")
     (refused #"P62 2 255\n" "byte 2" "white space")
     (refused #"P6" "byte 2" "width")
     (refused #"P6\n0 2\n255\n" "byte 3" "positive width" "\"0\"")
     (refused #"P6\n2 -2\n255\n" "byte 5" "positive height" "\"-2\"")
     (refused #"P6\n2 2\n0\n" "byte 7" "maximum")
     (refused #"P6\n2 2\n65536\n" "maximum of at most 65535" "65536")
     (refused #"P6\n1e9 2\n255\n" "positive width" "1e9")
     (refused #"P6\n2 2\n255" "byte 10" "white space" "end of the file")
     (refused (subbytes golden 0 22) "byte 11" "12 bytes of samples for 2x2 pixels" "found 11")
     (refused #"P6\n1000000000 1000000000\n255\nabc" "3000000000000000000 bytes" "found 3")
     (refused #"P6\n999999999999999999 999999999999999999\n65535\n" "bytes of samples")
     (refused #"P6\n1000000000000000000 1\n255\n" "positive width")
     (refused #"P6 1 1 100\n\0\145\0" "byte 12" "at most 100" "101")
     (refused #"P3\n1 1\n255\n0 0\n" "byte 10" "3 samples" "5 bytes")
     (refused #"P3\n1 1\n255\n0 0\n256" "line 5" "0 to 255" "256")
     (refused #"P3\n1 1\n255\n0\n-1 0" "line 5" "-1")
     (refused #"P3\n1 1\n255\n0 0     " "line 4" "end of the file")
     (refused #"P3\n1000000000 1000000000\n255\n0 0 0" "3000000000000000000 samples")
     (check-one-line (lambda () (Image-read-ppm (build-path folder "absent.ppm")))
                     "absent.ppm" "no such file")
     (check-one-line (lambda () (Image-read-ppm folder)) "folder")))

  ;; mutations: each loads or is refused on one line, and the mutations do both
  (define plain #"P3\n# four\n2 2\n255\n255 0 0  0 255 0\n0 0 255  255 255 255\n")
  (for ([bytes (in-list (list golden plain))] [header (in-list '(12 20))])
    (define loaded (check-mutations bytes Image-read-ppm 400 header))
    (check-true (< 20 loaded 380) (format "~a of 400 mutations loaded" loaded))))
