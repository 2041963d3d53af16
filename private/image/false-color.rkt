#lang typed/racket/base
;; A colour map for magnitudes: black, violet, red, orange, pale yellow, of evenly rising lightness.
(provide false-color)
(require racket/flonum)

;; false-color : linear RGB for a magnitude, 0 black ... 1 pale yellow, clamped; between the stops at
;; 0, 1/4, 1/2, 3/4 and 1 it is linear. NaN is pure magenta, which the map has nowhere else.
(: false-color (-> Flonum (Values Flonum Flonum Flonum)))
(define (false-color magnitude)
  (define t (fl* 4.0 (flmax 0.0 (flmin 1.0 magnitude))))
  (define-syntax-rule (between s c0 c1) (fl+ c0 (fl* s (fl- c1 c0))))
  (cond [(not (fl= magnitude magnitude)) (values 1.0 0.0 1.0)]
        [(fl< t 1.0) (values (between t 0.0 0.1) 0.0 (between t 0.0 0.3))]
        [(fl< t 2.0) (let ([s (fl- t 1.0)])
                       (values (between s 0.1 0.7) (between s 0.0 0.05) (between s 0.3 0.1)))]
        [(fl< t 3.0) (let ([s (fl- t 2.0)])
                       (values (between s 0.7 1.0) (between s 0.05 0.45) (between s 0.1 0.0)))]
        [else (let ([s (fl- t 3.0)])
                (values 1.0 (between s 0.45 1.0) (between s 0.0 0.8)))]))
