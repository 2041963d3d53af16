#lang typed/racket/base
;; What a canvas shows: every surface that covers samples of a pixel is shaded once, at the middle of
;; those samples.
(require racket/vector "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/matrix.rkt"
         "../base/transform.rkt" "../shape/kernel.rkt" "../world/camera.rkt"
         "../world/camera-kernel.rkt" "../world/background.rkt" "../world/world.rkt"
         "../material/material.rkt"
         "scan.rkt" "tessellate.rkt" "cover.rkt" "shade.rkt")

(provide (struct-out Film) resolver)

;; pixels: of a picture that wide; left: the column where a part of it begins.
(struct Film ([pixels : FlVector] [width : Fixnum] [left : Fixnum]))

;; Weights of a triangle's corners, and sums of colours, kept while kernels are called: at the far end
;; of the stack.
(define-syntax-rule (WEIGHTS) (fx+ flonum-stack 1000))
(define-syntax-rule (SUM) (fx+ flonum-stack 1003))
(define-syntax-rule (CORNER-SUM) (fx+ flonum-stack 1006))
(define-syntax-rule (DISTANCE) (fx+ flonum-stack 1009))
(define-syntax-rule (FRONT) (fx+ flonum-stack 1010))
(define-syntax-rule (CLEAR) (fx+ flonum-stack 1013))
(define-syntax-rule (FRONT-DISTANCE) (fx+ flonum-stack 1014))

;; A procedure that writes the pixels of a canvas to the film. Where surfaces are seen through, the
;; other canvas has what is behind them; without one that is the background.
(: resolver (-> Film World View (Vectorof Piece) (Vectorof FlVector) (-> FlVector FxVector Void)
                (Vectorof Material) Symbol Float3 Flonum Fixnum
                (-> Canvas (U #f Canvas) Void)))
(define (resolver film world view drawn corners shade! materials shading fog-color fog-density film-top)
  (define-values (r i) (make-scratch view))
  (define camera (View-camera view))
  (define cast-ray! (Camera-kernel camera (View-width view) (View-height view)))
  (define background (World-background world))
  (define background! (Background-kernel background))
  (define plain-ground? (and (memq shading '(wireframe hidden-lines normals depth texture-coordinates)) #t))
  (define flat? (eq? shading 'flat))
  (define gouraud? (eq? shading 'gouraud))
  (define toon? (eq? shading 'toon))
  ;; by material, whether texture coordinates are asked for
  (define uv-needs
    (for/vector : (Vectorof Boolean) ([material (in-vector materials)])
      (define-values (texture place) (Material-texture material))
      (or (and texture #t) (eq? shading 'texture-coordinates))))
  (define clear? (vector-map Material-clear? materials))
  (define-syntax-rule (uv-needed?) (vector-ref uv-needs (fxvector-ref i hit-material)))
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
    (when (uv-needed?)
      (let ([frame (Piece-frame piece)])
        (let-float3 ([weights (Float3-in r (WEIGHTS))]
                     [local (Float3-multiply-add
                             (Float3-multiply-add
                              (Float3-scale-by-scalar (Float3-in positions p) (Float3-x weights))
                              (Float3-y weights) (Float3-in positions q))
                             (Float3-z weights) (Float3-in positions s))])
          (if frame
              (Float3-put! r texture-point (matrix-point (Transform-matrix frame) 0 local))
              (Float3-put! r texture-point local))))
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
      [(and gouraud? (not (vector-ref clear? (Piece-material piece)))) (shade-corners! piece mesh colors triangle)]
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
       (when (uv-needed?)
         (Float3-put! r texture-point (Float3-in r surface-point))
         ((ShapeKernel-uv kernel) r i))
       (when flat? (Float3-put! r surface-shading-normal (Float3-in r surface-normal)))
       (face-viewer!)
       (flvector-set! r (DISTANCE) (flvector-ref r hit-t))
       (shade! r i)]
      [else (shade-ground!)]))

  (: shade-ground! (-> Void))
  (define (shade-ground!)
    (flvector-set! r (DISTANCE) 0.0)
    (flvector-set! r light-density 0.0)
    (cond
      [plain-ground? (Float3-put! r radiance (Float3 0.0 0.0 0.0))]
      [(Float3? background) (Float3-put! r radiance background)]
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

  (lambda ([canvas : Canvas] [behind : (U #f Canvas)])
    (define samples (Canvas-samples canvas))
    (define ids (Canvas-ids canvas))
    (define behind-ids (if behind (Canvas-ids behind) ids))
    (define-syntax-rule (same-surface? a b)
      (and (fx= (fxvector-ref ids a) (fxvector-ref ids b))
           (fx= (fxvector-ref behind-ids a) (fxvector-ref behind-ids b))))
    ;; what is seen through the surface just shaded, as far as it is
    (define (add-behind! [id : Fixnum]) : Void
      (let ([part (flvector-ref r light-density)])
        (when (fl> part 0.0)
          (flvector-set! r (CLEAR) part)
          (Float3-put! r (FRONT) (Float3-in r radiance))
          (flvector-set! r (FRONT-DISTANCE) (flvector-ref r (DISTANCE)))
          (shade-surface! id)
          (Float3-put! r radiance
                       (Float3-multiply-add (Float3-in r (FRONT)) (flvector-ref r (CLEAR))
                                            (Float3-in r radiance)))
          (flvector-set! r (DISTANCE) (flvector-ref r (FRONT-DISTANCE))))))
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
          (unless (and (fx> sample 0) (seen-before? same-surface? start sample))
            ;; all samples of the pixel that the same surface covers, and their middle
            (let count ([k : Fixnum sample] [n : Fixnum 0] [sx : Fixnum 0] [sy : Fixnum 0])
              (cond
                [(fx< k samples)
                 (if (same-surface? (fx+ start sample) (fx+ start k))
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
                 (when behind (add-behind! (fxvector-ref behind-ids (fx+ start sample))))
                 (when (and toon? (outline? canvas (fx+ start sample) x y))
                   (Float3-put! r radiance (Float3 0.0 0.0 0.0)))
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

;; Whether a sample is on an outline: next to one of another piece that is farther away, or where the
;; keys along a row or a column bend by a thirtieth, which those of a plane never do.
(: outline? (-> Canvas Fixnum Fixnum Fixnum Boolean))
(define (outline? canvas at x y)
  (define keys (Canvas-keys canvas))
  (define ids (Canvas-ids canvas))
  (define samples (Canvas-samples canvas))
  (define width (Canvas-width canvas))
  (: beside? (-> Fixnum Boolean))
  (define (beside? step)
    (and (fx>= (fxvector-ref ids at) 0)
         (let ([before (fx- at step)] [after (fx+ at step)])
           (or (in-front-of? before)
               (in-front-of? after)
               (let ([key (flvector-ref keys at)])
                 (fl> (flabs (fl- (fl+ (flvector-ref keys before) (flvector-ref keys after))
                                  (fl+ key key)))
                      (fl* 0.033 (flabs key))))))))
  (: in-front-of? (-> Fixnum Boolean))
  (define (in-front-of? other)
    (define id (fxvector-ref ids other))
    (and (not (fx= (number->piece (fxvector-ref ids at)) (if (fx< id 0) -1 (number->piece id))))
         (fl> (flvector-ref keys at) (flvector-ref keys other))))
  (or (and (fx> x 0) (fx< x (fx- width 1)) (beside? samples))
      (and (fx> y 0) (fx< y (fx- (Canvas-height canvas) 1)) (beside? (fx* samples width)))))

(define-syntax-rule (seen-before? same? start sample)
  (let check : Boolean ([k : Fixnum 0])
    (and (fx< k sample)
         (or (same? (fx+ start sample) (fx+ start k)) (check (fx+ k 1))))))
