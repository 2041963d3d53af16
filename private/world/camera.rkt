#lang typed/racket/base
;; Cameras: a point with three axes, as in the article, and a thin lens if one is wanted.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../base/public.rkt" "../sample/sampler.rkt" "../sample/warp.rkt" "ray.rkt")

(provide (struct-out Camera) make-Camera Camera-global-up Camera-look-at Camera-fitted
         Camera-get-ray-direction Camera-ray Camera-kernel)

;; eye: where it is. forward, right, up: from the eye to the middle of the image plane, from there
;; to the middle of its right edge and of its top edge; their lengths give the field of view.
;; lens-radius: 0 for a pinhole. focus-distance: along forward, where everything is sharp.
(struct Camera
  ([eye : Float3] [forward : Float3] [right : Float3] [up : Float3]
   [lens-radius : Flonum] [focus-distance : Flonum])
  #:transparent)

(: make-Camera (->* (Float3 Float3 Float3 Float3)
                    (Real Real #:lens-radius Real #:focus-distance Real)
                    Camera))
(define (make-Camera eye forward right up [lens-by-place 0.0] [focus-by-place 1.0]
                     #:lens-radius [lens-radius lens-by-place]
                     #:focus-distance [focus-distance focus-by-place])
  (Camera (check-point 'Camera "eye" eye)
          (check-direction 'Camera "forward" forward)
          (check-direction 'Camera "right" right)
          (check-direction 'Camera "up" up)
          (check-between 'Camera "lens-radius" lens-radius 0.0 1e300)
          (check-positive 'Camera "focus-distance" focus-distance)))

(define-constructor Camera make-Camera (eye forward right up lens-radius focus-distance))

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

;; The camera with its view as wide as a picture of that shape needs; its height stays.
(: Camera-fitted (-> Camera Real Camera))
(define (Camera-fitted camera aspect)
  (define right (Camera-right camera))
  (define width (fl* (real->double-flonum aspect) (Float3-length (Camera-up camera))))
  (Camera (Camera-eye camera) (Camera-forward camera)
          (Float3-scale-by-scalar right (fl/ width (Float3-length right)))
          (Camera-up camera) (Camera-lens-radius camera) (Camera-focus-distance camera)))

;; From the eye through the image plane at (x, y), both from 0 to 1, x from the left, y from the
;; top; not normalized.
(define-float3-operation
  (through-plane [(fx fy fz) : Float3] [(rx ry rz) : Float3] [(ux uy uz) : Float3]
                 [x : Flonum] [y : Flonum])
  #:let ([a (fl- (fl* 2.0 x) 1.0)] [b (fl- 1.0 (fl* 2.0 y))])
  : Float3 ((fl+ fx (fl+ (fl* a rx) (fl* b ux)))
            (fl+ fy (fl+ (fl* a ry) (fl* b uy)))
            (fl+ fz (fl+ (fl* a rz) (fl* b uz)))))

;; The unit direction from the eye through (x, y) of the image plane, from 0 at the left and top
;; to 1 at the right and bottom.
(: Camera-get-ray-direction (-> Camera Real Real Float3))
(define (Camera-get-ray-direction camera x y)
  (let-float3 ([forward (Camera-forward camera)] [right (Camera-right camera)]
               [up (Camera-up camera)])
    (let ([x (real->double-flonum x)] [y (real->double-flonum y)])
      (Float3-normalized/checked (through-plane forward right up x y)))))

;; The ray through (x, y) of the image plane and the middle of the lens.
(: Camera-ray (-> Camera Real Real Ray))
(define (Camera-ray camera x y)
  (make-Ray (Camera-eye camera) (Camera-get-ray-direction camera x y)))

;; A procedure that turns film-x and film-y, in pixels, into the ray in the scratch. A lens takes
;; the pair of the next dimension; a pinhole takes none.
(: Camera-kernel (-> Camera Fixnum Fixnum (-> FlVector FxVector Void)))
(define (Camera-kernel camera width height)
  (define eye (Camera-eye camera))
  (define forward (Camera-forward camera))
  (define right (Camera-right camera))
  (define up (Camera-up camera))
  (define lens-radius (Camera-lens-radius camera))
  (define unit-right (Float3-normalized right))
  (define unit-up (Float3-normalized up))
  (define focus-scale (fl/ (Camera-focus-distance camera) (Float3-length forward)))
  (define x-scale (fl/ 1.0 (fx->fl width)))
  (define y-scale (fl/ 1.0 (fx->fl height)))
  (if (fl= lens-radius 0.0)
      (lambda ([r : FlVector] [i : FxVector])
        (Float3-put! r ray-origin eye)
        (Float3-put! r ray-direction
                     (Float3-normalized
                      (through-plane forward right up
                                     (fl* x-scale (flvector-ref r film-x))
                                     (fl* y-scale (flvector-ref r film-y))))))
      (lambda ([r : FlVector] [i : FxVector])
        (sample-next-pair! r i)
        (let-float3 ([ahead (through-plane forward right up
                                           (fl* x-scale (flvector-ref r film-x))
                                           (fl* y-scale (flvector-ref r film-y)))]
                     [disk (warp-disk (flvector-ref r sample-u) (flvector-ref r sample-v))]
                     [aside (Float3-add
                             (Float3-scale-by-scalar unit-right
                                                     (fl* lens-radius (Float3-x disk)))
                             (Float3-scale-by-scalar unit-up
                                                     (fl* lens-radius (Float3-y disk))))])
          (Float3-put! r ray-origin (Float3-add eye aside))
          (Float3-put! r ray-direction
                       (Float3-normalized
                        (Float3-subtract (Float3-scale-by-scalar ahead focus-scale)
                                         aside)))))))
