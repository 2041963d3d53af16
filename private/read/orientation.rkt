#lang racket/base
;; Exact signs of areas: a floating-point filter first, rational arithmetic when it cannot decide.

(provide orientation
         zero-area?)

(require racket/fixnum
         racket/flonum)

;; The filter's bound: the rounding error of the determinant is below this times the sum of the
;; absolute products (Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997).
(define filter-bound 3.3306690738754716e-16)

;; Determinants below this may have lost bits to underflow and are left to the exact path.
(define filter-floor 1e-280)

;; Sign (-1, 0 or 1) of twice the area of the triangle a b c in the plane, positive when
;; counterclockwise. Exact for all finite coordinates.
(define (orientation ax ay bx by cx cy)
  (define left (fl* (fl- ax cx) (fl- by cy)))
  (define right (fl* (fl- ay cy) (fl- bx cx)))
  (define determinant (fl- left right))
  (cond
    [(certain? left right) (if (fl> determinant 0.0) 1 -1)]
    [(and (or (fl= ax cx) (fl= by cy)) (or (fl= ay cy) (fl= bx cx))) 0]
    [else (exact-orientation ax ay bx by cx cy)]))

;; Is the triangle of vertices a b c, indices into positions (3 per vertex), exactly of zero area?
(define (zero-area? positions a b c)
  (define ax (flvector-ref positions (fx* 3 a)))
  (define ay (flvector-ref positions (fx+ 1 (fx* 3 a))))
  (define az (flvector-ref positions (fx+ 2 (fx* 3 a))))
  (define bx (flvector-ref positions (fx* 3 b)))
  (define by (flvector-ref positions (fx+ 1 (fx* 3 b))))
  (define bz (flvector-ref positions (fx+ 2 (fx* 3 b))))
  (define cx (flvector-ref positions (fx* 3 c)))
  (define cy (flvector-ref positions (fx+ 1 (fx* 3 c))))
  (define cz (flvector-ref positions (fx+ 2 (fx* 3 c))))
  (define ux (fl- ax cx))
  (define uy (fl- ay cy))
  (define uz (fl- az cz))
  (define vx (fl- bx cx))
  (define vy (fl- by cy))
  (define vz (fl- bz cz))
  (not (or (certain? (fl* ux vy) (fl* uy vx))
           (certain? (fl* uy vz) (fl* uz vy))
           (certain? (fl* uz vx) (fl* ux vz))
           (not (fx= 0 (orientation ax ay bx by cx cy)))
           (not (fx= 0 (orientation ay az by bz cy cz)))
           (not (fx= 0 (orientation az ax bz bx cz cx))))))

;; Is the sign of left - right beyond doubt, each the rounded product of two rounded differences?
(define-syntax-rule (certain? left-product right-product)
  (let* ([left left-product]
         [right right-product]
         [size (flabs (fl- left right))])
    (and (fl> size filter-floor)
         (fl< size +inf.0)
         (fl> size (fl* filter-bound (fl+ (flabs left) (flabs right)))))))

(define (exact-orientation ax ay bx by cx cy)
  (define-values (x y) (values (inexact->exact cx) (inexact->exact cy)))
  (define determinant
    (- (* (- (inexact->exact ax) x) (- (inexact->exact by) y))
       (* (- (inexact->exact ay) y) (- (inexact->exact bx) x))))
  (cond [(> determinant 0) 1] [(< determinant 0) -1] [else 0]))
