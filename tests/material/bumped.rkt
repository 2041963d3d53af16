#lang racket/base
;; Textures that drive roughness and bumps: level ones change nothing, slopes tilt the normal as they
;; should, and no light is made.
(module+ test
  (require rackunit racket/fixnum racket/flonum racket/string raytrace)

  (define white (Float3 1 1 1))
  (define black (Float3 0 0 0))
  (define red (Float3 0.8 0.2 0.1))
  (define green (Float3 0.1 0.7 0.3))
  (define (grey x) (Float3 x x x))
  (define (of-one x) (Checker (grey x) (CheckerUV (grey x) (grey x)) 0.3))

  (define camera (Camera-look-at (Float3 0 2 6) (Float3 0 0.5 0)))
  (define lamp (Sphere (Float3 2 5 3) 0.5 (Emitter (Float3 20 20 20))))
  (define (rendered shapes #:samples [samples 4] #:background [background (Float3 0.3 0.4 0.5)]
                    #:camera [camera camera] #:size [size '(24 . 14)])
    (render (World shapes '() background) camera #:width (car size) #:height (cdr size)
            #:samples samples #:integrator 'path))
  (define (picture-of materials)
    (Image-pixels
     (rendered (cons lamp
                     (for/list ([material materials] [k (in-naturals)])
                       (Sphere (Float3 (- (* 2 k) (length materials)) 0.5 0) 1 material))))))

  ;; --- roughness ---

  (test-case "a roughness texture of one grey gives the picture of that number, to the bit"
    (for ([x '(0.3 0.05 1 0)])
      (define (materials roughness)
        (list (RoughConductor roughness) (gold roughness) (RoughDielectric 1.5 roughness)
              (Metal red roughness) (Mix (silver roughness) (Lambertian red) 0.4)))
      (define textured (materials (of-one x)))
      ;; the book's metal without fuzz draws no samples, the textured one does
      (define (but-metal all) (if (zero? x) (append (list (car all) (cadr all) (caddr all)) (cddddr all)) all))
      (check-equal? (picture-of (but-metal textured)) (picture-of (but-metal (materials x))))))

  (test-case "a checker of two roughnesses is the one or the other, to the bit"
    (define (square roughness)
      (define world
        (World (list (Quad (Float3 0 0 0) (Float3 1 0 0) (Float3 0 1 0) (gold roughness))) '()
               (GradientSky (grey 0.1) white)))
      (lambda (x)
        (for/list ([seed 8])
          (World-ray-trace world (Ray (Float3 (- x 3) 0.5 3) (Float3 1 0 -1)) #:seed seed))))
    (define both (square (CheckerUV (grey 0.2) (grey 0.6) 2 1)))
    (check-equal? (both 0.25) ((square 0.2) 0.25))
    (check-equal? (both 0.75) ((square 0.6) 0.75))
    (check-not-equal? (both 0.25) ((square 0.6) 0.25)))

  ;; A picture has levels of its own: an alpha next to the one asked for, at most an eightieth off.
  (test-case "a picture of one grey comes close to that number: five standard errors and 1%"
    (define picture (ImageTexture (render (World '() '() (grey 0.31)) camera #:width 2 #:height 2
                                          #:samples 1)))
    (for ([material (list gold (lambda (roughness) (RoughDielectric 1.5 roughness)))])
      (define (mean roughness)
        (define image
          (rendered (list lamp (Sphere (Float3 0 0.5 0) 1 (material roughness))) #:samples 256))
        (define pixels (Image-pixels image))
        (/ (for/sum ([x (in-flvector pixels)]) x) (flvector-length pixels)))
      (check-= (/ (mean picture) (mean 0.31)) 1 0.01)))

  (test-case "a metal's albedo and fuzz by textures of their own"
    (define plain (picture-of (list (Metal red 0.4))))
    (check-equal? (picture-of (list (Metal (Checker red red) (of-one 0.4)))) plain)
    (check-not-equal? (picture-of (list (Metal (Checker red red) (of-one 0.5)))) plain))

  ;; --- bumps ---

  (define smooth
    (list (Lambertian red) (Mirror) (Metal red 0.2) (Plastic green) (Dielectric 1.5) (gold 0.2)
          (RoughDielectric 1.5 0.3) (Mix (Lambertian red) (Mirror) 0.4)
          (Lambertian (Checker red green 0.2))))

  (test-case "a level bump texture, or one of height 0, is no bump, to the bit"
    (define plain (picture-of smooth))
    (check-equal? (picture-of (for/list ([m smooth]) (Bumped m (of-one 0.4) 0.5))) plain)
    (check-equal? (picture-of (for/list ([m smooth]) (Bumped m (Noise black white 5) 0))) plain)
    (check-not-equal? (picture-of (for/list ([m smooth]) (Bumped m (Noise black white 5) 0.1)))
                      plain)
    (define mesh (teapot #:material (Plastic red)))
    (define bumped-mesh (teapot #:material (Bumped (Plastic red) (of-one 0.4) 0.5)))
    (check-equal? (Image-pixels (rendered (list lamp bumped-mesh)))
                  (Image-pixels (rendered (list lamp mesh)))))

  ;; A texture that rises along x by `slope` a unit, in [0, 1] near the origin.
  (define (ramp slope)
    (FunctionTexture (lambda (p u v) (grey (+ 0.5 (* slope (Float3-x p)))))))

  ;; No surface of the article's: paths are traced even where all else is an emitter.
  (define far-away (Sphere (Float3 0 -500 900) 1 (Lambertian red)))
  ;; What a mirror shows of a sky that tells directions apart.
  (define sky (GradientSky (Float3 0 0 0) (Float3 1 1 1)))
  (define (seen shape point toward)
    (Float3-x (World-ray-trace (World (list shape far-away) '() sky)
                               (Ray (Float3-subtract point toward) toward) #:seed 1)))
  ;; The sky by the height of the direction, from -1 to 1.
  (define (sky-at direction) (* 0.5 (+ 1 (Float3-y (Float3-normalized direction)))))
  (define (mirrored toward normal)
    (Float3-reflect (Float3-negate toward) (Float3-normalized normal)))

  (test-case "a slope on a plane is the tilted normal in closed form, to 1e-9"
    (for* ([slope '(0.1 -0.3 0.7)] [height '(0.5 -1)]
           [toward (list (Float3 0 -1 0.001) (Float3 0.4 -1 0.3) (Float3 -0.3 -1 -0.6))])
      (define material (Bumped (Mirror) (ramp slope) height))
      (define normal (Float3 (- (* slope height)) 1 0))
      (define out (mirrored toward normal))
      (for ([shape (list (Plane black (Float3 0 1 0) material)
                         (Quad (Float3 -1 0 1) (Float3 2 0 0) (Float3 0 0 -2) material)
                         (Disk black (Float3 0 1 0) 1 material)
                         (Box (Float3 -1 -1 -1) (Float3 1 0 1) material)
                         (Triangle (Float3 -3 0 3) (Float3 3 0 3) (Float3 0 0 -3) material)
                         (Mesh (flvector -3.0 0.0 3.0 3.0 0.0 3.0 0.0 0.0 -3.0) (fxvector 0 1 2)
                               #:material material))])
        (when (> (Float3-y out) 0)
          (check-= (seen shape (Float3 0.1 0 0.2) toward) (sky-at out) 1e-9
                   (format "~a of slope ~a, height ~a" shape slope height))))))

  (test-case "the texture turns and moves with an instance; a scale does not change the height"
    (define material (Bumped (Mirror) (ramp 0.4) 0.5))
    (define quad (Quad (Float3 -1 0 1) (Float3 2 0 0) (Float3 0 0 -2) material))
    (define toward (Float3 0.2 -1 0.1))
    ;; turned by 90 degrees about y, x goes to -z
    (define turned
      (Instance quad (Transform-compose (Transform-translate 3 2 1)
                                        (Transform-rotate (Float3 0 1 0) #:degrees 90))))
    (check-= (seen turned (Float3 3 2 1) toward) (sky-at (mirrored toward (Float3 0 1 0.2))) 1e-9)
    (define larger (Instance quad (Transform-scale 4 4 4)))
    (check-= (seen larger black toward) (sky-at (mirrored toward (Float3 -0.05 1 0))) 1e-9))

  (test-case "on a sphere: the gradient along the surface, to 1e-3"
    (define ball (Sphere black 1 (Bumped (Mirror) (ramp 0.4) 0.5)))
    (for ([n (map Float3-normalized (list (Float3 0 1 0.2) (Float3 0.3 0.8 0.4) (Float3 -0.5 1 0)))])
      (define gradient (Float3 0.2 0 0))
      (define along (Float3-subtract gradient
                                     (Float3-scale-by-scalar n (Float3-dot gradient n))))
      (define toward (Float3 0.1 -1 -0.1))
      (check-= (seen ball n toward) (sky-at (mirrored toward (Float3-subtract n along))) 1e-3)))

  (test-case "seen from behind, what is raised in front is a dent"
    (define plane (Plane black (Float3 0 1 0) (Bumped (Mirror) (ramp 0.3) 1)))
    (define toward (Float3 0.1 1 0))
    (check-= (seen plane black toward) (sky-at (mirrored toward (Float3 -0.3 1 0))) 1e-9))

  (test-case "a picture scaled by a power of two is the same, to the bit"
    (define (scaled s)
      (define (at x y z) (Float3 (* s x) (* s y) (* s z)))
      (Image-pixels
       (rendered (list (Sphere (at 2 5 3) (* s 0.5) (Emitter (Float3 20 20 20)))
                       (Sphere (at 0 0.5 0) s
                               (Bumped (Lambertian red) (Noise black white (/ 5.0 s)) (* s 0.1))))
                 #:camera (Camera-look-at (at 0 2 6) (at 0 0.5 0)))))
    (check-equal? (scaled 1.0) (scaled 1024.0))
    (check-equal? (scaled 1.0) (scaled 0.0009765625)))

  ;; A white furnace: no pixel is brighter than the light around, by more than its noise; and what is
  ;; lost at steep bumps is little. Samples are at most the sky's radiance for materials that weigh
  ;; every sample by at most 1.
  (test-case "in a furnace bumps make no light, and lose at most a tenth"
    (for ([material (list (Lambertian white) (Mirror) (Metal white 0.3) (Plastic white)
                          (Dielectric 1.5) (RoughConductor 0.3) (RoughDielectric 1.5 0.3))]
          [name '(lambertian mirror metal plastic dielectric rough-conductor rough-dielectric)])
      (define (ball material)
        (rendered (list (Sphere black 1 material)) #:samples 64 #:background white #:size '(16 . 16)
                  #:camera (Camera-look-at (Float3 0 0 8) black #:vertical-field-of-view-degrees 15)))
      (define (mean image)
        (define pixels (Image-pixels image))
        (/ (for/sum ([x (in-flvector pixels)]) x) (flvector-length pixels)))
      (define image (ball (Bumped material (Noise black white 4) 0.2)))
      (define plain (mean (ball material)))
      (check-true (<= (mean image) (+ plain 0.005)) (format "~a: ~a of ~a" name (mean image) plain))
      (check-true (> (mean image) (- plain 0.1)) (format "~a: ~a of ~a" name (mean image) plain))
      ;; single samples of microfacets, and long paths in glass after roulette, may weigh more than 1
      (unless (memq name '(dielectric rough-conductor rough-dielectric))
        (for ([x (in-flvector (Image-pixels image))])
          (check-true (<= x (+ 1 1e-2)) (format "~a: ~a" name x))))))

  (test-case "bumps allocate next to nothing: less than a box of 16 bytes a sample"
    (define (bytes samples)
      (define world
        (World (list (Sphere black 1 (Bumped (Plastic red) (Noise black white 5)))) '() sky))
      (define before (current-memory-use 'cumulative))
      (render world camera #:width 60 #:height 40 #:samples samples #:integrator 'path
              #:schedule 'sequential)
      (- (current-memory-use 'cumulative) before))
    (bytes 4)
    (check-true (< (/ (- (bytes 64) (bytes 16)) (* 48.0 60 40)) 16.0)))

  (test-case "bumps of bumps, inside emitters and interiors; what is refused"
    (define twice (Bumped (Bumped (Mirror) (ramp 0.2) 1) (ramp 0.3) 1))
    (define toward (Float3 0.1 -1 0))
    (define plane (Plane black (Float3 0 1 0) twice))
    (define expected
      (let* ([n (Float3-normalized (Float3 -0.3 1 0))])
        (mirrored toward (Float3-subtract n (Float3 0.2 0 0)))))
    (check-= (seen plane black toward) (sky-at expected) 1e-9)
    (define once (Bumped (Mirror) (ramp 0.3) 1))
    (define shown (seen (Plane black (Float3 0 1 0) once) black toward))
    (for ([material (list (Emitter black #:surface once) (Interior (Medium 0 white) once))])
      (check-= (seen (Plane black (Float3 0 1 0) material) black toward) shown 1e-9))
    (define-syntax-rule (check-refused name expression)
      (check-exn (lambda (e)
                   (and (exn:fail:contract? e)
                        (string-prefix? (exn-message e) (string-append name ": expected "))
                        (not (string-contains? (exn-message e) "\n"))))
                 (lambda () expression)))
    (check-refused "Bumped" (Bumped (Emitter white) (UVTexture)))
    (check-refused "Bumped" (Bumped (Interior (Medium 1 white)) (UVTexture)))
    (check-refused "Bumped" (Bumped (Mirror) (UVTexture) +inf.0))
    (check-refused "Bumped" (Bumped (Mirror) red))
    (check-refused "Mix" (Mix once (Mirror) 0.5))
    (check-refused "RoughConductor" (RoughConductor red))
    (check-refused "Metal" (Metal red 1.5)))

  (test-case "previews and the article's shading take a bumped material for what it is made of"
    (define (preview-of material)
      (Image-pixels (render (World (list (Sphere (Float3 0 0.5 0) 1 material))
                                   (list (DistantLight (Float3 1 2 1) white)) (grey 0.3))
                            camera #:width 24 #:height 14 #:integrator 'raster)))
    (for ([m (list (Lambertian red) (Lambertian (Checker red green 0.2)) (gold 0.2))])
      (check-equal? (preview-of (Bumped m (Noise black white 5))) (preview-of m)))))
