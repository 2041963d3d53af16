#lang racket/base
;; The last picture of Ray Tracing: The Rest of Your Life: the Cornell box with a glass ball.
;; raco raytrace scenes/cornell-glass.rkt -o cornell-glass.png
(require raytrace "parts/cornell.rkt")

(provide world camera settings)

(define ball (Sphere (Float3 190 90 190) 90 #:material (Dielectric 1.5 #:fresnel 'schlick)))

(define world (cornell-world (cons ball (tall-block white))))
