#lang racket/base
;; Views, image planes and lenses against closed forms.

(module+ test
  (require racket/flonum racket/list racket/math rackunit "../../main.rkt")

  (test-case "G06: the view from a point as a matrix, to 1e-12 of its largest entry"
    (define view
      (Transform-inverse (Transform-look-at (Float3 1 3 2) (Float3 4 -2 8) (Float3 1 1 0))))
    (for ([found (append* (Transform-matrix-rows view))]
          [expected '(-0.5144957554275265 0.5144957554275265 0.6859943405700354 -2.400980191995124
                      0.7789240586062484 0.6149400462680908 0.12298800925361816 -2.869720215917757
                      -0.3585685828003181 0.5976143046671968 -0.7171371656006362 0.0)])
      (check-= found expected 3e-12)))

  ;; The solid angle between four directions, by the turns of its sides: their sum less 2 pi.
  (define (solid-angle directions)
    (define (angle-at before here after)
      (define (side other)
        (Float3-subtract other (Float3-scale-by-scalar here (Float3-dot other here))))
      (define-values (a b) (values (side before) (side after)))
      (atan (Float3-length (Float3-cross a b)) (Float3-dot a b)))
    (define corners (append (take-right directions 1) directions (take directions 1)))
    (- (for/sum ([before corners] [here (cdr corners)] [after (cddr corners)])
         (angle-at before here after))
       (* 2 pi)))

  (test-case "G08: a square image of 90 degrees is 2 pi / 3, whole and as a sum of pixels, 1e-12"
    (define camera
      (Camera-look-at (Float3 1 2 3) (Float3 -4 0 1) #:vertical-field-of-view-degrees 90 #:aspect 1))
    (define (pixel x y size)
      (solid-angle (for/list ([corner '((0 0) (1 0) (1 1) (0 1))])
                     (Ray-direction (Camera-ray camera (* size (+ x (car corner)))
                                                (* size (+ y (cadr corner))))))))
    (check-= (pixel 0 0 1.0) 2.0943951023931957 2e-12)
    (check-= (for*/sum ([x 16] [y 16]) (pixel x y 1/16)) 2.0943951023931957 2e-12))

  ;; A straight bright edge at a distance, rendered through a lens: one row of pixels, each `step`
  ;; wide on a film `film-distance` behind the lens. Row, middle in film units -> the profile as
  ;; (position, radiance) pairs.
  (define (edge-profile radius focus film-distance distance step)
    (define-values (columns big) (values 320 (* 1000.0 distance)))
    (define edge
      (Quad (Float3 0 (- big) (- distance)) (Float3 big 0 0) (Float3 0 (* 2 big) 0)
            (Emitter (Float3 1 1 1) #:two-sided? #t)))
    (define camera
      (Camera (Float3 0 0 0) (Float3 0 0 (- film-distance)) (Float3 (* 0.5 columns step) 0 0)
              (Float3 0 (* 0.5 step) 0) #:lens-radius radius #:focus-distance focus))
    (define picture
      (render (World (list edge) '() (Float3 0 0 0)) camera #:width columns #:height 1
              #:samples 1024 #:integrator 'path #:max-depth 0))
    (for/list ([k columns])
      (cons (* step (- (+ k 0.5) (* 0.5 columns))) (flvector-ref (Image-pixels picture) (* 3 k)))))

  ;; The diameter of the disk that such a profile is the blur by: four times the root of the second
  ;; moment of its slope, whose integral by parts is that of 2 |x| times what is on the wrong side.
  (define (blur-diameter profile)
    (define step (- (car (second profile)) (car (first profile))))
    (* 4.0
       (sqrt (for/sum ([entry profile])
               (define-values (x seen) (values (car entry) (cdr entry)))
               (* 2.0 step (abs x) (if (< x 0.0) seen (- 1.0 seen)))))))

  (define (check-blur profile diameter)
    (check-= (/ (blur-diameter profile) diameter) 1.0 0.003)
    ;; nothing is blurred farther, and most of it is
    (for ([entry profile])
      (define-values (x seen) (values (car entry) (cdr entry)))
      (cond
        [(> (abs x) (* 0.505 diameter)) (check-= seen (if (< x 0.0) 0.0 1.0) 1e-12)]
        [(< (abs x) (* 0.45 diameter)) (check-true (< 0.0 seen 1.0))])))

  (test-case "G11: 50 mm lens of 25 mm sharp at 2 m, an edge at 3 m: 0.2137 mm on the film, 0.3%"
    (define film-distance (/ 1.0 (- (/ 1.0 50.0) (/ 1.0 2000.0))))
    (check-blur (edge-profile 12.5 2000.0 film-distance 3000.0 0.001) 0.21367521367521367))

  (test-case "G12: 0.6 degrees of blur sharp at 10, an edge at 5: radius 0.05236 in focus, 0.3%"
    (define radius (* 10.0 (tan (degrees->radians 0.3))))
    (check-= radius 0.052360356057001275 1e-15)
    (check-blur (edge-profile radius 10.0 10.0 5.0 0.0005) (* 2 0.052360356057001275))))
