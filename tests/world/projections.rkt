#lang racket/base
;; Other projections, apertures with corners, the shutter and cameras that move, against closed forms.

(module+ test
  (require racket/match racket/math rackunit "../../main.rkt" "../statistics.rkt" "camera-rays.rkt")

  (define eye (Float3 1 2 3))
  (define focus (Float3 1 2 -5)) ; forward -z, right +x, up +y
  (define (check-near a b tolerance)
    (check-true (<= (Float3-distance a b) tolerance) (format "~a, not ~a" a b)))

  (test-case "orthographic: parallel rays from a plane; the height asked for, to 2 ulp of 8"
    (define camera (Camera-orthographic eye focus #:height 8))
    (define fitted (Camera-ray (Camera-with camera) 1/2 1/2))
    (check-near (Ray-point fitted) eye 0.0)
    (for ([x '(0.0 64.0 128.0)] [y '(0.0 32.0 64.0)])
      (match-define (list ox oy oz dx dy dz) (kernel-ray camera 128 64 x y 0))
      (check-near (Float3 dx dy dz) (Float3 0 0 -1) 1e-15)
      (check-= oy (- 6.0 (/ y 8.0)) 2e-15)
      (check-= oz 3.0 1e-15)))

  (test-case "panoramic: longitude across, latitude down"
    (define camera (Camera-panoramic eye focus))
    (for ([x '(0.5 0.75 0.25 0.625 0.3)] [y '(0.5 0.5 0.5 0.25 0.9)])
      (define-values (longitude latitude) (values (* 2 pi (- x 0.5)) (* pi (- 0.5 y))))
      (check-near (Camera-get-ray-direction camera x y)
                  (Float3 (* (cos latitude) (sin longitude)) (sin latitude)
                          (- (* (cos latitude) (cos longitude))))
                  3e-16))
    (check-near (Camera-get-ray-direction camera 0.1 0) (Float3 0 1 0) 2e-16))

  (test-case "fisheye: the angle from forward is the distance from the middle, half of it at a corner"
    (for ([degrees '(60 180 270 360)])
      (define camera (Camera-fisheye eye focus #:field-of-view-degrees degrees))
      (define half (* degrees pi 1/360))
      (define aspect (/ (Float3-length (Camera-right camera)) (Float3-length (Camera-up camera))))
      (for ([x '(0.5 0.0 1.0 0.25 0.7)] [y '(0.5 0.0 1.0 0.5 0.1)])
        (define-values (a b) (values (* aspect (- (* 2 x) 1)) (- 1 (* 2 y))))
        (define distance (sqrt (+ (* a a) (* b b))))
        (define angle (* half (/ distance (sqrt (+ 1 (* aspect aspect))))))
        (define direction (Camera-get-ray-direction camera x y))
        (check-near direction
                    (if (zero? distance)
                        (Float3 0 0 -1)
                        (Float3 (* (sin angle) (/ a distance)) (* (sin angle) (/ b distance))
                                (- (cos angle))))
                    4e-16))))

  (test-case "an aperture of n corners: inside the polygon, uniform over it"
    (for ([n '(3 5 6 8)])
      (define camera
        (Camera-with (Camera-look-at eye focus #:lens-radius 0.5 #:focus-distance 4) #:blades n))
      (define points
        (for/list ([k 4096])
          (match-define (list ox oy _ _ _ _) (kernel-ray camera 8 8 4.0 4.0 k))
          (cons (/ (- ox 1.0) 0.5) (/ (- oy 2.0) 0.5))))
      (for ([p points])
        ;; the distance along the normal of each side is at most that of the side
        (for ([side n])
          (define middle (/ (* 2 pi (+ side 1/2)) n))
          (check-true (<= (+ (* (car p) (sin middle)) (* (cdr p) (cos middle)))
                          (+ (cos (/ pi n)) 1e-14)))))
      ;; the mean squared radius of a regular polygon inscribed in the unit circle
      (check-= (mean (for/list ([p points]) (+ (sqr (car p)) (sqr (cdr p)))))
               (/ (+ 2 (cos (/ (* 2 pi) n))) 6) 0.002)
      (check-= (mean (map car points)) 0.0 0.004)
      (check-= (mean (map cdr points)) 0.0 0.004)))

  (test-case "the shutter: uniform between opening and closing; a moment"
    (define camera (Camera-look-at eye focus))
    (define (times open close)
      (for/list ([k 1024])
        (kernel-time (Camera-with camera #:shutter-open open #:shutter-close close) k)))
    (define some (times 0.25 0.75))
    (check-true (<= 0.25 (apply min some) (apply max some) 0.75))
    (check-= (mean some) 0.5 0.001)
    (check-= (mean (map sqr some)) (+ 0.25 1/48) 0.001)
    (check-equal? (times 0.5 0.5) (for/list ([k 1024]) 0.5)))

  ;; a picture of one pixel that looks along -z at (x, y, 0), almost without width
  (define (seen world x y #:camera-moves [moves #f])
    (define (camera-at x)
      (Camera-look-at (Float3 x y 10) (Float3 x y 0) #:vertical-field-of-view-degrees 1e-6))
    (define camera (if moves (Camera-moving (camera-at x) (camera-at (+ x moves))) (camera-at x)))
    (define-values (red green blue)
      (Image-pixel (render world camera #:width 1 #:height 1 #:samples 4096) 0 0))
    red)
  (define white (Emitter (Float3 1 1 1)))
  (define disk (Disk (Float3 0 0 0) (Float3 0 0 1) 1 white))
  (define (world-of shape) (World (list shape) '() (Float3 0 0 0)))
  ;; two nets of 2048 points and one edge or two: within 2 points of 4096
  (define tolerance (/ 2.0 4096))

  (test-case "a disk that moves by L covers a point at height y for the time chord / L"
    (for ([y '(0.0 0.6 0.96)] [length '(2.0 3.0 8.0)])
      (define moving
        (Moving disk (Transform-translate (* -0.5 length) 0 0)
                (Transform-translate (* 0.5 length) 0 0)))
      (check-= (seen (world-of moving) 0 y) (min 1.0 (/ (* 2 (sqrt (- 1 (* y y)))) length))
               tolerance)))

  (test-case "the same where the camera moves and the disk is at rest"
    (for ([y '(0.0 0.6)])
      (check-= (seen (world-of disk) -1.5 y #:camera-moves 3.0)
               (/ (* 2 (sqrt (- 1 (* y y)))) 3.0) tolerance)))

  (test-case "refused"
    (define-syntax-rule (check-refused name expression)
      (check-exn (lambda (e) (regexp-match? (string-append "^Camera[^\n]*" name "[^\n]*$")
                                            (exn-message e)))
                 (lambda () expression)))
    (define camera (Camera-look-at eye focus))
    (check-refused "blades" (Camera-with camera #:blades 2))
    (check-refused "shutter-close" (Camera-with camera #:shutter-open 0.5 #:shutter-close 0.25))
    (check-refused "shutter-open" (Camera-with camera #:shutter-open -1))
    (check-refused "height" (Camera-orthographic eye focus #:height 0))
    (check-refused "field-of-view-degrees" (Camera-fisheye eye focus #:field-of-view-degrees 361))
    (check-refused "lens-radius" (Camera-with (Camera-panoramic eye focus) #:lens-radius 1))))
