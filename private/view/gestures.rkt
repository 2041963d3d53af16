#lang racket/base
;; What the mouse does to a camera, as pure functions of pixels.
(require racket/math "../../main.rkt"
         (only-in "../world/camera.rkt" Camera-fitted Camera-angle Camera-end))

(provide Camera-dragged Camera-wheeled Camera-focused Camera-vertical)

;; A drag across the whole width of the picture turns by half a circle.
(define DEGREES-ACROSS 180.0)

;; A notch of the wheel goes this part of the way to what is in focus.
(define NOTCH 0.1)

;; Camera-dragged : the camera after a drag by so many pixels to the right and down, of a picture of
;; that size. kind: 'orbit goes around what is in focus, about the direction `vertical`; 'pan moves
;; sideways. What is in focus follows the pointer.
(define (Camera-dragged camera kind right down width height #:vertical [vertical (Camera-global-up)])
  (case kind
    [(orbit)
     (define degrees (/ DEGREES-ACROSS width))
     ;; a camera that hangs upside down sees what turns right go left
     (define hanging? (negative? (Float3-dot (Camera-up camera) vertical)))
     (Camera-orbit camera (* (if hanging? 1 -1) degrees right) (* degrees down) #:up vertical)]
    [(pan)
     (define unit (pixel-size camera width height))
     (Camera-pan camera (- (* unit right)) (* unit down))]))

;; The side of a pixel in world units, at the distance that is in focus.
(define (pixel-size camera width height)
  (define up (Float3-length (Camera-up camera)))
  (define focus (Camera-focus-distance camera))
  (case (Camera-projection camera)
    [(orthographic) (/ (* 2.0 up) height)]
    [(panoramic) (/ (* pi focus) height)]
    [(fisheye) (/ (* 2.0 focus (Camera-angle camera)) (sqrt (+ (* width width) (* height height))))]
    [else (/ (* 2.0 up focus) (* height (Float3-length (Camera-forward camera))))]))

;; Camera-wheeled : the camera so many notches nearer to what is in focus, or farther away where they
;; are negative; what parallel rays show becomes larger instead.
(define (Camera-wheeled camera notches)
  (define left (expt (- 1.0 NOTCH) notches))
  (if (eq? 'orthographic (Camera-projection camera))
      (Camera-enlarged camera left)
      (Camera-dolly camera (* (- 1.0 left) (Camera-focus-distance camera)))))

(define (Camera-enlarged camera factor)
  (Camera (Camera-eye camera) (Camera-forward camera)
               (Float3-scale-by-scalar (Camera-right camera) factor)
               (Float3-scale-by-scalar (Camera-up camera) factor)
               #:lens-radius (Camera-lens-radius camera)
               #:focus-distance (Camera-focus-distance camera)
               #:blades (Camera-blades camera)
               #:projection (Camera-projection camera) #:angle (Camera-angle camera)
               #:shutter-open (Camera-shutter-open camera)
               #:shutter-close (Camera-shutter-close camera)
               #:end (let ([end (Camera-end camera)]) (and end (Camera-enlarged end factor)))))

;; Camera-focused : the camera focused on what is seen in the middle of the pixel in column x and row
;; y of a picture of that size; #f where nothing is.
(define (Camera-focused world camera x y width height)
  (define ray
    (Camera-ray (Camera-fitted camera (/ width height)) (/ (+ x 0.5) width) (/ (+ y 0.5) height)))
  (define hit (World-nearest-hit world ray))
  (and (< (Intersection-t hit) INTERSECTION-T-MAX)
       (let* ([away (Float3-subtract (Intersection-point hit) (Camera-eye camera))]
              [forward (Camera-forward camera)]
              ;; a film that is no plane is sharp on a sphere
              [distance (if (memq (Camera-projection camera) '(perspective orthographic))
                            (/ (Float3-dot away forward) (Float3-length forward))
                            (Float3-length away))])
         (and (> distance 0.0) (Camera-with camera #:focus-distance distance)))))

;; Camera-vertical : the direction that is up for the camera's world: of the axes that its horizon is
;; square to, y unless z or x is clearly more upright; a tilted camera's own up where there is none.
(define (Camera-vertical camera)
  (define right (Float3-normalized (Camera-right camera)))
  (define up (Float3-normalized (Camera-up camera)))
  (define y (Camera-global-up))
  (define (level? axis) (< (abs (Float3-dot right axis)) 1e-6))
  (define (upright axis) (Float3-dot up axis))
  (define others (filter level? (list (Float3 0 0 1) (Float3 1 0 0))))
  (define other
    (for/first ([axis (in-list others)]
                #:when (> (upright axis) (if (level? y) (+ (abs (upright y)) 0.5) 0.0)))
      axis))
  (cond
    [other other]
    [(not (level? y)) up]
    [(negative? (upright y)) (Float3-negate y)]
    [else y]))
