#lang typed/racket/base
;; What watertight triangles are measured against: the same hierarchy with the test of Moller and
;; Trumbore ("Fast, Minimum Storage Ray/Triangle Intersection", 1997), edges taken beforehand.
;; And the loop that counts hits of many rays, six numbers each, by a shape's kernel.
(require "../../private/base/unsafe.rkt" "../../private/base/registers.rkt"
         "../../private/base/float3.rkt" "../../private/shape/kernel.rkt"
         "../../private/shape/shape.rkt" "../../private/shape/kernels.rkt"
         "../../private/world/hierarchy.rkt" "../../private/world/traverse.rkt")

(provide leaky-kernels shape-kernels count-hits hit-parameters)

(define-type Kernel (-> FlVector FxVector Boolean))

;; A shape's own nearest-hit and any-hit kernels.
(: shape-kernels (-> Shape (List Kernel Kernel)))
(define (shape-kernels shape)
  (define kernel (Shape-kernel shape))
  (list (ShapeKernel-nearest kernel) (ShapeKernel-occluded kernel)))

;; Rays that hit.
(: count-hits (-> Kernel FlVector Fixnum))
(define (count-hits kernel rays)
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (define count (quotient (flvector-length rays) 6))
  (let loop : Fixnum ([k : Fixnum 0] [found : Fixnum 0])
    (cond
      [(fx= k count) found]
      [else
       (Float3-put! r ray-origin (Float3-in rays (fx* 6 k)))
       (Float3-put! r ray-direction (Float3-in rays (fx+ 3 (fx* 6 k))))
       (flvector-set! r ray-limit +inf.0)
       (loop (fx+ k 1) (if (kernel r i) (fx+ found 1) found))])))

;; The parameter of each ray's hit by a nearest-hit kernel, infinite for none.
(: hit-parameters (-> Kernel FlVector FlVector))
(define (hit-parameters kernel rays)
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (define count (quotient (flvector-length rays) 6))
  (define found (make-flvector count +inf.0))
  (let loop : FlVector ([k : Fixnum 0])
    (cond
      [(fx= k count) found]
      [else
       (Float3-put! r ray-origin (Float3-in rays (fx* 6 k)))
       (Float3-put! r ray-direction (Float3-in rays (fx+ 3 (fx* 6 k))))
       (flvector-set! r ray-limit +inf.0)
       (when (kernel r i) (flvector-set! found k (flvector-ref r hit-t)))
       (loop (fx+ k 1))])))

;; Nearest-hit and any-hit kernels of a mesh's triangles that let rays through between them.
(: leaky-kernels (-> FlVector FxVector (List Kernel Kernel)))
(define (leaky-kernels positions triangles)
  (define count (quotient (fxvector-length triangles) 3))
  (define boxes (make-flvector (* 6 count)))
  (for ([k : Nonnegative-Fixnum (in-range count)])
    (for ([axis : Nonnegative-Fixnum (in-range 3)])
      (define-syntax-rule (corner c)
        (flvector-ref positions (fx+ axis (fx* 3 (fxvector-ref triangles (fx+ c (fx* 3 k)))))))
      (define-values (a b c) (values (corner 0) (corner 1) (corner 2)))
      (flvector-set! boxes (fx+ axis (fx* 6 k)) (fl- (flmin a (flmin b c)) 1e-15))
      (flvector-set! boxes (fx+ 3 (fx+ axis (fx* 6 k))) (fl+ (flmax a (flmax b c)) 1e-15))))
  (define hierarchy (build-hierarchy boxes count))
  (define bounds (Hierarchy-bounds hierarchy))
  (define links (Hierarchy-links hierarchy))
  (define order (Hierarchy-order hierarchy))
  ;; a corner and the edges to the other two
  (define packed (make-flvector (* 9 count)))
  (for ([place : Nonnegative-Fixnum (in-range count)])
    (define first (fx* 3 (fxvector-ref order place)))
    (let-float3 ([a (Float3-in positions (fx* 3 (fxvector-ref triangles first)))]
                 [b (Float3-in positions (fx* 3 (fxvector-ref triangles (fx+ first 1))))]
                 [c (Float3-in positions (fx* 3 (fxvector-ref triangles (fx+ first 2))))])
      (Float3-put! packed (fx* 9 place) a)
      (Float3-put! packed (fx+ 3 (fx* 9 place)) (Float3-subtract b a))
      (Float3-put! packed (fx+ 6 (fx* 9 place)) (Float3-subtract c a))))

  ;; hit sees t; a triangle that is missed costs no division
  (define-syntax-rule (let-hit t (o d place) hit miss)
    (let-float3 ([a (Float3-in packed (fx* 9 place))]
                 [edge-u (Float3-in packed (fx+ 3 (fx* 9 place)))]
                 [edge-v (Float3-in packed (fx+ 6 (fx* 9 place)))]
                 [p (Float3-cross d edge-v)]
                 [s (Float3-subtract o a)])
      (let* ([det (Float3-dot edge-u p)]
             [side (if (fl< det 0.0) -1.0 1.0)]
             [size (flabs det)]
             [u (fl* side (Float3-dot s p))])
        (if (or (fl< u 0.0) (fl> u size))
            miss
            (let-float3 ([q (Float3-cross s edge-u)])
              (let ([v (fl* side (Float3-dot d q))])
                (if (or (fl< v 0.0) (fl> (fl+ u v) size) (fl= det 0.0))
                    miss
                    (let ([t (fl/ (Float3-dot edge-v q) det)])
                      (if (fl> t 0.0) hit miss)))))))))

  (: nearest Kernel)
  (define (nearest r i)
    (flvector-set! r hit-t +inf.0)
    (fxvector-set! i hit-primitive -1)
    (traverse
     (bounds links r i) (o d) limit
     #:leaf (first end top next again)
     (let try ([place : Fixnum first] [far : Flonum limit])
       (if (fx= place end)
           (next far)
           (let-hit t (o d place)
             (if (fl< t far)
                 (begin
                   (flvector-set! r hit-t t)
                   (fxvector-set! i hit-primitive (fxvector-ref order place))
                   (try (fx+ place 1) t))
                 (try (fx+ place 1) far))
             (try (fx+ place 1) far))))
     #:done (fx>= (fxvector-ref i hit-primitive) 0)))

  (: occluded Kernel)
  (define (occluded r i)
    (traverse
     (bounds links r i) (o d) limit
     #:leaf (first end top next again)
     (let try ([place : Fixnum first])
       (if (fx= place end)
           (next limit)
           (let-hit t (o d place)
             (if (fl< t limit) #t (try (fx+ place 1)))
             (try (fx+ place 1)))))
     #:done #f))
  (list nearest occluded))
