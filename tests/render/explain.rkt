#lang racket/base
;; Explained pixels: they are the pixels of the picture to the bit, by every integrator and for worlds
;; of every kind, and the light they tell of adds up.
(module+ test
  (require racket/flonum racket/list rackunit raytrace
           (only-in "../../private/render/explain.rkt" Path Path-color Path-steps Path-film-x Vertex
                    Vertex? Vertex-lights Vertex-emission-weight Vertex-emitted Vertex-shape Vertex-t
                    Vertex-material Vertex-depth Vertex-point Vertex-onward Vertex-normal
                    Vertex-inside? Vertex-throughput Within? Within-depth Within-point Within-onward
                    LightSample-outcome LightSample-light
                    LightSample-weight LightSample-pdf LightSample-contribution
                    Miss? Miss-depth Miss-contribution Miss-color Onward-pdf Onward-direction)
           (prefix-in weekend: raytrace/scenes/weekend)
           (prefix-in cornell: raytrace/scenes/cornell-box)
           (prefix-in first: raytrace/scenes/first-light)
           (prefix-in many: raytrace/scenes/many-lights)
           (prefix-in sun: raytrace/scenes/sun-and-sky)
           (prefix-in globe: raytrace/scenes/globe))

  (define (pixel-of image x y) (call-with-values (lambda () (Image-pixel image x y)) Float3))

  ;; Explanations of scattered pixels against a picture of all of them, or of each as a crop.
  (define (check-same-pixels name world camera width height places . arguments)
    (define (same-arguments f . places)
      (keyword-apply f (map car arguments) (map cadr arguments) places
                     #:width width #:height height))
    (for ([place (in-list places)])
      (define explanation (same-arguments explain world camera (car place) (cadr place)))
      (define image
        (same-arguments (lambda (world camera #:width w #:height h #:samples [n 16]
                                 #:seed [s 0] #:integrator [i 'auto] #:max-depth [d #f])
                          (render world camera #:width w #:height h #:samples n #:seed s
                                  #:integrator i #:max-depth d
                                  #:crop (list (car place) (cadr place) 1 1)))
                        world camera))
      (with-check-info (['scene name] ['pixel place])
        (check-equal? (Explanation-color explanation) (pixel-of image 0 0))
        (define errors (Image-standard-error image))
        (check-equal? (and errors (for/list ([e (in-flvector errors)]) e))
                      (and (Explanation-standard-error explanation)
                           (components (Explanation-standard-error explanation))))
        (check-sums explanation))))

  (define (components v) (list (Float3-x v) (Float3-y v) (Float3-z v)))
  (define (sum colors) (for/fold ([sum '(0.0 0.0 0.0)]) ([c (in-list colors)]) (map + sum (components c))))

  ;; Sources and depths each add up to the pixel, and so do steps to their path: to 1e-9 of it, for they
  ;; are differences of sums.
  (define (check-sums explanation)
    (define color (components (Explanation-color explanation)))
    (define (check-near sum color)
      (for ([a (in-list sum)] [b (in-list color)]) (check-= a b (* 1e-9 (+ b 1e-6)))))
    (check-near (sum (map cdr (Explanation-sources explanation))) color)
    (check-near (sum (map cdr (Explanation-depths explanation))) color))

  ;; a lamp over a ball of smoke in a glass one, in fog
  (define misty
    (World (list (Quad (Float3 -5 0 5) (Float3 10 0 0) (Float3 0 0 -10) (Float3 0.5 0.5 0.5))
                 (Sphere (Float3 0 1 0) 1
                         #:material (Interior (Medium 2 (Float3 0.9 0.8 0.7) #:anisotropy 0.4)))
                 (Sphere (Float3 2 1 0) 1
                         #:material (Interior (Medium 1 (Float3 0.5 0.8 0.7)) (Dielectric 1.5)))
                 (Sphere (Float3 0 4 0) 0.5 #:material (Emitter (Float3 8 8 8))))
           (PointLight (Float3 3 3 3) (Float3 9 9 9)) (Float3 0.1 0.2 0.3)
           #:medium (Medium 0.05 (Float3 0.9 0.9 0.9))))
  (define down (Camera-look-at (Float3 0 2 4) (Float3 0 0 0)))

  (define places '((0 0) (31 17) (20 24) (50 11) (63 35)))

  (test-case "an explained pixel is the rendered pixel"
    (check-same-pixels "weekend" weekend:world weekend:camera 64 36 places '(#:samples 8))
    (check-same-pixels "cornell" cornell:world cornell:camera 64 36 places '(#:samples 8))
    (check-same-pixels "many lights" many:world many:camera 64 36 places '(#:samples 8))
    (check-same-pixels "first light" first:world first:camera 64 36 places '(#:samples 3))
    (check-same-pixels "first light" first:world first:camera 64 36 places
                       '(#:integrator path) '(#:samples 5))
    (check-same-pixels "sun and sky" sun:world sun:camera 64 36 places '(#:samples 6))
    (check-same-pixels "globe" globe:world globe:camera 64 36 places '(#:samples 6))
    (check-same-pixels "smoke and fog" misty down 64 36 places '(#:samples 6))
    (check-same-pixels "one sample" cornell:world cornell:camera 64 36 places '(#:samples 1))
    (check-same-pixels "another seed, few bounces" cornell:world cornell:camera 64 36 places
                       '(#:max-depth 1) '(#:samples 4) '(#:seed 7)))

  ;; --------------------------------------------------------------------------------------------

  (define black (Float3 0 0 0))
  (define white (Lambertian (Float3 0.5 0.5 0.5)))
  (define floor (Quad (Float3 -5 0 5) (Float3 10 0 0) (Float3 0 0 -10) #:material white))
  (define lamp (Sphere (Float3 0 3 0) 0.5 #:material (Emitter (Float3 8 8 8))))
  (define (steps-of explanation) (Path-steps (first (Explanation-paths explanation))))

  (test-case "what the paths tell: shape, parameter, point, normal, light, pdf and weight"
    (define world (World (list floor lamp) '() black))
    (define e (explain world down 20 20 #:width 41 #:height 41 #:samples 4))
    (define vertex (first (steps-of e)))
    (check-eq? (Vertex-shape vertex) floor)
    (check-equal? (Vertex-material vertex) white)
    (check-= (Float3-y (Vertex-normal vertex)) 1.0 1e-15)
    (check-= (Float3-y (Vertex-point vertex)) 0.0 1e-12)
    (check-equal? (Vertex-throughput vertex) (Float3 1 1 1))
    (check-false (Vertex-inside? vertex))
    (define sample (first (Vertex-lights vertex)))
    (check-eq? (LightSample-light sample) lamp)
    (check-eq? (LightSample-outcome sample) 'lit)
    ;; the sphere is seen under its cone alone: 1/pdf is the cone's solid angle
    (define sine (/ 0.5 (Float3-distance (Vertex-point vertex) (Float3 0 3 0))))
    (check-= (* (LightSample-pdf sample) 2 3.141592653589793 (- 1 (sqrt (- 1 (* sine sine))))) 1.0 1e-9)
    (check-true (< 0.5 (LightSample-weight sample) 1.0))
    (check-equal? (map car (Explanation-sources e)) (list lamp))
    (check-true (>= (Explanation-rays e) 2.0)))

  (test-case "a shadow, and a light without a size"
    (define sun (DistantLight (Float3 0 1 0) (Float3 1 1 1)))
    (define roof (Quad (Float3 -5 1 -1) (Float3 10 0 0) (Float3 0 0 -10) #:material white))
    (define (outcome shapes)
      (define e (explain (World shapes sun black) (Camera-look-at (Float3 0 0.8 4) (Float3 0 0 -2))
                         20 20 #:width 41 #:height 41 #:samples 2 #:integrator 'path))
      (define sample (first (Vertex-lights (first (steps-of e)))))
      (check-eq? (LightSample-light sample) sun)
      (check-equal? (LightSample-pdf sample) +inf.0)
      (LightSample-outcome sample))
    (check-eq? (outcome (list floor)) 'lit)
    (check-eq? (outcome (list floor roof)) 'shadowed))

  (test-case "past a cloud too the path is not told to meet what stops a shadow ray"
    (define roof (Quad (Float3 -5 4 5) (Float3 10 0 0) (Float3 0 0 -10) #:material white))
    (define cloud (Sphere (Float3 9 9 9) 1 (Interior (Medium 1 (Float3 0.5 0.5 0.5)))))
    (define world (World (list floor roof cloud) (PointLight (Float3 0 8 0) (Float3 50 50 50)) black))
    (define e (explain world (Camera-look-at (Float3 0 2 0.5) (Float3 0 0 0)) 4 4
                       #:width 9 #:height 9 #:samples 8 #:integrator 'path #:max-depth 3))
    (for* ([path (in-list (Explanation-paths e))]
           [vertices (in-value (filter Vertex? (Path-steps path)))])
      (check-eq? (Vertex-shape (first vertices)) floor)
      (check-equal? (map LightSample-outcome (Vertex-lights (first vertices))) '(shadowed))
      (for ([vertex (in-list (drop-right vertices 1))])
        (check-pred Vertex-onward vertex))))

  (test-case "what media scatter is a step with its bounce: points and directions lead to the next one"
    (define cloud (Interior (Medium 3 (Float3 0.9 0.9 0.9))))
    (define ground (Disk (Float3 0 -2 0) (Float3 0 1 0) 3 white))
    (define world (World (list (Sphere (Float3 0 0 0) 1 cloud) ground) '() (Float3 1 1 1)))
    (define e (explain world (Camera-look-at (Float3 0 0 5) (Float3 0 0 0)) 4 4
                       #:width 9 #:height 9 #:samples 32 #:integrator 'path))
    (check-sums e)
    (define scattered
      (for*/sum ([path (in-list (Explanation-paths e))] [step (in-list (Path-steps path))])
        (if (and (Within? step) (Within-onward step)) 1 0)))
    (check > scattered 32)
    (for ([path (in-list (Explanation-paths e))])
      (for/fold ([bounces 0] [from #f] [direction #f] #:result (void))
                ([step (in-list (Path-steps path))])
        (define-values (depth point onward)
          (cond
            [(Vertex? step) (values (Vertex-depth step) (Vertex-point step) (Vertex-onward step))]
            [(Within? step) (values (Within-depth step) (Within-point step) (Within-onward step))]
            [else (values (Miss-depth step) #f #f)]))
        (check-equal? depth bounces)
        (when (and from point direction)
          (define way (Float3-subtract point from))
          (check-= (Float3-dot way direction) (Float3-length way) 1e-9))
        (values (if onward (+ bounces 1) bounces) (or point from)
                (if onward (Onward-direction onward) direction)))))

  (test-case "a lamp seen directly, in a group, and the background"
    (define (source shape)
      (explain (World (list shape) '() (Float3 0.1 0.1 0.1)) (Camera-look-at (Float3 0 3 6) (Float3 0 3 0))
               20 20 #:width 41 #:height 41 #:samples 2))
    (for ([shape (in-list (list lamp (Group (list floor lamp))))])
      (define e (source shape))
      (check-equal? (Explanation-sources e) (list (cons shape (Float3 8 8 8))))
      (check-equal? (Explanation-depths e) (list (cons 0 (Float3 8 8 8)))))
    (define miss (explain (World '() '() (Float3 0.1 0.2 0.3)) down 0 0 #:width 4 #:height 4))
    (check-equal? (map car (Explanation-sources miss)) '(background))
    (check-true (Miss? (first (steps-of miss)))))

  (test-case "ambient light of the article's shading"
    (define e (explain (World (list (Sphere (Float3 0 0 0) 1)) '() (Float3 1 1 1)
                              #:ambient-samples 4)
                       (Camera-look-at (Float3 0 0 5) (Float3 0 0 0)) 20 20 #:width 41 #:height 41))
    (check-equal? (map car (Explanation-sources e)) '(ambient)))

  (test-case "as text: the pixel, its sources and the tree"
    (define text
      (format "~v" (explain (World (list floor lamp) '() black) down 20 20
                            #:width 41 #:height 41 #:samples 4)))
    (for ([part (in-list '("^pixel 20,20: " "\nstandard error " "\nwhere the light comes from\n"
                           "100 % [(]Sphere " "\n  hits [(]Quad " "\n    light [(]Sphere "
                           ", pdf [0-9.]+, weight 0[.][0-9]+: brings "
                           "\n    goes on to [(]|ends here"))])
      (check-regexp-match part text)))

  (test-case "bad arguments are told"
    (define world (World (list floor) '() black))
    (check-exn #rx"^explain: expected a whole number from 0 to 3 as x, given 4$"
               (lambda () (explain world down 4 0 #:width 4 #:height 4)))
    (check-exn #rx"^explain: expected a World as world, given 'w$" (lambda () (explain 'w down 4 0)))
    (check-exn #rx"expected one of" (lambda () (explain world down 0 0 #:integrator 'none)))))
