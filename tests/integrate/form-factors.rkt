#lang racket/base
;; Light from skies and squares onto matte squares against closed forms, by renders; passes within
;; 4.5 standard errors (see measure.rkt).
(require rackunit racket/math raytrace "measure.rkt")

(define white (Float3 1 1 1))

(module+ test
  (test-case "A17: a tilted matte plate under half a sky, on black ground"
    (define tilt (degrees->radians 50))
    (define normal (Float3 0 (cos tilt) (sin tilt)))
    (define plate (Disk (Float3 0 1 0) normal 1e-3 (grey 1)))
    (define ground (Plane black (Float3 0 1 0) (grey 0)))
    (check-radiance (World (list plate ground) '() white)
                    (look-from (Float3-add (Float3 0 1 0) normal) (Float3 0 1 0))
                    (/ 2.580484742999784 pi)))

  (test-case "A18: the overcast sky (1 + 2 sin(elevation)) / 3 over a level matte plate"
    ;; light adds up: that sky is 4/3 of one that grows from 0 below to 1 above, less 1/3 of a white
    ;; one; the plate has albedo 1 and shows the irradiance over pi
    (define plate (Disk black (Float3 0 1 0) 1 (grey 1)))
    (define (plate-under sky)
      (measure (World (list plate) '() sky) (look-from (Float3 0.1 1 0.2) black)
               #:samples 256))
    (define-values (growing growing-error) (plate-under (GradientSky (Float3 0 0 0) (Float3 1 1 1))))
    (define-values (even even-error) (plate-under white))
    (define error (sqrt (+ (expt (* 4/3 growing-error) 2) (expt (* 1/3 even-error) 2))))
    (check-= (* pi (- (* 4/3 growing) (* 1/3 even))) 2.443460952792061 (+ (* 4.5 pi error) 1e-12))
    (check-true (< error 0.005)))

  (test-case "A20: the direct light on the Cornell box's floor, near a corner"
    (define light (Quad (Float3 213 554 227) (Float3 130 0 0) (Float3 0 0 105)
                        (Emitter (Float3 15 15 15))))
    (define floor (Quad black (Float3 0 0 555) (Float3 555 0 0) (grey 0.73)))
    (check-radiance (World (list light floor) '() black)
                    (look-from (Float3 25 100 500) (Float3 20 0 520)) 0.0783832489736813
                    #:max-depth 1))

  ;; The mean of what the unit square on the floor reflects, from the middle of the cube above it.
  (define (mean-on-floor light)
    (define floor (Quad black (Float3 0 0 1) (Float3 1 0 0) (grey 1)))
    (values (World (list floor light) '() black)
            (Camera-look-at (Float3 0.5 0.5 0.5) (Float3 0.5 0 0.5) #:up (Float3 0 0 1)
                            #:vertical-field-of-view-degrees 90)))

  (test-case "A21: the form factor of opposite faces of a cube"
    (define-values (world camera)
      (mean-on-floor (Quad (Float3 0 1 0) (Float3 1 0 0) (Float3 0 0 1) (Emitter white))))
    (check-radiance world camera 0.19982489569838738 #:size 16 #:samples 16 #:seeds 32))

  (test-case "A22: of adjacent faces"
    (define-values (world camera)
      (mean-on-floor (Quad black (Float3 0 1 0) (Float3 0 0 1) (Emitter white))))
    (check-radiance world camera 0.20004377607540316 #:size 16 #:samples 16 #:seeds 32)))
