#lang racket/base
;; PFM files: golden bytes, both byte orders, grey, scale, and what is refused.
(module+ test
  (require racket/flonum rackunit "support.rkt"
           "../../private/image/image.rkt" "../../private/image/pfm.rkt")

  (define (pfm-bytes image)
    (define out (open-output-bytes))
    (Image-write-pfm image out)
    (get-output-bytes out))
  (define (numbers image) (for/list ([x (in-flvector (Image-pixels image))]) x))

  ;; bottom row (blue, white) first; 1.0 is 00 00 80 3f, low byte first
  (define golden
    (bytes-append #"PF\n2 2\n-1.0\n"
                  #"\0\0\0\0" #"\0\0\0\0" #"\0\0\200\77"
                  #"\0\0\200\77" #"\0\0\200\77" #"\0\0\200\77"
                  #"\0\0\200\77" #"\0\0\0\0" #"\0\0\0\0"
                  #"\0\0\0\0" #"\0\0\200\77" #"\0\0\0\0"))
  (check-equal? (pfm-bytes small-image) golden)

  (call-with-folder
   (lambda (folder)
     (define path (build-path folder "picture"))
     (define (read-back bytes) (Image-read-pfm (write-file path bytes)))

     ;; exact: single precision survives, infinities and NaN with it
     (check-equal? (read-back golden) small-image)
     (define singles '(0.5 -2.25 1e10 +inf.0 -inf.0 +nan.0))
     (check-equal? (numbers (read-back (pfm-bytes (make-Image 1 2 (apply flvector singles)))))
                   singles)
     ;; other numbers to half a unit of single precision, 2^-24
     (define image (random-image 37 23 3 -5.0 5.0))
     (for ([x (in-list (numbers image))] [y (in-list (numbers (read-back (pfm-bytes image))))])
       (unless (<= (abs (- x y)) (* (expt 2.0 -24) (abs x))) (fail (format "~a read as ~a" x y))))

     ;; high byte first, grey, magnitude of the scale
     (check-equal? (numbers (read-back #"PF 1 1 1.0\n\77\200\0\0\100\0\0\0\277\200\0\0"))
                   '(1.0 2.0 -1.0))
     (check-equal? (numbers (read-back #"Pf 1 2 -1\n\0\0\200\77\0\0\0\100"))
                   '(2.0 2.0 2.0 1.0 1.0 1.0))
     (check-equal? (numbers (read-back #"Pf 2 1 +.5e0\n\77\200\0\0\100\0\0\0"))
                   '(0.5 0.5 0.5 1.0 1.0 1.0))

     ;; refused, with file, place and what was expected
     (define (refused bytes . parts)
       (apply check-one-line (lambda () (read-back bytes)) (path->string path) parts))
     (refused #"" "byte 0" "PF or Pf")
     (refused #"P6\n1 1\n255\nabc" "byte 0" "PF or Pf" "P6")
     (refused #"PF2 2\n-1.0\n" "byte 2" "white space")
     (refused #"PF\n2 x\n-1.0\n" "byte 5" "positive height" "\"x\"")
     (for ([scale (in-list '(#"nan" #"+nan.0" #"inf" #"0" #"-0.0" #"1e999" #"1e-999" #"1/2" #"#e1"
                             #"" #"--1" #"1e99999999999999999999"))])
       (refused (bytes-append #"PF\n2 2\n" scale #"\n") "byte" "expected a scale"))
     (refused (subbytes golden 0 59) "byte 12" "48 bytes of samples for 2x2 pixels" "found 47")
     (refused #"PF\n1000000000 1000000000\n-1.0\nabc" "12000000000000000000 bytes" "found 3")))

  ;; mutations: each loads or is refused on one line, and the mutations do both
  (define loaded (check-mutations golden Image-read-pfm 400 13))
  (check-true (< 20 loaded 380) (format "~a of 400 mutations loaded" loaded)))
