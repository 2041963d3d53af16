#lang racket/base
;; Error measures against figures worked out by hand, the sums' accuracy, and difference pictures.
(module+ test
  (require racket/flonum rackunit "support.rkt"
           "../../private/image/image.rkt" "../../private/image/compare.rkt"
           "../../private/image/false-color.rkt")

  (define (image width height . numbers)
    (make-Image width height (apply flvector numbers)))
  ;; relative tolerance 1e-15, about four roundings
  (define (check-close name actual expected [tolerance 1e-15])
    (check-true (<= (abs (- actual expected)) (* tolerance (abs expected)))
                (format "~a: ~a should be ~a" name actual expected)))

  ;; two pixels: differences .5 0 0 | 0 -1 2, squares .25 0 0 | 0 1 4, sum 5.25 over 6
  (define a (image 2 1  1.0 0.5 0.0  0.25 1.0 3.0))
  (define b (image 2 1  0.5 0.5 0.0  0.25 2.0 1.0))
  (define result (Image-compare a b))
  (check-close 'rmse (Comparison-rmse result) (sqrt 0.875))
  ;; after min(., 1): .5 0 0 | 0 0 0
  (check-close 'rmse1 (Comparison-rmse1 result) (sqrt (/ 0.25 6.0)))
  ;; .25/.26 + 1/4.01 + 4/1.01 over 6
  (check-close 'relative (Comparison-relative-mse result)
               (exact->inexact (/ (+ 25/26 100/401 400/101) 6)))
  ;; 5.75/4.25 - 1, where the subtraction costs another 2 bits
  (check-close 'bias (Comparison-bias result) (/ 1.5 4.25) 1e-15)
  ;; -10 log10 .875
  (check-close 'psnr (Comparison-psnr result) 0.57991946977686754 1e-14)
  (check-equal? (list (Comparison-worst-x result) (Comparison-worst-y result)
                      (Comparison-worst-difference result))
                '(1 0 2.0))

  ;; swapped: the bias and the relative measure change, the rest does not
  (define swapped (Image-compare b a))
  (check-equal? (Comparison-rmse swapped) (Comparison-rmse result))
  (check-close 'bias (Comparison-bias swapped) (- (/ 1.5 5.75)) 1e-15)

  ;; .1 everywhere: 20 dB
  (check-close 'psnr (Comparison-psnr (Image-compare (image 1 1 0.1 0.1 0.1) (image 1 1 0.0 0.0 0.0)))
               20.0 1e-14)

  ;; equal pictures, exactly
  (define noise (random-image 31 17 11))
  (check-equal? (Image-compare noise noise) (Comparison 0.0 0.0 0.0 0.0 +inf.0 0 0 0.0))

  ;; the worst pixel is the first of equals, in its row and column
  (define worst (Image-compare (image 2 2  0.0 0.0 0.0  0.0 0.0 0.0  0.0 0.0 -3.0  3.0 0.0 0.0)
                               (image 2 2  0.0 0.0 0.0  0.0 0.0 0.0  0.0 0.0 0.0  0.0 0.0 0.0)))
  (check-equal? (list (Comparison-worst-x worst) (Comparison-worst-y worst)
                      (Comparison-worst-difference worst))
                '(0 1 3.0))

  ;; sums to about one rounding whatever the count: against exact rational sums, 4 ulp
  (define c (random-image 300 200 21 0.0 3.0))
  (define d (random-image 300 200 22 0.0 3.0))
  (define (exact-mean f)
    (/ (for/sum ([x (in-flvector (Image-pixels c))] [y (in-flvector (Image-pixels d))])
         (inexact->exact (f x y)))
       180000))
  (define compared (Image-compare c d))
  (define (close-to-exact name actual exact)
    (check-close name actual (exact->inexact exact) (* 4 2.220446049250313e-16)))
  (close-to-exact 'rmse (Comparison-rmse compared)
                  (sqrt (exact->inexact (exact-mean (lambda (x y) (* (- x y) (- x y)))))))
  (close-to-exact 'relative (Comparison-relative-mse compared)
                  (exact-mean (lambda (x y) (/ (* (- x y) (- x y)) (+ (* y y) 0.01)))))
  (check-close 'ratio (+ 1.0 (Comparison-bias compared))
               (exact->inexact (/ (exact-mean (lambda (x y) x)) (exact-mean (lambda (x y) y))))
               (* 4 2.220446049250313e-16))
  ;; one large number must not swallow a million small ones: the bias
  ;; is 299999e-16, of which an ordinary sum keeps nothing; 1e-4 is the rounding of 1 + bias
  (define uneven (let ([pixels (make-flvector 300000 1e-16)])
                   (flvector-set! pixels 0 1.0)
                   (make-Image 100000 1 pixels)))
  (define mean-reference (make-Image 100000 1 (make-flvector 300000 (/ 300000.0))))
  (check-close 'uneven (Comparison-bias (Image-compare uneven mean-reference)) 2.99999e-11 1e-4)

  ;; NaN and infinity are seen, not lost
  (define with-nan (Image-compare (image 2 1  9.0 0.0 0.0  0.0 +nan.0 0.0)
                                  (image 2 1  0.0 0.0 0.0  0.0 0.0 0.0)))
  (check-equal? (Comparison-rmse with-nan) +nan.0)
  (check-equal? (list (Comparison-worst-x with-nan) (Comparison-worst-y with-nan)) '(1 0))
  (check-equal? (Comparison-rmse (Image-compare (image 1 1 +inf.0 0.0 0.0) (image 1 1 0.0 0.0 0.0)))
                +inf.0)

  ;; sizes
  (define wide (make-Image 3 2 (make-flvector 18)))
  (define tall (make-Image 2 3 (make-flvector 18)))
  (check-one-line (lambda () (Image-compare wide tall)) "same size" "3x2" "2x3")
  (check-one-line (lambda () (Image-difference wide tall)) "same size" "3x2" "2x3")

  ;; the colour map: its stops exactly, its ends beyond, NaN, and lightness that never falls
  (define (color t) (call-with-values (lambda () (false-color t)) list))
  (check-equal? (map color '(0.0 0.25 0.5 0.75 1.0))
                '((0.0 0.0 0.0) (0.1 0.0 0.3) (0.7 0.05 0.1) (1.0 0.45 0.0) (1.0 1.0 0.8)))
  (check-equal? (color -1.0) (color 0.0))
  (check-equal? (color +inf.0) (color 1.0))
  (check-equal? (color +nan.0) '(1.0 0.0 1.0))
  (for/fold ([before -1.0] #:result (void)) ([i (in-range 1001)])
    (define light (apply + (map * '(0.2126 0.7152 0.0722) (color (/ (exact->inexact i) 1000.0)))))
    (check-true (> light before))
    light)

  ;; difference pictures: root mean square over channels, of the largest or of the scale given
  (define (pixels image) (for/list ([x (in-flvector (Image-pixels image))]) x))
  (define zero (image 3 1  0.0 0.0 0.0  0.0 0.0 0.0  0.0 0.0 0.0))
  (define steps (image 3 1  0.0 0.0 0.0  1.0 1.0 -1.0  2.0 -2.0 2.0))
  (check-equal? (pixels (Image-difference steps zero))
                (append (color 0.0) (color 0.5) (color 1.0)))
  (check-equal? (pixels (Image-difference steps zero #:scale 4))
                (append (color 0.0) (color 0.25) (color 0.5)))
  (check-equal? (Image-difference noise noise)
                (make-Image 31 17 (make-flvector (* 3 31 17))))
  (define odd (image 3 1  +nan.0 0.0 0.0  1.0 1.0 1.0  +inf.0 0.0 0.0))
  (check-equal? (pixels (Image-difference odd zero))
                (append (color +nan.0) (color 1.0) (color 1.0)))
  (for ([scale (in-list '(0 -1.0 +inf.0 +nan.0))])
    (check-exn exn:fail:contract? (lambda () (Image-difference steps zero #:scale scale)))))
