#lang racket/base
;; Mesh files as scenes: the mesh stands on the floor, 2 units large, in the middle and in sight; what
;; cannot be shown is one line.
(module+ test
  (require racket/file rackunit raytrace "support.rkt" "../../private/command/studio.rkt"
           "../../private/command/needs.rkt" (only-in "../read/sphere-files.rkt" write-sphere))

  (define cube
    (string-append
     "v 10 5 -3\nv 14 5 -3\nv 14 7 -3\nv 10 7 -3\nv 10 5 -2\nv 14 5 -2\nv 14 7 -2\nv 10 7 -2\n"
     "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n"))

  (call-with-folder
   (lambda (folder)
     (define (file name text)
       (define path (build-path folder name))
       (display-to-file text path)
       path)
     (define path (file "cube.obj" cube))
     (define-values (world camera settings) (load-studio path #f))
     ;; 4 x 2 x 1 becomes 2 x 1 x 1/2: straight down on the middle the top is 1 above the floor
     (define (height x z)
       (define hit (World-nearest-hit world (Ray (Float3 x 3 z) (Float3 0 -1 0))))
       (Float3-y (Intersection-point hit)))
     (check-= (height 0 0) 1 1e-12)
     (check-= (height 0.99 0.24) 1 1e-12)
     (check-= (height 1.01 0) 0 1e-12)
     (check-= (height 0 0.26) 0 1e-12)
     ;; the middle of the picture shows the mesh
     (define image (render world camera #:width 1 #:height 1 #:samples 1 #:integrator 'depth))
     (define-values (depth green blue) (Image-pixel image 0 0))
     (check-true (< 3 depth 12) (format "~a" depth))
     (check-equal? (map cdr (filter (lambda (need) (member (car need) '("lights sampled" "lens")))
                                    (scene-needs world camera 'path)))
                   '("3" "skipped: a pinhole"))
     (check-exn #rx"nothing.obj:2: expected at least one face with an area"
                (lambda () (load-studio (file "nothing.obj" "v 0 0 0\n") #f)))
     (check-exn #rx"bad.obj:1: expected a number for z"
                (lambda () (load-studio (file "bad.obj" "v 0 0 x\n") #f)))
     ;; while a large file is read the part of it is shown, where that is wanted, and cleared
     (define large (build-path folder "large.obj"))
     (write-sphere 'obj-plain 100 large)
     (define (shown show?)
       (define out (open-output-string))
       (parameterize ([current-error-port out]) (load-studio large show?))
       (get-output-string out))
     (check-regexp-match #px"^(\r[0-9]+%[^\r]*\e\\[K)+\r\e\\[J$" (shown #t))
     (check-equal? (shown #f) ""))))
