#lang racket/base
;; Makes references/cornell-diffuse.pfm: of the 256x256 picture of scenes/cornell-diffuse.rkt the
;; pixels of even rows and columns, 4096 samples each, rendered one by one.
;;   racket tests/bench/cornell-reference.rkt
;; The own error it prints is that of the mean of two independent halves.
(require raytrace racket/runtime-path raytrace/scenes/cornell-diffuse)

(define-runtime-path reference-file "references/cornell-diffuse.pfm")

(define side 256)
(define samples 2048)

(define (even-pixels seed)
  (for*/list ([y (in-range 0 side 2)] [x (in-range 0 side 2)])
    (define image
      (render world camera #:width side #:height side #:samples samples #:seed seed
              #:integrator 'path #:schedule 'sequential #:crop (list x y 1 1)))
    (define-values (red green blue) (Image-pixel image 0 0))
    (list red green blue)))

(module+ main
  (define-values (a b) (values (even-pixels 1001) (even-pixels 2002)))
  (define differences
    (for*/list ([pair (map list a b)] [channel 3])
      (define-values (p q) (values (list-ref (car pair) channel) (list-ref (cadr pair) channel)))
      (expt (- (min p 1.0) (min q 1.0)) 2)))
  (printf "RMSE1 of the reference: ~a\n"
          (/ (sqrt (/ (apply + differences) (length differences))) 2))
  ;; bottom row first, red green blue, little endian
  (define half (quotient side 2))
  (define pixels
    (for/vector ([p a] [q b]) (for/list ([x p] [y q]) (/ (+ x y) 2))))
  (call-with-output-file reference-file #:exists 'truncate
    (lambda (out)
      (fprintf out "PF\n~a ~a\n-1.0\n" half half)
      (for* ([y (in-range (- half 1) -1 -1)] [x half] [value (vector-ref pixels (+ (* half y) x))])
        (write-bytes (real->floating-point-bytes value 4 #f) out)))))
