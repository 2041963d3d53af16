#lang typed/racket/base
;; A camera as rasterization sees it: points of the world to pixels and back, the matrices on the way,
;; and the planes between which something is seen.
(require "../base/unsafe.rkt" "../base/float3.rkt" "../base/check.rkt" "../base/matrix.rkt"
         "../base/transform.rkt" "../world/camera.rkt" "../world/camera-kernel.rkt"
         "../world/ray.rkt" "../world/projection.rkt")

(provide Camera-project Camera-unproject Camera-view Camera-frustum Transform-viewport
         Projection-clip-planes Projection-frustum-corners
         Camera-opened Camera-coordinates)

(define-syntax-rule (PI) 3.141592653589793)

;; The camera at rest where it is when its shutter opens.
(: Camera-opened (-> Camera Camera))
(define (Camera-opened camera)
  (define end (Camera-end camera))
  (define time (Camera-shutter-open camera))
  (define-syntax-rule (now part)
    (if end
        (Float3-add (Float3-scale-by-scalar (part camera) (fl- 1.0 time))
                    (Float3-scale-by-scalar (part end) time))
        (part camera)))
  (Camera (now Camera-eye) (now Camera-forward) (now Camera-right) (now Camera-up)
          0.0 (Camera-focus-distance camera) 0
          (Camera-projection camera) (Camera-angle camera) time time #f))

;; The map from the world to the camera's own coordinates (a, b, c), in which a point of it is
;; eye + a right + b up + c forward. Raises for a camera whose axes lie in one plane.
(: Camera-coordinates (-> Camera Transform))
(define (Camera-coordinates camera)
  (Transform-inverse (Camera-placement camera 1.0 1.0 1.0)))

;; From coordinates along right, up and forward, in these units, to the world.
(: Camera-placement (-> Camera Flonum Flonum Flonum Transform))
(define (Camera-placement camera a b c)
  (let-float3 ([right (Float3-scale-by-scalar (Camera-right camera) a)]
               [up (Float3-scale-by-scalar (Camera-up camera) b)]
               [forward (Float3-scale-by-scalar (Camera-forward camera) c)]
               [eye (Camera-eye camera)])
    (make-Transform (Float3-x right) (Float3-x up) (Float3-x forward) (Float3-x eye)
                    (Float3-y right) (Float3-y up) (Float3-y forward) (Float3-y eye)
                    (Float3-z right) (Float3-z up) (Float3-z forward) (Float3-z eye))))

(: fitted (-> Symbol Camera Integer Integer Camera))
(define (fitted who camera width height)
  (Camera-fitted (Camera-opened camera)
                 (/ (check-count who "width" width 1 100000)
                    (check-count who "height" height 1 100000))))

;; Camera-project : where a point of the world is seen in a picture of #:width by #:height pixels, as
;; a Float3: x from the left edge and y from the top edge in pixels, and the distance to the point
;; along the ray through that place, in world units. Places may lie outside the picture. #f for a
;; point that no ray leads to: behind a perspective's or an orthographic camera's eye, or the eye
;; itself. Lenses are taken as pinholes; a camera that moves is where its shutter opens.
(: Camera-project (->* (Camera Float3) (#:width Integer #:height Integer) (U #f Float3)))
(define (Camera-project given point #:width [width 640] #:height [height 360])
  (define camera (fitted 'Camera-project given width height))
  (define offset (Float3-subtract point (Camera-eye camera)))
  (define seen
    (matrix-vector (Transform-matrix (Camera-coordinates camera)) 0 offset))
  (define-values (a b c) (values (Float3-x seen) (Float3-y seen) (Float3-z seen)))
  (define distance (Float3-length offset))
  (: place (-> Flonum Flonum Flonum Float3))
  (define (place a b depth)
    (Float3 (fl* (fl* 0.5 (fx->fl (assert width fixnum?))) (fl+ 1.0 a))
            (fl* (fl* 0.5 (fx->fl (assert height fixnum?))) (fl- 1.0 b))
            depth))
  (define right (Float3-length (Camera-right camera)))
  (define up (Float3-length (Camera-up camera)))
  (define forward (Float3-length (Camera-forward camera)))
  ;; the same along unit vectors
  (define-values (x y z) (values (fl* a right) (fl* b up) (fl* c forward)))
  (define aside (flsqrt (fl+ (fl* x x) (fl* y y))))
  (case (Camera-projection camera)
    [(perspective) (and (fl> c 0.0) (place (fl/ a c) (fl/ b c) distance))]
    [(orthographic) (and (fl>= c 0.0) (place a b z))]
    [(panoramic)
     (and (fl> distance 0.0)
          (place (fl/ (atan x z) (PI))
                 (fl/ (atan y (flsqrt (fl+ (fl* x x) (fl* z z)))) (fl* 0.5 (PI)))
                 distance))]
    [else
     (define corner (flsqrt (fl+ (fl* right right) (fl* up up))))
     (cond
       [(fl> aside 0.0)
        (define away (fl/ (fl* corner (fl/ (atan aside z) (Camera-angle camera))) aside))
        (place (fl* away (fl/ x right)) (fl* away (fl/ y up)) distance)]
       [else (and (fl> z 0.0) (place 0.0 0.0 distance))])]))

;; Camera-unproject : the point of the world that Camera-project finds at (x, y, distance); it lies on
;; the ray through that place of the picture, as Camera-ray casts it.
(: Camera-unproject (->* (Camera Float3) (#:width Integer #:height Integer) Float3))
(define (Camera-unproject given seen #:width [width 640] #:height [height 360])
  (define camera (fitted 'Camera-unproject given width height))
  (define ray (Camera-ray camera (/ (Float3-x seen) width) (/ (Float3-y seen) height)))
  (Float3-multiply-add (Ray-point ray) (Float3-z seen) (Ray-direction ray)))

;; Camera-view : the view matrix, from the world to eye space: the eye at the origin, right along x,
;; up along y, looking along -z. Distances stay.
(: Camera-view (-> Camera Transform))
(define (Camera-view given)
  (define camera (Camera-opened given))
  (Transform-inverse
   (Camera-placement camera
                     (fl/ 1.0 (Float3-length (Camera-right camera)))
                     (fl/ 1.0 (Float3-length (Camera-up camera)))
                     (fl/ -1.0 (Float3-length (Camera-forward camera))))))

;; Camera-frustum : the projection matrix from that eye space to device coordinates, of a picture of
;; #:width by #:height pixels and the part of space between the distances 0 < near < far along the
;; line of sight; without #:far a perspective's has no end. Raises for panoramic and fisheye cameras,
;; whose projections have no matrix, and for an orthographic one without an end.
(: Camera-frustum
   (->* (Camera #:near Real) (#:far Real #:width Integer #:height Integer) Projection))
(define (Camera-frustum given #:near near #:far [far +inf.0] #:width [width 640]
                        #:height [height 360])
  (define camera (fitted 'Camera-frustum given width height))
  (define n (check-positive 'Camera-frustum "near" near))
  (define f (check-farther 'Camera-frustum n far))
  (define right (Float3-length (Camera-right camera)))
  (define up (Float3-length (Camera-up camera)))
  (define forward (Float3-length (Camera-forward camera)))
  (case (Camera-projection camera)
    [(perspective)
     (define-values (z-scale z-offset) (perspective-depth n f))
     (Projection (fl/ forward right) (fl/ forward up) z-scale 0.0 0.0 z-offset #t)]
    [(orthographic)
     (Projection-orthographic #:left (fl- 0.0 right) #:right right #:bottom (fl- 0.0 up) #:top up
                              #:near n #:far f)]
    [else (raise-expected 'Camera-frustum "camera" "a perspective or orthographic camera"
                          (Camera-projection camera))]))

;; Transform-viewport : the viewport matrix: device coordinates to x and y in pixels from the left and
;; the top edge, and depth from 0, near, to 1, far.
(: Transform-viewport (-> Integer Integer Transform))
(define (Transform-viewport width height)
  (define x (* 1/2 (check-count 'Transform-viewport "width" width 1 100000)))
  (define y (* 1/2 (check-count 'Transform-viewport "height" height 1 100000)))
  (make-Transform x 0 0 x
                  0 (- y) 0 y
                  0 0 1/2 1/2))

;; Projection-clip-planes : the planes left, right, bottom, top, near and far of what is seen, in eye
;; space, each as (list a b c d): a x + b y + c z + d is the distance of a point from it, positive
;; on the side that is seen; without far where a perspective has no end. (Gribb and Hartmann, "Fast Extraction of Viewing Frustum Planes from the
;; World-View-Projection Matrix", 2001.)
(: Projection-clip-planes (-> Projection (Listof (List Flonum Flonum Flonum Flonum))))
(define (Projection-clip-planes projection)
  (define rows (Projection-matrix-rows projection))
  (define last-row (cadddr rows))
  (define endless? (Projection-endless? projection))
  (for*/list : (Listof (List Flonum Flonum Flonum Flonum)) ([k (in-list '(0 1 2))]
                                                            [sign (in-list '(1.0 -1.0))]
                                                            #:unless (and endless? (= k 2)
                                                                          (fl< sign 0.0)))
    (define sum
      (for/list : (Listof Flonum) ([w (in-list last-row)] [entry (in-list (list-ref rows k))])
        (fl+ w (fl* sign entry))))
    (define-values (a b c d) (values (car sum) (cadr sum) (caddr sum) (cadddr sum)))
    (define length (flsqrt (fl+ (fl+ (fl* a a) (fl* b b)) (fl* c c))))
    (list (fl/ a length) (fl/ b length) (fl/ c length) (fl/ d length))))

;; Whether what is seen has no end.
(: Projection-endless? (-> Projection Boolean))
(define (Projection-endless? projection)
  (and (Projection-divides? projection) (fl= (Projection-z-scale projection) -1.0)))

;; Projection-frustum-corners : the eight corners of what is seen, in eye space: four near, four far,
;; each time left bottom, right bottom, left top, right top. Raises where a perspective has no end.
(: Projection-frustum-corners (-> Projection (Listof Float3)))
(define (Projection-frustum-corners projection)
  (when (Projection-endless? projection)
    (raise-expected 'Projection-frustum-corners "projection" "one with a far plane" projection))
  (for*/list : (Listof Float3) ([z (in-list '(-1.0 1.0))] [y (in-list '(-1.0 1.0))]
                                                          [x (in-list '(-1.0 1.0))])
    (Projection-unproject projection (Float3 x y z))))
