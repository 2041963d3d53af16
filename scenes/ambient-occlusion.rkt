#lang racket/base
;; Ambient occlusion alone: no light but an even white sky, so only nearness is seen.
;; raco raytrace scenes/ambient-occlusion.rkt -o ambient-occlusion.png
(require raytrace)

(provide world camera settings)

(define plaster (Phong (Float3 0.92 0.90 0.86) #:specularity 0))

(define floor (Sphere (Float3 0 -1000 0) 1000 #:material plaster))

;; A pyramid of balls that touch: rows of 5, 4, 3, 2 and 1.
(define balls
  (for*/list ([level (in-range 5)]
              [row (in-range (- 5 level))]
              [column (in-range (- 5 level))])
    (define shift (/ (- 4 level) 2.0))
    (Sphere (Float3 (- column shift) (+ 0.5 (* level (sqrt 0.5))) (- row shift)) 0.5
            #:material plaster)))

(define world
  (World (cons floor balls) '() (Float3 1 1 1)
         #:ambient-samples 64 #:ambient-weighting 'cosine
         #:occlusion-falloff 'binary #:max-occlusion-distance 6))

(define camera
  (Camera-look-at (Float3 4.2 4.4 7.5) (Float3 0 1.25 0) #:vertical-field-of-view-degrees 34))

(define settings (hash 'size '(800 600) 'samples 4))
