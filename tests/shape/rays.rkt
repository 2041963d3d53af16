#lang typed/racket/base
;; Rays at a shape's kernels, for the tests: many rays at once, six numbers each in an flvector.
(require "../../private/base/unsafe.rkt" "../../private/base/registers.rkt"
         "../../private/base/float3.rkt" "../../private/shape/shape.rkt"
         "../../private/shape/kernel.rkt" "../../private/shape/kernels.rkt"
         "../../private/shape/mesh.rkt" "../../private/material/material.rkt")

(provide shoot shoot-by-scan shoot-occluded shoot-surface shoot-material hit-count leave-count)

;; The parameter of the nearest hit of each ray, infinite for none, then the number in the first
;; place of its path, -1 for none: two numbers a ray.
(: shoot (->* (Shape FlVector) (Flonum) FlVector))
(define (shoot shape rays [limit +inf.0])
  (shoot-with (ShapeKernel-nearest (Shape-kernel shape)) rays limit))

;; The same for a mesh, by trying all its triangles.
(: shoot-by-scan (->* (Mesh FlVector) (Flonum) FlVector))
(define (shoot-by-scan mesh rays [limit +inf.0])
  (shoot-with (lambda ([r : FlVector] [i : FxVector]) (Mesh-nearest-by-scan mesh r i)) rays limit))

(: shoot-with (-> (-> FlVector FxVector Boolean) FlVector Flonum FlVector))
(define (shoot-with nearest rays limit)
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (define count (quotient (flvector-length rays) 6))
  (define result (make-flvector (* 2 count) +inf.0))
  (let loop ([k : Fixnum 0])
    (cond
      [(fx= k count) result]
      [else
       (put-ray! r i rays k limit)
       (cond
         [(nearest r i)
          (flvector-set! result (fx* 2 k) (flvector-ref r hit-t))
          (flvector-set! result (fx+ 1 (fx* 2 k)) (fx->fl (fxvector-ref i hit-path)))]
         [else (flvector-set! result (fx+ 1 (fx* 2 k)) -1.0)])
       (check-as-before r i rays k)
       (loop (fx+ k 1))])))

;; Whatever was entered on the way, the ray and the levels must be left as they were.
(: check-as-before (-> FlVector FxVector FlVector Fixnum Void))
(define (check-as-before r i rays k)
  (unless (and (fx= 0 (fxvector-ref i nest-level))
               (fx= 0 (fxvector-ref i stack-base))
               (for/and : Boolean ([j : Nonnegative-Fixnum (in-range 6)])
                 (eqv? (flvector-ref rays (fx+ (fx* 6 k) j)) (flvector-ref r (fx+ ray-origin j)))))
    (error 'shoot "the kernel left the ray or the levels changed, ray ~a" k)))

;; How many rays the any-hit kernel calls occluded; how many have a nearest hit.
(: shoot-occluded (->* (Shape FlVector) (Flonum) Fixnum))
(define (shoot-occluded shape rays [limit +inf.0])
  (count-with (ShapeKernel-occluded (Shape-kernel shape)) rays limit))
(: hit-count (->* (Shape FlVector) (Flonum) Fixnum))
(define (hit-count shape rays [limit +inf.0])
  (count-with (ShapeKernel-nearest (Shape-kernel shape)) rays limit))

(: count-with (-> (-> FlVector FxVector Boolean) FlVector Flonum Fixnum))
(define (count-with kernel rays limit)
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (define count (quotient (flvector-length rays) 6))
  (let loop : Fixnum ([k : Fixnum 0] [found : Fixnum 0])
    (cond
      [(fx= k count) found]
      [else
       (put-ray! r i rays k limit)
       (let ([found (if (kernel r i) (fx+ found 1) found)])
         (check-as-before r i rays k)
         (loop (fx+ k 1) found))])))

(: put-ray! (-> FlVector FxVector FlVector Fixnum Flonum Void))
(define (put-ray! r i rays k limit)
  (fxvector-set! i accept-ties 0)
  (Float3-put! r ray-origin (Float3-in rays (fx* 6 k)))
  (Float3-put! r ray-direction (Float3-in rays (fx+ 3 (fx* 6 k))))
  (flvector-set! r ray-limit limit))

;; What the surface kernel says where one ray meets the shape: t, point, normal, shading normal,
;; u, v, error, or #f for no hit.
(: shoot-surface (->* (Shape Float3 Float3) (#:time Flonum) (U #f (Listof Flonum))))
(define (shoot-surface shape origin direction #:time [time 0.0])
  (define kernel (Shape-kernel shape))
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (Float3-put! r ray-origin origin)
  (Float3-put! r ray-direction direction)
  (flvector-set! r ray-limit +inf.0)
  (flvector-set! r ray-time time)
  (cond
    [((ShapeKernel-nearest kernel) r i)
     ((ShapeKernel-surface kernel) r i)
     ((ShapeKernel-uv kernel) r i)
     (append (list (flvector-ref r hit-t))
             (for/list : (Listof Flonum)
                       ([place (list surface-point (+ 1 surface-point) (+ 2 surface-point)
                                     surface-normal (+ 1 surface-normal) (+ 2 surface-normal)
                                     surface-shading-normal (+ 1 surface-shading-normal)
                                     (+ 2 surface-shading-normal)
                                     surface-uv (+ 1 surface-uv) surface-error)])
               (flvector-ref r place)))]
    [else #f]))

;; The number of the material where one ray meets the shape: as `number` says for a composite's
;; parts, -2 where the shape left it to its owner, #f for no hit.
(: shoot-material (-> Shape Float3 Float3 (-> Material Fixnum) (U #f Fixnum)))
(define (shoot-material shape origin direction number)
  (define kernel ((Shape-compiler number) shape))
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (Float3-put! r ray-origin origin)
  (Float3-put! r ray-direction direction)
  (flvector-set! r ray-limit +inf.0)
  (fxvector-set! i hit-material -2)
  (and ((ShapeKernel-nearest kernel) r i)
       (begin
         ((ShapeKernel-surface kernel) r i)
         (fxvector-ref i hit-material))))

;; How many of the rays that hit a shape hit it again when they go on from there, outwards: the
;; direction turned to the normal's side, the origin off the surface by its error bound.
(: leave-count (-> Shape FlVector FlVector Fixnum))
(define (leave-count shape rays directions)
  (define kernel (Shape-kernel shape))
  (define nearest (ShapeKernel-nearest kernel))
  (define surface (ShapeKernel-surface kernel))
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (define count (quotient (flvector-length rays) 6))
  (let loop : Fixnum ([k : Fixnum 0] [again : Fixnum 0])
    (cond
      [(fx= k count) again]
      [else
       (put-ray! r i rays k +inf.0)
       (cond
         [(nearest r i)
          (surface r i)
          (let-float3 ([n (Float3-in r surface-normal)]
                       [d (Float3-in directions (fx* 3 k))])
            (Float3-put! r ray-origin
                         (Float3-multiply-add (Float3-in r surface-point)
                                              (flvector-ref r surface-error) n))
            (Float3-put! r ray-direction
                         (Float3-scale-by-scalar d (if (fl< (Float3-dot n d) 0.0) -1.0 1.0))))
          (flvector-set! r ray-limit +inf.0)
          (loop (fx+ k 1) (if (nearest r i) (fx+ again 1) again))]
         [else (loop (fx+ k 1) again)])])))
