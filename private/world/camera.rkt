#lang typed/racket/base
;; Cameras: a point with three axes, as in the article; a thin lens, a shutter and other projections
;; if they are wanted. Their rays are cast in camera-kernel.rkt.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/float3.rkt" "../base/check.rkt" "../base/public.rkt"
         "../base/unsafe-typed.rkt"
         "../sample/warp.rkt")

(provide (struct-out Camera) make-Camera Camera-global-up Camera-look-at Camera-fitted
         Camera-with Camera-moving
         Camera-orthographic Camera-panoramic Camera-fisheye through-plane)

;; eye: where it is. forward, right, up: from the eye to the middle of the image plane, from there
;; to the middle of its right edge and of its top edge; their lengths give the field of view.
;; lens-radius: 0 for a pinhole. focus-distance: along forward, where everything is sharp. blades:
;; corners of the aperture, 0 for a round one. projection: one of PROJECTIONS; angle: for the fisheye,
;; radians from the middle of the picture to its corner. shutter-open, shutter-close: the part of the
;; time from 0 to 1 in which light is gathered. end: the camera at time 1, #f for one at rest.
(struct Camera
  ([eye : Float3] [forward : Float3] [right : Float3] [up : Float3]
   [lens-radius : Flonum] [focus-distance : Flonum] [blades : Fixnum]
   [projection : Symbol] [angle : Flonum]
   [shutter-open : Flonum] [shutter-close : Flonum] [end : (U #f Camera)])
  #:transparent
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write
  (lambda ([camera : Camera] [port : Output-Port] [mode : (U Boolean 0 1)])
    (print-call 'Camera
                (list (Camera-eye camera) (Camera-forward camera)
                      (Camera-right camera) (Camera-up camera))
                (list '#:lens-radius (Camera-lens-radius camera) 0.0
                      '#:focus-distance (Camera-focus-distance camera) 1.0
                      '#:blades (Camera-blades camera) 0
                      '#:projection (Camera-projection camera) 'perspective
                      '#:angle (Camera-angle camera) 1.0
                      '#:shutter-open (Camera-shutter-open camera) 0.0
                      '#:shutter-close (Camera-shutter-close camera) 1.0
                      '#:end (Camera-end camera) #f)
                port mode)))

(unsafe-require/typed "../base/print.rkt"
  [print-call (-> Symbol (Listof Any) (Listof Any) Output-Port (U Boolean 0 1) Any)])

;; perspective: through the image plane. orthographic: along forward, from the plane through the eye
;; that right and up span. panoramic: the picture's width is all around, its height from straight down
;; to straight up (equirectangular). fisheye: the angle from forward grows with the distance from the
;; picture's middle (equidistant).
(define PROJECTIONS : (Listof Symbol) '(perspective orthographic panoramic fisheye))

(: make-Camera (->* (Float3 Float3 Float3 Float3)
                    (Real Real #:lens-radius Real #:focus-distance Real #:blades Integer
                     #:projection Symbol #:angle Real
                     #:shutter-open Real #:shutter-close Real #:end (U #f Camera))
                    Camera))
(define (make-Camera eye forward right up [lens-by-place 0.0] [focus-by-place 1.0]
                     #:lens-radius [lens-radius lens-by-place]
                     #:focus-distance [focus-distance focus-by-place]
                     #:blades [blades 0]
                     #:projection [projection 'perspective] #:angle [angle 1.0]
                     #:shutter-open [open 0.0] #:shutter-close [close 1.0] #:end [end #f])
  (unless (memq projection PROJECTIONS)
    (raise-expected 'Camera "projection" (format "one of ~a" PROJECTIONS) projection))
  (unless (or (eqv? blades 0) (<= 3 blades 1000))
    (raise-expected 'Camera "blades" "0 for a round aperture, or 3 to 1000" blades))
  (when (and (eq? projection 'panoramic) (> lens-radius 0))
    (raise-expected 'Camera "lens-radius" "0 for a panoramic camera" lens-radius))
  (define opened (check-between 'Camera "shutter-open" open 0.0 1.0))
  (Camera (check-point 'Camera "eye" eye)
          (check-direction 'Camera "forward" forward)
          (check-direction 'Camera "right" right)
          (check-direction 'Camera "up" up)
          (check-between 'Camera "lens-radius" lens-radius 0.0 1e300)
          (check-positive 'Camera "focus-distance" focus-distance)
          (assert blades fixnum?)
          projection
          (check-between 'Camera "angle" angle 1e-9 (PI))
          opened
          (check-between 'Camera "shutter-close" close opened 1.0)
          end))

(define-constructor Camera make-Camera (eye forward right up lens-radius focus-distance)
  #:struct (eye forward right up lens-radius focus-distance _ _ _ _ _ _))

;; Camera-with : the same camera but for what is given; see the struct.
(: Camera-with (->* (Camera)
                    (#:eye Float3 #:lens-radius Real #:focus-distance Real #:blades Integer
                     #:shutter-open Real #:shutter-close Real #:end (U #f Camera))
                    Camera))
(define (Camera-with camera #:eye [eye (Camera-eye camera)]
                     #:lens-radius [lens-radius (Camera-lens-radius camera)]
                     #:focus-distance [focus-distance (Camera-focus-distance camera)]
                     #:blades [blades (Camera-blades camera)]
                     #:shutter-open [open (Camera-shutter-open camera)]
                     #:shutter-close [close (Camera-shutter-close camera)]
                     #:end [end (Camera-end camera)])
  (make-Camera eye (Camera-forward camera) (Camera-right camera) (Camera-up camera)
               #:lens-radius lens-radius #:focus-distance focus-distance #:blades blades
               #:projection (Camera-projection camera) #:angle (Camera-angle camera)
               #:shutter-open open #:shutter-close close #:end end))

;; Camera-moving : a camera that goes from one to the other, linearly, in the time from 0 to 1. Lens
;; and projection are the first one's.
(: Camera-moving (-> Camera Camera Camera))
(define (Camera-moving from to) (Camera-with from #:end to))

;; The direction away from the ground.
(: Camera-global-up (-> Float3))
(define (Camera-global-up) (make-Float3 0 1 0))

;; A camera at `eye` that looks at `focus`. As in the article, `aspect` is the width of the view
;; for a height of 1 and `zoom` the distance of the image plane, for a half height of 1; or
;; #:vertical-field-of-view-degrees says the same as an angle. A render fits the width to its own
;; picture. #:lens-radius and #:focus-distance (by default the distance of `focus`) blur what is
;; nearer or farther. Raises where eye and focus agree or `up` is along the line of sight.
;; (The published program's right hand comes out of a cross product with a wrong sign.)
(: Camera-look-at (->* (Float3 Float3)
                       (Float3 Real Real #:up Float3 #:aspect Real #:zoom Real
                        #:vertical-field-of-view-degrees Real
                        #:lens-radius Real #:focus-distance (U #f Real))
                       Camera))
(define (Camera-look-at eye focus [up-by-place (Camera-global-up)] [aspect-by-place (/ 16.0 9.0)]
                        [zoom-by-place 1.5]
                        #:up [up up-by-place]
                        #:aspect [aspect aspect-by-place]
                        #:zoom [zoom zoom-by-place]
                        #:vertical-field-of-view-degrees [angle #f]
                        #:lens-radius [lens-radius 0.0]
                        #:focus-distance [focus-distance #f])
  (check-point 'Camera-look-at "eye" eye)
  (check-point 'Camera-look-at "focus" focus)
  (define sight
    (check-direction 'Camera-look-at "focus - eye" (Float3-subtract focus eye)))
  (define plane-distance
    (cond
      [angle
       (define degrees
         (check-between 'Camera-look-at "vertical-field-of-view-degrees" angle 1e-9 179.9999999))
       (fl/ 1.0 (fltan (fl* degrees (fl/ (PI) 360.0))))]
      [else (check-positive 'Camera-look-at "zoom" zoom)]))
  (define forward (Float3-normalized/checked sight))
  (define aside
    (Float3-cross forward
                  (Float3-normalized/checked (check-direction 'Camera-look-at "up" up))))
  (unless (fl> (Float3-length aside) 1e-12)
    (raise-expected 'Camera-look-at "up" "a direction across the line of sight" up))
  (define right (Float3-normalized/checked aside))
  (make-Camera eye
               (Float3-scale-by-scalar forward plane-distance)
               (Float3-scale-by-scalar right (check-positive 'Camera-look-at "aspect" aspect))
               (Float3-normalized/checked (Float3-cross right forward))
               #:lens-radius lens-radius
               #:focus-distance (or focus-distance (Float3-length sight))))

;; Camera-orthographic : parallel rays along the line from eye to focus; `height` world units from the
;; lower to the upper edge of the picture. A lens blurs as in Camera-look-at.
(: Camera-orthographic (->* (Float3 Float3 #:height Real)
                            (#:up Float3 #:lens-radius Real #:focus-distance (U #f Real))
                            Camera))
(define (Camera-orthographic eye focus #:height height #:up [up (Camera-global-up)]
                             #:lens-radius [lens-radius 0.0] #:focus-distance [distance #f])
  (define half (fl* 0.5 (check-positive 'Camera-orthographic "height" height)))
  (define base (Camera-look-at eye focus #:up up #:zoom 1.0 #:lens-radius lens-radius
                               #:focus-distance distance))
  (make-Camera eye (Camera-forward base)
               (Float3-scale-by-scalar (Camera-right base) half)
               (Float3-scale-by-scalar (Camera-up base) half)
               #:lens-radius lens-radius #:focus-distance (Camera-focus-distance base)
               #:projection 'orthographic))

;; Camera-panoramic : all directions around the eye, the one to `focus` in the middle: longitude across
;; the picture, latitude down it (equirectangular; a picture twice as wide as high has square pixels
;; at the equator).
(: Camera-panoramic (->* (Float3 Float3) (#:up Float3) Camera))
(define (Camera-panoramic eye focus #:up [up (Camera-global-up)])
  (define base (Camera-look-at eye focus #:up up #:zoom 1.0))
  (make-Camera eye (Camera-forward base) (Camera-right base) (Camera-up base)
               #:projection 'panoramic))

;; Camera-fisheye : an equidistant fisheye; field-of-view-degrees from corner to corner, up to 360.
(: Camera-fisheye (->* (Float3 Float3)
                       (#:up Float3 #:field-of-view-degrees Real #:lens-radius Real
                        #:focus-distance (U #f Real))
                       Camera))
(define (Camera-fisheye eye focus #:up [up (Camera-global-up)]
                        #:field-of-view-degrees [degrees 180.0]
                        #:lens-radius [lens-radius 0.0] #:focus-distance [distance #f])
  (define checked
    (check-between 'Camera-fisheye "field-of-view-degrees" degrees 1e-6 360.0))
  (define base (Camera-look-at eye focus #:up up #:zoom 1.0 #:lens-radius lens-radius
                               #:focus-distance distance))
  (make-Camera eye (Camera-forward base) (Camera-right base) (Camera-up base)
               #:lens-radius lens-radius #:focus-distance (Camera-focus-distance base)
               #:projection 'fisheye #:angle (fl* checked (fl/ (PI) 360.0))))

;; The camera with its view as wide as a picture of that shape needs; its height stays.
(: Camera-fitted (-> Camera Real Camera))
(define (Camera-fitted camera aspect)
  (define right (Camera-right camera))
  (define width (fl* (real->double-flonum aspect) (Float3-length (Camera-up camera))))
  (define end (Camera-end camera))
  (Camera (Camera-eye camera) (Camera-forward camera)
          (Float3-scale-by-scalar right (fl/ width (Float3-length right)))
          (Camera-up camera) (Camera-lens-radius camera) (Camera-focus-distance camera)
          (Camera-blades camera) (Camera-projection camera) (Camera-angle camera)
          (Camera-shutter-open camera) (Camera-shutter-close camera)
          (and end (Camera-fitted end aspect))))

;; From the eye through the image plane at (x, y), both from 0 to 1, x from the left, y from the
;; top; not normalized.
(define-float3-operation
  (through-plane [(fx fy fz) : Float3] [(rx ry rz) : Float3] [(ux uy uz) : Float3]
                 [x : Flonum] [y : Flonum])
  #:let ([a (fl- (fl* 2.0 x) 1.0)] [b (fl- 1.0 (fl* 2.0 y))])
  : Float3 ((fl+ fx (fl+ (fl* a rx) (fl* b ux)))
            (fl+ fy (fl+ (fl* a ry) (fl* b uy)))
            (fl+ fz (fl+ (fl* a rz) (fl* b uz)))))
