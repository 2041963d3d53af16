#lang racket/base
;; The Cornell box of Ray Tracing: The Rest of Your Life with two matte blocks: the scene on which
;; every correct renderer agrees.
;; raco raytrace scenes/cornell-diffuse.rkt -o cornell-diffuse.png
(require raytrace "parts/cornell.rkt")

(provide world camera settings)

(define world (cornell-world (append (tall-block white) (block 165 -18 130 65 white))))
