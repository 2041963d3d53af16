#lang typed/racket/base
;; Affine maps as kernels use them: twelve numbers in an flvector, the first three rows of the
;; 4 x 4 matrix, row by row.
(require "unsafe.rkt" "float3.rkt")

(provide matrix-point matrix-vector matrix-normal matrix-origin matrix-product transform-box)

;; The image of a point, of a direction, and of a normal, under the matrix at a place of an flvector:
;; of a normal under the map whose inverse is given, by its transpose.
(define-float3-operation (matrix-point [m : FlVector] [at : Fixnum] [(x y z) : Float3])
  : Float3 ((fl+ (row-dot m at x y z) (flvector-ref m (fx+ at 3)))
            (fl+ (row-dot m (fx+ at 4) x y z) (flvector-ref m (fx+ at 7)))
            (fl+ (row-dot m (fx+ at 8) x y z) (flvector-ref m (fx+ at 11)))))
(define-float3-operation (matrix-vector [m : FlVector] [at : Fixnum] [(x y z) : Float3])
  : Float3 ((row-dot m at x y z) (row-dot m (fx+ at 4) x y z) (row-dot m (fx+ at 8) x y z)))
(define-float3-operation (matrix-normal [inverse : FlVector] [at : Fixnum] [(x y z) : Float3])
  : Float3 ((column-dot inverse at x y z)
            (column-dot inverse (fx+ at 1) x y z)
            (column-dot inverse (fx+ at 2) x y z)))

;; Where the matrix takes the origin.
(define-float3-operation (matrix-origin [m : FlVector] [at : Fixnum])
  : Float3 ((flvector-ref m (fx+ at 3)) (flvector-ref m (fx+ at 7)) (flvector-ref m (fx+ at 11))))

(define-syntax-rule (row-dot m row x y z)
  (fl+ (fl+ (fl* (flvector-ref m row) x) (fl* (flvector-ref m (fx+ row 1)) y))
       (fl* (flvector-ref m (fx+ row 2)) z)))
(define-syntax-rule (column-dot m column x y z)
  (fl+ (fl+ (fl* (flvector-ref m column) x) (fl* (flvector-ref m (fx+ column 4)) y))
       (fl* (flvector-ref m (fx+ column 8)) z)))

;; The box around the images of a box's corners, low x y z and high x y z, and of the roundings in
;; computing them; all of space where the box is not finite.
(: transform-box (-> FlVector FlVector FlVector))
(define (transform-box m box)
  (define image (flvector +inf.0 +inf.0 +inf.0 -inf.0 -inf.0 -inf.0))
  (for* ([corner : Nonnegative-Fixnum (in-range 8)] [axis : Nonnegative-Fixnum (in-range 3)])
    (define row (fx* 4 axis))
    (define x (flvector-ref box (if (fx= 0 (fxand corner 1)) 0 3)))
    (define y (flvector-ref box (if (fx= 0 (fxand corner 2)) 1 4)))
    (define z (flvector-ref box (if (fx= 0 (fxand corner 4)) 2 5)))
    (define offset (flvector-ref m (fx+ row 3)))
    (define value (fl+ (row-dot m row x y z) offset))
    (define size
      (fl+ (fl+ (flabs (fl* (flvector-ref m row) x)) (flabs (fl* (flvector-ref m (fx+ row 1)) y)))
           (fl+ (flabs (fl* (flvector-ref m (fx+ row 2)) z)) (flabs offset))))
    (define pad (fl* 8.881784197001252e-16 size)) ; eight roundings
    (flvector-set! image axis (flmin (fl- value pad) (flvector-ref image axis)))
    (flvector-set! image (fx+ 3 axis) (flmax (fl+ value pad) (flvector-ref image (fx+ 3 axis)))))
  (if (for/and : Boolean ([k : Nonnegative-Fixnum (in-range 6)])
        (fl< (flabs (flvector-ref image k)) +inf.0))
      image
      (flvector -inf.0 -inf.0 -inf.0 +inf.0 +inf.0 +inf.0)))

;; The matrix of doing n first, then m.
(: matrix-product (-> FlVector FlVector FlVector))
(define (matrix-product m n)
  (define result (make-flvector 12 0.0))
  (for* ([row : Nonnegative-Fixnum (in-range 3)] [column : Nonnegative-Fixnum (in-range 4)])
    (flvector-set! result (fx+ (fx* 4 row) column)
                   (fl+ (row-dot m (fx* 4 row)
                                 (flvector-ref n column)
                                 (flvector-ref n (fx+ 4 column))
                                 (flvector-ref n (fx+ 8 column)))
                        (if (fx= column 3) (flvector-ref m (fx+ 3 (fx* 4 row))) 0.0))))
  result)
