#lang racket/base
;; What is probably a mistake in a scene: each kind is found, and no scene of the package raises an alarm.
(module+ test
  (require racket/list rackunit raytrace "../../private/command/scenes.rkt"
           "../../private/command/load.rkt")

  (define matte (Lambertian (Float3 0.5 0.5 0.5)))
  (define ball (Sphere (Float3 0 0 0) 1 #:material matte))
  (define floor (Plane (Float3 0 -1 0) (Float3 0 1 0) matte))
  (define sky (Float3 0.5 0.6 0.7))
  (define black (Float3 0 0 0))
  (define camera (Camera-look-at (Float3 0 1 6) (Float3 0 0 0)))

  ;; Exactly one problem, which is told in these words.
  (define (check-problem pattern world [camera camera])
    (define problems (World-problems world camera))
    (check-equal? (length problems) 1 (format "~s" problems))
    (check-regexp-match pattern (car problems))
    (check-false (regexp-match? #rx"\n" (car problems))))
  (define (check-no-problem world [camera camera])
    (check-equal? (World-problems world camera) '()))

  (test-case "good worlds"
    (check-no-problem (World (list ball floor) '() sky))
    (check-no-problem (World (list ball floor) (PointLight (Float3 3 3 3) (Float3 30 30 30)) black)))

  (test-case "no light"
    (check-problem #rx"^there is no light:" (World (list ball) '() black))
    (check-problem #rx"^there is no light:" (World (list ball) '() (GradientSky black black))))

  (test-case "a light inside a shape"
    (check-problem #rx"^the light [(]PointLight .* is inside [(]Sphere"
                   (World (list ball floor) (PointLight (Float3 0.1 0.2 0) (Float3 3 3 3)) black))
    (check-problem #rx"^the light [(]SpotLight .* is inside [(]Box"
                   (World (list (Box (Float3 -1 -1 -1) (Float3 1 1 1) #:material matte) floor)
                          (SpotLight (Float3 0 0.5 0) (Float3 0 1 0) (Float3 3 3 3) 1 0.5) sky))
    (check-problem #rx"^the light [(]Sphere .* is inside [(]Sphere"
                   (World (list ball (Sphere (Float3 0 0 0.2) 0.3 #:material (Emitter (Float3 5 5 5))))
                          '() sky))
    ;; glass lets light out, and a lamp in the room with the camera is where it should be
    (check-no-problem (World (list (Sphere (Float3 0 0 0) 1 #:material (Dielectric 1.5)) floor)
                             (PointLight (Float3 0.1 0.2 0) (Float3 30 30 30)) sky))
    (check-no-problem (World (list (Sphere (Float3 0 0 0) 100 #:material matte) ball)
                             (PointLight (Float3 0 9 0) (Float3 300 300 300)) black))
    ;; beside a shape, and in the hole of one
    (check-no-problem (World (list ball floor) (PointLight (Float3 0.9 0.9 0) (Float3 30 30 30)) black))
    (check-no-problem (World (list (Torus (Float3 0 0 0) (Float3 0 1 0) 1 0.2 #:material matte))
                             (PointLight (Float3 0 0 0) (Float3 3 3 3)) black)))

  (test-case "the camera inside a shape"
    (check-problem #rx"^the camera is inside [(]Sphere"
                   (World (list ball floor (Sphere (Float3 5 0 0) 1 #:material matte)) '() sky)
                   (Camera-look-at (Float3 0.2 0.1 0) (Float3 5 0 0)))
    ;; a room is no mistake
    (check-no-problem (World (list (Box (Float3 -9 -9 -9) (Float3 9 9 9) #:material matte) ball
                                   (Sphere (Float3 0 7 0) 1 #:material (Emitter (Float3 9 9 9))))
                             '() black)))

  (test-case "the camera looks away"
    (check-problem #rx"^the camera sees no shape: .*middle is at [(]Float3 0.0 0.0 0.0[)]$"
                   (World (list ball) '() sky) (Camera-look-at (Float3 0 0 6) (Float3 0 0 12)))
    (check-problem #rx"^there are no shapes" (World '() '() sky)))

  (test-case "a black and a white picture"
    (check-problem #rx"^the picture is black"
                   (World (list ball (Quad (Float3 -9 3 9) (Float3 18 0 0) (Float3 0 0 -18) #:material matte))
                          (DistantLight (Float3 0 1 0) (Float3 1 1 1)) black)
                   (Camera-look-at (Float3 0 1 3) (Float3 0 0 0)
                                   #:vertical-field-of-view-degrees 10))
    (check-problem #rx"^the picture is white: half of its pixels are above [0-9]+[.]"
                   (World (list floor ball) (PointLight (Float3 0 20 0) (Float3 1e6 1e6 1e6))
                          (Float3 30 30 30))))

  (test-case "samples that are no numbers"
    ;; irradiance overflows near the light
    (define problems
      (World-problems (World (list floor ball) (PointLight (Float3 1.5 -0.9 1) (Float3 1e307 1e307 1e307))
                             sky)
                      camera))
    (check-regexp-match #rx"^[0-9]+ of its samples are no numbers.* at column [0-9]+ and row"
                        (last problems)))

  (test-case "no scene of the package looks wrong"
    (check-true (> (length (package-scenes)) 10))
    (for ([path (in-list (package-scenes))])
      (define-values (world camera settings) (load-scene (scene-name path) path))
      (check-equal? (World-problems world camera
                                    #:integrator (hash-ref settings 'integrator 'auto)
                                    #:max-depth (hash-ref settings 'max-depth #f)
                                    #:aspect (apply / (hash-ref settings 'size '(640 360))))
                    '() (scene-name path)))))
