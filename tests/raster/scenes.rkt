#lang racket/base
;; Worlds with every kind of shape, for the tests of rasterization.
(require "../../main.rkt")

(provide raster-scenes all-shapes)

(define grey (Float3 0.6 0.6 0.6))
(define (at x y z . more) (apply Transform-compose (Transform-translate x y z) more))
(define turn (Transform-rotate (Float3 1 2 0.5) #:degrees 40))

(define all-shapes
  (list (Sphere (Float3 -3 1 0) 1 grey)
        (Box (Float3 -1.6 0 -0.6) (Float3 -0.4 1.4 0.6) grey)
        (Cylinder (Float3 0.6 0 0) (Float3 0.9 1.6 0.3) 0.5 grey)
        (Cylinder (Float3 0.2 2.2 0) (Float3 1.4 2.6 0.3) 0.3 grey #:caps? #f)
        (Cone (Float3 2.4 0 0) 0.7 (Float3 2.5 1.7 0.2) grey)
        (Cone (Float3 -1 2.4 0) 0.5 (Float3 -1.2 1.7 0.8) grey #:caps? #f)
        (Torus (Float3 -3 2.6 -0.5) (Float3 0.3 1 0.5) 0.8 0.25 grey)
        (Disk (Float3 2.6 2.6 -0.5) (Float3 0.4 0.3 1) 0.7 grey)
        (Quad (Float3 -4 0 -2) (Float3 8 0 0) (Float3 0 4 0.5) grey)
        (Triangle (Float3 3.4 0.2 0.4) (Float3 4.2 0.1 -0.2) (Float3 3.9 1.8 0.1) grey)))

(define solids
  (list (SolidDifference (Sphere (Float3 -1.5 0 0) 1.1 grey)
                         (Cylinder (Float3 -1.5 -2 0.4) (Float3 -1.5 2 0.6) 0.5 grey))
        (Instance (SolidIntersection (Box (Float3 -1 -1 -1) (Float3 1 1 1) grey)
                                     (Sphere (Float3 0 0 0) 1.3 grey))
                  (at 1.2 0 0 turn))
        (DistanceShape (lambda (x y z)
                         (- (sqrt (+ (* (- x 3.2) (- x 3.2)) (* y y) (* z z)))
                            0.7 (* 0.1 (sin (* 8.0 y)))))
                       (Float3 2.3 -1 -1) (Float3 4.1 1 1) grey #:lipschitz 1.8)
        (CustomShape (Float3 -4 -1 -0.01) (Float3 -3 1 0.01)
                     (lambda (origin direction t-max)
                       (define t (/ (- (Float3-z origin)) (Float3-z direction)))
                       (define x (+ (Float3-x origin) (* t (Float3-x direction))))
                       (define y (+ (Float3-y origin) (* t (Float3-y direction))))
                       (and (< 0.0 t t-max) (<= -4.0 x -3.0) (<= -1.0 y 1.0)
                            (list t (Float3 0 0 1))))
                     grey)))

(define pot (teapot #:tolerance 0.02))
(define copies
  (list (Instance pot (at -2.5 0 0 turn (Transform-scale 0.7)))
        (Instance pot (at 2.5 0 -1 (Transform-scale -0.8 0.7 0.6)) #:material (Mirror))
        (Instance (Group all-shapes) (at 0 -2 -6 (Transform-shear #:x-by-y 0.3)))
        (Moving (Group (list (Sphere (Float3 0 3 1) 0.8 grey) (Box (Float3 -1 0 1) (Float3 0 1 2))))
                (at 0 0 0) (at 1 0 0))))

(define plain (World all-shapes (DistantLight (Float3 1 2 3) (Float3 0.7 0.7 0.7))))
(define landscape
  (World (list (Plane (Float3 0 -0.3 0) (Float3 0.05 1 0) grey)
               (Plane (Float3 0 0 -40) (Float3 0.2 0.1 1) grey)
               (Sphere (Float3 0 -1000 0) 1000 grey)
               (Sphere (Float3 0 1 0) 1 grey) (Sphere (Float3 3 0.2 2) 0.25 grey))
         '() (GradientSky (Float3 1 1 1) (Float3 0.5 0.7 1))))

;; By name: a world and a camera.
(define raster-scenes
  (list
   (list "shapes" plain (Camera-look-at (Float3 1 2.5 9) (Float3 0 1.5 0) #:zoom 1.7))
   (list "shapes along parallel rays" plain
         (Camera-orthographic (Float3 3 4 9) (Float3 0 1.5 0) #:height 6))
   (list "from among the shapes" plain
         (Camera-look-at (Float3 0.1 1.2 1.8) (Float3 -2 0.9 -0.3) #:vertical-field-of-view-degrees 95))
   (list "solids, distances, users' shapes" (World solids)
         (Camera-look-at (Float3 0.5 2 7) (Float3 0 0 0) #:zoom 1.8))
   (list "copies, mirrored, sheared and moving" (World copies)
         (Camera-with (Camera-look-at (Float3 0 3 10) (Float3 0 1 0))
                      #:shutter-open 0.25 #:shutter-close 0.25))
   (list "planes to the horizon" landscape
         (Camera-look-at (Float3 1 1.2 6) (Float3 0 1 0) #:zoom 1.2))))
