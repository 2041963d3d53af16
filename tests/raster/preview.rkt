#lang racket/base
;; Previews: parts of a picture, faces, fog, coverage, shadings and textures, against closed forms.

(module+ test
  (require racket/flonum racket/list rackunit "../../main.rkt" "scenes.rkt")

  (define (pixel image x y)
    (define-values (r g b) (Image-pixel image x y))
    (list r g b))
  (define (draw world camera #:width [width 64] #:height [height 36] #:samples [samples 1]
                #:shading [shading 'phong] . more)
    (preview world camera #:width width #:height height #:samples samples #:shading shading))

  (define shapes (cadr (car raster-scenes)))
  (define shapes-camera (caddr (car raster-scenes)))

  (test-case "a crop is that part of the whole picture, exactly"
    (for ([shading '(phong gouraud flat wireframe hidden-lines depth)])
      (define whole (preview shapes shapes-camera #:width 96 #:height 54 #:shading shading))
      (define part (preview shapes shapes-camera #:width 96 #:height 54 #:shading shading
                            #:crop '(17 9 40 31)))
      (for* ([y 31] [x 40])
        (check-equal? (pixel part x y) (pixel whole (+ x 17) (+ y 9))))))

  (test-case "several shadings stand side by side, each a picture of its own"
    (define both (preview shapes shapes-camera #:width 96 #:height 40 #:shading '(flat depth)))
    (define flat (preview shapes shapes-camera #:width 48 #:height 40 #:shading 'flat))
    (define depth (preview shapes shapes-camera #:width 48 #:height 40 #:shading 'depth))
    (for* ([y 40] [x 48])
      (check-equal? (pixel both x y) (pixel flat x y))
      (check-equal? (pixel both (+ x 48) y) (pixel depth x y))))

  (test-case "render draws the same where the integrator is raster, and refuses a goal"
    (check-equal? (render shapes shapes-camera #:width 64 #:height 36 #:integrator 'raster)
                  (preview shapes shapes-camera #:width 64 #:height 36))
    (check-exn #rx"no noise"
               (lambda () (render shapes shapes-camera #:integrator 'raster #:error 0.1))))

  (define black (Float3 0 0 0))
  (define white (Lambertian (Float3 1 1 1)))
  (define ahead (Camera-look-at (Float3 0 0 4) (Float3 0 0 0) #:zoom 1))
  (define wall (Quad (Float3 -9 -9 0) (Float3 18 0 0) (Float3 0 18 0) white))

  (test-case "glass shows what is behind it, less what it reflects; 1e-3"
    (define red-wall (Quad (Float3 -9 -9 0) (Float3 18 0 0) (Float3 0 18 0)
                           (Lambertian (Float3 0.8 0.2 0.1))))
    (define pane (Quad (Float3 -1 -1 1) (Float3 2 0 0) (Float3 0 2 0) (Dielectric 1.5)))
    (define sky (Float3 0.2 0.4 1))
    (define sun (DistantLight (Float3 0 3 4) (Float3 5 5 5)))
    (define (middle shapes shading)
      (pixel (draw (World shapes sun sky) ahead #:shading shading) 32 18))
    (for ([shading '(phong gouraud flat)])
      (define wall-alone (middle (list red-wall) shading))
      (for ([glass (list (list red-wall pane) (list pane red-wall))])
        (for ([shown (middle glass shading)] [behind wall-alone] [mirrored '(0.2 0.4 1)])
          (check-= shown (+ (* 0.96 behind) (* 0.04 mirrored)) 1e-3)))
      ;; nothing behind but the sky: the sky itself; behind a second pane the wall still
      (for ([shown (middle (list pane) shading)] [expected '(0.2 0.4 1)])
        (check-= shown expected 1e-3)))
    (define edge (pixel (draw (World (list red-wall pane) sun sky) ahead) 2 2))
    (check-equal? edge (pixel (draw (World (list red-wall) sun sky) ahead) 2 2)))

  (test-case "hidden lines: all lines where nothing hides, none of those behind a surface"
    (define (lit image)
      (for/sum ([y (Image-height image)] #:when #t [x (Image-width image)])
        (if (> (apply + (pixel image x y)) 0) 1 0)))
    (define tilted (Quad (Float3 -1 -1 0.5) (Float3 2 0.3 -1) (Float3 0.2 2 -0.7) white))
    (define (lines shapes shading)
      (preview (World shapes (list) black) ahead #:width 384 #:height 216 #:samples 1
               #:shading shading))
    (check-equal? (lines (list tilted) 'hidden-lines) (lines (list tilted) 'wireframe))
    (define wires (lines (list (Sphere (Float3 0 0 0) 1 white)) 'wireframe))
    (define seen (lines (list (Sphere (Float3 0 0 0) 1 white)) 'hidden-lines))
    ;; a ball's front has about half of its lines, and no sample that the wires have not
    (check-true (< (* 0.3 (lit wires)) (lit seen) (* 0.95 (lit wires))))
    (for* ([y 216] [x 384])
      (when (> (apply + (pixel seen x y)) 0)
        (check-true (> (apply + (pixel wires x y)) 0))))
    ;; a box: its corner nearest to the viewer is seen, the one farthest away is not
    (define camera (Camera-look-at (Float3 2 1.5 4) (Float3 0 0 0)))
    (define box (Box (Float3 -1 -1 -1) (Float3 1 1 1) white))
    (define (near-corner? corner shading)
      (define image
        (preview (World (list box) '() black) camera #:width 160 #:height 90 #:shading shading))
      (define at (Camera-project camera corner #:width 160 #:height 90))
      (for*/or ([dy '(-1 0 1)] [dx '(-1 0 1)])
        (> (apply + (pixel image (+ dx (inexact->exact (floor (Float3-x at))))
                           (+ dy (inexact->exact (floor (Float3-y at))))))
           0)))
    (check-true (near-corner? (Float3 1 1 1) 'hidden-lines))
    (check-true (near-corner? (Float3 -1 -1 -1) 'wireframe))
    (check-false (near-corner? (Float3 -1 -1 -1) 'hidden-lines))
    ;; a wall in front hides everything
    (define front (Quad (Float3 -9 -9 2) (Float3 18 0 0) (Float3 0 18 0) white))
    (check-equal? (lines (list (Sphere (Float3 0 0 0) 0.5 white) front) 'hidden-lines)
                  (lines (list front) 'wireframe)))

  (test-case "light on a wall: irradiance over pi; the article's without pi; 1e-12"
    (define sun (DistantLight (Float3 0 3 4) (Float3 5 5 5)))
    (for ([shading '(phong gouraud flat)])
      (check-= (car (pixel (draw (World (list wall) sun black) ahead #:shading shading) 32 18))
               (/ 4 3.141592653589793) 1e-12)
      (check-= (car (pixel (draw (World (list (Quad (Float3 -9 -9 0) (Float3 18 0 0) (Float3 0 18 0)
                                                    (Phong (Float3 0.5 0.5 0.5) 0)))
                                        sun black)
                                 ahead #:shading shading) 32 18))
               2.0 1e-12))
    (define lamp (PointLight (Float3 0 0 2) (Float3 8 8 8)))
    (check-= (car (pixel (draw (World (list wall) lamp black) ahead #:width 65 #:height 37) 32 18))
             (/ 2 3.141592653589793) 1e-12))

  (test-case "fog: exp(-density distance) of the surface is left; the background stays"
    (define world (World (list (Quad (Float3 -1 -1 0) (Float3 2 0 0) (Float3 0 2 0)
                                     (Emitter (Float3 1 1 1))))
                         '() (Float3 0.25 0.5 0.75)))
    (define image (preview world ahead #:width 65 #:height 37 #:samples 1 #:fog-density 0.3
                           #:fog-color (Float3 0 1 0)))
    (check-= (car (pixel image 32 18)) (exp (* -0.3 4)) 1e-12)
    (check-= (cadr (pixel image 32 18)) 1.0 1e-12)
    (check-equal? (pixel image 1 1) '(0.25 0.5 0.75)))

  (test-case "faces: outsides, insides or both, of triangles, planes and cast shapes"
    (define (hits shape faces)
      (define image (preview (World (list shape)) ahead #:width 64 #:height 36 #:samples 1
                             #:shading 'depth #:faces faces))
      (for*/sum ([y 36] [x 64]) (if (zero? (car (pixel image x y))) 0 1)))
    (define mirrored (Instance wall (Transform-scale -1 1 1)))
    (for ([shape (list wall mirrored (Plane (Float3 0 0 0) (Float3 0 0 1))
                       (Disk (Float3 0 0 0) (Float3 0 0 1) 2)
                       (CustomShape (Float3 -2 -2 0) (Float3 2 2 0)
                                    (lambda (o d most)
                                      (define t (/ (- (Float3-z o)) (Float3-z d)))
                                      (and (< 0 t most) (list t (Float3 0 0 1))))))])
      (check-true (positive? (hits shape 'both)))
      (check-equal? (hits shape 'front) (hits shape 'both))
      (check-equal? (hits shape 'back) 0))
    (define ball (Sphere (Float3 0 0 0) 1))
    (check-equal? (hits ball 'front) (hits ball 'both))
    (check-equal? (hits ball 'back) (hits ball 'both)))

  (test-case "coverage: the mean over a picture is the part of it that is covered"
    ;; the quad fills x from -1 to 0.3 of the picture's half width, at distance 4
    (define aspect 16/9)
    (define quad (Quad (Float3 (* -8 aspect) -9 0) (Float3 (* (+ 8 (* 4 0.3)) aspect) 0 0)
                       (Float3 0 18 0) (Emitter (Float3 1 1 1))))
    (for ([samples '(4 16 64)])
      (define image (preview (World (list quad) '() black) ahead #:width 64 #:height 36
                             #:samples samples))
      (define mean (/ (for/sum ([v (in-flvector (Image-pixels image))]) v) (* 3 64 36)))
      ;; within half a column of samples
      (check-= mean 0.65 (/ 0.6 64 samples))))

  (test-case "a texture is seen where the shape's texture coordinates put it"
    (define checked
      (Quad (Float3 -1 -1 0) (Float3 2 0 0) (Float3 0 2 0)
            (Emitter (FunctionTexture (lambda (point u v) (Float3 u v 0.0))))))
    (define image (preview (World (list checked) '() black) ahead #:width 64 #:height 36 #:samples 1))
    (for* ([y '(15 18 20)] [x '(30 32 34)])
      (define-values (px py)
        (values (* 4 16/9 (- (/ (* 2 (+ x 0.5)) 64) 1)) (* 4 (- 1 (/ (* 2 (+ y 0.5)) 36)))))
      (check-= (car (pixel image x y)) (/ (+ px 1) 2) 1e-12)
      (check-= (cadr (pixel image x y)) (/ (+ py 1) 2) 1e-12)))

  (test-case "every shading draws every scene: finite, none negative, and not nothing"
    (for* ([scene raster-scenes] [shading '(phong gouraud flat toon wireframe hidden-lines)])
      (define image (draw (cadr scene) (caddr scene) #:samples 2 #:shading shading))
      (for ([v (in-flvector (Image-pixels image))]) (check-true (<= 0.0 v 1e6)))
      (check-true (> (length (remove-duplicates (for*/list ([y 36] [x 64]) (pixel image x y)))) 2)
                  (format "~a ~a" (car scene) shading))))

  (test-case "render with the integrator raster is preview, to the bit, whatever the shading"
    (for ([shading '(phong flat normals (toon depth))])
      (check-equal? (Image-pixels (render shapes ahead #:integrator 'raster #:shading shading
                                          #:width 64 #:height 36))
                    (Image-pixels (preview shapes ahead #:shading shading #:width 64 #:height 36))
                    (format "~a" shading))))

  (test-case "an empty world is its background; what is wrong is refused"
    (check-equal? (pixel (draw (World '() '() (Float3 0.1 0.2 0.3)) ahead) 5 5) '(0.1 0.2 0.3))
    (check-equal? (pixel (draw (World '() '() (Float3 0.1 0.2 0.3))
                               (Camera-fisheye (Float3 0 0 4) (Float3 0 0 0))) 5 5)
                  '(0.1 0.2 0.3))
    (check-exn #rx"shading" (lambda () (draw shapes ahead #:shading 'what)))
    (check-exn #rx"samples" (lambda () (draw shapes ahead #:samples 65)))
    (check-exn #rx"faces" (lambda () (preview shapes ahead #:faces 'left)))
    (check-exn #rx"tolerance" (lambda () (preview shapes ahead #:tolerance 0)))
    (check-exn #rx"fog-density" (lambda () (preview shapes ahead #:fog-density -1)))))
