#lang racket/base
;; Mirrors: nine mirror balls around coloured ones, each seen in all the others.
;; raco raytrace scenes/mirrors.rkt -o mirrors.png
(require raytrace racket/math)

(provide world camera settings)

(define (mirror tint) (Phong (Float3 0 0 0) #:reflectivity tint #:specularity 0.8 #:shininess 500))

(define tints
  (list (Float3 0.95 0.95 0.95) (Float3 0.98 0.78 0.40) (Float3 0.95 0.64 0.54)))

(define ring
  (for/list ([k (in-range 9)])
    (define angle (* 2 pi (/ k 9.0)))
    (Sphere (Float3 (* 3.4 (cos angle)) 1 (* 3.4 (sin angle))) 1
            #:material (mirror (list-ref tints (remainder k 3))))))

(define middle
  (for/list ([k (in-range 5)])
    (define angle (+ 0.3 (* 2 pi (/ k 5.0))))
    (Sphere (Float3 (* 1.1 (cos angle)) 0.5 (* 1.1 (sin angle))) 0.5
            #:material (Phong (list-ref (list (Float3 0.8 0.1 0.1) (Float3 0.1 0.3 0.8)
                                              (Float3 0.9 0.6 0.1) (Float3 0.1 0.6 0.3)
                                              (Float3 0.6 0.2 0.6))
                                        k)))))

(define top (Sphere (Float3 0 2.35 0) 1.3 #:material (mirror (Float3 0.92 0.94 0.96))))

(define floor
  (Sphere (Float3 0 -2000 0) 2000
          #:material (Phong (Float3 0.25 0.27 0.30) #:specularity 0.2 #:reflectivity 0.15)))

(define world
  (World (append (list floor top) ring middle)
         (list (DistantLight (Float3 -0.5 1 0.6) (Float3 1.0 0.92 0.80)))
         (GradientSky (Float3 0.85 0.80 0.78) (Float3 0.15 0.32 0.75))
         #:ambient-samples 4 #:ambient-weighting 'cosine #:max-occlusion-distance 3
         #:mirror-bounces 12))

(define camera
  (Camera-look-at (Float3 0 4.6 9.4) (Float3 0 1.15 0) #:vertical-field-of-view-degrees 42))

(define settings (hash 'size '(800 500) 'samples 16))
