#lang racket/base
;; The path integrator against closed forms: every value comes from a render, 64 independent seeds
;; of one pixel each, and passes within 4.5 standard errors of their mean.
(require rackunit racket/math raytrace "measure.rkt")

(module+ test
  (test-case "a white Lambertian sphere in a furnace is invisible"
    (define world (World (list (Sphere black 1 (grey 1))) '() (Float3 1 1 1)))
    (check-radiance world (look-from (Float3 0 0 5) black) 1.0))

  (test-case "a glass ball in a furnace is invisible"
    (define world (World (list (Sphere black 1 (Dielectric 1.5))) '() (Float3 1 1 1)))
    (check-radiance world (look-from (Float3 0.3 0.2 5) (Float3 0.3 0.2 0)) 1.0))

  (test-case "A16: a lone matte sphere under the book's sky"
    ;; normal with y = -1/4, albedo 1/2: red of the gradient from white to (0.5 0.7 1)
    (define world
      (World (list (Sphere black 1 (grey 0.5))) '() (GradientSky (Float3 1 1 1) (Float3 0.5 0.7 1))))
    (define z (sqrt (- 1 (sqr 0.25))))
    (check-radiance world (look-from (Float3 0 -0.25 5) (Float3 0 -0.25 z)) 0.3958333333333333))

  (test-case "D03, D04: a point light in a closed matte sphere, all bounces"
    (define (inside albedo at intensity)
      (World (list (Sphere black 1 (grey albedo)))
             (list (PointLight at (Float3 intensity intensity intensity))) black))
    (check-radiance (inside 0.5 black pi) (look-from (Float3 0.2 0 0) (Float3 1 0.1 0)) 1.0)
    (check-radiance (inside 0.6 (Float3 0 0 0.5) 1)
                    (look-from black (Float3 1 0 0)) 0.4231373059015096))

  (test-case "D04 stopped after one bounce is its direct part"
    (define world
      (World (list (Sphere black 1 (grey 0.6)))
             (list (PointLight (Float3 0 0 0.5) (Float3 1 1 1))) black))
    (define image
      (render world (look-from black (Float3 1 0 0)) #:width 1 #:height 1 #:samples 4
              #:integrator 'path #:max-depth 1))
    (define-values (red green blue) (Image-pixel image 0 0))
    ;; (rho/pi) I cos / r^2 with r^2 = 5/4, cos = 1/r; the camera sees within 1e-8 of the point
    (check-= red (/ (* 0.6 (/ 1 (sqrt 1.25))) (* pi 1.25)) 1e-7))

  ;; A matte floor of albedo 1/2 at the origin: radiance = E / 2 pi.
  (define floor (Disk black (Float3 0 0 1) 50 (grey 0.5)))
  (define (floor-radiance light irradiance)
    (check-radiance (World (list floor light) '() black)
                    (look-from (Float3 0.4 -0.3 0.3) black)
                    (/ irradiance (* 2 pi))))
  (define shining (Emitter (Float3 1 1 1)))
  (define both (Emitter (Float3 1 1 1) #:two-sided? #t))

  (test-case "A02: a square light above"
    (floor-radiance (Quad (Float3 -1 -1 1) (Float3 0 2 0) (Float3 2 0 0) shining)
                    1.7408395027342063))
  (test-case "A01: a square light from below its corner"
    (floor-radiance (Quad (Float3 0 0 1) (Float3 0 1 0) (Float3 1 0 0) shining)
                    0.4352098756835516))
  (test-case "A05: a triangular light, two-sided"
    (floor-radiance (Triangle (Float3 1 0 2) (Float3 2 1.5 3) (Float3 -1 1 1.5) both)
                    0.21650809210405844))
  (test-case "A12: a disk light off the axis"
    (floor-radiance (Disk (Float3 1.5 0 1) (Float3 0 0 -1) 1 shining) 0.39676851439432764))
  (test-case "A10: a sphere light partly below the horizon"
    (define c 0.3)
    (floor-radiance (Sphere (Float3 (* 2 (sqrt (- 1 (* c c)))) 0 (* 2 c)) 1 shining)
                    0.24729181891384264)))
