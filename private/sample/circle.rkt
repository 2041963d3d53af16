#lang typed/racket/base
;; Points on a circle: cosine and sine of a part of a turn, together and faster than two calls.
(require "../base/unsafe.rkt" "../base/float3.rkt")

(provide define-circle-operation)

;; A Float3 operation with the result (radius cos(2 pi v), radius sin(2 pi v), z) for v in [0, 1],
;; cosine and sine within 3e-16. The turn is cut into 64 sectors: a table has their middles, Taylor
;; polynomials of degree 8 and 7 the rest, which is at most pi / 64.
(define-syntax-rule
  (define-circle-operation (name argument ...) #:let (binding ...) radius v z)
  (define-float3-operation (name argument ...)
    #:let (binding ...
           [length radius]
           [sectors (fl* 64.0 v)]
           [sector (fx->fl (fl->fx (fl+ sectors 0.5)))]
           [x (fl* (fl- sectors sector) 0.09817477042468103)]
           [xx (fl* x x)]
           [s (fl* x (fl- 1.0 (fl* xx (fl- 0.16666666666666666
                                           (fl* xx (fl- 0.008333333333333333
                                                        (fl* xx 0.0001984126984126984)))))))]
           [c (fl- 1.0 (fl* xx (fl- 0.5 (fl* xx (fl- 0.041666666666666664
                                                     (fl* xx (fl- 0.001388888888888889
                                                                  (fl* xx 0.0000248015873015873))))))))]
           [middle-c (flvector-ref TURN (fx* 2 (fl->fx sector)))]
           [middle-s (flvector-ref TURN (fx+ 1 (fx* 2 (fl->fx sector))))])
    : Float3 ((fl* length (fl- (fl* middle-c c) (fl* middle-s s)))
              (fl* length (fl+ (fl* middle-s c) (fl* middle-c s)))
              z)))

;; Cosine and sine of the 65 sectors' middles, exact at the quarters.
(define TURN : FlVector
  (let ([table (make-flvector 130)])
    (for ([k (in-range 65)])
      (define-values (quarter rest) (quotient/remainder k 16))
      (define angle (fl* 6.283185307179586 (fl/ (fx->fl rest) 64.0)))
      (define-values (c s) (values (flcos angle) (flsin angle)))
      (define (put! [c : Flonum] [s : Flonum])
        (flvector-set! table (fx* 2 k) c)
        (flvector-set! table (fx+ 1 (fx* 2 k)) s))
      (case (remainder quarter 4)
        [(0) (put! c s)]
        [(1) (put! (fl* -1.0 s) c)]
        [(2) (put! (fl* -1.0 c) (fl* -1.0 s))]
        [else (put! s (fl* -1.0 c))]))
    table))
