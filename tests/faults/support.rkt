#lang racket/base
;; What tests of interrupted renders share: a scene that takes a second or two, and its commands.
(provide small-scene small-words kill-command)
(require racket/system "../command/support.rkt")

;; Writes the scene: glass and a matte ball under a sky.
(define (small-scene folder)
  (write-scene
   folder "balls.rkt"
   (scene-text
    #:world (string-append
             "(World (list (Sphere (Float3 0 0 0) 1 (Lambertian (Float3 0.7 0.4 0.3)))"
             " (Sphere (Float3 1.5 0 1) 0.7 (Dielectric 1.5))"
             " (Plane (Float3 0 -1 0) (Float3 0 1 0) (Lambertian (Float3 0.5 0.5 0.5))))"
             " '() (GradientSky (Float3 1 1 1) (Float3 0.4 0.6 1)))"))))

(define small-words '("balls.rkt" "--size" "120x80" "--integrator" "path" "--max-depth" "8"))

(define (kill-command command) (signal-command command 'KILL))
