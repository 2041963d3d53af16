#lang racket/base
;; Cameras: axes, rays through corners, fitted pictures, lenses, refused arguments.

(module+ test
  (require racket/list racket/match rackunit "../../main.rkt" "../statistics.rkt"
           (only-in "../../private/world/camera.rkt" Camera-fitted) "camera-rays.rkt")

  (define uniform (seeded 1))
  (define (random-float3) (Float3 (uniform -5.0 5.0) (uniform -5.0 5.0) (uniform -5.0 5.0)))
  (define (nums v) (list (Float3-x v) (Float3-y v) (Float3-z v)))
  (define (check-near a b tolerance)
    (check-true (<= (Float3-distance a b) tolerance) (format "~a, not ~a" a b)))
  (define (plus . vectors) (for/fold ([sum (Float3 0 0 0)]) ([v vectors]) (Float3-add sum v)))

  (test-case "looking at a point: orthogonal axes of the lengths asked for, right-handed, top up"
    (for ([k 1000])
      (define-values (eye focus up) (values (random-float3) (random-float3) (random-float3)))
      (define-values (aspect zoom) (values (uniform 0.2 4.0) (uniform 0.2 4.0)))
      (match-define (Camera e forward right top lens distance)
        (Camera-look-at eye focus up aspect zoom))
      (check-equal? (list e lens) (list eye 0.0))
      (check-= distance (Float3-distance eye focus) 1e-14)
      (for ([axis (list forward right top)] [length (list zoom aspect 1.0)])
        (check-= (Float3-length axis) length 2e-15))
      (for ([a (list forward right top)] [b (list right top forward)])
        (check-= (Float3-dot (Float3-normalized a) (Float3-normalized b)) 0.0 5e-16))
      (check-near (Float3-cross (Float3-normalized right) top)
                  (Float3-negate (Float3-normalized forward)) 1e-15)
      (check-near (Float3-normalized forward) (Float3-normalized (Float3-subtract focus eye)) 1e-15)
      (check-true (> (Float3-dot top up) 0.0))))

  (test-case "corners: the eye's rays go forward, and right and up by the whole of both"
    (define camera (Camera-look-at (Float3 1 2 3) (Float3 -4 0 1) #:aspect 2.5 #:zoom 0.7))
    (match-define (Camera _ forward right up _ _) camera)
    (for* ([x '(0 1/2 1)] [y '(0 1/2 1)])
      (check-near (Camera-get-ray-direction camera x y)
                  (Float3-normalized (plus forward
                                           (Float3-scale-by-scalar right (- (* 2 x) 1))
                                           (Float3-scale-by-scalar up (- 1 (* 2 y)))))
                  4e-16)
      (check-equal? (Ray-point (Camera-ray camera x y)) (Float3 1 2 3))
      (check-equal? (Ray-direction (Camera-ray camera x y))
                    (Camera-get-ray-direction camera x y))))

  (test-case "the article's camera: axes by hand"
    (match-define (Camera _ forward right up _ _)
      (Camera-look-at (Float3 0 0 12) (Float3 0 0 0) (Camera-global-up) (/ 16 9) 1.35))
    (for ([axis (list forward right up)]
          [expected (list (Float3 0 0 -1.35) (Float3 (/ 16.0 9.0) 0 0) (Float3 0 1 0))])
      (check-near axis expected 3e-16)))

  (test-case "G07: the book's camera, one ray to 1e-12"
    (define camera
      (Camera-look-at (Float3 -2 2 1) (Float3 0 0 -1) #:up (Float3 0 1 0)
                      #:vertical-field-of-view-degrees 20 #:aspect 16/9))
    (for ([c (nums (Camera-get-ray-direction camera 0.25 0.75))]
          [expected '(0.42373226777508594 -0.6390841054139011 -0.6418897658114643)])
      (check-= c expected (* 1e-12 (abs expected)))))

  (test-case "fitted to a picture: the height stays, pixels are square; the kernel agrees"
    (define camera (Camera-look-at (Float3 1 2 3) (Float3 -4 0 1) #:aspect 2.5 #:zoom 0.7))
    (for ([size '((1920 1080) (33 77) (1 1) (100000 1))])
      (match-define (list width height) size)
      (define fitted (Camera-fitted camera (/ width height)))
      (check-equal? (Camera-up fitted) (Camera-up camera))
      (check-equal? (Camera-forward fitted) (Camera-forward camera))
      (check-= (/ (Float3-length (Camera-right fitted)) width)
               (/ (Float3-length (Camera-up fitted)) height) (/ 1e-15 height))
      (for ([k 20])
        (define-values (x y) (values (uniform 0.0 width) (uniform 0.0 height)))
        (match-define (list ox oy oz dx dy dz) (kernel-ray fitted width height x y k))
        (check-equal? (Float3 ox oy oz) (Float3 1 2 3))
        (check-near (Float3 dx dy dz)
                    (Camera-get-ray-direction fitted (/ x width) (/ y height)) 1e-15))))

  (test-case "a lens: every ray through a film point meets the others in the plane of focus"
    (define camera
      (Camera-look-at (Float3 3 1 -2) (Float3 0 0 0) #:zoom 1.3 #:aspect 2
                      #:lens-radius 0.4 #:focus-distance 7.5))
    (define eye (Camera-eye camera))
    (define axis (Float3-normalized (Camera-forward camera)))
    (for ([x '(0.0 200.0 133.7)] [y '(0.0 50.0 100.0)])
      (define sharp (Camera-get-ray-direction camera (/ x 200.0) (/ y 100.0)))
      (define meeting
        (Float3-add eye (Float3-scale-by-scalar sharp (/ 7.5 (Float3-dot sharp axis)))))
      (define squares
        (for/list ([k 1024])
          (match-define (list ox oy oz dx dy dz) (kernel-ray camera 200 100 x y k))
          (define-values (o d) (values (Float3 ox oy oz) (Float3 dx dy dz)))
          (define t (/ (- 7.5 (Float3-dot (Float3-subtract o eye) axis)) (Float3-dot d axis)))
          (check-near (Float3-add o (Float3-scale-by-scalar d t)) meeting 1e-14)
          (check-= (Float3-length d) 1.0 4e-16)
          (define aside (Float3-subtract o eye))
          (check-= (Float3-dot aside axis) 0.0 1e-15)
          (check-true (<= (Float3-length aside) (* 0.4 1.000000001)))
          (Float3-length-squared aside)))
      ;; uniform over the lens: the squared radius has mean R^2 / 2; 1024 points of a net hold 1%
      (check-= (mean squares) 0.08 0.0008)))

  (test-case "no lens: all samples start at the eye"
    (define camera (Camera-look-at (Float3 3 1 -2) (Float3 0 0 0)))
    (check-equal? (length (remove-duplicates
                           (for/list ([k 16]) (kernel-ray camera 64 36 10.5 20.5 k))))
                  1))

  (test-case "refused: one line that names the argument"
    (define-values (o z up) (values (Float3 0 0 0) (Float3 0 0 1) (Float3 0 1 0)))
    (define-syntax-rule (check-refused name expression)
      (check-exn (lambda (e)
                   (and (exn:fail:contract? e)
                        (regexp-match? (string-append "^Camera[^\n]*" name "[^\n]*$")
                                       (exn-message e))))
                 (lambda () expression)))
    (check-refused "focus" (Camera-look-at o o))
    (check-refused "eye" (Camera-look-at (Float3 +nan.0 0 0) z))
    (check-refused "focus" (Camera-look-at o (Float3 0 +inf.0 0)))
    (check-refused "up" (Camera-look-at o z z))
    (check-refused "up" (Camera-look-at o z (Float3 0 0 0)))
    (check-refused "up" (Camera-look-at o z (Float3 0 0 -5)))
    (check-refused "zoom" (Camera-look-at o z #:zoom 0))
    (check-refused "zoom" (Camera-look-at o z #:zoom +nan.0))
    (check-refused "aspect" (Camera-look-at o z #:aspect -1))
    (check-refused "vertical-field-of-view-degrees"
                   (Camera-look-at o z #:vertical-field-of-view-degrees 180))
    (check-refused "vertical-field-of-view-degrees"
                   (Camera-look-at o z #:vertical-field-of-view-degrees 0))
    (check-refused "lens-radius" (Camera-look-at o z #:lens-radius -0.1))
    (check-refused "focus-distance" (Camera-look-at o z #:lens-radius 1 #:focus-distance 0))
    (check-refused "forward" (Camera o (Float3 0 0 0) z up))
    (check-refused "eye" (Camera (Float3 0 +inf.0 0) z z up))))
