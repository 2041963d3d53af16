#lang racket/base
;; How true the error is that pictures tell, and the bias of stopping by it.

(provide cases)

(require racket/list "case.rkt" "../accuracy/error-scenes.rkt" "../accuracy/error-measures.rkt")

;; The ratio of the true RMSE to the estimated one on six scenes, each with its uncertainty.
(define (estimate size)
  (define found
    (for/list ([s (in-list error-scenes)])
      (measure-estimate s (amount 64 size 8) '((#:samples . 16)))))
  (values (format "true RMSE ~a +- ~a of the estimate on six scenes"
                  (map rounded (map estimated-ratio found))
                  (map rounded (map estimated-uncertainty found)))
          (for/and ([f (in-list found)])
            ;; two standard errors are left to chance
            (<= (abs (- (estimated-ratio f) 1.0)) (+ 0.15 (* 2.0 (estimated-uncertainty f)))))))

;; The errors asked for: each needs several passes on its scene.
(define TARGETS '(0.01 0.05 0.05 0.1 0.05 0.05))

(define (adaptive size)
  (define-values (scenes targets)
    (if (< size 1) (values (take error-scenes 3) (take TARGETS 3)) (values error-scenes TARGETS)))
  (define-values (biases uncertainties ratios)
    (for/lists (biases uncertainties ratios) ([s (in-list scenes)] [target (in-list targets)])
      (define-values (bias uncertainty) (measure-bias s (amount 64 size 8) target 64))
      (define found (measure-estimate s (amount 64 size 8) (list (cons '#:error target))))
      (values (/ bias target) (/ uncertainty target) (estimated-ratio found))))
  (values (format "bias ~a +- ~a of the error asked for; true RMSE ~a of the estimate"
                  (map rounded biases) (map rounded uncertainties) (map rounded ratios))
          (for/and ([b (in-list biases)] [u (in-list uncertainties)])
            (< (+ (abs b) (* 2.0 u)) 0.25))))

(define cases
  (list (stress-case "error estimate" "within 15% (and 2 standard errors)" estimate)
        (stress-case "error reached: bias" "below a quarter of the error, with 2 standard errors"
                     adaptive)))
