#lang typed/racket/base
;; Instances: a shape in another place, size or attitude. The shape itself is shared.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/matrix.rkt"
         "../base/transform.rkt" "../base/public.rkt" "../material/material.rkt"
         "kernel.rkt" "shape.rkt" "composite.rkt")

(provide (struct-out Instance) make-Instance Instance-kernel
         matrix-growth largest-row-sum missed-by-inverse)

;; shape: what is shown, made in a space of its own. transform: from there to here. material:
;; instead of the shape's own, or #f.
(struct Instance Composite ([shape : Shape] [transform : Transform] [material : (U #f Material)])
  #:transparent)

;; Instance : the shape transformed. #:material, if given, takes the place of all its materials.
;; Raises where composites nest too deep.
(: make-Instance (->* (Shape Transform) (#:material (U #f MaterialOrColor)) Instance))
(define (make-Instance shape transform #:material [material #f])
  (Instance (check-nesting 'Instance (list shape)) shape transform
            (and material (->material material))))

(define-constructor Instance make-Instance (shape transform material)
  #:struct (_ shape transform material))

(: Instance-kernel (-> Instance CompileShape NumberMaterial ShapeKernel))
(define (Instance-kernel instance compile number)
  (define matrix (Transform-matrix (Instance-transform instance)))
  (define inverse (Transform-inverse-matrix (Instance-transform instance)))
  (define kernel (compile (Instance-shape instance)))
  (define material (Instance-material instance))
  (define material-number (if material (number material) -1))
  (define growth (matrix-growth matrix))
  (define local-rounding (local-rounding-factor matrix inverse))

  (: in-local-space (-> (-> FlVector FxVector Boolean) (-> FlVector FxVector Boolean)))
  (define (in-local-space hit?)
    (lambda ([r : FlVector] [i : FxVector])
      (save-ray! r i)
      (put-local-ray! r (matrix 0) (inverse 0))
      (let ([found? (with-next-level i : Boolean (hit? r i))])
        (restore-ray! r i)
        found?)))

  (define shape-surface! (ShapeKernel-surface kernel))
  (: surface! (-> FlVector FxVector Void))
  (define (surface! r i)
    (save-ray! r i)
    (put-local-ray! r (matrix 0) (inverse 0))
    (with-next-level i : Void (shape-surface! r i))
    (restore-ray! r i)
    (put-material! i material-number)
    (put-world-surface! r (matrix 0) (inverse 0) growth local-rounding))

  (define shape-uv! (ShapeKernel-uv kernel))
  (: uv! (-> FlVector FxVector Void))
  (define (uv! r i)
    (put-local-normal! r i (matrix 0) (inverse 0))
    (with-next-level i : Void (shape-uv! r i))
    (restore-surface! r i))

  (ShapeKernel (transform-box matrix (ShapeKernel-bounds kernel))
               (in-local-space (ShapeKernel-nearest kernel))
               (in-local-space (ShapeKernel-occluded kernel))
               surface! uv!
               (fx+ 1 (ShapeKernel-nesting kernel)) (ShapeKernel-stack kernel)))

;; No vector grows by more than this factor: the root of the sum of the squares of the entries.
(: matrix-growth (-> FlVector Flonum))
(define (matrix-growth m)
  (define largest
    (for*/fold ([largest : Flonum 0.0]) ([row : Nonnegative-Fixnum (in-range 3)]
                                         [column : Nonnegative-Fixnum (in-range 3)])
      (flmax largest (flabs (flvector-ref m (fx+ column (fx* 4 row)))))))
  (fl* largest
       (flsqrt (for*/fold ([sum : Flonum 0.0]) ([row : Nonnegative-Fixnum (in-range 3)]
                                                [column : Nonnegative-Fixnum (in-range 3)])
                 (define entry (fl/ (flvector-ref m (fx+ column (fx* 4 row))) largest))
                 (fl+ sum (fl* entry entry))))))

;; Bounds, for local points with coordinates up to 1, in world units: the roundings of the way out
;; (the sum along a row), of the way back in, and what the inverse misses of undoing the matrix.
(: local-rounding-factor (-> FlVector FlVector Flonum))
(define (local-rounding-factor matrix inverse)
  (define growth (matrix-growth matrix))
  (define out (largest-row-sum matrix 0))
  (define in (fl* growth (fl* out (largest-row-sum inverse 0))))
  (fl+ (fl* growth (missed-by-inverse matrix 0 inverse 0))
       (fl* (fl* 8.0 (ROUNDING)) (fl+ out in))))

;; The largest sum of magnitudes along a row of the matrix at a place.
(: largest-row-sum (-> FlVector Fixnum Flonum))
(define (largest-row-sum m at)
  (for/fold ([largest : Flonum 0.0]) ([row : Nonnegative-Fixnum (in-range 3)])
    (flmax largest
           (for/fold ([sum : Flonum 0.0]) ([column : Nonnegative-Fixnum (in-range 3)])
             (fl+ sum (flabs (flvector-ref m (fx+ at (fx+ column (fx* 4 row))))))))))

;; The same of inverse times matrix minus the identity.
(: missed-by-inverse (-> FlVector Fixnum FlVector Fixnum Flonum))
(define (missed-by-inverse matrix m inverse n)
  (for/fold ([largest : Flonum 0.0]) ([row : Nonnegative-Fixnum (in-range 3)])
    (flmax largest
           (for/fold ([sum : Flonum 0.0]) ([column : Nonnegative-Fixnum (in-range 3)])
             (fl+ sum
                  (flabs
                   (for/fold ([rest : Flonum (if (fx= row column) -1.0 0.0)])
                             ([k : Nonnegative-Fixnum (in-range 3)])
                     (fl+ rest
                          (fl* (flvector-ref inverse (fx+ n (fx+ k (fx* 4 row))))
                               (flvector-ref matrix (fx+ m (fx+ column (fx* 4 k)))))))))))))
