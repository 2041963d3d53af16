#lang racket/base
;; Spheres under a sky, and a bump whose distance function does what the environment variable
;; RAYTRACE_TEST_FAULT says where a ray comes near its top.
(require raytrace)
(provide world camera settings start-again!)

(define (word) (getenv "RAYTRACE_TEST_FAULT"))
(define done '())
(define (start-again!) (set! done '()))
(define (once key act)
  (unless (member key done)
    (set! done (cons key done))
    (act)))

(define (distance x y z)
  (define near? (and (> y 0.9) (< (abs x) 0.2)))
  (when near?
    (case (word)
      [("always") (error "no distance here")]
      [("once") (once 'here (lambda () (error "no distance yet")))]
      [("exit") (exit 3)]
      [("stall") (once 'here (lambda () (unless (file-exists? (getenv "RAYTRACE_TEST_FILE"))
                                          (call-with-output-file (getenv "RAYTRACE_TEST_FILE") void)
                                          (let loop () (sleep 1) (loop)))))]
      [else (void)]))
  (- (sqrt (+ (* x x) (* y y) (* z z))) 1.0))

(define matte (Lambertian (Float3 0.7 0.5 0.3)))
(define world
  (World (list (DistanceShape distance (Float3 -1.1 -1.1 -1.1) (Float3 1.1 1.1 1.1) matte)
               (Sphere (Float3 0 -101 0) 100 (Lambertian (Float3 0.5 0.5 0.6)))
               (Sphere (Float3 2.2 0 0) 1 (Metal (Float3 0.8 0.8 0.8) 0.1)))
         '() (GradientSky (Float3 1 1 1) (Float3 0.4 0.6 1))))
(define camera (Camera-look-at (Float3 0 1 6) (Float3 0.5 0 0)))
(define settings (hash 'size '(64 36) 'samples 4))
