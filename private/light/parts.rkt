#lang typed/racket/base
;; Lights that are parts of groups and instances: each emitting part is sampled as the shape it is
;; in the world's space, and a hit's path through the composite tells which of them it is.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/matrix.rkt"
         "../base/transform.rkt" "../base/frame.rkt"
         "../material/material.rkt" "../material/emitter.rkt"
         "../shape/shape.rkt" "../shape/kernel.rkt" "../shape/kernels.rkt" "../shape/composite.rkt"
         "../shape/group.rkt" "../shape/instance.rkt" "../shape/sphere.rkt" "../shape/quad.rkt"
         "../shape/disk.rkt" "../shape/triangle.rkt" "../shape/box.rkt" "../shape/mesh.rkt"
         "light.rkt" "kernels.rkt" "mesh.rkt" "planar.rkt")

(provide FindLight part-lights)

;; From the path to a hit to the number of the light that was hit, or -1.
(define-type FindLight (-> FxVector Fixnum))

;; The lights in a composite, numbered from `first`, and which of them a hit is on; #f without any.
;; Sampled are the shapes that are sampled in a world, where every instance around them maps them
;; to a shape of the same kind: spheres if it keeps angles, disks if it does in their plane, boxes
;; if it only moves and stretches along the axes. Others, and what moves or is a solid's part, are
;; found by scattered rays alone.
(: part-lights (-> Shape Fixnum (Values (Listof LightKernel) (U #f FindLight))))
(define (part-lights composite first)
  (define lights : (Listof LightKernel) '())
  (define count : Fixnum 0)
  (define known : (HashTable Shape Boolean) (make-hasheq))

  ;; Whether a part has an emitting material of its own; asked once of a shape that is shared.
  (: shines? (-> Shape Boolean))
  (define (shines? shape)
    (hash-ref! known shape
               (lambda ()
                 (cond
                   [(Group? shape) (ormap shines? (Group-shapes shape))]
                   [(Instance? shape)
                    (define material (Instance-material shape))
                    (if material (Emitter? material) (shines? (Instance-shape shape)))]
                   [(Composite? shape) #f]
                   [else (Emitter? (Shape-material shape))]))))

  ;; level: of nesting; transforms: of the instances around the shape, the innermost first;
  ;; material: that of the outermost of them that has one, or #f.
  (: visit (-> Shape Fixnum (Listof Transform) (U #f Material) FindLight))
  (define (visit shape level transforms material)
    (cond
      [(if material (not (Emitter? material)) (not (shines? shape))) none]
      [(Group? shape)
       (define parts : (Vectorof FindLight)
         (for/vector : (Vectorof FindLight) ([part (in-list (Group-shapes shape))])
           (visit part (fx+ level 1) transforms material)))
       (define place (fx+ hit-path level))
       (if (for/and : Boolean ([find (in-vector parts)]) (eq? find none))
           none
           (lambda ([i : FxVector]) ((vector-ref parts (fxvector-ref i place)) i)))]
      [(Instance? shape)
       (visit (Instance-shape shape) (fx+ level 1) (cons (Instance-transform shape) transforms)
              (or material (Instance-material shape)))]
      [(Composite? shape) none]
      [else
       (define emitter (or material (Shape-material shape)))
       (define light
         (and (Emitter? emitter)
              (Float3? (Emitter-radiance emitter))
              (part-light-kernel shape emitter level transforms)))
       (cond
         [light
          (define number (fx+ first count))
          (set! lights (cons light lights))
          (set! count (fx+ count 1))
          (lambda ([i : FxVector]) number)]
         [else none])]))

  (define find (visit composite 0 '() #f))
  (values (reverse lights) (if (eq? find none) #f find)))

(: none FindLight)
(define (none i) -1)

;; --- one part ---

;; How far a part's hits may be from where its light's samples are: an absolute bound, and one for
;; every unit of the ray's length; of a shape in a space of its own, and of its instance.
(struct Misfit ([absolute : Flonum] [relative : Flonum]))

(: own-misfit (-> Shape Misfit))
(define (own-misfit shape)
  (Misfit (fl* (fl* 256.0 (ROUNDING)) (shape-size shape)) (fl* 64.0 (ROUNDING))))

(: instance-misfit (-> Misfit Transform Shape Shape Misfit))
(define (instance-misfit misfit transform local image)
  (define matrix (Transform-matrix transform))
  (define growth (matrix-growth matrix))
  (define rows (largest-row-sum (Transform-inverse-matrix transform) 0))
  (define condition (fl+ 1.0 (fl* growth rows)))
  (Misfit (fl+ (fl* growth (Misfit-absolute misfit))
               (fl* (fl* 64.0 (ROUNDING))
                    (fl* condition (fl+ (fl* growth (shape-size local)) (shape-size image)))))
          (fl* condition (fl+ (Misfit-relative misfit) (fl* 64.0 (ROUNDING))))))

;; #f where the part is no shape that can be sampled.
(: part-light-kernel (-> Shape Emitter Fixnum (Listof Transform) (U #f LightKernel)))
(define (part-light-kernel local emitter level transforms)
  (let outward ([shape : (U #f Shape) (sampled-shape local)]
                [misfit : Misfit (own-misfit local)]
                [transforms : (Listof Transform) transforms])
    (cond
      [(not shape) #f]
      [(pair? transforms)
       (define image (transformed-shape shape (car transforms)))
       (outward image
                (if image (instance-misfit misfit (car transforms) shape image) misfit)
                (cdr transforms))]
      [else (ending-short shape emitter level misfit)])))

;; A shadow ray cannot pass over a part of a composite as it does over a light of the world: it ends
;; short of the light by what hits and samples may differ along the ray, which grows as the ray
;; gets flatter to the light.
(: ending-short (-> Shape Emitter Fixnum Misfit (U #f LightKernel)))
(define (ending-short shape emitter level misfit)
  (define-values (absolute relative) (values (Misfit-absolute misfit) (Misfit-relative misfit)))
  (cond
    [(Mesh? shape) (Mesh-light-kernel shape emitter level absolute relative)]
    [else
     (define kernel (Shape-light-kernel shape emitter -1))
     (define put-cosine! (cosine-at-sample shape))
     (and kernel
          (LightKernel
           (lambda ([r : FlVector] [i : FxVector])
             ((LightKernel-sample kernel) r i)
             (when (fl> (flvector-ref r light-density) 0.0)
               (put-cosine! r)
               (let ([cosine (flvector-ref r workspace)])
                 (end-short! r absolute relative cosine))))
           (LightKernel-density kernel)
           #t -1
           (LightKernel-bound kernel)))]))

;; Writes the cosine at which the sampled ray meets the light, to the first place of the workspace.
(: cosine-at-sample (-> Shape (-> FlVector Void)))
(define (cosine-at-sample shape)
  (define-syntax-rule (at-point (r p) cosine)
    (lambda ([r : FlVector])
      (let-float3 ([p (Float3-multiply-add (Float3-in r surface-point)
                                           (flvector-ref r light-distance)
                                           (Float3-in r light-direction))])
        (flvector-set! r workspace (flabs cosine)))))
  (define-syntax-rule (flat normal)
    (let ([n normal])
      (at-point (r p) (Float3-dot n (Float3-in r light-direction)))))
  (cond
    [(Quad? shape) (flat (Quad-normal shape))]
    [(Disk? shape) (flat (Disk-normal shape))]
    [(Triangle? shape)
     (flat (or (triangle-normal (Triangle-a shape) (Triangle-b shape) (Triangle-c shape))
               (make-Float3 0 0 0)))]
    [(Sphere? shape)
     (define-values (center inverse) (values (Sphere-point shape) (fl/ 1.0 (Sphere-radius shape))))
     (at-point (r p) (fl* inverse (Float3-dot (Float3-subtract p center)
                                              (Float3-in r light-direction))))]
    [(Box? shape)
     ;; of the face the point is nearest to
     (define-values (low high) (values (Box-low shape) (Box-high shape)))
     (define-syntax-rule (gap component p)
       (flmin (flabs (fl- (component p) (component low)))
              (flabs (fl- (component high) (component p)))))
     (at-point (r p)
       (let* ([x (gap Float3-x p)] [y (gap Float3-y p)] [z (gap Float3-z p)]
              [axis (if (and (fl<= x y) (fl<= x z)) 0 (if (fl<= y z) 1 2))])
         (flvector-ref r (fx+ light-direction axis))))]
    [else (lambda ([r : FlVector]) (flvector-set! r workspace 1.0))]))

;; --- shapes and their images ---

;; The shape itself if lights can have it.
(: sampled-shape (-> Shape (U #f Shape)))
(define (sampled-shape shape)
  (and (or (Sphere? shape) (Quad? shape) (Disk? shape) (Triangle? shape) (Box? shape) (Mesh? shape))
       shape))

;; About the largest coordinate of a sampled shape.
(: shape-size (-> Shape Flonum))
(define (shape-size shape)
  (: largest (-> FlVector Flonum))
  (define (largest numbers)
    (for/fold ([size : Flonum 0.0]) ([k : Nonnegative-Fixnum (in-range (flvector-length numbers))])
      (flmax size (flabs (flvector-ref numbers k)))))
  (cond
    [(Sphere? shape) (largest (Sphere-bounds shape))]
    [(Quad? shape) (largest (Quad-bounds shape))]
    [(Disk? shape) (largest (Disk-bounds shape))]
    [(Triangle? shape) (largest (Triangle-bounds shape))]
    [(Box? shape) (largest (Box-bounds shape))]
    [(Mesh? shape) (largest (Mesh-positions shape))]
    [else 0.0]))

;; The image of a sampled shape if it is one of the same kind, else #f. A map that mirrors turns
;; the order of edges and corners, so that outside stays outside.
;; So is one that is too large or too small to be a shape.
(: transformed-shape (-> Shape Transform (U #f Shape)))
(define (transformed-shape shape transform)
  (with-handlers ([exn:fail:contract? (lambda (e) #f)])
    (image-of-shape shape transform)))

(: image-of-shape (-> Shape Transform (U #f Shape)))
(define (image-of-shape shape transform)
  (define-syntax-rule (point-of p) (Transform-point transform p))
  (define-syntax-rule (vector-of v) (Transform-vector transform v))
  (define mirrors? (fl< (determinant (Transform-matrix transform)) 0.0))
  (define-values (x y z)
    (values (vector-of (make-Float3 1 0 0)) (vector-of (make-Float3 0 1 0))
            (vector-of (make-Float3 0 0 1))))
  (cond
    [(Sphere? shape)
     (and (square? x y) (square? y z) (square? z x)
          (make-Sphere (point-of (Sphere-point shape))
                       (fl* (Float3-length x) (Sphere-radius shape))))]
    [(Quad? shape)
     (define-values (u v)
       (values (vector-of (Quad-edge-u shape)) (vector-of (Quad-edge-v shape))))
     (define corner (point-of (Quad-corner shape)))
     (if mirrors? (make-Quad corner v u) (make-Quad corner u v))]
    [(Disk? shape)
     (define n (Disk-normal shape))
     (define aside
       (Float3-normalized
        (Float3-cross n (if (fl< (flabs (Float3-x n)) 0.5) (make-Float3 1 0 0) (make-Float3 0 1 0)))))
     (define-values (p q) (values (vector-of aside) (vector-of (Float3-cross n aside))))
     (and (square? p q)
          (make-Disk (point-of (Disk-point shape)) (Transform-normal transform n)
                     (fl* (Float3-length p) (Disk-radius shape))))]
    [(Triangle? shape)
     (define-values (a b c)
       (values (point-of (Triangle-a shape)) (point-of (Triangle-b shape))
               (point-of (Triangle-c shape))))
     (if mirrors? (make-Triangle a c b) (make-Triangle a b c))]
    [(Box? shape)
     (define-values (p q) (values (point-of (Box-low shape)) (point-of (Box-high shape))))
     (and (along-axes? x y z)
          (make-Box (Float3-componentwise flmin p q) (Float3-componentwise flmax p q)))]
    [(Mesh? shape)
     (make-Mesh (transformed-positions (Mesh-positions shape) (Transform-matrix transform))
                (if mirrors? (turned-triangles (Mesh-triangles shape)) (Mesh-triangles shape)))]
    [else #f]))

(define-syntax-rule (Float3-componentwise f p q)
  (make-Float3 (f (Float3-x p) (Float3-x q)) (f (Float3-y p) (Float3-y q))
               (f (Float3-z p) (Float3-z q))))

(: determinant (-> FlVector Flonum))
(define (determinant m)
  (define-values (x y z)
    (values (Float3 (flvector-ref m 0) (flvector-ref m 4) (flvector-ref m 8))
            (Float3 (flvector-ref m 1) (flvector-ref m 5) (flvector-ref m 9))
            (Float3 (flvector-ref m 2) (flvector-ref m 6) (flvector-ref m 10))))
  (Float3-dot (Float3-cross x y) z))

;; Whether two vectors are equally long and at right angles, but for a few roundings.
(: square? (-> Float3 Float3 Boolean))
(define (square? p q)
  (define-values (pp qq) (values (Float3-length-squared p) (Float3-length-squared q)))
  (define least (fl* (fl* 64.0 (ROUNDING)) (flmax pp qq)))
  (and (fl<= (flabs (fl- pp qq)) least) (fl<= (flabs (Float3-dot p q)) least)))

(: along-axes? (-> Float3 Float3 Float3 Boolean))
(define (along-axes? x y z)
  (and (fl= 0.0 (Float3-y x)) (fl= 0.0 (Float3-z x)) (fl= 0.0 (Float3-x y))
       (fl= 0.0 (Float3-z y)) (fl= 0.0 (Float3-x z)) (fl= 0.0 (Float3-y z))))

(: transformed-positions (-> FlVector FlVector FlVector))
(define (transformed-positions positions matrix)
  (define images (make-flvector (flvector-length positions) 0.0))
  (for ([at : Nonnegative-Fixnum (in-range 0 (flvector-length positions) 3)])
    (let-float3 ([p (Float3-in positions at)])
      (Float3-put! images at (matrix-point matrix 0 p))))
  images)

(: turned-triangles (-> FxVector FxVector))
(define (turned-triangles triangles)
  (define turned (fxvector-copy triangles))
  (for ([at : Nonnegative-Fixnum (in-range 0 (fxvector-length triangles) 3)])
    (fxvector-set! turned (fx+ at 1) (fxvector-ref triangles (fx+ at 2)))
    (fxvector-set! turned (fx+ at 2) (fxvector-ref triangles (fx+ at 1))))
  turned)
