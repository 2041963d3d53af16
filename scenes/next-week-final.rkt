#lang racket/base
;; The last picture of Ray Tracing: The Next Week: everything the book teaches, in thin mist.
;; raco raytrace scenes/next-week-final.rkt -o next-week-final.png
(require raytrace "parts/land.rkt" "parts/random.rkt")

(provide world camera settings)

(define white (Lambertian (Float3 0.73 0.73 0.73)))

;; 400 columns of different height.
(define ground
  (for*/list ([row 20] [column 20])
    (define x (+ -1000 (* 100 row)))
    (define z (+ -1000 (* 100 column)))
    (Box (Float3 x 0 z) (Float3 (+ x 100) (random-between 1 101 (+ column (* 20 row))) (+ z 100))
         (Lambertian (Float3 0.48 0.83 0.53)))))

(define lamp (Quad (Float3 123 554 147) (Float3 300 0 0) (Float3 0 0 265) (Emitter (Float3 7 7 7))))

(define passing
  (Moving (Sphere (Float3 400 400 200) 50 #:material (Lambertian (Float3 0.7 0.3 0.1)))
          (Transform-identity)
          (Transform-translate 30 0 0)))

(define glass (Dielectric 1.5 #:fresnel 'schlick))

;; Glass around a blue medium: the book's subsurface scattering.
(define milk-glass (Interior (Medium 0.2 (Float3 0.2 0.4 0.9)) glass))

(define mist (Interior (Medium 0.0001 (Float3 1 1 1))))

(define globe (Instance (Sphere (Float3 0 0 0) 1 #:material (Lambertian land))
                        (Transform-compose (Transform-translate 400 200 400)
                                           (Transform-scale 100 100 100))))

(define foam
  (Instance
   (Group (for/list ([k 1000])
            (define (place axis) (random-between 0 165 k #:series axis))
            (Sphere (Float3 (place 1) (place 2) (place 3)) 10 #:material white)))
   (Transform-compose (Transform-translate -100 270 395)
                      (Transform-rotate (Float3 0 1 0) #:degrees 15))))

(define world
  (World (append ground
                 (list lamp
                       passing
                       (Sphere (Float3 260 150 45) 50 #:material glass)
                       (Sphere (Float3 0 150 145) 50
                               #:material (Metal (Float3 0.8 0.8 0.9) 1.0))
                       (Sphere (Float3 360 150 145) 70 #:material milk-glass)
                       (Sphere (Float3 0 0 0) 5000 #:material mist)
                       globe
                       (Sphere (Float3 220 280 300) 80
                               #:material (Lambertian (Marble (Float3 0 0 0) (Float3 1 1 1) #:bands 0.2)))
                       foam))
         '()
         (Float3 0 0 0)))

(define camera
  (Camera-look-at (Float3 478 278 -600) (Float3 278 278 0) #:vertical-field-of-view-degrees 40))

(define settings (hash 'size '(400 400) 'samples 64))
