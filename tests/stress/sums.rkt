#lang racket/base
;; S21: a pixel's mean over many samples.

(provide cases)

(require racket/flonum "case.rkt" "../../main.rkt")

(define EPS (expt 2.0 -52))

;; Samples that are all the same colour: their mean is that colour, whatever their number.
(define (accumulation size)
  (define colors '((0.1 0.7 1.0) (0.3333333333333333 1e8 100000000.1) (1e-300 1e300 123.456)))
  (define camera (Camera-look-at (Float3 0 0 1) (Float3 0 0 0)))
  (define errors
    (for/list ([samples (in-list (list 3 1000 (amount 100000 size 10000) (amount 10000000 size)))])
      (for/fold ([worst 0.0]) ([color (in-list colors)])
        (define world (World '() '() (point color)))
        (define pixel
          (Image-pixels (render world camera #:width 1 #:height 1 #:samples samples
                                #:integrator 'path #:schedule 'sequential)))
        (for/fold ([worst worst]) ([found (in-flvector pixel)] [right (in-list color)])
          (max worst (/ (abs (- found right)) right EPS))))))
  (values (format "relative ~a eps for 3, 1e3, ~a, ~a samples" (map rounded errors)
                  (amount 100000 size 10000) (amount 10000000 size))
          (andmap (lambda (e) (<= e 2.0)) errors)))

(define cases
  (list (stress-case "S21 accumulation (means of equal samples; there are no variances yet)"
                     "relative 2 eps for any number" accumulation)))
