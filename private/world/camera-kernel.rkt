#lang typed/racket/base
;; Rays of a camera: a procedure that turns film-x and film-y, in pixels, into the ray in the scratch.
;; A pinhole at rest, the commonest camera, has one of its own; what a camera does not have (a lens, a
;; shutter, another projection) takes no sample and no time.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt"
         "../sample/sampler.rkt" "../sample/warp.rkt" "ray.rkt" "camera.rkt")

(provide Camera-kernel Camera-ray Camera-get-ray-direction)

;; width, height: of the whole picture in pixels. moving?: whether anything in the world moves. A lens
;; takes the pair of the next dimension, time a dimension of its own far behind those of a path.
(: Camera-kernel (->* (Camera Fixnum Fixnum) (Boolean) (-> FlVector FxVector Void)))
(define (Camera-kernel camera width height [moving? #f])
  (define open (Camera-shutter-open camera))
  (define span (fl- (Camera-shutter-close camera) open))
  (define cast! (untimed-kernel camera width height))
  (cond
    [(and (not moving?) (not (Camera-end camera))) cast!]
    [(fl= span 0.0)
     (lambda ([r : FlVector] [i : FxVector])
       (flvector-set! r ray-time open)
       (cast! r i))]
    [else
     (lambda ([r : FlVector] [i : FxVector])
       (sample-pair! r i (TIME-DIMENSION) (fxvector-ref i sampler-index))
       (flvector-set! r ray-time (fl+ open (fl* span (flvector-ref r sample-u))))
       (cast! r i))]))

(define-syntax-rule (TIME-DIMENSION) 65535)

(: untimed-kernel (-> Camera Fixnum Fixnum (-> FlVector FxVector Void)))
(define (untimed-kernel camera width height)
  (if (and (eq? (Camera-projection camera) 'perspective)
           (fl= (Camera-lens-radius camera) 0.0)
           (not (Camera-end camera)))
      (pinhole-kernel camera width height)
      (general-kernel camera width height)))

;; The ray through (x, y) of the picture, from 0 at the left and top to 1 at the right and bottom, and
;; the middle of the lens, at time 0.
(: Camera-ray (-> Camera Real Real Ray))
(define (Camera-ray camera x y)
  (define r (make-flonum-registers))
  (define cast! (untimed-kernel (Camera-with camera #:lens-radius 0) 1 1))
  (flvector-set! r film-x (real->double-flonum x))
  (flvector-set! r film-y (real->double-flonum y))
  (cast! r (make-fixnum-registers))
  (make-Ray (Float3-in r ray-origin) (Float3-in r ray-direction)))

;; The unit direction of that ray.
(: Camera-get-ray-direction (-> Camera Real Real Float3))
(define (Camera-get-ray-direction camera x y) (Ray-direction (Camera-ray camera x y)))

(: pinhole-kernel (-> Camera Fixnum Fixnum (-> FlVector FxVector Void)))
(define (pinhole-kernel camera width height)
  (define eye (Camera-eye camera))
  (define forward (Camera-forward camera))
  (define right (Camera-right camera))
  (define up (Camera-up camera))
  (define x-scale (fl/ 1.0 (fx->fl width)))
  (define y-scale (fl/ 1.0 (fx->fl height)))
  (lambda ([r : FlVector] [i : FxVector])
    (Float3-put! r ray-origin eye)
    (Float3-put! r ray-direction
                 (Float3-normalized
                  (through-plane forward right up
                                 (fl* x-scale (flvector-ref r film-x))
                                 (fl* y-scale (flvector-ref r film-y)))))))

;; ----------------------------------------------------------------------------------------------

;; Where the camera is at the ray's time, in the kernels' workspace: eye, forward, right, up; and the
;; two coordinates on the film, from -1 to 1, right and up.
(define-syntax-rule (pose-eye) workspace)
(define-syntax-rule (pose-forward) (fx+ workspace 3))
(define-syntax-rule (pose-right) (fx+ workspace 6))
(define-syntax-rule (pose-up) (fx+ workspace 9))
(define-syntax-rule (film-right) (fx+ workspace 12))
(define-syntax-rule (film-up) (fx+ workspace 13))

(: general-kernel (-> Camera Fixnum Fixnum (-> FlVector FxVector Void)))
(define (general-kernel camera width height)
  (define put-pose! (pose-writer camera))
  (define project! (projector camera))
  (define lens-radius (Camera-lens-radius camera))
  (define blades (Camera-blades camera))
  (define x-scale (fl/ 2.0 (fx->fl width)))
  (define y-scale (fl/ 2.0 (fx->fl height)))
  (define planar? (and (memq (Camera-projection camera) '(perspective orthographic)) #t))
  (define focus-distance (Camera-focus-distance camera))
  (: project-sharply! (-> FlVector Void))
  (define (project-sharply! r)
    (put-pose! r)
    (flvector-set! r (film-right) (fl- (fl* x-scale (flvector-ref r film-x)) 1.0))
    (flvector-set! r (film-up) (fl- 1.0 (fl* y-scale (flvector-ref r film-y))))
    (project! r))
  (cond
    [(fl= lens-radius 0.0)
     (lambda ([r : FlVector] [i : FxVector]) (project-sharply! r))]
    [else
     (lambda ([r : FlVector] [i : FxVector])
       (project-sharply! r)
       (sample-next-pair! r i)
       (put-aperture-point! r blades)
       (refocus! r lens-radius focus-distance planar?))]))

;; Puts the pose at the ray's time.
(: pose-writer (-> Camera (-> FlVector Void)))
(define (pose-writer camera)
  (define start (packed-pose camera))
  (define end-camera (Camera-end camera))
  (define end (and end-camera (packed-pose end-camera)))
  (if end
      (lambda ([r : FlVector])
        (let ([time (flvector-ref r ray-time)])
          (let each ([k : Fixnum 0])
            (when (fx< k 12)
              (flvector-set! r (fx+ (pose-eye) k)
                             (fl+ (fl* (fl- 1.0 time) (flvector-ref start k))
                                  (fl* time (flvector-ref end k))))
              (each (fx+ k 1))))))
      (lambda ([r : FlVector])
        (let each ([k : Fixnum 0])
          (when (fx< k 12)
            (flvector-set! r (fx+ (pose-eye) k) (flvector-ref start k))
            (each (fx+ k 1)))))))

(: packed-pose (-> Camera FlVector))
(define (packed-pose camera)
  (define pose (make-flvector 12))
  (Float3-put! pose 0 (Camera-eye camera))
  (Float3-put! pose 3 (Camera-forward camera))
  (Float3-put! pose 6 (Camera-right camera))
  (Float3-put! pose 9 (Camera-up camera))
  pose)

;; Puts the ray through the middle of the lens.
(: projector (-> Camera (-> FlVector Void)))
(define (projector camera)
  (define angle (Camera-angle camera))
  (case (Camera-projection camera)
    [(perspective) perspective!]
    [(orthographic) orthographic!]
    [(panoramic) panoramic!]
    [else (lambda ([r : FlVector]) (fisheye! r angle))]))

(define-syntax-rule (on-film r)
  (Float3-multiply-add
   (Float3-scale-by-scalar (Float3-in r (pose-right)) (flvector-ref r (film-right)))
   (flvector-ref r (film-up)) (Float3-in r (pose-up))))

(: perspective! (-> FlVector Void))
(define (perspective! r)
  (Float3-put! r ray-origin (Float3-in r (pose-eye)))
  (Float3-put! r ray-direction
               (Float3-normalized (Float3-add (Float3-in r (pose-forward)) (on-film r)))))

(: orthographic! (-> FlVector Void))
(define (orthographic! r)
  (Float3-put! r ray-origin (Float3-add (Float3-in r (pose-eye)) (on-film r)))
  (Float3-put! r ray-direction (Float3-normalized (Float3-in r (pose-forward)))))

(: panoramic! (-> FlVector Void))
(define (panoramic! r)
  (let* ([longitude (fl* (PI) (flvector-ref r (film-right)))]
         [latitude (fl* (fl* 0.5 (PI)) (flvector-ref r (film-up)))]
         [level (flcos latitude)])
    (put-direction! r (fl* level (flcos longitude)) (fl* level (flsin longitude))
                    (flsin latitude))))

;; The film's middle is straight ahead, its corner `angle` away.
(: fisheye! (-> FlVector Flonum Void))
(define (fisheye! r angle)
  (let-float3 ([p (on-film r)] [right (Float3-in r (pose-right))] [up (Float3-in r (pose-up))])
    (let* ([corner (flsqrt (fl+ (Float3-length-squared right) (Float3-length-squared up)))]
           [distance (Float3-length p)]
           [away (fl* angle (fl/ distance corner))]
           [part (if (fl> distance 0.0) (fl/ (flsin away) distance) 0.0)])
      (put-direction! r (flcos away)
                      (fl* part (fl* (flvector-ref r (film-right)) (Float3-length right)))
                      (fl* part (fl* (flvector-ref r (film-up)) (Float3-length up)))))))

;; The ray from the eye, by the shares of the unit vectors forward, right and up.
(define-syntax-rule (put-direction! r f0 x0 y0)
  (let ([f f0] [x x0] [y y0])
    (Float3-put! r ray-origin (Float3-in r (pose-eye)))
    (Float3-put! r ray-direction
                 (Float3-normalized
                  (Float3-multiply-add
                   (Float3-multiply-add
                    (Float3-scale-by-scalar (Float3-normalized (Float3-in r (pose-forward))) f)
                    x (Float3-normalized (Float3-in r (pose-right))))
                   y (Float3-normalized (Float3-in r (pose-up))))))))

;; ----------------------------------------------------------------------------------------------

;; Turns the sample into a point of the aperture, uniform over the unit disk, or over the regular
;; polygon inscribed in it, one corner at the top: left in sample-u and sample-v, right and up.
(: put-aperture-point! (-> FlVector Fixnum Void))
(define (put-aperture-point! r blades)
  (cond
    [(fx= blades 0)
     (let-float3 ([p (warp-disk (flvector-ref r sample-u) (flvector-ref r sample-v))])
       (flvector-set! r sample-u (Float3-x p))
       (flvector-set! r sample-v (Float3-y p)))]
    [else
     ;; one of the triangles between the middle and two corners, and a point uniform in it
     (let* ([sides (fx->fl blades)]
            [scaled (fl* sides (flvector-ref r sample-u))]
            [side (flfloor scaled)]
            [outward (flsqrt (fl- scaled side))]
            [along (flvector-ref r sample-v)]
            [turn (fl/ (TWO-PI) sides)]
            [first (fl* turn side)]
            [second (fl+ first turn)]
            [near (fl* outward (fl- 1.0 along))]
            [far (fl* outward along)])
       (flvector-set! r sample-u (fl+ (fl* near (flsin first)) (fl* far (flsin second))))
       (flvector-set! r sample-v (fl+ (fl* near (flcos first)) (fl* far (flcos second)))))]))

;; Takes the ray through another point of the lens to the same point in focus: on the plane at that
;; distance along forward, or, where the film is no plane, on the sphere.
(: refocus! (-> FlVector Flonum Flonum Boolean Void))
(define (refocus! r radius focus-distance planar?)
  (let-float3 ([origin (Float3-in r ray-origin)]
               [direction (Float3-in r ray-direction)]
               [forward (Float3-normalized (Float3-in r (pose-forward)))]
               [aside (Float3-multiply-add
                       (Float3-scale-by-scalar (Float3-normalized (Float3-in r (pose-right)))
                                               (fl* radius (flvector-ref r sample-u)))
                       (fl* radius (flvector-ref r sample-v))
                       (Float3-normalized (Float3-in r (pose-up))))])
    (let ([distance (if planar?
                        (fl/ focus-distance (Float3-dot direction forward))
                        focus-distance)])
      (Float3-put! r ray-origin (Float3-add origin aside))
      (Float3-put! r ray-direction
                   (Float3-normalized
                    (Float3-subtract (Float3-scale-by-scalar direction distance) aside))))))
