#lang racket/base
;; The article's scene: twenty random spheres, a warm sun, ambient occlusion, a blue sky.
;; raco raytrace scenes/seed.rkt -o seed.ppm
(require raytrace)

(provide world camera settings)

(define seed 2016)

(define spheres
  (for/list ([k (in-range 20)])
    (Sphere (Float3-random-point-in-sphere 10 #:seed seed #:index k)
            (+ 0.5 (Float3-x (Float3-random-color #:seed (+ seed 1) #:index k)))
            (Float3-random-color #:seed (+ seed 2) #:index k))))

(define sun (DistantLight (Float3-normalized (Float3 1 1 1)) (Float3 1 0.8 0.65)))

(define world (World spheres sun (Float3 0.45 0.65 1)))

(define camera
  (Camera-look-at (Float3 0 0 12) (Float3 0 0 0) (Camera-global-up) (/ 16 9) 1.35))

(define settings (hash 'size '(1920 1080) 'samples 1))
