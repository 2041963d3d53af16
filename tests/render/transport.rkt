#lang racket/base
;; Worlds go to another place and come back equal, what was shared is shared, and a picture made
;; there has the same bits.
(module+ test
  (require racket/flonum racket/fixnum rackunit raytrace
           "../../private/render/transport.rkt")

  (define red (Lambertian (Float3 0.8 0.1 0.1)))
  (define square
    (Mesh (flvector -1. 0. -1. 1. 0. -1. 1. 0. 1. -1. 0. 1.) (fxvector 0 2 1 0 3 2)
          #:uvs (flvector 0. 0. 1. 0. 1. 1. 0. 1.) #:material red))
  (define (at x) (Transform-translate x 0 0))
  (define shapes
    (list (Instance square (at 1)) (Instance square (at 2) #:material (gold))
          (Group (list (Sphere (Float3 0 1 0) 1 (Metal (Float3 1 1 1) 0.2))
                       (Moving (Box (Float3 0 0 0) (Float3 1 1 1) red) (at 0) (at 1))))
          (Torus (Float3 0 1 2) (Float3 0 1 0) 1 0.25 (Dielectric 1.5))
          (Cone (Float3 3 0 0) 1 (Float3 3 2 0) (Plastic (Float3 0.5 0.5 0.9) 1.5))
          (Disk (Float3 0 5 0) (Float3 0 -1 0) 2 (Emitter (Float3 4 4 4)))
          (Plane (Float3 0 -1 0) (Float3 0 1 0) red)))
  (define world (World shapes '() (GradientSky (Float3 1 1 1) (Float3 0.5 0.7 1))))
  (define camera (Camera-look-at (Float3 0 3 9) (Float3 0 1 0) #:lens-radius 0.1))

  (define back (message->value (value->message shapes)))
  (check-eq? (Instance-shape (car back)) (Instance-shape (cadr back)))
  (check-eq? (Mesh-material (Instance-shape (car back))) (Plane-material (list-ref back 6)))
  (check-equal? (cddr back) (cddr shapes))
  (check-equal? (Mesh-triangles (Instance-shape (car back))) (Mesh-triangles square))

  (define (picture schedule)
    (Image-pixels (render world camera #:width 32 #:height 18 #:samples 4 #:schedule schedule
                          #:workers 2)))
  (check-equal? (picture 'places) (picture 'sequential))

  (define bump
    (DistanceShape (lambda (x y z) (- (sqrt (+ (* x x) (* y y) (* z z))) 1.0))
                   (Float3 -1 -1 -1) (Float3 1 1 1) red))
  (check-exn #rx"cannot be sent to another place"
             (lambda () (value->message (World (list bump) '() (Float3 0 0 0))))))
