#lang racket/base
;; The Cornell box with a block of smoke and one of mist, as in Ray Tracing: The Next Week.
;; raco raytrace scenes/cornell-smoke.rkt -o cornell-smoke.png
(require raytrace "parts/cornell.rkt")

(provide world camera settings)

(define (filled-block height degrees x z medium)
  (Instance (Box (Float3 0 0 0) (Float3 165 height 165) (Interior medium))
            (Transform-compose (Transform-translate x 0 z)
                               (Transform-rotate (Float3 0 1 0) #:degrees degrees))))

(define smoke (Medium 0.01 (Float3 0 0 0)))
(define mist (Medium 0.01 (Float3 1 1 1)))

(define world
  (cornell-world (list (filled-block 330 15 265 295 smoke) (filled-block 165 -18 130 65 mist))
                 #:light (Quad (Float3 113 554 127) (Float3 330 0 0) (Float3 0 0 305)
                               (Emitter (Float3 7 7 7)))))
