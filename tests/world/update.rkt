#lang racket/base
;; Worlds and cameras that differ a little from others.
(module+ test
  (require rackunit raytrace)

  (define ball (Sphere (Float3 0 0 0) 1))
  (define box (Box (Float3 1 1 1) (Float3 2 2 2)))
  (define sun (DistantLight (Float3 0 1 0) (Float3 1 1 1)))
  (define lamp (PointLight (Float3 0 3 0) (Float3 9 9 9)))
  (define world (World (list ball) sun (Float3 0.1 0.2 0.3) #:shadow-samples 3))

  (test-case "worlds"
    (check-equal? (World-add world box lamp)
                  (World (list ball box) (list sun lamp) (Float3 0.1 0.2 0.3) #:shadow-samples 3))
    (check-equal? (World-add world) world)
    (check-equal? (World-with-lights world lamp)
                  (World (list ball) lamp (Float3 0.1 0.2 0.3) #:shadow-samples 3))
    (check-equal? (World-with-lights world '()) (World-with-lights world (list)))
    (check-equal? (World-shapes (World-with-shapes world (list box))) (list box))
    ;; the ambient colour follows the background where it came from it
    (define sky (GradientSky (Float3 1 1 1) (Float3 0 0 1)))
    (check-equal? (World-with-background world sky)
                  (World (list ball) sun sky #:shadow-samples 3))
    (define own (World (list ball) sun (Float3 0.1 0.2 0.3) #:ambient-color (Float3 1 0 0)))
    (check-equal? (World-with-background own sky)
                  (World (list ball) sun sky #:ambient-color (Float3 1 0 0)))
    ;; the world itself has not changed
    (check-equal? (World-shapes world) (list ball))
    (check-exn exn:fail:contract? (lambda () (World-add world 'no)))
    (check-exn #rx"background" (lambda () (World-with-background world (Float3 -1 0 0)))))

  (define camera (Camera-look-at (Float3 0 0 5) (Float3 0 0 0) #:lens-radius 0.1))
  (define (near? a b) (< (Float3-distance a b) 1e-12))
  (define (check-near a b) (check-true (near? a b) (format "~v, not ~v" a b)))

  (test-case "orbiting: to the right, over it, and around another point"
    (check-near (Camera-eye (Camera-orbit camera 90)) (Float3 5 0 0))
    (check-near (Float3-normalized (Camera-forward (Camera-orbit camera 90))) (Float3 -1 0 0))
    (check-near (Camera-eye (Camera-orbit camera 0 90)) (Float3 0 5 0))
    (check-near (Camera-eye (Camera-orbit camera 90 90)) (Float3 0 5 0))
    (check-near (Camera-up (Camera-orbit camera 0 90)) (Float3 0 0 -1))
    (check-near (Camera-eye (Camera-orbit camera 180 #:around (Float3 1 0 5))) (Float3 2 0 5))
    (check-near (Camera-eye (Camera-orbit camera 360)) (Camera-eye camera))
    (define there (Camera-orbit (Camera-orbit camera 20 30) 17))
    (check-near (Camera-eye there) (Camera-eye (Camera-orbit camera 37 30)))
    ;; what is in the middle stays there, sharp; the view stays as wide, the horizon level
    (check-= (Float3-distance (Camera-eye there) (Float3 0 0 0)) 5.0 1e-12)
    (check-equal? (Camera-focus-distance there) 5.0)
    (check-= (Float3-length (Camera-forward there)) (Float3-length (Camera-forward camera)) 1e-12)
    (check-= (Float3-y (Camera-right there)) 0.0 1e-12)
    (check-equal? (Camera-lens-radius there) 0.1)
    (check-exn #rx"right-degrees" (lambda () (Camera-orbit camera +nan.0))))

  (test-case "dolly: forward, the focus stays where it is"
    (check-near (Camera-eye (Camera-dolly camera 2)) (Float3 0 0 3))
    (check-equal? (Camera-focus-distance (Camera-dolly camera 2)) 3.0)
    (check-equal? (Camera-focus-distance (Camera-dolly camera -2)) 7.0)
    (check-equal? (Camera-focus-distance (Camera-dolly camera 5)) 5.0)
    (check-equal? (Camera-forward (Camera-dolly camera 2)) (Camera-forward camera))
    (check-exn #rx"distance" (lambda () (Camera-dolly camera +inf.0))))

  (test-case "pan: sideways"
    (check-near (Camera-eye (Camera-pan camera 2)) (Float3 2 0 5))
    (check-near (Camera-eye (Camera-pan camera 0 -1)) (Float3 0 -1 5))
    (check-equal? (Camera-forward (Camera-pan camera 2 3)) (Camera-forward camera)))

  (test-case "a moving camera moves as a whole"
    (define moving (Camera-moving camera (Camera-look-at (Float3 1 0 5) (Float3 1 0 0))))
    (define turned (Camera-orbit moving 90))
    (check-equal? (Camera-pan (Camera-dolly turned 1) 1)
                  (Camera-moving (Camera-pan (Camera-dolly (Camera-orbit camera 90) 1) 1)
                                 (Camera-pan (Camera-dolly
                                              (Camera-orbit (Camera-look-at (Float3 1 0 5) (Float3 1 0 0))
                                                            90 #:around (Float3 0 0 0)) 1) 1)))))
