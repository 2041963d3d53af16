#lang racket/base
;; Random rays among n spheres: through the hierarchy and by a linear scan of the same packed data.
(require raytrace racket/flonum racket/fixnum
         (only-in raytrace/private/world/world World-scene) raytrace/private/world/scene raytrace/private/world/trace
         raytrace/private/base/registers raytrace/private/base/scratch
         "worlds.rkt")

(provide scaling-row)

;; n -> (list µs a ray, µs a ray by scan or #f where that would take minutes, build seconds)
(define (scaling-row n)
  (define world (World (random-spheres n (Phong (Float3 0.5 0.5 0.5))) '() (Float3 1 1 1)))
  (collect-garbage)
  (define start (current-process-milliseconds))
  (define scene (World-scene world))
  (define build (/ (- (current-process-milliseconds) start) 1000.0))
  (define side (expt n 1/3))
  (define (microseconds trace! rays)
    (define r (make-flonum-registers))
    (define i (make-fixnum-registers))
    (define start (current-process-milliseconds))
    (for ([k (in-range rays)])
      (define from (Float3-random-color #:seed 31 #:index k))
      (define d (Float3-random-point-in-sphere 1 #:seed 32 #:index k))
      (put-scratch-ray! r (Float3-scale-by-scalar from side) (Float3-normalized d))
      (trace! scene r i))
    (/ (* 1000.0 (- (current-process-milliseconds) start)) rays))
  ;; what making the rays costs is measured by tracing nothing, and taken off
  (define rays 100000)
  (define overhead (microseconds void rays))
  (define (net time) (max 0.001 (- time overhead)))
  (list (net (microseconds Scene-nearest! rays))
        (and (<= n 10000)
             (let ([few (quotient 20000000 n)])
               (net (microseconds Scene-nearest-by-scan! (min rays few)))))
        build))
