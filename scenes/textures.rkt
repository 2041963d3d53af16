#lang racket/base
;; Textures that drive more than colour: hammered copper and orange peel by bumps, glass and steel that
;; are polished and blasted in turn by roughness, on rippled tiles.
;; raco raytrace scenes/textures.rkt -o textures.png
(require raytrace)

(provide world camera settings)

(define black (Float3 0 0 0))
(define white (Float3 1 1 1))
(define (grey x) (Float3 x x x))
(define (ball x radius material) (Sphere (Float3 x radius 0) radius #:material material))

(define hammered (Bumped (copper 0.12) (Noise black white #:scale 5) #:height 0.09))
(define peel (Bumped (Plastic (Float3 0.85 0.32 0.03)) (Noise black white #:scale 26) #:height 0.012))
(define etched (RoughDielectric 1.5 #:roughness (CheckerUV (grey 0) (grey 0.35) 16 8)))
(define blasted (RoughConductor (CheckerUV (grey 0.04) (grey 0.4) 24 12) #:color (grey 0.8)))

;; Tiles with soft edges, a unit wide: low in the joints, and rippled a little.
(define (edge x) (min 1 (* 16 (abs (- x (round x))))))
(define tile-height
  (FunctionTexture
   (lambda (point u v)
     (define-values (x z) (values (Float3-x point) (Float3-z point)))
     (grey (+ (* 0.8 (min (edge x) (edge z)))
              (* 0.1 (+ 1 (perlin-noise (Float3 (* 3 x) 0 (* 3 z))))))))))
(define tiles
  (Bumped (Plastic (Checker (Float3 0.24 0.34 0.4) (Float3 0.6 0.62 0.6) #:size 1)) tile-height
          #:height 0.05))

(define world
  (World (list (Plane (Float3 0 0 0) (Float3 0 1 0) #:material tiles)
               (ball -3.2 1 hammered) (ball -1 0.9 peel) (ball 1.1 0.9 etched) (ball 3.3 1 blasted)
               (Sphere (Float3 -5 9 6) 1.5 #:material (Emitter (Float3 24 22 19))))
         '()
         (GradientSky (Float3 0.55 0.6 0.68) (Float3 0.1 0.18 0.32))))

(define camera
  (Camera-look-at (Float3 0 3 9.5) (Float3 0 0.7 0) #:vertical-field-of-view-degrees 27))

(define settings (hash 'size '(640 288) 'samples 128))
