#lang typed/racket/base
;; A world as pieces that can be drawn: triangles by the shapes' own parameters, as fine as the picture
;; needs; and, where triangles would be no cheaper or there are none, kernels that rays are cast at.
(require "../base/unsafe.rkt" "../base/float3.rkt" "../base/matrix.rkt" "../base/transform.rkt"
         "../material/material.rkt" "../world/camera.rkt"
         "../shape/shape.rkt" "../shape/kernel.rkt" "../shape/kernels.rkt" "../shape/sphere.rkt"
         "../shape/plane.rkt" "../shape/disk.rkt" "../shape/quad.rkt" "../shape/triangle.rkt"
         "../shape/box.rkt" "../shape/cylinder.rkt" "../shape/cone.rkt" "../shape/torus.rkt"
         "../shape/mesh.rkt" "../shape/composite.rkt" "../shape/instance.rkt"
         "../shape/moving.rkt" "../shape/group.rkt" "../shape/solid.rkt"
         "view.rkt")

(provide (struct-out View) make-View View-place (struct-out Tessellation) (struct-out Piece)
         world-pieces)

;; A camera at rest, fitted to a film of width by height pixels; linear?: whether straight lines are
;; seen straight; coordinates: see Camera-coordinates; perspective?: whether rays meet in the eye.
(struct View ([camera : Camera] [width : Fixnum] [height : Fixnum] [coordinates : Transform]
              [linear? : Boolean] [perspective? : Boolean] [time : Flonum]))

(: make-View (-> Camera Fixnum Fixnum View))
(define (make-View given width height)
  (define camera (Camera-fitted (Camera-opened given) (/ width height)))
  (define kind (Camera-projection camera))
  (View camera width height (Camera-coordinates camera)
        (and (memq kind '(perspective orthographic)) #t) (eq? kind 'perspective)
        (Camera-shutter-open camera)))

;; normals and uvs of vertices, or #f: then the triangles are flat, and texture coordinates are the
;; weights of the second and third corner.
(struct Tessellation
  ([positions : FlVector] [triangles : FxVector] [normals : (U #f FlVector)]
   [uvs : (U #f FlVector)]))

;; mesh: triangles in a space of their own, which transform takes to the world; #f for what is cast
;; by its kernel, in the world's space. plane: where the kernel is an infinite plane's, a point
;; of it and its normal. material: its number. frame: where the mesh is made in another space than
;; the shape, the way there.
(struct Piece ([mesh : (U #f Tessellation)] [transform : Transform] [frame : (U #f Transform)]
               [kernel : (U #f ShapeKernel)]
               [plane : (U #f (Pairof Float3 Float3))] [material : Fixnum]))

;; world-pieces : the pieces of shapes as a view needs them, and the materials by number. tolerance:
;; how far in pixels a triangle may be seen from the surface it stands for. wires?: whether all that
;; can be is wanted as triangles, none of them too fine for lines; what cannot is its box.
;; Where the view bends straight lines the pieces are there for what they shine, and `drawn` is one
;; piece that rays are cast at; else drawn is the same as the pieces.
(: world-pieces (-> (Listof Shape) View Flonum Boolean
                    (Values (Vectorof Piece) (Vectorof Material) (Vectorof Piece))))
(define (world-pieces shapes view tolerance wires?)
  (define numbers : (HashTable Material Fixnum) (make-hasheq))
  (define materials : (Listof Material) '())
  (: number NumberMaterial)
  (define (number material)
    (or (hash-ref numbers material (lambda () #f))
        (let ([new (hash-count numbers)])
          (hash-set! numbers material new)
          (set! materials (cons material materials))
          new)))
  (define compile (Shape-compiler number))
  (define known : (HashTable Any Tessellation) (make-hash))
  (define found : (Listof Piece) '())

  (: add-mesh! (->* (Tessellation Transform Material) ((U #f Transform)) Void))
  (define (add-mesh! mesh transform material [frame #f])
    (define whole
      (cond
        [(not frame) transform]
        [(eq? transform identity) frame]
        [else (Transform-compose transform frame)]))
    (set! found (cons (Piece mesh whole frame #f #f (number material)) found)))

  (: add-cast! (-> Shape Transform (U #f Material) (U #f (Pairof Float3 Float3)) Void))
  (define (add-cast! shape transform material plane)
    (define kernel
      (compile (if (or material (not (eq? transform identity)))
                   (make-Instance shape transform #:material material)
                   shape)))
    (define box (ShapeKernel-bounds kernel))
    (cond
      [(not wires?)
       (set! found
             (cons (Piece #f identity #f kernel plane (number (or material (Shape-material shape))))
                   found))]
      [(finite? box)
       (add-mesh! (hash-ref! known 'box unit-box)
                  (box-transform (Float3-in box 0) (Float3-in box 3))
                  (or material (Shape-material shape)))]))

  ;; A curved shape in triangles, or cast where that would be too many: `make` from the number of
  ;; segments of full turns around two radii, `frame` places what it makes.
  (: add-curved! (-> Shape FlVector Transform (U #f Material) Transform
                     Flonum Flonum (-> Fixnum Fixnum Fixnum) Any
                     (-> Fixnum Fixnum Tessellation) Void))
  (define (add-curved! shape box transform material frame radius second-radius count key make)
    (define allowed (view-tolerance view box transform tolerance))
    (define n (segments radius allowed))
    (define m (segments second-radius allowed))
    (define most
      (if wires? MOST-WIRES (flmax 4096.0 (View-pixels view box transform))))
    (define-values (columns rows)
      (if wires? (values (fxmin2 n 48) (fxmin2 m 48)) (values n m)))
    (cond
      [(and (fx< columns MOST-SEGMENTS) (fx< rows MOST-SEGMENTS)
            (fl<= (fx->fl (count columns rows)) most))
       (add-mesh! (hash-ref! known (list key columns rows) (lambda () (make columns rows)))
                  transform (or material (Shape-material shape)) frame)]
      [else (add-cast! shape transform material #f)]))

  (: add! (-> Shape Transform (U #f Material) Void))
  (define (add! shape transform material)
    (define-syntax-rule (inner transform-within) (Transform-compose transform transform-within))
    (cond
      [(Group? shape) (for ([part (in-list (Group-shapes shape))]) (add! part transform material))]
      [(Instance? shape)
       (add! (Instance-shape shape) (inner (Instance-transform shape))
             (or material (Instance-material shape)))]
      [(Moving? shape)
       (add! (Moving-shape shape) (inner (transform-at shape (View-time view))) material)]
      [(Mesh? shape)
       (add-mesh! (Tessellation (Mesh-positions shape) (Mesh-triangles shape) (Mesh-normals shape)
                                (Mesh-uvs shape))
                  transform (or material (Mesh-material shape)))]
      [(Triangle? shape)
       (add-mesh! (Tessellation (packed (list (Triangle-a shape) (Triangle-b shape)
                                              (Triangle-c shape)))
                                (fxvector 0 1 2) #f #f)
                  transform (or material (Triangle-material shape)))]
      [(Quad? shape)
       (define corner (Quad-corner shape))
       (define-values (u v) (values (Float3-add corner (Quad-edge-u shape))
                                    (Float3-add corner (Quad-edge-v shape))))
       (add-mesh! (Tessellation (packed (list corner u (Float3-add u (Quad-edge-v shape)) v))
                                (fxvector 0 1 2 0 2 3) #f
                                (flvector 0.0 0.0 1.0 0.0 1.0 1.0 0.0 1.0))
                  transform (or material (Quad-material shape)))]
      [(Box? shape)
       (add-mesh! (hash-ref! known 'box unit-box)
                  transform (or material (Box-material shape))
                  (box-transform (Box-low shape) (Box-high shape)))]
      [(Sphere? shape)
       (define radius (Sphere-radius shape))
       (define center (Sphere-point shape))
       (add-curved! shape (Sphere-bounds shape) transform material
                    (make-Transform radius 0 0 (Float3-x center) 0 radius 0 (Float3-y center)
                                    0 0 radius (Float3-z center))
                    radius radius (lambda (n m) (fx* n m)) 'sphere
                    (lambda (n m) (unit-sphere n (fxquotient (fx+ m 1) 2))))]
      [(Disk? shape)
       (define radius (Disk-radius shape))
       (add-curved! shape (Disk-bounds shape) transform material
                    (frame-transform (Disk-point shape) (Disk-normal shape) radius 1.0)
                    radius 0.0 (lambda (n m) n) 'disk (lambda (n m) (joined (list (cap n 0.0 #t)))))]
      [(Cylinder? shape)
       (define base (Cylinder-base shape))
       (define axis (Float3-subtract (Cylinder-top shape) base))
       (define caps? (Cylinder-caps? shape))
       (add-curved! shape (Cylinder-bounds shape) transform material
                    (frame-transform base axis (Cylinder-radius shape) (Float3-length axis))
                    (Cylinder-radius shape) 0.0 (lambda (n m) (fx* 4 n))
                    (if caps? 'cylinder 'tube)
                    (lambda (n m)
                      (joined (cons (tube n) (if caps? (list (cap n 0.0 #f) (cap n 1.0 #t)) '())))))]
      [(Cone? shape)
       (define apex (Cone-apex shape))
       (define axis (Float3-subtract (Cone-base shape) apex))
       (define caps? (Cone-caps? shape))
       (add-curved! shape (Cone-bounds shape) transform material
                    (frame-transform apex axis (Cone-radius shape) (Float3-length axis))
                    (Cone-radius shape) 0.0 (lambda (n m) (fx* (fx* 4 n) (CONE-ROWS)))
                    (if caps? 'cone 'open-cone)
                    (lambda (n m)
                      (define columns (if (fx< n 24) 48 (fx* 2 n)))
                      (joined (cons (cone-side columns)
                                    (if caps? (list (cone-cap columns)) '())))))]
      [(Torus? shape)
       (define-values (major minor) (values (Torus-major-radius shape) (Torus-minor-radius shape)))
       (add-curved! shape (Torus-bounds shape) transform material
                    (frame-transform (Torus-center shape) (Torus-axis shape) 1.0 1.0)
                    (fl+ major minor) minor (lambda (n m) (fx* 2 (fx* n m)))
                    (list 'torus major minor)
                    (lambda (n m) (ring n m major minor)))]
      [(Plane? shape)
       (unless wires?
         (add-cast! shape transform material
                    (cons (Transform-point transform (Plane-point shape))
                          (Transform-normal transform (Plane-normal shape)))))]
      [else (add-cast! shape transform material #f)]))

  (for ([shape (in-list shapes)]) (add! shape identity #f))
  (define pieces (list->vector (reverse found)))
  (define drawn
    (if (or (View-linear? view) (null? shapes))
        pieces
        (vector (Piece #f identity #f (compile (make-Group shapes)) #f
                       (number (Shape-material (car shapes)))))))
  (values pieces (list->vector (reverse materials)) drawn))

(define identity : Transform (Transform-identity))
(define MOST-SEGMENTS : Fixnum 100000)
(define MOST-WIRES : Flonum 10000.0)
(define-syntax-rule (fxmin2 a b) (if (fx< a b) a b))

(: finite? (-> FlVector Boolean))
(define (finite? box)
  (for/and : Boolean ([k : Nonnegative-Fixnum (in-range 6)])
    (fl< (flabs (flvector-ref box k)) +inf.0)))

;; Where a moving shape is at a time: entry by entry between its two places.
(: transform-at (-> Moving Flonum Transform))
(define (transform-at moving time)
  (define from (Transform-matrix (Moving-from moving)))
  (define to (Transform-matrix (Moving-to moving)))
  (define (entry [k : Fixnum])
    (fl+ (fl* (fl- 1.0 time) (flvector-ref from k)) (fl* time (flvector-ref to k))))
  (make-Transform (entry 0) (entry 1) (entry 2) (entry 3) (entry 4) (entry 5) (entry 6) (entry 7)
                  (entry 8) (entry 9) (entry 10) (entry 11)))

;; --- how fine ---

;; Segments of a full turn so that no chord is farther from the arc than half of what is allowed; the
;; other half is for the turn across.
(: segments (-> Flonum Flonum Fixnum))
(define (segments radius allowed)
  (cond
    [(fl= radius 0.0) 1]
    [(fl<= allowed 0.0) MOST-SEGMENTS]
    [else
     (define cosine (fl- 1.0 (fl/ (fl* 0.5 allowed) radius)))
     (cond
       [(fl<= cosine 0.7) 8]
       [(fl>= cosine 0.9999999999) MOST-SEGMENTS]
       [else
        ;; even, and few different ones, so that spheres of much the same size share triangles
        (define exact (fl/ (PI) (flacos cosine)))
        (define step (if (fl< exact 32.0) 2.0 (if (fl< exact 128.0) 8.0 32.0)))
        (fl->fx (fl* step (flceiling* (fl/ exact step))))])]))

(define-syntax-rule (PI) 3.141592653589793)
(define-syntax-rule (flceiling* x) (fl* -1.0 (flfloor (fl* -1.0 x))))

;; How far a triangle may be from its surface anywhere in a box, in the box's own space; 0 where the
;; box reaches the eye. A distance across the line of sight is seen smaller by what it is away along
;; the line of sight, and larger aside by at most the secant of the widest angle.
(: view-tolerance (-> View FlVector Transform Flonum Flonum))
(define (view-tolerance view box transform tolerance)
  (define camera (View-camera view))
  (define right (Float3-length (Camera-right camera)))
  (define up (Float3-length (Camera-up camera)))
  (define forward (Float3-length (Camera-forward camera)))
  (define pixel (fl/ (fl* 2.0 up) (fx->fl (View-height view))))
  (define growth (matrix-growth (Transform-matrix transform)))
  (cond
    [(or (View-perspective? view) (not (View-linear? view)))
     (define cosine
       (fl/ forward (flsqrt (fl+ (fl* forward forward) (fl+ (fl* right right) (fl* up up))))))
     (define world-box (transform-box (Transform-matrix transform) box))
     (define seen (transform-box (Transform-matrix (View-coordinates view)) world-box))
     (define nearest
       (flmax (flvector-ref seen 2)
              (fl/ (fl* cosine (distance-to-box (Camera-eye camera) world-box)) forward)))
     (fl/ (fl* (fl* tolerance cosine) (fl* pixel nearest)) growth)]
    [else (fl/ (fl* tolerance pixel) growth)]))

(: distance-to-box (-> Float3 FlVector Flonum))
(define (distance-to-box point box)
  (define (gap [value : Flonum] [axis : Fixnum])
    (flmax 0.0 (flmax (fl- (flvector-ref box axis) value)
                      (fl- value (flvector-ref box (fx+ axis 3))))))
  (let ([x (gap (Float3-x point) 0)] [y (gap (Float3-y point) 1)] [z (gap (Float3-z point) 2)])
    (flsqrt (fl+ (fl+ (fl* x x) (fl* y y)) (fl* z z)))))

;; View-place : the part of the film, in pixels, in which a box of the world is seen: left, top, right
;; and bottom; the whole film where part of the box is not in front of the eye.
(: View-place (-> View FlVector (List Flonum Flonum Flonum Flonum)))
(define (View-place view box)
  (define width (fx->fl (View-width view)))
  (define height (fx->fl (View-height view)))
  (define matrix (Transform-matrix (View-coordinates view)))
  (define whole (list 0.0 0.0 width height))
  (if (and (View-linear? view) (finite? box))
      (let each : (List Flonum Flonum Flonum Flonum)
        ([corner : Fixnum 0] [left : Flonum +inf.0] [top : Flonum +inf.0]
                             [right : Flonum -inf.0] [bottom : Flonum -inf.0])
        (cond
          [(fx= corner 8)
           (list (flmax 0.0 left) (flmax 0.0 top) (flmin width right) (flmin height bottom))]
          [else
           (let-float3 ([seen (matrix-point
                               matrix 0
                               (Float3 (flvector-ref box (if (fx= 0 (fxand corner 1)) 0 3))
                                       (flvector-ref box (if (fx= 0 (fxand corner 2)) 1 4))
                                       (flvector-ref box (if (fx= 0 (fxand corner 4)) 2 5))))])
             (let ([w (if (View-perspective? view) (Float3-z seen) 1.0)])
               (if (fl<= w 0.0)
                   whole
                   (let ([x (fl* (fl* 0.5 width) (fl+ 1.0 (fl/ (Float3-x seen) w)))]
                         [y (fl* (fl* 0.5 height) (fl- 1.0 (fl/ (Float3-y seen) w)))])
                     (each (fx+ corner 1) (flmin left x) (flmin top y)
                           (flmax right x) (flmax bottom y))))))]))
      whole))

(: View-pixels (-> View FlVector Transform Flonum))
(define (View-pixels view box transform)
  (define place (View-place view (transform-box (Transform-matrix transform) box)))
  (fl* (flmax 0.0 (fl- (caddr place) (car place))) (flmax 0.0 (fl- (cadddr place) (cadr place)))))

;; --- triangles by parameters ---

(define-type Vertex (-> Flonum Flonum FlVector Fixnum FlVector Void))

;; A rectangle of parameters u and v from 0 to 1 in columns and rows, two triangles a cell; vertex!
;; writes the point and the normal there. Triangles turn counter-clockwise where v grows to the left
;; of u, or the other way. pole-low?, pole-high?: whether the first or the last row is one point.
(: grid (-> Fixnum Fixnum Boolean Boolean Boolean Vertex Tessellation))
(define (grid columns rows turned? pole-low? pole-high? vertex!)
  (define count (fx* (fx+ columns 1) (fx+ rows 1)))
  (define positions (make-flvector (fx* 3 count)))
  (define normals (make-flvector (fx* 3 count)))
  (define uvs (make-flvector (fx* 2 count)))
  (for-range (row (fx+ rows 1))
    (define v (fl/ (fx->fl row) (fx->fl rows)))
    (define pole? (or (and pole-low? (fx= row 0)) (and pole-high? (fx= row rows))))
    (for-range (column (fx+ columns 1))
      (define k (fx+ column (fx* row (fx+ columns 1))))
      ;; a pole's vertex belongs to the triangle of one column
      (define u (fl/ (fl+ (fx->fl column) (if pole? 0.5 0.0)) (fx->fl columns)))
      (vertex! u v positions (fx* 3 k) normals)
      (flvector-set! uvs (fx* 2 k) u)
      (flvector-set! uvs (fx+ 1 (fx* 2 k)) v)))
  (define triangles
    (make-fxvector (fx* 3 (fx- (fx* 2 (fx* columns rows))
                               (fx+ (if pole-low? columns 0) (if pole-high? columns 0))))
                   0))
  (define next : Fixnum 0)
  (: put! (-> Fixnum Fixnum Fixnum Void))
  (define (put! a b c)
    (fxvector-set! triangles next a)
    (fxvector-set! triangles (fx+ next 1) (if turned? c b))
    (fxvector-set! triangles (fx+ next 2) (if turned? b c))
    (set! next (fx+ next 3)))
  (for-range (row rows)
    (for-range (column columns)
      (define a (fx+ column (fx* row (fx+ columns 1))))
      (define d (fx+ a (fx+ columns 1)))
      (define last? (and pole-high? (fx= row (fx- rows 1))))
      (unless (and pole-low? (fx= row 0)) (put! a (fx+ a 1) (if last? d (fx+ d 1))))
      (unless last? (put! a (fx+ d 1) d))))
  (Tessellation positions triangles normals uvs))

(define-syntax-rule (for-range (k count) body ...)
  (let ([end : Fixnum count])
    (let each ([k : Fixnum 0])
      (when (fx< k end)
        (let () body ... (void))
        (each (fx+ k 1))))))

(define-syntax-rule (put3! v at x y z)
  (begin (flvector-set! v at x) (flvector-set! v (fx+ at 1) y) (flvector-set! v (fx+ at 2) z)))
;; From texture coordinate u to the angle, as the shapes count it.
(define-syntax-rule (angle-of u) (fl* (fl* 2.0 (PI)) (fl- u 0.5)))

(: unit-sphere (-> Fixnum Fixnum Tessellation))
(define (unit-sphere columns rows)
  (grid columns (if (fx< rows 2) 2 rows) #f #t #t
        (lambda ([u : Flonum] [v : Flonum] [positions : FlVector] [at : Fixnum] [normals : FlVector])
          (let* ([angle (angle-of u)]
                 [ring (flsin (fl* (PI) v))]
                 [x (fl* ring (flcos angle))]
                 [y (fl* -1.0 (flcos (fl* (PI) v)))]
                 [z (fl* -1.0 (fl* ring (flsin angle)))])
            (put3! positions at x y z)
            (put3! normals at x y z)))))

(: tube (-> Fixnum Tessellation))
(define (tube columns)
  (grid columns 1 #f #f #f
        (lambda ([u : Flonum] [v : Flonum] [positions : FlVector] [at : Fixnum] [normals : FlVector])
          (let* ([angle (angle-of u)] [x (flcos angle)] [y (flsin angle)])
            (put3! positions at x y v)
            (put3! normals at x y 0.0)))))

;; The unit disk at height z, seen from above or from below.
(: cap (-> Fixnum Flonum Boolean Tessellation))
(define (cap columns z up?)
  (grid columns 1 up? #t #f
        (lambda ([u : Flonum] [v : Flonum] [positions : FlVector] [at : Fixnum] [normals : FlVector])
          (let* ([angle (angle-of u)])
            (put3! positions at (fl* v (flcos angle)) (fl* v (flsin angle)) z)
            (put3! normals at 0.0 0.0 (if up? 1.0 -1.0))))))

;; From the apex at the origin to a base of radius 1 at z = 1. Normals are constant along lines from
;; the apex, which no three normals of a triangle at the apex can say: so rows shrink towards it.
(define-syntax-rule (CONE-ROWS) 14)
(: cone-side (-> Fixnum Tessellation))
(define (cone-side columns)
  (define side
    (grid columns (CONE-ROWS) #f #f #t
          (lambda ([u : Flonum] [v : Flonum] [positions : FlVector] [at : Fixnum]
                                [normals : FlVector])
            (let* ([angle (angle-of u)]
                   [z (if (fl< v 1.0) (flexpt 0.7071 (fl* v (fx->fl (CONE-ROWS)))) 0.0)]
                   [x (flcos angle)]
                   [y (fl* -1.0 (flsin angle))])
              (put3! positions at (fl* z x) (fl* z y) z)
              (put3! normals at x y -1.0)))))
  (define uvs (Tessellation-uvs side))
  (when uvs
    (for-range (k (fxquotient (flvector-length uvs) 2))
      (flvector-set! uvs (fx+ 1 (fx* 2 k))
                     (fl- 1.0 (flvector-ref (Tessellation-positions side) (fx+ 2 (fx* 3 k)))))))
  side)

(: cone-cap (-> Fixnum Tessellation))
(define (cone-cap columns)
  (grid columns 1 #f #t #f
        (lambda ([u : Flonum] [v : Flonum] [positions : FlVector] [at : Fixnum] [normals : FlVector])
          (let* ([angle (angle-of u)])
            (put3! positions at (fl* v (flcos angle)) (fl* -1.0 (fl* v (flsin angle))) 1.0)
            (put3! normals at 0.0 0.0 1.0)))))

(: ring (-> Fixnum Fixnum Flonum Flonum Tessellation))
(define (ring columns rows major minor)
  (grid columns rows #f #f #f
        (lambda ([u : Flonum] [v : Flonum] [positions : FlVector] [at : Fixnum] [normals : FlVector])
          (let* ([angle (angle-of u)] [across (angle-of v)]
                 [out (flcos across)] [up (flsin across)]
                 [distance (fl+ major (fl* minor out))])
            (put3! positions at (fl* distance (flcos angle)) (fl* distance (flsin angle))
                   (fl* minor up))
            (put3! normals at (fl* out (flcos angle)) (fl* out (flsin angle)) up)))))

;; The box from 0 to 1, its faces in the order and with the texture coordinates of Box.
(: unit-box (-> Tessellation))
(define (unit-box)
  (define-syntax-rule (face (u v) x y z)
    (grid 1 1 #f #f #f
          (lambda ([u : Flonum] [v : Flonum] [positions : FlVector] [at : Fixnum]
                                [normals : FlVector])
            (put3! positions at x y z))))
  (define faces
    (joined (list (face (u v) 0.0 v u) (face (u v) 1.0 v (fl- 1.0 u))
                  (face (u v) u 0.0 v) (face (u v) u 1.0 (fl- 1.0 v))
                  (face (u v) (fl- 1.0 u) v 0.0) (face (u v) u v 1.0))))
  (Tessellation (Tessellation-positions faces) (Tessellation-triangles faces) #f
                (Tessellation-uvs faces)))

;; Several as one.
(: joined (-> (Listof Tessellation) Tessellation))
(define (joined parts)
  (: together (-> (-> Tessellation FlVector) FlVector))
  (define (together field)
    (apply flvector (apply append (for/list : (Listof (Listof Flonum)) ([part (in-list parts)])
                                    (for/list : (Listof Flonum)
                                              ([x (in-flvector* (field part))]) x)))))
  (define-values (triangles vertices)
    (for/fold ([triangles : (Listof Fixnum) '()] [before : Fixnum 0]) ([part (in-list parts)])
      (define own (Tessellation-triangles part))
      (values (append triangles
                      (for/list : (Listof Fixnum) ([k : Nonnegative-Fixnum
                                                      (in-range (fxvector-length own))])
                        (fx+ before (fxvector-ref own k))))
              (fx+ before (fxquotient (flvector-length (Tessellation-positions part)) 3)))))
  (Tessellation (together Tessellation-positions) (apply fxvector triangles)
                (together (lambda ([part : Tessellation]) (or (Tessellation-normals part) (flvector))))
                (together (lambda ([part : Tessellation]) (or (Tessellation-uvs part) (flvector))))))

(define-syntax-rule (in-flvector* v)
  (in-list (let ([vector v])
             (for/list : (Listof Flonum) ([k : Nonnegative-Fixnum
                                             (in-range (flvector-length vector))])
               (flvector-ref vector k)))))

(: packed (-> (Listof Float3) FlVector))
(define (packed points)
  (apply flvector
         (apply append (for/list : (Listof (Listof Flonum)) ([p (in-list points)])
                         (list (Float3-x p) (Float3-y p) (Float3-z p))))))

;; --- where unit shapes go ---

(: box-transform (-> Float3 Float3 Transform))
(define (box-transform low high)
  (let-float3 ([size (Float3-subtract high low)])
    (make-Transform (positive (Float3-x size)) 0 0 (Float3-x low)
                    0 (positive (Float3-y size)) 0 (Float3-y low)
                    0 0 (positive (Float3-z size)) (Float3-z low))))

;; A box of no thickness has no inverse to turn normals by; the thinnest one that has.
(: positive (-> Flonum Flonum))
(define (positive x) (flmax x 1e-150))

;; Local z along a direction, as shapes around an axis have it.
(: frame-transform (-> Float3 Float3 Flonum Flonum Transform))
(define (frame-transform origin direction across along)
  (define frame (axial-frame origin direction))
  (define (at [k : Fixnum] [scale : Flonum]) (fl* scale (flvector-ref frame k)))
  (make-Transform (at 3 across) (at 6 across) (at 9 along) (at 0 1.0)
                  (at 4 across) (at 7 across) (at 10 along) (at 1 1.0)
                  (at 5 across) (at 8 across) (at 11 along) (at 2 1.0)))
