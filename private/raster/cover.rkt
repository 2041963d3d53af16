#lang typed/racket/base
;; What covers the samples of a canvas: every piece of a world drawn into the z-buffer, by its
;; triangles, as an infinite plane, or by a ray for each sample where it may be seen.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/matrix.rkt"
         "../base/transform.rkt" "../shape/kernel.rkt" "../world/camera.rkt"
         "../world/camera-kernel.rkt" "scan.rkt" "tessellate.rkt")

(provide film-corners draw-pieces! make-scratch put-sample-place! number->piece number->triangle)

;; A surface's number: that of its piece, and of its triangle.
(define-syntax-rule (TRIANGLE-BITS) 28)
(define-syntax-rule (surface-number piece triangle)
  (fxior (fxlshift piece (TRIANGLE-BITS)) triangle))
(define-syntax-rule (number->piece id) (fxrshift id (TRIANGLE-BITS)))
(define-syntax-rule (number->triangle id) (fxand id (fx- (fxlshift 1 (TRIANGLE-BITS)) 1)))

;; The vertices as scan.rkt takes them.
(: film-corners (-> Tessellation Transform View FlVector))
(define (film-corners mesh transform view)
  (define positions (Tessellation-positions mesh))
  (define matrix
    (matrix-product (Transform-matrix (View-coordinates view)) (Transform-matrix transform)))
  (define perspective? (View-perspective? view))
  (define count (fxquotient (flvector-length positions) 3))
  (define corners (make-flvector (fx* 4 count)))
  (let each ([k : Fixnum 0])
    (when (fx< k count)
      (let-float3 ([p (matrix-point matrix 0 (Float3-in positions (fx* 3 k)))])
        (flvector-set! corners (fx* 4 k) (Float3-x p))
        (flvector-set! corners (fx+ 1 (fx* 4 k)) (Float3-y p))
        (flvector-set! corners (fx+ 2 (fx* 4 k)) (if perspective? (Float3-z p) 1.0))
        (flvector-set! corners (fx+ 3 (fx* 4 k)) (if perspective? 1.0 (fl* -1.0 (Float3-z p)))))
      (each (fx+ k 1))))
  corners)

(: draw-pieces! (-> Canvas View (Vectorof Piece) (Vectorof FlVector) Fixnum Boolean Void))
(define (draw-pieces! canvas view drawn corners faces wires?)
  (define perspective? (View-perspective? view))
  (define nearest (if perspective? +inf.0 0.0))
  (for ([piece (in-vector drawn)] [k : Nonnegative-Fixnum (in-range (vector-length drawn))])
    (define mesh (Piece-mesh piece))
    (define kernel (Piece-kernel piece))
    (define plane (Piece-plane piece))
    (cond
      [mesh
       (define points (vector-ref corners k))
       (define turned?
         (not (eq? (turns? (Piece-transform piece)) (not (turns? (View-coordinates view))))))
       (draw-mesh! canvas points (Tessellation-triangles mesh) (surface-number k 0)
                   (if (and turned? (fx> faces 0)) (fx- 3 faces) faces)
                   wires? (if perspective? (near-distance points) 0.5) nearest)]
      [(and plane (View-linear? view))
       (define away? (fl< (Float3-dot (Float3-subtract (Camera-eye (View-camera view)) (car plane))
                                      (cdr plane))
                          0.0))
       (define seen-from-front?
         (if perspective?
             (not away?)
             (fl< (Float3-dot (Camera-forward (View-camera view)) (cdr plane)) 0.0)))
       (unless (fx= faces (if seen-from-front? 2 1))
         (draw-plane! canvas view (car plane) (cdr plane) (surface-number k 0) nearest))]
      [kernel (cast-at! canvas view kernel (surface-number k 0) faces)])))

;; Whether a map turns what is counter-clockwise clockwise.
(: turns? (-> Transform Boolean))
(define (turns? transform)
  (define m (Transform-matrix transform))
  (let-float3 ([x (Float3 (flvector-ref m 0) (flvector-ref m 4) (flvector-ref m 8))]
               [y (Float3 (flvector-ref m 1) (flvector-ref m 5) (flvector-ref m 9))]
               [z (Float3 (flvector-ref m 2) (flvector-ref m 6) (flvector-ref m 10))])
    (fl< (Float3-dot (Float3-cross x y) z) 0.0)))

;; What is nearer than 2^-40 of the farthest vertex is clipped: numbers stay finite.
(: near-distance (-> FlVector Flonum))
(define (near-distance corners)
  (define count (fxquotient (flvector-length corners) 4))
  (let each : Flonum ([k : Fixnum 0] [farthest : Flonum 0.0])
    (if (fx< k count)
        (each (fx+ k 1) (flmax farthest (flvector-ref corners (fx+ 2 (fx* 4 k)))))
        (flmax 1e-300 (fl* 9.094947017729282e-13 farthest)))))

;; An infinite plane: from the point of it nearest to the eye, in a quarter each, to points infinitely
;; far away, so that its horizon is where it belongs. Seen along parallel rays it has no horizon: it
;; is as large as the clipped film.
(: draw-plane! (-> Canvas View Float3 Float3 Fixnum Flonum Void))
(define (draw-plane! canvas view point normal id nearest)
  (define camera (View-camera view))
  (define eye (Camera-eye camera))
  (define height (Float3-dot (Float3-subtract eye point) normal))
  (define coordinates (Transform-matrix (View-coordinates view)))
  (cond
    [(View-perspective? view)
     (define foot (matrix-point coordinates 0 (Float3-multiply-add eye (fl- 0.0 height) normal)))
     ;; in units of the eye's height, to keep digits
     (define size (flabs height))
     (define aside
       (Float3-normalized/checked
        (if (fl< (flabs (Float3-x normal)) 0.7)
            (Float3-cross normal (make-Float3 1 0 0))
            (Float3-cross normal (make-Float3 0 1 0)))))
     (define along (Float3-cross normal aside))
     (: direction (-> Float3 Flonum Float3))
     (define (direction d sign)
       (matrix-vector coordinates 0 (Float3-scale-by-scalar d (fl* sign size))))
     (define round
       (vector (direction aside 1.0) (direction along 1.0) (direction aside -1.0)
               (direction along -1.0)))
     (define near (flmax 1e-300 (fl* 9.094947017729282e-13 size)))
     (when (fl> size 0.0)
       (for ([k : Nonnegative-Fixnum (in-range 4)])
         (define a (vector-ref round k))
         (define b (vector-ref round (fxand 3 (fx+ k 1))))
         (draw-polygon! canvas
                        (flvector (Float3-x foot) (Float3-y foot) (Float3-z foot) 1.0
                                  (Float3-x a) (Float3-y a) (Float3-z a) 0.0
                                  (Float3-x b) (Float3-y b) (Float3-z b) 0.0)
                        id 0 near nearest)))]
    [else
     (define slope (Float3-dot (Camera-forward camera) normal))
     (: key (-> Flonum Flonum Flonum)) ; less the distance in units of forward
     (define (key a b)
       (fl/ (fl+ height (fl+ (fl* a (Float3-dot (Camera-right camera) normal))
                             (fl* b (Float3-dot (Camera-up camera) normal))))
            slope))
     (unless (fl= slope 0.0)
       (draw-polygon! canvas
                      (flvector -1.5 -1.5 1.0 (key -1.5 -1.5) 1.5 -1.5 1.0 (key 1.5 -1.5)
                                1.5 1.5 1.0 (key 1.5 1.5) -1.5 1.5 1.0 (key -1.5 1.5))
                      id 0 0.5 nearest))]))

;; The key of a point at distance t along the ray in the scratch.
(define-syntax-rule (ray-key r coordinates perspective? linear?)
  (let ([t (flvector-ref r hit-t)])
    (if linear?
        (let-float3 ([d (Float3-in r ray-direction)])
          (let ([along (fl* t (fl+ (fl+ (fl* (flvector-ref coordinates 8) (Float3-x d))
                                        (fl* (flvector-ref coordinates 9) (Float3-y d)))
                                   (fl* (flvector-ref coordinates 10) (Float3-z d))))])
            (if perspective? (fl/ 1.0 along) (fl* -1.0 along))))
        (fl* -1.0 t))))

;; A ray through every sample where the shape may be seen.
(: cast-at! (-> Canvas View ShapeKernel Fixnum Fixnum Void))
(define (cast-at! canvas view kernel id faces)
  (define-values (r i) (make-scratch view))
  (define cast-ray! (Camera-kernel (View-camera view) (View-width view) (View-height view)))
  (define nearest! (ShapeKernel-nearest kernel))
  (define surface! (ShapeKernel-surface kernel))
  (define coordinates (Transform-matrix (View-coordinates view)))
  (define-values (perspective? linear?) (values (View-perspective? view) (View-linear? view)))
  (define place (View-place view (ShapeKernel-bounds kernel)))
  (define samples (Canvas-samples canvas))
  (define-values (keys ids) (values (Canvas-keys canvas) (Canvas-ids canvas)))
  (define width (Canvas-width canvas))
  (define-values (left top) (values (Canvas-left canvas) (Canvas-top canvas)))
  (: first (-> Flonum Fixnum Fixnum))
  (define (first edge origin)
    (let ([k (fx- (fx- (fl->fx (flfloor edge)) origin) 1)]) (if (fx< k 0) 0 k)))
  (: end (-> Flonum Fixnum Fixnum Fixnum))
  (define (end edge origin most)
    (let ([k (fx+ (fx- (fl->fx (flfloor edge)) origin) 2)]) (if (fx< k most) k most)))
  (when (and (fl<= (car place) (caddr place)) (fl<= (cadr place) (cadddr place)))
    (define first-x (first (car place) left))
    (define end-x (end (caddr place) left width))
    (define first-y (first (cadr place) top))
    (define end-y (end (cadddr place) top (Canvas-height canvas)))
    (let rows ([y : Fixnum first-y])
      (when (fx< y end-y)
        (let columns ([x : Fixnum first-x])
          (when (fx< x end-x)
            (let each ([sample : Fixnum 0])
              (when (fx< sample samples)
                (put-sample-place! r canvas x y sample)
                (cast-ray! r i)
                (flvector-set! r ray-limit +inf.0)
                (when (and (nearest! r i)
                           (or (fx= faces 0)
                               (begin
                                 (surface! r i)
                                 (let-float3 ([n (Float3-in r surface-normal)]
                                              [d (Float3-in r ray-direction)])
                                   (eq? (fl< (Float3-dot n d) 0.0) (fx= faces 1))))))
                  (let ([at (fx+ sample (fx* samples (fx+ x (fx* y width))))]
                        [key (ray-key r coordinates perspective? linear?)])
                    (put-if-nearer! keys ids at key id)))
                (each (fx+ sample 1))))
            (columns (fx+ x 1))))
        (rows (fx+ y 1))))))

;; A scratch for kernels, at the view's time.
(: make-scratch (-> View (Values FlVector FxVector)))
(define (make-scratch view)
  (define r (make-flonum-registers))
  (flvector-set! r ray-time (View-time view))
  (values r (make-fixnum-registers)))

;; Writes where on the film a sample of a pixel of the canvas is.
(define-syntax-rule (put-sample-place! r canvas x y sample)
  (let ([offsets (Canvas-offsets canvas)]
        [part (fl/ 1.0 (fx->fl (Canvas-subpixels canvas)))])
    (flvector-set! r film-x
                   (fl+ (fx->fl (fx+ x (Canvas-left canvas)))
                        (fl* part (fx->fl (fxvector-ref offsets (fx* 2 sample))))))
    (flvector-set! r film-y
                   (fl+ (fx->fl (fx+ y (Canvas-top canvas)))
                        (fl* part (fx->fl (fxvector-ref offsets (fx+ 1 (fx* 2 sample)))))))))
