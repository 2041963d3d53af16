#lang typed/racket/base
;; A world drawn at once, by rasterization: its pieces go into a z-buffer, then every surface that is
;; seen in a pixel is shaded once.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/matrix.rkt"
         "../base/transform.rkt" "../base/check.rkt" "../material/material.rkt"
         "../shape/kernel.rkt" "../world/camera.rkt" "../world/camera-kernel.rkt"
         "../world/background.rkt" "../world/world.rkt" "../image/image.rkt"
         "scan.rkt" "tessellate.rkt" "shade.rkt")

(provide preview SHADINGS coverage-offsets)

;; How surfaces are shaded: one colour a triangle, colours of corners interpolated, normals of corners
;; interpolated, those in steps with an outline, edges only; and views of one thing each.
(define SHADINGS : (Listof Symbol)
  '(phong gouraud flat toon wireframe normals depth texture-coordinates))

;; preview : the picture of a world through a camera at once, without shadows, reflections of other
;; surfaces, blur and noise. #:width and #:height in pixels. #:shading one of SHADINGS, or a list of
;; them for as many pictures side by side. #:samples at each of which it is decided what covers a
;; pixel, 1 to 64. #:tolerance how far in pixels triangles may be seen from a curved surface.
;; #:faces 'both, 'front for triangles seen from outside only, or 'back. #:fog-density: light from a
;; surface at distance d loses all but exp(-density d) of itself to #:fog-color. #:crop (list x y width
;; height) draws only that part. What moves is where it is when the shutter opens; a lens is taken as
;; a pinhole. Raises exn:fail:contract on numbers out of range.
(: preview (->* (World Camera)
                (#:width Integer #:height Integer #:shading (U Symbol (Listof Symbol))
                 #:samples Integer #:tolerance Real #:faces Symbol
                 #:fog-color Float3 #:fog-density Real
                 #:crop (U #f (List Integer Integer Integer Integer)))
                Image))
(define (preview world camera #:width [width 640] #:height [height 360] #:shading [shading 'phong]
                 #:samples [samples 4] #:tolerance [tolerance 0.2] #:faces [faces 'both]
                 #:fog-color [fog-color (make-Float3 1 1 1)] #:fog-density [fog-density 0.0]
                 #:crop [crop #f])
  (define columns (check-count 'preview "width" width 1 100000))
  (define rows (check-count 'preview "height" height 1 100000))
  (define offsets (coverage-offsets (check-count 'preview "samples" samples 1 64)
                                    (subpixels columns rows)))
  (define within (check-positive 'preview "tolerance" tolerance))
  (define density (check-between 'preview "fog-density" fog-density 0.0 1e300))
  (check-color 'preview "fog-color" fog-color)
  (define face-number : Fixnum
    (case faces
      [(both) 0] [(front) 1] [(back) 2]
      [else (raise-expected 'preview "faces" "'both, 'front or 'back" faces)]))
  (define shadings : (Listof Symbol) (if (symbol? shading) (list shading) shading))
  (define count (length shadings))
  (unless (and (<= 1 count columns)
               (for/and : Boolean ([name (in-list shadings)]) (and (memq name SHADINGS) #t)))
    (raise-expected 'preview "shading" (format "one of ~a, or a list of them" SHADINGS) shading))
  (define-values (x0 y0 across down)
    (if crop
        (values (check-count 'preview "crop's x" (car crop) 0 (- columns 1))
                (check-count 'preview "crop's y" (cadr crop) 0 (- rows 1))
                (check-count 'preview "crop's width" (caddr crop) 1 (- columns (car crop)))
                (check-count 'preview "crop's height" (cadddr crop) 1 (- rows (cadr crop))))
        (values 0 0 columns rows)))
  (define pixels (make-flvector (* 3 across down) 0.0))
  (for ([name (in-list shadings)] [k : Nonnegative-Fixnum (in-range 100000)])
    (define left (fxquotient (fx* columns k) count))
    (define right (fxquotient (fx* columns (fx+ k 1)) count))
    (define first-column (if (fx> left x0) left x0))
    (define end-column (if (fx< right (fx+ x0 across)) right (fx+ x0 across)))
    (when (fx< first-column end-column)
      (draw! (Film pixels across (fx- first-column x0))
             world (make-View camera (fx- right left) rows) name within face-number
             fog-color density offsets
             (fx- first-column left) y0 (fx- end-column first-column) down)))
  (make-Image across down pixels))

;; pixels: of a picture that wide; left: the column where a part of it begins.
(struct Film ([pixels : FlVector] [width : Fixnum] [left : Fixnum]))

;; Parts of a pixel's side that corners are rounded to: as many as leave products of whole numbers
;; room in 60 bits.
(: subpixels (-> Fixnum Fixnum Fixnum))
(define (subpixels width height) (if (fx< (if (fx< width height) height width) 16384) 4096 256))

;; coverage-offsets : where the samples of a pixel are, two whole numbers of subpixels each: in every
;; row and column of an n by n grid one (Hammersley 1960). Their mean is the pixel's middle.
(: coverage-offsets (-> Fixnum Fixnum FxVector))
(define (coverage-offsets count parts)
  (define offsets (make-fxvector (fx* 2 count) 0))
  (define (mirrored [k : Integer]) ; of six bits
    (for/fold ([sum : Integer 0]) ([bit (in-range 6)])
      (if (bitwise-bit-set? k bit) (+ sum (arithmetic-shift 32 (- bit))) sum)))
  (define order
    (for/list : (Listof Integer) ([k (in-range count)]) (mirrored k)))
  (define (place [rank : Integer])
    (assert (quotient (* parts (+ 1 (* 2 rank))) (* 2 count)) fixnum?))
  (for ([key (in-list order)] [k : Nonnegative-Fixnum (in-range 64)])
    (define rank (for/sum : Integer ([other (in-list order)]) (if (< other key) 1 0)))
    (fxvector-set! offsets (fx* 2 k) (place k))
    (fxvector-set! offsets (fx+ 1 (fx* 2 k)) (place rank)))
  offsets)

;; A surface's number: that of its piece, and of its triangle.
(define-syntax-rule (TRIANGLE-BITS) 28)
(define-syntax-rule (surface-number piece triangle)
  (fxior (fxlshift piece (TRIANGLE-BITS)) triangle))
(define-syntax-rule (number->piece id) (fxrshift id (TRIANGLE-BITS)))
(define-syntax-rule (number->triangle id) (fxand id (fx- (fxlshift 1 (TRIANGLE-BITS)) 1)))

(define MOST-SAMPLES-AT-ONCE : Fixnum 4000000)

(: draw! (-> Film World View Symbol Flonum Fixnum Float3 Flonum FxVector
             Fixnum Fixnum Fixnum Fixnum Void))
(define (draw! film world view shading tolerance faces fog-color fog-density offsets
               left top width height)
  (define wires? (eq? shading 'wireframe))
  (define-values (pieces materials drawn)
    (world-pieces (World-shapes world) view tolerance wires?))
  (define corners
    (for/vector : (Vectorof FlVector) ([piece (in-vector drawn)])
      (define mesh (Piece-mesh piece))
      (if mesh (film-corners mesh (Piece-transform piece) view) (flvector))))
  (define shade! (make-shader world pieces materials shading))
  (define samples (fxquotient (fxvector-length offsets) 2))
  (define band-height
    (let ([rows (fxquotient MOST-SAMPLES-AT-ONCE (fx* width samples))]) (if (fx< rows 1) 1 rows)))
  (define resolve! (resolver film world view drawn corners shade! shading fog-color fog-density top))
  (let each-band ([y : Fixnum top])
    (when (fx< y (fx+ top height))
      (let* ([rest (fx- (fx+ top height) y)]
             [rows (if (fx< rest band-height) rest band-height)]
             [canvas (make-Canvas (View-width view) (View-height view) left y width rows offsets
                                  (subpixels (View-width view) (View-height view)))])
        (draw-pieces! canvas view drawn corners faces wires?)
        (resolve! canvas))
      (each-band (fx+ y band-height)))))

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

;; --- what covers the samples ---

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

;; A scratch for kernels, at the view's time.
(: make-scratch (-> View (Values FlVector FxVector)))
(define (make-scratch view)
  (define r (make-flonum-registers))
  (flvector-set! r ray-time (View-time view))
  (values r (make-fixnum-registers)))

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

;; --- what they show ---

;; Weights of a triangle's corners, and a sum of colours, kept while shaders are called.
(define-syntax-rule (WEIGHTS) saved-rays)
(define-syntax-rule (SUM) (fx+ saved-rays 3))
(define-syntax-rule (CORNER-SUM) (fx+ saved-rays 6))
(define-syntax-rule (DISTANCE) (fx+ saved-rays 9))

;; A procedure that writes the pixels of a canvas to the film.
(: resolver (-> Film World View (Vectorof Piece) (Vectorof FlVector) (-> FlVector FxVector Void)
                Symbol Float3 Flonum Fixnum (-> Canvas Void)))
(define (resolver film world view drawn corners shade! shading fog-color fog-density film-top)
  (define-values (r i) (make-scratch view))
  (define camera (View-camera view))
  (define cast-ray! (Camera-kernel camera (View-width view) (View-height view)))
  (define background! (Background-kernel (World-background world)))
  (define plain-ground? (and (memq shading '(wireframe normals depth texture-coordinates)) #t))
  (define flat? (eq? shading 'flat))
  (define gouraud? (eq? shading 'gouraud))
  (define uv? (eq? shading 'texture-coordinates))
  (define foggy? (and (fl> fog-density 0.0) (not plain-ground?)))
  (define perspective? (View-perspective? view))
  (define eye (Camera-eye camera))
  (define forward (Float3-normalized/checked (Camera-forward camera)))
  (define x-scale (fl/ 2.0 (fx->fl (View-width view))))
  (define y-scale (fl/ 2.0 (fx->fl (View-height view))))
  ;; colours of vertices seen from outside, then from inside; NaN where nobody asked yet
  (define vertex-colors
    (for/vector : (Vectorof (U #f FlVector)) ([piece (in-vector drawn)])
      (define mesh (Piece-mesh piece))
      (and gouraud? mesh (Tessellation-normals mesh)
           (make-flvector (fx* 2 (flvector-length (Tessellation-positions mesh))) +nan.0))))

  ;; The surface of a triangle where its corners have the weights in the scratch.
  (: put-triangle-surface! (-> Piece Tessellation Fixnum Void))
  (define (put-triangle-surface! piece mesh triangle)
    (define positions (Tessellation-positions mesh))
    (define triangles (Tessellation-triangles mesh))
    (define normals (Tessellation-normals mesh))
    (define matrix (Transform-matrix (Piece-transform piece)))
    (define inverse (Transform-inverse-matrix (Piece-transform piece)))
    (define p (fx* 3 (fxvector-ref triangles (fx* 3 triangle))))
    (define q (fx* 3 (fxvector-ref triangles (fx+ 1 (fx* 3 triangle)))))
    (define s (fx* 3 (fxvector-ref triangles (fx+ 2 (fx* 3 triangle)))))
    (fxvector-set! i hit-material (Piece-material piece))
    (let-float3 ([weights (Float3-in r (WEIGHTS))]
                 [a (Float3-in positions p)] [b (Float3-in positions q)]
                 [c (Float3-in positions s)]
                 [local (Float3-multiply-add
                         (Float3-multiply-add (Float3-scale-by-scalar a (Float3-x weights))
                                              (Float3-y weights) b)
                         (Float3-z weights) c)]
                 [point (matrix-point matrix 0 local)]
                 [away (Float3-subtract point eye)])
      (let ([distance (if perspective? (Float3-length away) (Float3-dot away forward))])
        (flvector-set! r hit-t distance)
        (Float3-put! r surface-point point)
        (if perspective?
            (Float3-put! r ray-direction (Float3-scale-by-scalar away (fl/ 1.0 distance)))
            (Float3-put! r ray-direction forward))
        (let-float3 ([across (Float3-cross (Float3-subtract b a) (Float3-subtract c a))]
                     [normal (Float3-normalized (matrix-normal inverse 0 across))])
          (Float3-put! r surface-normal normal)
          (if (and normals (not flat?))
              (let-float3 ([blend (Float3-multiply-add
                                   (Float3-multiply-add
                                    (Float3-scale-by-scalar (Float3-in normals p)
                                                            (Float3-x weights))
                                    (Float3-y weights) (Float3-in normals q))
                                   (Float3-z weights) (Float3-in normals s))])
                (Float3-put! r surface-shading-normal
                             (Float3-normalized (matrix-normal inverse 0 blend))))
              (Float3-put! r surface-shading-normal normal)))))
    (when uv?
      (let ([uvs (Tessellation-uvs mesh)])
        (let-float3 ([weights (Float3-in r (WEIGHTS))])
          (define-syntax-rule (put! k otherwise)
            (flvector-set! r (fx+ surface-uv k)
                           (if uvs
                               (fl+ (fl* (Float3-x weights)
                                         (flvector-ref uvs (fx+ k (fxquotient (fx* 2 p) 3))))
                                    (fl+ (fl* (Float3-y weights)
                                              (flvector-ref uvs (fx+ k (fxquotient (fx* 2 q) 3))))
                                         (fl* (Float3-z weights)
                                              (flvector-ref uvs
                                                            (fx+ k (fxquotient (fx* 2 s) 3))))))
                               otherwise)))
          (put! 0 (Float3-y weights))
          (put! 1 (Float3-z weights)))))
    (face-viewer!))

  ;; Turns the normals to the side that is seen.
  (define-syntax-rule (face-viewer!)
    (let-float3 ([n (Float3-in r surface-normal)] [d (Float3-in r ray-direction)])
      (Float3-put! r out-direction (Float3-negate d))
      (cond
        [(fl> (Float3-dot n d) 0.0)
         (fxvector-set! i surface-inside 1)
         (Float3-put! r surface-normal (Float3-negate n))
         (Float3-put! r surface-shading-normal
                      (Float3-negate (Float3-in r surface-shading-normal)))]
        [else (fxvector-set! i surface-inside 0)])))

  ;; Perspective-correct weights of the corners at a place of the film: the ray through it against
  ;; the planes through the eye and two corners each. None is negative.
  (: put-weights! (-> FlVector FxVector Fixnum Void))
  (define (put-weights! points triangles triangle)
    (define p (fx* 4 (fxvector-ref triangles (fx* 3 triangle))))
    (define q (fx* 4 (fxvector-ref triangles (fx+ 1 (fx* 3 triangle)))))
    (define s (fx* 4 (fxvector-ref triangles (fx+ 2 (fx* 3 triangle)))))
    (let-float3 ([d (Float3 (fl- (fl* x-scale (flvector-ref r film-x)) 1.0)
                            (fl- 1.0 (fl* y-scale (flvector-ref r film-y))) 1.0)]
                 [a (Float3-in points p)] [b (Float3-in points q)] [c (Float3-in points s)]
                 [ab (Float3-cross a b)] [bc (Float3-cross b c)] [ca (Float3-cross c a)])
      (let* ([wa (Float3-dot d bc)] [wb (Float3-dot d ca)] [wc (Float3-dot d ab)]
             [sum (fl+ wa (fl+ wb wc))]
             [sign (if (fl< sum 0.0) -1.0 1.0)]
             [pa (flmax 0.0 (fl* sign wa))] [pb (flmax 0.0 (fl* sign wb))]
             [pc (flmax 0.0 (fl* sign wc))]
             [total (fl+ pa (fl+ pb pc))])
        (if (fl> total 0.0)
            (Float3-put! r (WEIGHTS) (Float3 (fl/ pa total) (fl/ pb total) (fl/ pc total)))
            (put-middle!)))))
  (define-syntax-rule (put-middle!)
    (let ([third (fl/ 1.0 3.0)]) (Float3-put! r (WEIGHTS) (Float3 third third third))))

  (: shade-triangle! (-> Piece Tessellation FlVector (U #f FlVector) Fixnum Void))
  (define (shade-triangle! piece mesh points colors triangle)
    (put-weights! points (Tessellation-triangles mesh) triangle)
    (cond
      [gouraud? (shade-corners! piece mesh colors triangle)]
      [else
       (when flat? (put-middle!))
       (put-triangle-surface! piece mesh triangle)
       (flvector-set! r (DISTANCE) (flvector-ref r hit-t))
       (shade! r i)]))

  ;; Gouraud shading: the corners' colours at the weights in the scratch.
  (: shade-corners! (-> Piece Tessellation (U #f FlVector) Fixnum Void))
  (define (shade-corners! piece mesh colors triangle)
    (put-triangle-surface! piece mesh triangle)
    (let ([inside (fxvector-ref i surface-inside)])
      (let-float3 ([weights (Float3-in r (WEIGHTS))])
        (flvector-set! r (DISTANCE) (flvector-ref r hit-t))
        (Float3-put! r (CORNER-SUM) (Float3 0.0 0.0 0.0))
        (define-syntax-rule (add-corner! k weight)
          (let* ([vertex (fxvector-ref (Tessellation-triangles mesh) (fx+ k (fx* 3 triangle)))]
                 [at (fx+ (fx* 6 vertex) (fx* 3 inside))])
            (cond
              [(and colors (fl= (flvector-ref colors at) (flvector-ref colors at)))
               (Float3-put! r radiance (Float3-in colors at))]
              [else
               (Float3-put! r (WEIGHTS) (Float3 (if (fx= k 0) 1.0 0.0) (if (fx= k 1) 1.0 0.0)
                                                (if (fx= k 2) 1.0 0.0)))
               (put-triangle-surface! piece mesh triangle)
               (unless (fx= inside (fxvector-ref i surface-inside))
                 (turn-normals!))
               (shade! r i)
               (when colors (Float3-put! colors at (Float3-in r radiance)))])
            (Float3-put! r (CORNER-SUM)
                         (Float3-multiply-add (Float3-in r (CORNER-SUM)) weight
                                              (Float3-in r radiance)))))
        (add-corner! 0 (Float3-x weights))
        (add-corner! 1 (Float3-y weights))
        (add-corner! 2 (Float3-z weights))
        (Float3-put! r radiance (Float3-in r (CORNER-SUM))))))

  (define-syntax-rule (turn-normals!)
    (begin
      (Float3-put! r surface-normal (Float3-negate (Float3-in r surface-normal)))
      (Float3-put! r surface-shading-normal
                   (Float3-negate (Float3-in r surface-shading-normal)))))

  ;; A shape that rays are cast at, at the place of the film in the scratch.
  (: shade-cast! (-> ShapeKernel Fixnum Void))
  (define (shade-cast! kernel material)
    (cast-ray! r i)
    (flvector-set! r ray-limit +inf.0)
    (cond
      [((ShapeKernel-nearest kernel) r i)
       (fxvector-set! i hit-material material)
       ((ShapeKernel-surface kernel) r i)
       (when uv? ((ShapeKernel-uv kernel) r i))
       (when flat? (Float3-put! r surface-shading-normal (Float3-in r surface-normal)))
       (face-viewer!)
       (flvector-set! r (DISTANCE) (flvector-ref r hit-t))
       (shade! r i)]
      [else (shade-ground!)]))

  (: shade-ground! (-> Void))
  (define (shade-ground!)
    (flvector-set! r (DISTANCE) 0.0)
    (cond
      [plain-ground? (Float3-put! r radiance (Float3 0.0 0.0 0.0))]
      [else
       (cast-ray! r i)
       (background! r i)
       (Float3-put! r radiance (Float3-in r surface-color))]))

  (: shade-surface! (-> Fixnum Void))
  (define (shade-surface! id)
    (cond
      [(fx< id 0) (shade-ground!)]
      [else
       (define k (number->piece id))
       (define piece (vector-ref drawn k))
       (define mesh (Piece-mesh piece))
       (define kernel (Piece-kernel piece))
       (cond
         [mesh (shade-triangle! piece mesh (vector-ref corners k) (vector-ref vertex-colors k)
                                (number->triangle id))]
         [kernel (shade-cast! kernel (Piece-material piece))])]))

  (: exactly-placed? (-> Fixnum Boolean))
  (define (exactly-placed? id)
    (and (fx>= id 0) (not (Piece-mesh (vector-ref drawn (number->piece id))))))

  (define-syntax-rule (add-fog!)
    (let ([clear (flexp (fl* (fl* -1.0 fog-density) (flvector-ref r (DISTANCE))))])
      (let-float3 ([color fog-color])
        (Float3-put! r radiance
                     (Float3-linear-interpolate color (Float3-in r radiance) clear)))))

  (lambda ([canvas : Canvas])
    (define samples (Canvas-samples canvas))
    (define ids (Canvas-ids canvas))
    (define offsets (Canvas-offsets canvas))
    (define width (Canvas-width canvas))
    (define pixels (Film-pixels film))
    (define part (fl/ 1.0 (fx->fl (Canvas-subpixels canvas))))
    (define (shade-pixel! [x : Fixnum] [y : Fixnum]) : Void
      (define start (fx* samples (fx+ x (fx* y width))))
      (Float3-put! r (SUM) (Float3 0.0 0.0 0.0))
      (let each ([sample : Fixnum 0])
        (when (fx< sample samples)
          (define id (fxvector-ref ids (fx+ start sample)))
          (unless (seen-before? ids id start sample)
            ;; all samples of the pixel that the same surface covers, and their middle
            (let count ([k : Fixnum sample] [n : Fixnum 0] [sx : Fixnum 0] [sy : Fixnum 0])
              (cond
                [(fx< k samples)
                 (if (fx= id (fxvector-ref ids (fx+ start k)))
                     (count (fx+ k 1) (fx+ n 1) (fx+ sx (fxvector-ref offsets (fx* 2 k)))
                            (fx+ sy (fxvector-ref offsets (fx+ 1 (fx* 2 k)))))
                     (count (fx+ k 1) n sx sy))]
                [else
                 (cond
                   [(exactly-placed? id) (put-sample-place! r canvas x y sample)]
                   [else
                    (flvector-set! r film-x (fl+ (fx->fl (fx+ x (Canvas-left canvas)))
                                                 (fl/ (fl* part (fx->fl sx)) (fx->fl n))))
                    (flvector-set! r film-y (fl+ (fx->fl (fx+ y (Canvas-top canvas)))
                                                 (fl/ (fl* part (fx->fl sy)) (fx->fl n))))])
                 (shade-surface! id)
                 (when foggy? (add-fog!))
                 (Float3-put! r (SUM)
                              (Float3-multiply-add (Float3-in r (SUM))
                                                   (fl/ (fx->fl n) (fx->fl samples))
                                                   (Float3-in r radiance)))])))
          (each (fx+ sample 1))))
      (Float3-put! pixels
                   (fx* 3 (fx+ (fx+ x (Film-left film))
                               (fx* (fx+ y (fx- (Canvas-top canvas) film-top)) (Film-width film))))
                   (Float3-in r (SUM))))
    (let rows ([y : Fixnum 0])
      (when (fx< y (Canvas-height canvas))
        (let columns ([x : Fixnum 0])
          (when (fx< x width)
            (shade-pixel! x y)
            (columns (fx+ x 1))))
        (rows (fx+ y 1))))))

(define-syntax-rule (seen-before? ids id start sample)
  (let check : Boolean ([k : Fixnum 0])
    (and (fx< k sample)
         (or (fx= id (fxvector-ref ids (fx+ start k))) (check (fx+ k 1))))))
