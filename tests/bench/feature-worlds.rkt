#lang racket/base
;; Worlds that differ from a plain one, 400 matte spheres under a sky, by one feature each.
(require raytrace "worlds.rkt")

(provide features feature-world feature-camera)

(define count 400)
(define grey (Lambertian (Float3 0.6 0.6 0.6)))
(define sky (GradientSky (Float3 1 1 1) (Float3 0.5 0.7 1)))
(define spheres (random-spheres count grey))

(define pinhole (front-camera count))
(define middle (Float3-add (Camera-eye pinhole) (Camera-forward pinhole)))

;; Every second sphere changed.
(define (half change)
  (for/list ([sphere (in-list spheres)] [k (in-naturals)])
    (if (even? k) (change sphere) sphere)))
(define (with-material material)
  (lambda (sphere) (Sphere (Sphere-point sphere) (Sphere-radius sphere) material)))
(define (world shapes [lights '()]) (World shapes lights sky))

(define (boxed sphere)
  (define side (* 0.8 (Sphere-radius sphere)))
  (define corner (Float3 side side side))
  (Box (Float3-subtract (Sphere-point sphere) corner) (Float3-add (Sphere-point sphere) corner) grey))
(define (moving sphere)
  (Moving sphere (Transform-identity) (Transform-translate 0.1 0 0)))

;; name -> world; made when asked for.
(define worlds
  (list
   (cons "nothing" (lambda () (world spheres)))
   (cons "a point light"
         (lambda () (world spheres (list (PointLight (Float3 4 20 25) (Float3 50 50 50))))))
   (cons "20 point lights"
         (lambda ()
           (world spheres (for/list ([k 20]) (PointLight (Float3 k 20 25) (Float3 5 5 5))))))
   (cons "a shining sphere"
         (lambda () (world (cons (Sphere (Float3 4 20 25) 2 (Emitter (Float3 9 9 9))) spheres))))
   (cons "a lamp in a group"
         (lambda ()
           (world (cons (Group (list (Sphere (Float3 4 20 25) 2 (Emitter (Float3 9 9 9)))))
                        spheres))))
   (cons "half of glass" (lambda () (world (half (with-material (Dielectric 1.5))))))
   (cons "half of rough metal" (lambda () (world (half (with-material (gold 0.3))))))
   (cons "half mixed of two"
         (lambda () (world (half (with-material (Mix grey (Lambertian (Float3 0.2 0.3 0.4)) 0.5))))))
   (cons "as many materials as spheres"
         (lambda ()
           (world (for/list ([sphere (in-list spheres)] [k (in-naturals)])
                    ((with-material (Lambertian (Float3 0.6 0.6 (/ k 1.0 count)))) sphere)))))
   (cons "a plane" (lambda () (world (cons (Plane (Float3 0 -1 0) (Float3 0 1 0) grey) spheres))))
   (cons "half boxes" (lambda () (world (half boxed))))
   (cons "all in a group" (lambda () (world (list (Group spheres)))))
   (cons "half moving" (lambda () (world (half moving))))
   (cons "a lens" (lambda () (world spheres)))))

(define features (map car worlds))
(define (feature-world name) ((cdr (assoc name worlds))))
(define (feature-camera name)
  (if (equal? name "a lens")
      (Camera-look-at (Camera-eye pinhole) middle #:vertical-field-of-view-degrees 40
                      #:lens-radius 0.05 #:focus-distance 10)
      pinhole))
