#lang typed/racket/base
;; Checkers: two colours or textures in turn, in cubes of space or in rectangles of u and v.
(require (for-syntax racket/base)
         "../../base/unsafe.rkt" "../../base/registers.rkt" "../../base/float3.rkt"
         "../../base/check.rkt" "../../base/public.rkt" "texture.rkt")

(provide (struct-out Checker) make-Checker Checker-kernel
         (struct-out CheckerUV) make-CheckerUV CheckerUV-kernel)

;; even, odd: what is seen in cubes the sum of whose numbers is even, odd; the cube from the origin
;; to (size, size, size) is even. size: edge of a cube, in units of the space the shape is made in.
(struct Checker Texture ([even : ColorOrTexture] [odd : ColorOrTexture] [size : Flonum])
  #:transparent)

;; (Checker even odd [size 1]).
(: make-Checker (->* (ColorOrTexture ColorOrTexture) (Real #:size Real) Checker))
(define (make-Checker even odd [size-by-place 1.0] #:size [size size-by-place])
  (Checker (check-color-or-texture 'Checker "even" even)
           (check-color-or-texture 'Checker "odd" odd)
           (check-positive 'Checker "size" size)))

(define-constructor Checker make-Checker (even odd size))

;; columns, rows: how many rectangles u and v from 0 to 1 are cut into.
(struct CheckerUV Texture
  ([even : ColorOrTexture] [odd : ColorOrTexture] [columns : Flonum] [rows : Flonum])
  #:transparent)

;; (CheckerUV even odd [columns 8] [rows columns]).
(: make-CheckerUV (->* (ColorOrTexture ColorOrTexture)
                       (Real (U #f Real) #:columns Real #:rows (U #f Real))
                       CheckerUV))
(define (make-CheckerUV even odd [columns-by-place 8.0] [rows-by-place #f]
                        #:columns [columns columns-by-place] #:rows [rows rows-by-place])
  (CheckerUV (check-color-or-texture 'CheckerUV "even" even)
             (check-color-or-texture 'CheckerUV "odd" odd)
             (check-positive 'CheckerUV "columns" columns)
             (check-positive 'CheckerUV "rows" (or rows columns))))

(define-constructor CheckerUV make-CheckerUV (even odd columns rows))

;; The number of a cell. Cells begin 2^-30 of their width early, so that a surface that lies in
;; the border between two, as a floor at height 0, is not speckled by roundings.
(define-syntax-rule (cell x per-unit) (flfloor (fl+ (fl* x per-unit) 9.313225746154785e-10)))

(define-syntax-rule (even-number? sum)
  (let ([half (fl* 0.5 sum)]) (fl= half (flfloor half))))

(: Checker-kernel (-> Checker (-> ColorOrTexture TextureKernel) TextureKernel))
(define (Checker-kernel checker kernel)
  (define even! (kernel (Checker-even checker)))
  (define odd! (kernel (Checker-odd checker)))
  (define per-unit (fl/ 1.0 (Checker-size checker)))
  (lambda ([r : FlVector] [i : FxVector])
    (define even?
      (let-float3 ([p (Float3-in r texture-point)])
        (even-number? (fl+ (fl+ (cell (Float3-x p) per-unit) (cell (Float3-y p) per-unit))
                           (cell (Float3-z p) per-unit)))))
    (if even? (even! r i) (odd! r i))))

(: CheckerUV-kernel (-> CheckerUV (-> ColorOrTexture TextureKernel) TextureKernel))
(define (CheckerUV-kernel checker kernel)
  (define even! (kernel (CheckerUV-even checker)))
  (define odd! (kernel (CheckerUV-odd checker)))
  (define columns (CheckerUV-columns checker))
  (define rows (CheckerUV-rows checker))
  (lambda ([r : FlVector] [i : FxVector])
    (define even?
      (even-number? (fl+ (cell (flvector-ref r surface-uv) columns)
                         (cell (flvector-ref r (fx+ surface-uv 1)) rows))))
    (if even? (even! r i) (odd! r i))))
