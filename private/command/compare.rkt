#lang racket/base
;; raco raytrace compare: how far one picture file is from another.
(require "flags.rkt" "../image/compare.rkt" "../image/write.rkt")

(provide compare-pictures)

(define flags
  `((usage-help "Tells how far picture <A> is from picture <B>, its reference, in linear RGB."
                "Pictures are .ppm, .pfm, .hdr, .png or .jpg files of the same size.")
    (once-each
     [("-o" "--output") ,(lambda (flag file) file)
                        ("Write a false-colour picture of the difference to <file>" "file")])))

(define (compare-pictures program words)
  (define-values (output path-a path-b)
    (parse-words program words flags '("A" "B")
                 (lambda (output a b) (values (and (pair? output) (car output)) a b))))
  (when output (check-output-path output))
  (define a (Image-read path-a))
  (define b (Image-read path-b))
  (define comparison (Image-compare a b))
  (when output (Image-write (Image-difference a b) output))
  (for ([row (in-list (comparison-rows comparison))])
    (printf "~a  ~a\n" (car row) (cdr row))))

(define (comparison-rows comparison)
  (list (cons "RMSE  " (number-text (Comparison-rmse comparison)))
        (cons "RMSE1 " (number-text (Comparison-rmse1 comparison)))
        (cons "relMSE" (number-text (Comparison-relative-mse comparison)))
        (cons "bias  " (format "~a %" (number-text (* 100.0 (Comparison-bias comparison)))))
        (cons "PSNR  " (format "~a dB" (number-text (Comparison-psnr comparison))))
        (cons "worst " (format "~a at x ~a, y ~a"
                               (number-text (Comparison-worst-difference comparison))
                               (Comparison-worst-x comparison) (Comparison-worst-y comparison)))))

;; Six significant digits.
(define (number-text x)
  (cond
    [(= x 0.0) "0"]
    [(= (abs x) +inf.0) "infinite"]
    [(not (= x x)) "no number"]
    [else
     (define exponent (- 5 (inexact->exact (floor (/ (log (abs x)) (log 10.0))))))
     (define unit (expt 10 exponent))
     (number->string (exact->inexact (/ (round (* (inexact->exact x) unit)) unit)))]))
