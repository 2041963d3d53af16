#lang typed/racket/base
;; How far one picture is from another: the field's error measures over all pixels and channels in
;; linear RGB, and a picture of where the difference lies.
(provide (struct-out Comparison) Image-compare Image-difference)
(require racket/flonum racket/fixnum "image.rkt" "false-color.rkt")

;; rmse: root of mean squared difference; rmse1: the same after min(., 1) on both pictures;
;; relative-mse: mean of (a-b)^2 / (b^2 + 0.01); bias: mean(a)/mean(b) - 1; psnr: of rmse for a
;; peak of 1, in decibels, infinite for equal pictures; worst-x, worst-y, worst-difference: the
;; first pixel with the largest difference |a-b| of a channel, and that difference.
(struct Comparison ([rmse : Flonum] [rmse1 : Flonum] [relative-mse : Flonum] [bias : Flonum]
                    [psnr : Flonum] [worst-x : Index] [worst-y : Index]
                    [worst-difference : Flonum])
  #:transparent)

;; The mean of term over i = 0 ... count-1 by Neumaier's compensated sum (1974): its error is about
;; one rounding of the result, whatever the count, as long as the terms are of one sign.
(define-syntax-rule (compensated-mean (i count) term)
  (let ([end : Fixnum count])
    (let loop : Flonum ([i : Fixnum 0] [sum : Flonum 0.0] [lost : Flonum 0.0])
      (if (fx< i end)
          (let* ([x term]
                 [next (fl+ sum x)])
            (loop (fx+ i 1) next
                  (fl+ lost (if (fl>= (flabs sum) (flabs x))
                                (fl+ (fl- sum next) x)
                                (fl+ (fl- x next) sum)))))
          ;; an infinite sum has lost NaN
          (fl/ (if (fl< (flabs sum) +inf.0) (fl+ sum lost) (fl+ sum 0.0)) (->fl end))))))

;; Image-compare : the error measures of an image against a reference of the same size. NaN in
;; either makes the means NaN and its pixel the worst. Raises exn:fail:user when the sizes differ.
(: Image-compare (-> Image Image Comparison))
(define (Image-compare image reference)
  (check-sizes 'Image-compare image reference)
  (define a (Image-pixels image))
  (define b (Image-pixels reference))
  (define count (min (flvector-length a) (flvector-length b)))
  (define rmse
    (flsqrt (compensated-mean (i count) (squared (fl- (flvector-ref a i) (flvector-ref b i))))))
  (define rmse1
    (flsqrt (compensated-mean (i count) (squared (fl- (flmin 1.0 (flvector-ref a i))
                                                      (flmin 1.0 (flvector-ref b i)))))))
  (define relative-mse
    (compensated-mean (i count) (fl/ (squared (fl- (flvector-ref a i) (flvector-ref b i)))
                                     (fl+ (squared (flvector-ref b i)) 0.01))))
  (define bias
    (fl- (fl/ (compensated-mean (i count) (flvector-ref a i))
              (compensated-mean (i count) (flvector-ref b i)))
         1.0))
  (define worst (worst-channel a b count))
  (define pixel (quotient worst 3))
  (define width (Image-width image))
  (Comparison rmse rmse1 relative-mse bias
              (if (fl= rmse 0.0) +inf.0 (fl* -20.0 (fl/ (fllog rmse) (fllog 10.0))))
              (assert (remainder pixel width) index?) (assert (quotient pixel width) index?)
              (flabs (fl- (flvector-ref a worst) (flvector-ref b worst)))))

;; Image-difference : a picture of the same size that shows, pixel by pixel, the root of the mean
;; over channels of (a-b)^2 in the colours of false-color: black for no difference, pale yellow
;; for #:scale or more, which is positive and by default the largest finite one of this pair.
;; Raises exn:fail:user when the sizes differ, exn:fail:contract when the scale is not positive.
(: Image-difference (->* (Image Image) (#:scale (U #f Real)) Image))
(define (Image-difference image reference #:scale [scale #f])
  (check-sizes 'Image-difference image reference)
  (unless (or (not scale) (< 0 scale +inf.0))
    (raise-argument-error 'Image-difference "positive finite scale" scale))
  (define a (Image-pixels image))
  (define b (Image-pixels reference))
  (define count (quotient (min (flvector-length a) (flvector-length b)) 3))
  (define differences
    (for/flvector #:length count ([pixel (in-range count)])
      (define-syntax-rule (term channel)
        (squared (fl- (flvector-ref a (+ (* 3 pixel) channel))
                      (flvector-ref b (+ (* 3 pixel) channel)))))
      (flsqrt (fl/ (fl+ (fl+ (term 0) (term 1)) (term 2)) 3.0))))
  (define full (if scale (real->double-flonum scale) (largest-finite differences)))
  (define pixels (make-flvector (* 3 count)))
  (for ([pixel (in-range count)])
    (define difference (flvector-ref differences pixel))
    (define-values (red green blue)
      (false-color (if (fl= difference 0.0) 0.0 (fl/ difference full))))
    (flvector-set! pixels (* 3 pixel) red)
    (flvector-set! pixels (+ (* 3 pixel) 1) green)
    (flvector-set! pixels (+ (* 3 pixel) 2) blue))
  (make-Image (Image-width image) (Image-height image) pixels))

(define-syntax-rule (squared x)
  (let ([value x]) (fl* value value)))

(: check-sizes (-> Symbol Image Image Void))
(define (check-sizes who image reference)
  (unless (and (= (Image-width image) (Image-width reference))
               (= (Image-height image) (Image-height reference)))
    (raise-user-error who "expected pictures of the same size, found ~ax~a and ~ax~a"
                      (Image-width image) (Image-height image)
                      (Image-width reference) (Image-height reference))))

;; The index of the first largest |a-b|, NaN counting as larger than everything.
(: worst-channel (-> FlVector FlVector Fixnum Nonnegative-Fixnum))
(define (worst-channel a b count)
  (let loop ([i : Nonnegative-Fixnum 0] [worst : Nonnegative-Fixnum 0] [largest : Flonum -1.0])
    (if (< i count)
        (let ([difference (flabs (fl- (flvector-ref a i) (flvector-ref b i)))])
          (cond [(not (fl= difference difference)) i]
                [(fl> difference largest) (loop (fx+ i 1) i difference)]
                [else (loop (fx+ i 1) worst (fl+ largest 0.0))]))
        worst)))

(: largest-finite (-> FlVector Flonum))
(define (largest-finite differences)
  (for/fold ([largest : Flonum 0.0]) ([difference (in-flvector differences)])
    (if (and (fl< largest difference) (fl< difference +inf.0)) difference largest)))
