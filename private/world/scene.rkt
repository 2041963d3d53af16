#lang typed/racket/base
;; A World compiled for rendering: shapes packed in the order of the hierarchy, lights and
;; materials as kernels. Built once for a World, on first use, and never changed.
(require racket/vector
         "../base/unsafe.rkt" "../base/float3.rkt"
         "../shape/shape.rkt" "../shape/kernel.rkt" "../shape/kernels.rkt" "../shape/sphere.rkt"
         "../shape/composite.rkt"
         "../material/material.rkt" "../material/kernel.rkt" "../material/kernels.rkt"
         "../base/unsafe-typed.rkt"
         "../light/light.rkt" "../light/kernels.rkt" "../light/parts.rkt" "../light/choice.rkt"
         "background.rkt" "hierarchy.rkt")

(provide (struct-out Scene) compile-scene)

(unsafe-require/typed "../base/promise.rkt" [once (All (a) (-> (-> a) (Promise a)))])

;; bounds, links, order: the hierarchy over the bounded primitives. spheres: centre and radius of
;; the sphere at each place of the hierarchy, radius -1 where the primitive is another shape;
;; primitive-spheres: the same by primitive.
;; unbounded: primitives without a box, tried for every ray. kernels: by primitive, #f for
;; spheres. primitive-materials: index into materials by primitive. primitive-lights: by primitive
;; the number of the light it is, -1 for none, and -2 - k for a composite with lights among its
;; parts, which part-lights tells apart at k. background-light: the number of the light that the
;; background is, the last one, or -1. extent: the largest coordinate. material-kernels: by number, made
;; when a path is first traced.
(struct Scene
  ([bounds : FlVector] [links : FxVector] [order : FxVector]
   [spheres : FlVector] [primitive-spheres : FlVector]
   [only-spheres? : Boolean] [unbounded : FxVector]
   [kernels : (Vectorof (U #f ShapeKernel))]
   [primitive-materials : FxVector] [materials : (Vectorof Material)]
   [lights : (Vectorof LightKernel)] [light-choice : LightChoice]
   [primitive-lights : FxVector] [part-lights : (Vectorof FindLight)]
   [background-light : Fixnum]
   [background : (-> FlVector FxVector Void)]
   [extent : Flonum]
   [material-kernels : (Promise (Vectorof MaterialKernel))]
   ;; what becomes of the kernel of points in media, for who observes the world
   [watch-scattering : (-> MaterialKernel MaterialKernel)]))

;; Boxes are padded by a few roundings of their coordinates, so that a hit the intersection finds
;; on the very edge of a shape is never outside the box.
(: put-padded-box! (-> FlVector Fixnum FlVector Void))
(define (put-padded-box! boxes at box)
  (let loop ([axis : Fixnum 0])
    (when (fx< axis 3)
      (let* ([low (flvector-ref box axis)]
             [high (flvector-ref box (fx+ axis 3))]
             [pad (fl* (fl* 8.0 (ROUNDING)) (flmax (flabs low) (flabs high)))])
        (flvector-set! boxes (fx+ at axis) (fl- low pad))
        (flvector-set! boxes (fx+ at (fx+ axis 3)) (fl+ high pad)))
      (loop (fx+ axis 1)))))

(: bounded? (-> FlVector Boolean))
(define (bounded? box)
  (let loop ([k : Fixnum 0])
    (or (fx= k 6) (and (fl< (flabs (flvector-ref box k)) +inf.0) (loop (fx+ k 1))))))

;; Spheres need no kernel of their own: worlds keep them packed.
(: kernel-or-sphere (-> CompileShape (-> Shape (U #f ShapeKernel))))
(define ((kernel-or-sphere compile) shape) (if (Sphere? shape) #f (compile shape)))

(: shape-bounds (-> Shape (U #f ShapeKernel) FlVector))
(define (shape-bounds shape kernel)
  (cond
    [kernel (ShapeKernel-bounds kernel)]
    [(Sphere? shape) (Sphere-bounds shape)]
    [else (flvector)]))

(: compile-scene (-> (Listof Shape) (Listof Light) Background Scene))
(define (compile-scene shape-list lights background)
  (define shapes (list->vector shape-list))
  (define count (vector-length shapes))
  (define-values (number all-materials) (number-materials))
  (define primitive-materials (numbers-of-materials shapes number))
  (define kernels : (Vectorof (U #f ShapeKernel))
    (vector-map (kernel-or-sphere (Shape-compiler number)) shapes))
  ;; the bounded primitives and their boxes; the unbounded ones
  (define boxes (make-flvector (* 6 count) 0.0))
  (define bounded (make-fxvector count 0))
  (define unbounded (make-fxvector count 0))
  (define bounded-count
    (let loop : Nonnegative-Fixnum ([k : Nonnegative-Fixnum 0] [found : Nonnegative-Fixnum 0])
      (cond
        [(< k count)
         (define box (shape-bounds (vector-ref shapes k) (vector-ref kernels k)))
         (cond
           [(bounded? box)
            (put-padded-box! boxes (fx* 6 found) box)
            (fxvector-set! bounded found k)
            (loop (+ k 1) (assert (+ found 1) fixnum?))]
           [else
            (fxvector-set! unbounded (fx- k found) k)
            (loop (+ k 1) found)])]
        [else found])))
  (define hierarchy (build-hierarchy boxes bounded-count))
  (define order (make-fxvector bounded-count 0))
  (let loop ([place : Fixnum 0])
    (when (fx< place bounded-count)
      (fxvector-set! order place
                     (fxvector-ref bounded (fxvector-ref (Hierarchy-order hierarchy) place)))
      (loop (fx+ place 1))))
  (define all (make-fxvector count 0))
  (let loop ([k : Fixnum 0])
    (when (fx< k count)
      (fxvector-set! all k k)
      (loop (fx+ k 1))))
  (define-values (shape-lights primitive-lights part-lights) (find-shape-lights shapes))
  (define background-light (Background-light-kernel background))
  (define materials (all-materials))
  (define light-kernels
    (list->vector (append shape-lights (map Light-kernel lights)
                          (if background-light (list background-light) '()))))
  (Scene (Hierarchy-bounds hierarchy) (Hierarchy-links hierarchy) order
         (packed-spheres shapes order)
         (packed-spheres shapes all)
         (and (= bounded-count count)
              (for/and : Boolean ([shape (in-vector shapes)]) (Sphere? shape)))
         (fxvector-copy unbounded 0 (- count bounded-count))
         kernels primitive-materials materials
         light-kernels (make-light-choice light-kernels)
         primitive-lights part-lights
         (if background-light (- (vector-length light-kernels) 1) -1)
         (Background-kernel background)
         (largest-magnitude boxes (* 6 bounded-count))
         (once (lambda ()
                 (for/vector : (Vectorof MaterialKernel) ([material (in-vector materials)])
                   (Material-kernel material))))
         (lambda ([kernel : MaterialKernel]) kernel)))

;; A procedure that numbers materials by identity in the order it meets them, those of the parts of
;; composites too, and one that returns all it has met.
(: number-materials (-> (Values NumberMaterial (-> (Vectorof Material)))))
(define (number-materials)
  (define numbers : (HashTable Material Index) (make-hasheq))
  (: number NumberMaterial)
  (define (number material)
    (or (hash-ref numbers material (lambda () #f))
        (let ([new (hash-count numbers)])
          (hash-set! numbers material new)
          new)))
  (: all-materials (-> (Vectorof Material)))
  (define (all-materials)
    (define pairs
      (sort (hash->list numbers)
            (lambda ([a : (Pairof Material Index)] [b : (Pairof Material Index)])
              (< (cdr a) (cdr b)))))
    (for/vector : (Vectorof Material) ([pair (in-list pairs)]) (car pair)))
  (values number all-materials))

(: numbers-of-materials (-> (Vectorof Shape) NumberMaterial FxVector))
(define (numbers-of-materials shapes number)
  (define numbers (make-fxvector (vector-length shapes) 0))
  (for ([k : Nonnegative-Fixnum (in-range (vector-length shapes))])
    (fxvector-set! numbers k (number (Shape-material (vector-ref shapes k)))))
  numbers)

;; The lights that shapes and parts of composites are; for every primitive its number among them, -1
;; or what stands for a composite; and by that what tells the number of the part that was hit.
(: find-shape-lights (-> (Vectorof Shape)
                         (Values (Listof LightKernel) FxVector (Vectorof FindLight))))
(define (find-shape-lights shapes)
  (define primitive-lights (make-fxvector (vector-length shapes) -1))
  (define-values (lights count finders finder-count)
    (for/fold ([lights : (Listof LightKernel) '()] [count : Fixnum 0]
               [finders : (Listof FindLight) '()] [finder-count : Fixnum 0])
              ([shape (in-vector shapes)] [k : Nonnegative-Fixnum (in-range (vector-length shapes))])
      (cond
        [(Composite? shape)
         (define-values (parts find) (part-lights shape count))
         (cond
           [find
            (fxvector-set! primitive-lights k (fx- -2 finder-count))
            (values (append (reverse parts) lights) (fx+ count (length parts))
                    (cons find finders) (fx+ finder-count 1))]
           [else (values lights count finders finder-count)])]
        [(Shape-light-kernel shape (Shape-material shape) k)
         => (lambda ([light : LightKernel])
              (fxvector-set! primitive-lights k count)
              (values (cons light lights) (fx+ count 1) finders finder-count))]
        [else (values lights count finders finder-count)])))
  (values (reverse lights) primitive-lights (list->vector (reverse finders))))

(: packed-spheres (-> (Vectorof Shape) FxVector FlVector))
(define (packed-spheres shapes order)
  (define packed (make-flvector (* 4 (fxvector-length order)) -1.0))
  (let loop ([place : Fixnum 0])
    (when (fx< place (fxvector-length order))
      (let ([shape (vector-ref shapes (fxvector-ref order place))])
        (when (Sphere? shape)
          (Float3-put! packed (fx* 4 place) (Sphere-point shape))
          (flvector-set! packed (fx+ 3 (fx* 4 place)) (Sphere-radius shape))))
      (loop (fx+ place 1))))
  packed)

(: largest-magnitude (-> FlVector Integer Flonum))
(define (largest-magnitude v end)
  (for/fold ([largest : Flonum 0.0]) ([k (in-range end)])
    (flmax largest (flabs (flvector-ref v (assert k fixnum?))))))
