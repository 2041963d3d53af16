#lang racket/base
;; How true the error is that pictures tell of themselves, and what stopping by it does to them.

(provide (struct-out estimated) measure-estimate measure-bias)

(require racket/flonum "../../main.rkt" "../statistics.rkt" "error-scenes.rkt")

(define WIDTH 32)
(define HEIGHT 18)

(define (pictures s seeds first-seed settings)
  (for/list ([seed seeds])
    (keyword-apply* render settings s (+ first-seed seed))))

(define (keyword-apply* f settings s seed)
  (define sorted (sort (append (list (cons '#:width WIDTH) (cons '#:height HEIGHT)
                                     (cons '#:seed seed) (cons '#:schedule 'sequential))
                               settings)
                       keyword<? #:key car))
  (keyword-apply f (map car sorted) (map cdr sorted) (list (scene-world s) (scene-camera s))))

;; ratio: the true RMSE over the estimated one; uncertainty: the standard error of that ratio; error:
;; the true RMSE relative to the mean.
(struct estimated (ratio uncertainty error))

;; Pictures of a scene for so many seeds. The truth is how far each is from the mean of the others.
(define (measure-estimate s seeds settings)
  (define images (pictures s seeds 100 settings))
  (define centre (mean-picture (map Image-pixels images)))
  (define brightness (picture-mean centre))
  (define larger (/ seeds (- seeds 1.0)))
  (define true-squares
    (for/list ([image images]) (* larger (mean-square-difference (Image-pixels image) centre))))
  (define estimated-squares
    (for/list ([image images])
      (expt (* (Image-relative-error image) (picture-mean (Image-pixels image))) 2)))
  (define ratio (/ (mean true-squares) (mean estimated-squares)))
  ;; the standard error of a quotient of means; half of it, relatively, for its root
  (define residues
    (for/list ([t true-squares] [e estimated-squares]) (- t (* ratio e))))
  (estimated (sqrt ratio)
             (/ (* 0.5 (sqrt ratio) (standard-error residues)) (mean true-squares))
             (/ (sqrt (mean true-squares)) brightness)))

;; What pictures rendered until a relative error have too much or too little of light on average,
;; relative to pictures of a fixed number of samples; and the standard error of that.
(define (measure-bias s seeds target samples)
  (define (means first-seed settings)
    (for/list ([image (pictures s seeds first-seed settings)]) (picture-mean (Image-pixels image))))
  (define adaptive (means 1000 (list (cons '#:error target))))
  (define fixed (means 2000 (list (cons '#:samples samples))))
  (define truth (mean fixed))
  (values (/ (- (mean adaptive) truth) truth)
          (/ (sqrt (+ (expt (standard-error adaptive) 2) (expt (standard-error fixed) 2))) truth)))
