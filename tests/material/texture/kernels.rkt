#lang racket/base
;; Textures on materials and shapes: a texture of one colour is that colour to the bit; a texture
;; goes where its shape goes; what is refused.
(module+ test
  (require rackunit racket/flonum racket/string raytrace "support.rkt"
           "../../../private/render/transport.rkt")

  (define red (Float3 0.8 0.2 0.1))
  (define green (Float3 0.1 0.7 0.3))
  (define black (Float3 0 0 0))
  (define white (Float3 1 1 1))

  (define camera (Camera-look-at (Float3 0 2 6) (Float3 0 0.5 0)))
  (define lamp (Sphere (Float3 2 5 3) 0.5 (Emitter (Float3 20 20 20))))
  (define (picture-of . materials)
    (define balls
      (for/list ([material materials] [k (in-naturals)])
        (Sphere (Float3 (- (* 2 k) (length materials)) 0.5 0) 1 #:material material)))
    (define world (World (cons lamp balls) '() (Float3 0.3 0.4 0.5)))
    (Image-pixels (render world camera #:width 16 #:height 9 #:samples 4 #:integrator 'path)))

  (test-case "a texture of one colour gives the picture of that colour, to the bit"
    (for ([plain (list red (Float3 0.5 0.5 0.5))])
      (define texture (Checker plain plain))
      (define (materials color)
        (list (Lambertian color) (Plastic color) (Metal color) (Metal color 0.4) (Mirror color)
              (Mix (Lambertian color) (Plastic color) 0.3)
              (Emitter (Float3 0.1 0.1 0.1) #:surface (Lambertian color))))
      (check-equal? (apply picture-of (materials texture)) (apply picture-of (materials plain)))))

  (test-case "the article's surface, by its shading: the picture of the colour where a texture shows it"
    (define (picture . colors)
      (define world
        (World (for/list ([color colors] [k (in-naturals)])
                 (Sphere (Float3 (- (* 2 k) 1) 0.5 0) 1 #:material (Phong color #:reflectivity 0.2)))
               (list (DistantLight (Float3 1 2 1) white)) white))
      (Image-pixels (render world camera #:width 16 #:height 9 #:samples 4)))
    (check-equal? (picture (Checker red red 3) (CheckerUV green green)) (picture red green)))

  (test-case "a mix whose weight is a texture of one grey, nested ones too, to 1e-12"
    (define (grey x) (Checker (Float3 x x x) (Float3 x x x)))
    (define a (Lambertian (CheckerUV red green)))
    (define b (Plastic green))
    (define c (Mirror (Noise red white)))
    (define constant (picture-of (Mix (Mix a b 0.25) c 0.5) (Mix a (Mix b c 0.75) 0.125)))
    (define textured
      (picture-of (Mix (Mix a b (grey 0.25)) c (grey 0.5)) (Mix a (Mix b c (grey 0.75)) 0.125)))
    (for ([x (in-flvector constant)] [y (in-flvector textured)]) (check-= x y 1e-12)))

  ;; Radiance on a lone square under a white sky is its albedo, in every sample.
  (define (albedo material x y)
    (define world
      (World (list (Quad (Float3 0 0 0) (Float3 1 0 0) (Float3 0 1 0) material)) '() white))
    (components (World-ray-trace world (Ray (Float3 x y 9) (Float3 0 0 -1)))))

  (test-case "a mix weighed by black and white is one material or the other"
    (define mix (Mix (Lambertian red) (Lambertian green) (CheckerUV black white 2 1)))
    (check-true (same-color? (albedo mix 0.2 0.5) (components red) 1e-12))
    (check-true (same-color? (albedo mix 0.7 0.5) (components green) 1e-12)))

  (test-case "what a texture shows beyond an albedo is clamped, NaN is black"
    (define odd (FunctionTexture (lambda (p u v) (Float3 2 -1 +nan.0))))
    (check-equal? (albedo (Lambertian odd) 0.5 0.5) '(1.0 0.0 0.0))
    (check-equal? ((seen odd) 0.5 0.5) '(2.0 0.0 0.0)))

  (test-case "a function is given the point, u and v"
    (define given (FunctionTexture (lambda (p u v) (Float3 (Float3-x p) u v))))
    (check-true (same-color? ((seen given) 0.3 0.9) '(0.3 0.3 0.9) 1e-12)))

  (test-case "uv and gradients"
    (check-true (same-color? ((seen (UVTexture)) 0.3 0.9) '(0.3 0.9 0.0) 1e-12))
    (define (between s) (components (Float3-linear-interpolate red green s)))
    (check-true (same-color? ((seen (GradientTexture red green)) 0.3 0.9) (between 0.9) 1e-12))
    (define slanted (seen (GradientTexture red green (Float3 0.2 0 0) (Float3 0.6 0 0))))
    (check-true (same-color? (slanted 0.3 0.9) (between 0.25) 1e-12))
    (check-true (same-color? (slanted 0.1 0.9) (between 0) 1e-12))
    (check-true (same-color? (slanted 0.7 0.9) (between 1) 1e-12)))

  (test-case "a texture is attached to its shape: moved, turned, scaled, grouped and on its way"
    (define points
      (FunctionTexture (lambda (p u v) (Float3 (+ 5 (Float3-x p)) (+ 5 (Float3-y p)) (+ u v)))))
    (for ([texture (list (Noise red green 3) (CheckerUV red green 6) points)])
      (define quad (Quad (Float3 0 0 0.5) (Float3 1 0 0) (Float3 0 1 0) (shining texture)))
      (define there
        (Transform-compose (Transform-translate 3 -2 1) (Transform-rotate (Float3 0 0 1) 0.7)
                           (Transform-scale 2)))
      (define back (Transform-inverse there))
      (define look (looker quad))
      (define (check-moved . shapes)
        (define moved (apply looker shapes))
        (for* ([x '(0.13 0.52 0.91)] [y '(0.07 0.45 0.88)])
          (define at (Transform-point there (Float3 x y 0)))
          (check-true (same-color? (components (look x y))
                                   (components (moved (Float3-x at) (Float3-y at))) 1e-9))))
      (check-moved (Instance quad there))
      (check-moved (Group (list (Instance (Group (list quad)) there))))
      (check-moved (Instance (Instance quad (Transform-translate 1 2 3))
                             (Transform-compose there (Transform-translate -1 -2 -3))))
      (define moving (looker (Moving quad (Transform-translate 0 0 0) (Transform-translate 4 0 0))))
      (for ([time '(0 0.25 1)])
        (check-true (same-color? (components (look 0.3 0.6))
                                 (components (moving (+ 0.3 (* 4 time)) 0.6 time)) 1e-9)))))

  (test-case "every integrator sees what shines, and paths are lit by it"
    (define world
      (World (list (Sphere black 1 (Emitter (Checker white white) #:two-sided? #t
                                            #:surface (Lambertian (Checker red red)))))
             '() black))
    ;; inside a closed white shell of albedo a: 1 / (1 - a)
    (define pixel
      (render world (Camera-look-at black (Float3 0 0 1)) #:width 2 #:height 2 #:samples 4096
              #:integrator 'path))
    (define-values (r g b) (Image-pixel pixel 0 0))
    (check-= r 5 0.25)
    (check-= g 1.25 0.02))

  (define dots (render (World '() '() red) camera #:width 2 #:height 2 #:samples 1))
  (define textures
    (list (Checker red (Checker green red 2) 0.5) (CheckerUV red green) (ImageTexture dots)
          (Noise red green) (Turbulence red green) (Marble red green)
          (GradientTexture red green) (GradientTexture red green black white) (UVTexture)))
  (define shared-texture (car textures))
  (define world
    (World (list* lamp
                  (Sphere (Float3 0 3 0) 1 #:material (Mix (Mirror shared-texture) (Plastic green)
                                                           (Noise black white)))
                  (for/list ([texture textures] [k (in-naturals)])
                    (Sphere (Float3 (- k 4) 0 0) 0.5 #:material (Lambertian texture))))
           '() white))

  (test-case "textures travel to other places"
    (define back (message->value (value->message world)))
    (check-equal? (World-shapes back) (World-shapes world))
    (define (picture schedule)
      (Image-pixels (render world camera #:width 16 #:height 9 #:samples 4 #:schedule schedule
                            #:workers 2)))
    (check-equal? (picture 'places) (picture 'sequential))
    (check-exn #rx"cannot be sent to another place"
               (lambda ()
                 (value->message
                  (World (list (Sphere black 1 #:material
                                       (Lambertian (FunctionTexture (lambda (p u v) p)))))
                         '() black)))))

  (test-case "they print as what makes them"
    (define text (format "~v" (Lambertian (Checker red green 2))))
    (check-equal? text (string-append "(Lambertian (Checker (Float3 0.8 0.2 0.1) "
                                      "(Float3 0.1 0.7 0.3) 2.0))")))

  (test-case "bad arguments are refused with one line that names the constructor"
    (define-syntax-rule (check-refused name expression)
      (check-exn (lambda (e)
                   (and (exn:fail:contract? e)
                        (string-prefix? (exn-message e) (string-append name ": expected "))
                        (not (string-contains? (exn-message e) "\n"))))
                 (lambda () expression)))
    (check-refused "Checker" (Checker red green 0))
    (check-refused "Checker" (Checker (Float3 -1 0 0) green))
    (check-refused "CheckerUV" (CheckerUV red green +nan.0))
    (check-refused "CheckerUV" (CheckerUV red green 3 -2))
    (check-refused "ImageTexture" (ImageTexture dots 'cubic))
    (check-refused "ImageTexture" (ImageTexture dots #:wrap 'mirror))
    (check-refused "Noise" (Noise red green -1))
    (check-refused "Noise" (Noise red (Float3 +inf.0 0 0)))
    (check-refused "Turbulence" (Turbulence red green #:octaves 0))
    (check-refused "Marble" (Marble red green #:bands +inf.0))
    (check-refused "Marble" (Marble red green #:seed -1))
    (check-refused "perlin-noise" (perlin-noise red #:octaves 99))
    (check-refused "GradientTexture" (GradientTexture red green red))
    (check-refused "GradientTexture" (GradientTexture red green red red))
    (check-refused "Lambertian" (Lambertian (Float3 2 0 0)))
    (check-refused "Mix" (for/fold ([mix (Lambertian red)]) ([k 8])
                           (Mix mix (Mirror) (Noise red green))))))
