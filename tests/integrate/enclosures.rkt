#lang racket/base
;; Closed rooms, plates and lit balls whose light is known in closed form, all bounces included.
;; Every value comes from renders and passes within 4.5 standard errors (see measure.rkt).
(require rackunit racket/math raytrace "measure.rkt")

(define white (Float3 1 1 1))

;; A sphere seen from inside that shines with 1 and scatters by the material.
(define (shining-room material)
  (World (list (Sphere black 1 (Emitter white #:two-sided? #t #:surface material))) '() black))
(define inside (look-from (Float3 0.3 0.1 -0.2) (Float3 -0.4 0.7 0.5)))

;; A camera far away that sees the disk of the unit sphere in the square just around it.
(define far 20000)
(define (orthographic-from direction)
  (Camera-look-at (Float3-scale-by-scalar direction far) black
                  #:vertical-field-of-view-degrees (radians->degrees (* 2 (atan (/ 1.0 far))))))

(module+ test
  (test-case "D01: a matte room that shines"
    (check-radiance (shining-room (grey 0.8)) inside 5.0))

  (test-case "D02: the same, stopped after n bounces"
    (for ([n '(0 1 8)] [expected '(1.0 1.5 1.99609375)])
      (check-radiance (shining-room (grey 0.5)) inside expected #:max-depth n)))

  (test-case "D08: a mirror room that shines, stopped after 50 bounces and not"
    (define mirror (Mirror (Float3 0.9 0.9 0.9)))
    (check-radiance (shining-room mirror) inside 9.953616023134119 #:max-depth 50)
    (check-radiance (shining-room mirror) inside 10.0))

  (test-case "D06: a grey ball shines in a concentric sphere"
    (define ball (Sphere black 0.5 (Emitter white #:surface (grey 0.3))))
    (define room (Sphere black 1 (grey 0.5)))
    (check-radiance (World (list ball room) '() black)
                    (look-from (Float3 0 0.7 0) (Float3 0.5 0.8 0.2)) 0.2127659574468085
                    #:samples 256))

  (test-case "D07: between infinite plates, one of them shining"
    (define top (Plane (Float3 0 1 0) (Float3 0 -1 0) (Emitter white #:surface (grey 0.5))))
    (define bottom (Plane black (Float3 0 1 0) (grey 0.8)))
    (define world (World (list top bottom) '() black))
    (define middle (Float3 0 0.5 0))
    (check-radiance world (look-from middle (Float3 0.2 1 0.1)) 1.6666666666666667)
    (check-radiance world (look-from middle (Float3 0.2 0 0.1)) 1.3333333333333333))

  (test-case "D18, D19: the phases of a matte ball in parallel light"
    ;; irradiance pi, so radiance is the cosine; the distance of the camera costs 1e-4 of the size
    (for ([degrees '(0 60)] [mean '(0.6666666666666666 0.4059985206961529)])
      (define angle (degrees->radians degrees))
      (define sun (DistantLight (Float3 (sin angle) 0 (cos angle)) (Float3 pi pi pi)))
      (define world (World (list (Sphere black 1 (grey 1))) sun black))
      (define-values (measured error)
        (measure world (orthographic-from (Float3 0 0 1)) #:size 64 #:samples 16 #:seeds 8
                 #:max-depth 1))
      (check-= (* 4/pi measured) mean (+ (* 4.5 4/pi error) 2e-4)))))

(define 4/pi (/ 4 pi))
