#lang typed/racket/base
;; Groups: many shapes as one, with a hierarchy of their own, for instances to share.
(require (for-syntax racket/base) racket/list
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/public.rkt"
         "../material/material.rkt"
         "../world/hierarchy.rkt" "../world/traverse.rkt"
         "kernel.rkt" "shape.rkt" "composite.rkt")

(provide (struct-out Group) make-Group Group-kernel)

(struct Group Composite ([shapes : (Listof Shape)]) #:transparent)

;; Group : the shapes as one, each with its own material; where several are equally near, the first
;; of the list is seen. Raises where composites nest too deep.
(: make-Group (-> (Listof Shape) Group))
(define (make-Group shapes) (Group (check-nesting 'Group shapes) shapes))

(define-constructor Group make-Group (shapes) #:struct (_ shapes))

;; What a ray needs of the parts: the hierarchy over those with a box, their numbers at its places
;; and the numbers of those without a box; kernels by number.
(struct Parts
  ([bounds : FlVector] [links : FxVector] [order : FxVector] [unbounded : FxVector]
   [kernels : (Vectorof ShapeKernel)]))

(: Group-kernel (-> Group CompileShape NumberMaterial (-> Shape Material) ShapeKernel))
(define (Group-kernel group compile number material-of)
  (define shapes (Group-shapes group))
  (define kernels : (Vectorof ShapeKernel) (list->vector (map compile shapes)))
  (define materials : (Vectorof Fixnum)
    (for/vector : (Vectorof Fixnum) #:length (vector-length kernels) ([shape (in-list shapes)])
      (number (material-of shape))))
  (define-values (bounded unbounded)
    (partition (lambda ([part : Index]) (finite-box? (ShapeKernel-bounds (vector-ref kernels part))))
               (build-list (vector-length kernels) (lambda ([k : Index]) k))))
  (define boxes (make-flvector (* 6 (length bounded)) 0.0))
  (for ([part (in-list bounded)] [k : Nonnegative-Fixnum (in-range (length bounded))])
    (put-padded-box! boxes (fx* 6 k) (ShapeKernel-bounds (vector-ref kernels part))))
  (define hierarchy (build-hierarchy boxes (assert (length bounded) fixnum?)))
  (define numbers (apply fxvector bounded))
  (define order (Hierarchy-order hierarchy))
  (for ([place : Nonnegative-Fixnum (in-range (fxvector-length order))])
    (fxvector-set! order place (fxvector-ref numbers (fxvector-ref order place))))
  (define bounds (Hierarchy-bounds hierarchy))
  (define links (Hierarchy-links hierarchy))
  (define parts (Parts bounds links order (apply fxvector unbounded) kernels))

  ;; The first place of this level's part of the stack keeps the number of the nearest part so
  ;; far; it starts above all numbers where a hit at ray-limit is wanted, else below them, so that
  ;; the lowest of equally near parts wins.
  (: nearest (-> FlVector FxVector Boolean))
  (define (nearest r i)
    (define known (fx+ stack (fxvector-ref i stack-base)))
    (fxvector-set! i known
                   (if (fx= 1 (fxvector-ref i accept-ties)) (fixnum-literal #xFFFFFFFFFF) -1))
    (with-own-level i
      (nearest-unbounded! parts known r i)
      (traverse
       (bounds links r i) (o d) limit
       #:leaf (first end top next again)
       (begin
         (fxvector-set! i stack-base top)
         (nearest-parts! parts first end known r i)
         (again))
       #:done (let ([found (fxvector-ref i known)])
                (and (fx>= found 0) (fx< found (fixnum-literal #xFFFFFFFFFF)))))))

  (: occluded (-> FlVector FxVector Boolean))
  (define (occluded r i)
    (with-own-level i
      (fxvector-set! i accept-ties 0)
      (or (occluded-by-unbounded? parts r i)
          (traverse
           (bounds links r i) (o d) limit
           #:leaf (first end top next again)
           (begin
             (fxvector-set! i stack-base top)
             (if (occluded-by-parts? parts first end r i) #t (again)))
           #:done #f))))

  (: surface! (-> FlVector FxVector Void))
  (define (surface! r i)
    (define part (hit-part i))
    (define kernel (vector-ref kernels part))
    (put-material! i (vector-ref materials part))
    (with-next-level i : Void ((ShapeKernel-surface kernel) r i)))

  (: uv! (-> FlVector FxVector Void))
  (define (uv! r i)
    (define kernel (vector-ref kernels (hit-part i)))
    (with-next-level i : Void ((ShapeKernel-uv kernel) r i)))

  (define-values (nesting stack-size)
    (for/fold ([nesting : Fixnum 0] [stack-size : Fixnum 0]) ([kernel (in-vector kernels)])
      (values (greater nesting (ShapeKernel-nesting kernel))
              (greater stack-size (ShapeKernel-stack kernel)))))
  (ShapeKernel (if (null? unbounded) (box-of-boxes boxes (length bounded)) EVERYWHERE)
               nearest occluded surface! uv!
               (fx+ 1 nesting)
               (fx+ (fx+ 1 (Hierarchy-depth hierarchy)) stack-size)))

(define-syntax-rule (greater a b) (let ([x a] [y b]) (if (fx> x y) x y)))

(define EVERYWHERE : FlVector (flvector -inf.0 -inf.0 -inf.0 +inf.0 +inf.0 +inf.0))

(define-syntax-rule (hit-part i) (fxvector-ref i (fx+ hit-path (fxvector-ref i nest-level))))

;; The body's value, at the next level of nesting, the stack used above this level's first place.
(define-syntax-rule (with-own-level i body ...)
  (let ([base (fxvector-ref i stack-base)])
    (fxvector-set! i stack-base (fx+ base 1))
    (let ([result : Boolean (with-next-level i : Boolean body ...)])
      (fxvector-set! i stack-base base)
      result)))

;; Tries one part; a hit becomes the nearest, and the ray ends there.
(define-syntax-rule (nearest-part! parts part known r i)
  (let ([kernel (vector-ref (Parts-kernels parts) part)])
    (fxvector-set! i accept-ties (if (fx< part (fxvector-ref i known)) 1 0))
    (when ((ShapeKernel-nearest kernel) r i)
      (flvector-set! r ray-limit (flvector-ref r hit-t))
      (fxvector-set! i known part)
      (fxvector-set! i (fx+ hit-path (fx- (fxvector-ref i nest-level) 1)) part))))

(: nearest-parts! (-> Parts Fixnum Fixnum Fixnum FlVector FxVector Void))
(define (nearest-parts! parts first end known r i)
  (let loop ([place first])
    (when (fx< place end)
      (nearest-part! parts (fxvector-ref (Parts-order parts) place) known r i)
      (loop (fx+ place 1)))))

(: nearest-unbounded! (-> Parts Fixnum FlVector FxVector Void))
(define (nearest-unbounded! parts known r i)
  (define unbounded (Parts-unbounded parts))
  (let loop ([k : Fixnum 0])
    (when (fx< k (fxvector-length unbounded))
      (nearest-part! parts (fxvector-ref unbounded k) known r i)
      (loop (fx+ k 1)))))

(: occluded-by-parts? (-> Parts Fixnum Fixnum FlVector FxVector Boolean))
(define (occluded-by-parts? parts first end r i)
  (let loop ([place first])
    (and (fx< place end)
         (or ((ShapeKernel-occluded
               (vector-ref (Parts-kernels parts) (fxvector-ref (Parts-order parts) place)))
              r i)
             (loop (fx+ place 1))))))

(: occluded-by-unbounded? (-> Parts FlVector FxVector Boolean))
(define (occluded-by-unbounded? parts r i)
  (define unbounded (Parts-unbounded parts))
  (let loop ([k : Fixnum 0])
    (and (fx< k (fxvector-length unbounded))
         (or ((ShapeKernel-occluded
               (vector-ref (Parts-kernels parts) (fxvector-ref unbounded k)))
              r i)
             (loop (fx+ k 1))))))

(: finite-box? (-> FlVector Boolean))
(define (finite-box? box)
  (for/and : Boolean ([k : Nonnegative-Fixnum (in-range 6)])
    (fl< (flabs (flvector-ref box k)) +inf.0)))

;; Boxes are padded by a few roundings of their coordinates, as a world pads them.
(: put-padded-box! (-> FlVector Fixnum FlVector Void))
(define (put-padded-box! boxes at box)
  (for ([axis : Nonnegative-Fixnum (in-range 3)])
    (let* ([low (flvector-ref box axis)]
           [high (flvector-ref box (fx+ axis 3))]
           [pad (fl* (fl* 8.0 (ROUNDING)) (flmax (flabs low) (flabs high)))])
      (flvector-set! boxes (fx+ at axis) (fl- low pad))
      (flvector-set! boxes (fx+ at (fx+ axis 3)) (fl+ high pad)))))

;; The box around all boxes; the point 0 around none.
(: box-of-boxes (-> FlVector Index FlVector))
(define (box-of-boxes boxes count)
  (define around (flvector +inf.0 +inf.0 +inf.0 -inf.0 -inf.0 -inf.0))
  (for* ([k : Nonnegative-Fixnum (in-range count)] [axis : Nonnegative-Fixnum (in-range 3)])
    (define at (fx+ (fx* 6 k) axis))
    (flvector-set! around axis (flmin (flvector-ref around axis) (flvector-ref boxes at)))
    (flvector-set! around (fx+ 3 axis)
                   (flmax (flvector-ref around (fx+ 3 axis)) (flvector-ref boxes (fx+ 3 at)))))
  (if (fx= count 0) (make-flvector 6 0.0) around))
