#lang typed/racket/base
;; How large the error of a rendered picture is, by its own estimate.
(provide Image-relative-error Image-relative-error-uncertainty)
(require racket/flonum "image.rkt")

;; Image-relative-error : the estimated RMSE of a picture (root of the mean squared standard error, all
;; pixels and channels) relative to the mean of its pixels; 0 for a black picture. #f where no errors
;; are known: pixels of one sample, pictures from files.
(: Image-relative-error (-> Image (U #f Flonum)))
(define (Image-relative-error image)
  (define errors (Image-standard-error image))
  (and errors
       (let ([light (sum-of (Image-pixels image))])
         (if (fl> light 0.0)
             (fl/ (flsqrt (fl* (sum-of-squares errors) (->fl (flvector-length errors)))) light)
             0.0))))

;; Image-relative-error-uncertainty : the standard error of that estimate, from how much the errors of
;; pixels scatter.
(: Image-relative-error-uncertainty (-> Image (U #f Flonum)))
(define (Image-relative-error-uncertainty image)
  (define errors (Image-standard-error image))
  (define relative (Image-relative-error image))
  (and errors relative
       (let ([sum (sum-of-squares errors)])
         ;; a root's relative uncertainty is half that of what is under it
         (if (fl> sum 0.0)
             (fl* relative (fl/ (fl* 0.5 (flsqrt (sum-of-squared-pixels errors))) sum))
             0.0))))

(: sum-of (-> FlVector Flonum))
(define (sum-of v)
  (for/fold ([sum : Flonum 0.0]) ([x (in-flvector v)]) (fl+ sum x)))

(: sum-of-squares (-> FlVector Flonum))
(define (sum-of-squares v)
  (for/fold ([sum : Flonum 0.0]) ([x (in-flvector v)]) (fl+ sum (fl* x x))))

;; Over pixels: the square of the sum over channels, which vary together, of the squared error.
(: sum-of-squared-pixels (-> FlVector Flonum))
(define (sum-of-squared-pixels v)
  (define-syntax-rule (square at) (let ([x (flvector-ref v at)]) (fl* x x)))
  (for/fold ([sum : Flonum 0.0]) ([at (in-range 0 (flvector-length v) 3)])
    (define pixel (fl+ (square at) (fl+ (square (+ at 1)) (square (+ at 2)))))
    (fl+ sum (fl* pixel pixel))))
