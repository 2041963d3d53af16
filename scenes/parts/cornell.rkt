#lang racket/base
;; What the Cornell box scenes share: the room of Ray Tracing: The Next Week, its light, its camera.
(require raytrace racket/math)

(provide cornell-world tall-block block white camera settings)

(define red (Lambertian (Float3 0.65 0.05 0.05)))
(define white (Lambertian (Float3 0.73 0.73 0.73)))
(define green (Lambertian (Float3 0.12 0.45 0.15)))
(define lamp
  (Quad (Float3 213 554 227) (Float3 130 0 0) (Float3 0 0 105) (Emitter (Float3 15 15 15))))

(define room
  (list (Quad (Float3 555 0 0) (Float3 0 0 555) (Float3 0 555 0) green)
        (Quad (Float3 0 0 555) (Float3 0 0 -555) (Float3 0 555 0) red)
        (Quad (Float3 0 555 0) (Float3 555 0 0) (Float3 0 0 555) white)
        (Quad (Float3 0 0 555) (Float3 555 0 0) (Float3 0 0 -555) white)
        (Quad (Float3 555 0 555) (Float3 -555 0 0) (Float3 0 555 0) white)))

;; The six sides of the box from the origin to (165, height, 165), turned about the y axis and then
;; moved to (x, 0, z).
(define (block height degrees x z material)
  (define angle (degrees->radians degrees))
  (define (turned a b c)
    (Float3 (+ (* (cos angle) a) (* (sin angle) c)) b (- (* (cos angle) c) (* (sin angle) a))))
  (define (side corner u v)
    (Quad (Float3-add (Float3 x 0 z) (apply turned corner)) (apply turned u) (apply turned v)
          material))
  (define s 165)
  (list (side '(0 0 165) '(165 0 0) (list 0 height 0))
        (side '(165 0 165) '(0 0 -165) (list 0 height 0))
        (side '(165 0 0) '(-165 0 0) (list 0 height 0))
        (side '(0 0 0) '(0 0 165) (list 0 height 0))
        (side (list 0 height s) '(165 0 0) '(0 0 -165))
        (side '(0 0 0) '(165 0 0) '(0 0 165))))

(define (tall-block material) (block 330 15 265 295 material))

;; The room with its lamp, or another light, and what stands in it.
(define (cornell-world things #:light [light lamp])
  (World (append room (list light) things) '() (Float3 0 0 0)))

(define camera
  (Camera-look-at (Float3 278 278 -800) (Float3 278 278 0)
                  #:vertical-field-of-view-degrees 40))

(define settings (hash 'size '(600 600) 'samples 64))
