#lang typed/racket/base
;; A difference of squares that cancels, to twice the digits of its terms.
(require "unsafe.rkt")

(provide squares-excess)

;; x x + y y + z z - s s for magnitudes up to 2 unit, to within 2^-74 unit^2; unit: a power of two.
;; Each number is cut at 2^-25 unit, so that the squares of the high parts and their sum are exact;
;; what the low parts add is smaller by 2^-25 and may be rounded.
(define-syntax-rule (squares-excess x* y* z* s* unit)
  (let* ([x x*] [y y*] [z z*] [s s*]
         [cut (fl* 201326592.0 unit)] ; 1.5 2^27
         [x-high (fl- (fl+ x cut) cut)] [y-high (fl- (fl+ y cut) cut)]
         [z-high (fl- (fl+ z cut) cut)] [s-high (fl- (fl+ s cut) cut)])
    (fl+ (fl- (fl+ (fl+ (fl* x-high x-high) (fl* y-high y-high)) (fl* z-high z-high))
              (fl* s-high s-high))
         (fl- (fl+ (fl+ (fl* (fl- x x-high) (fl+ x x-high)) (fl* (fl- y y-high) (fl+ y y-high)))
                   (fl* (fl- z z-high) (fl+ z z-high)))
              (fl* (fl- s s-high) (fl+ s s-high))))))
