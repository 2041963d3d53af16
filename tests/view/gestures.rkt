#lang racket/base
;; The camera under the mouse: what should follow the pointer does.
(module+ test
  (require racket/math rackunit raytrace "../../private/view/gestures.rkt")

  (define camera (Camera-look-at (Float3 1 2 6) (Float3 0.5 0.4 0)
                                 #:vertical-field-of-view-degrees 40))
  (define-values (width height) (values 320 200))
  (define focus (Float3 0.5 0.4 0))
  (define up (Float3 0 1 0))

  (define (close? a b [tolerance 1e-9])
    (< (Float3-distance a b) (* tolerance (+ 1.0 (Float3-length a)))))
  ;; where a point is seen, in pixels
  (define (seen-at camera point) (Camera-project camera point #:width width #:height height))

  (test-case "orbit: what is in focus stays where it is, as far away; the horizon stays level"
    (for* ([right '(-90 -7 0 33)] [down '(-20 0 41)])
      (define moved (Camera-dragged camera 'orbit right down width height))
      (check-true (close? (seen-at camera focus) (seen-at moved focus)) (format "~a ~a" right down))
      (check-= (Float3-distance (Camera-eye moved) focus)
               (Float3-distance (Camera-eye camera) focus) 1e-9)
      (check-= (Float3-dot (Camera-right moved) up) 0.0 1e-12)
      (check-= (Camera-focus-distance moved) (Camera-focus-distance camera) 1e-12)))

  (test-case "orbit: across the picture is half a circle; what is in front follows the pointer"
    (define half (Camera-dragged camera 'orbit width 0 width height))
    (define (flat v) (Float3 (Float3-x v) 0 (Float3-z v)))
    (check-true (close? (flat (Float3-subtract (Camera-eye half) focus))
                        (Float3-negate (flat (Float3-subtract (Camera-eye camera) focus)))))
    (define front (Float3-linear-interpolate focus (Camera-eye camera) 0.1))
    (define (moves right down)
      (Float3-subtract (seen-at (Camera-dragged camera 'orbit right down width height) front)
                       (seen-at camera front)))
    (check-true (> (Float3-x (moves 10 0)) 0.1))
    (check-true (> (Float3-y (moves 0 10)) 0.1)))

  (test-case "orbit: a camera that hangs upside down turns the same way under the pointer"
    (define hanging (Camera-orbit camera 0 150))
    (check-true (< (Float3-y (Camera-up hanging)) 0))
    (define front (Float3-linear-interpolate focus (Camera-eye hanging) 0.1))
    (define moved (Camera-dragged hanging 'orbit 10 0 width height))
    (check-true (> (Float3-x (seen-at moved front)) (+ 0.1 (Float3-x (seen-at hanging front))))))

  (test-case "pan: what is in focus moves with the pointer, pixel by pixel, whatever the projection"
    (define (check-pan camera)
      (define moved (Camera-dragged camera 'pan 30 -12 width height))
      (define shift (Float3-subtract (seen-at moved focus) (seen-at camera focus)))
      (check-= (Float3-x shift) 30.0 1e-6)
      (check-= (Float3-y shift) -12.0 1e-6)
      (check-true (close? (Camera-forward camera) (Camera-forward moved))))
    (check-pan camera)
    (check-pan (Camera-orthographic (Float3 1 2 6) focus #:height 5))
    ;; on a sphere only small moves are straight: a pixel to a part in a thousand
    (for ([camera (list (Camera-panoramic (Float3 1 2 6) focus)
                        (Camera-fisheye (Float3 1 2 6) focus #:field-of-view-degrees 170))])
      (define near (Camera-with camera #:focus-distance (Float3-distance (Float3 1 2 6) focus)))
      (define moved (Camera-dragged near 'pan 0 1 width height))
      (define turned
        (acos (/ (Float3-dot (Float3-subtract focus (Camera-eye moved))
                             (Float3-subtract focus (Camera-eye near)))
                 (* (Float3-distance focus (Camera-eye moved))
                    (Float3-distance focus (Camera-eye near))))))
      (define pixel
        (if (eq? 'panoramic (vector-ref (struct->vector near) 8))
            (/ pi height)
            (/ (degrees->radians 170) (sqrt (+ (* width width) (* height height))))))
      (check-= (/ turned pixel) 1.0 0.001)))

  (test-case "wheel: a notch forward and one back meet; ten come near and not past"
    (define near (Camera-wheeled camera 1))
    (check-= (/ (Camera-focus-distance near) (Camera-focus-distance camera)) 0.9 1e-12)
    (check-true (close? (Camera-eye (Camera-wheeled near -1)) (Camera-eye camera)))
    (define-values (a b) (values (seen-at near focus) (seen-at camera focus)))
    (check-= (Float3-x a) (Float3-x b) 1e-9)
    (check-= (Float3-y a) (Float3-y b) 1e-9)
    (check-true (< 0 (Camera-focus-distance (Camera-wheeled camera 10)) 3))
    (define parallel (Camera-orthographic (Float3 1 2 6) focus #:height 5))
    (define larger (Camera-wheeled parallel 1))
    (check-true (close? (Camera-eye larger) (Camera-eye parallel)))
    (check-= (/ (Float3-length (Camera-up larger)) (Float3-length (Camera-up parallel))) 0.9 1e-12))

  (test-case "focus: the distance along the line of sight of what the pixel shows"
    (define wall (World (list (Plane (Float3 0 0 -2) (Float3 0 0 1) (Float3 1 1 1)))))
    (define straight (Camera-look-at (Float3 0 0 3) (Float3 0 0 0) #:lens-radius 0.1))
    ;; a plane square to the line of sight is in focus as a whole
    (for ([x '(0 100 319)] [y '(0 150 199)])
      (define focused (Camera-focused wall straight x y width height))
      (check-= (Camera-focus-distance focused) 5.0 1e-9)
      (check-equal? (Camera-eye focused) (Camera-eye straight))
      (check-equal? (Camera-lens-radius focused) 0.1))
    (define ball (World (list (Sphere (Float3 0.5 0.4 0) 1 (Float3 1 1 1)))))
    (define focused (Camera-focused ball camera 159.5 99.5 width height))
    (check-= (Camera-focus-distance focused) (- (Camera-focus-distance camera) 1.0) 1e-9)
    (check-false (Camera-focused ball camera 0 0 width height)))

  (test-case "vertical: the axis the horizon is square to"
    (define (vertical-from eye up) (Camera-vertical (Camera-look-at eye (Float3 0 0 0) #:up up)))
    (for ([eye (list (Float3 0 1 6) (Float3 3 2 1) (Float3 0 5 4) (Float3 0 5 -4) (Float3 -2 -1 3))])
      (check-equal? (vertical-from eye (Float3 0 1 0)) (Float3 0 1 0) (format "~v" eye)))
    (for ([eye (list (Float3 4 -5 2) (Float3 0 -5 2) (Float3 5 0 1))])
      (check-equal? (vertical-from eye (Float3 0 0 1)) (Float3 0 0 1) (format "~v" eye)))
    (define tilted (Camera-look-at (Float3 1 2 6) (Float3 0 0 0) #:up (Float3 1 2 0.5)))
    (check-true (close? (Camera-vertical tilted) (Float3-normalized (Camera-up tilted))))))
