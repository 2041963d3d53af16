#lang racket/base
;; The Cornell box with a block of aluminium and a matte one.
;; raco raytrace scenes/cornell-box.rkt -o cornell-box.png
(require raytrace "parts/cornell.rkt")

(provide world camera settings)

(define aluminium (Metal (Float3 0.8 0.85 0.88) 0.0))

(define world (cornell-world (append (tall-block aluminium) (block 165 -18 130 65 white))))
