#lang racket/base
;; Worlds made for measuring: spheres of equal density, and rays through them.
(require raytrace)

(provide random-spheres mirror-world half-empty-world front-camera)

;; n spheres uniform in a cube that grows with n, so that density stays the same.
(define (random-spheres n material #:radius [radius 0.45])
  (define side (expt n 1/3))
  (for/list ([k (in-range n)])
    (define place (Float3-random-color #:seed 11 #:index k))
    (define size (Float3-x (Float3-random-color #:seed 12 #:index k)))
    (Sphere (Float3-scale-by-scalar place side) (* radius (+ 0.2 (* 0.8 size)))
            #:material material)))

;; Perfect mirrors followed for up to 50 bounces, no light to sample.
(define (mirror-world n)
  (World (random-spheres n (Phong (Float3 0 0 0) #:specularity 0 #:reflectivity 1))
         '() (GradientSky (Float3 1 1 1) (Float3 0.5 0.7 1))
         #:ambient-color (Float3 0 0 0) #:mirror-bounces 50))

;; Looks at the cube of n spheres from the front.
(define (front-camera n)
  (define side (expt n 1/3))
  (Camera-look-at (Float3 (* 0.5 side) (* 0.5 side) (* 2.4 side))
                  (Float3 (* 0.5 side) (* 0.5 side) (* 0.5 side))
                  #:vertical-field-of-view-degrees 40))

;; Everything on the left half of the picture: what static halves would schedule badly.
(define (half-empty-world)
  (World (for/list ([k (in-range 400)])
           (define p (Float3-random-color #:seed 21 #:index k))
           (Sphere (Float3 (* -8 (Float3-x p)) (* 8 (- (Float3-y p) 0.5))
                           (* 8 (- (Float3-z p) 0.5)))
                   0.4))
         (list (DistantLight (Float3 0 1 1) (Float3 1 1 1)))
         (Float3 0.4 0.6 1)
         #:ambient-samples 16))
