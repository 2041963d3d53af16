#lang racket/base
;; The land and the seas of a globe: a texture whose continents are noise.
(require raytrace)

(provide land)

;; Colours from the sea's floor to the highest mountains, each with the height where it begins.
(define ramp
  (list (cons -1.00 (Float3 0.01 0.03 0.12)) (cons -0.10 (Float3 0.02 0.12 0.30))
        (cons 0.06 (Float3 0.05 0.30 0.42))  (cons 0.07 (Float3 0.55 0.48 0.28))
        (cons 0.11 (Float3 0.10 0.26 0.07))  (cons 0.30 (Float3 0.24 0.21 0.10))
        (cons 0.45 (Float3 0.35 0.30 0.26))  (cons 0.60 (Float3 0.85 0.85 0.88))))

(define (ramp-color height)
  (let next ([below (car ramp)] [rest (cdr ramp)])
    (cond
      [(null? rest) (cdr below)]
      [(>= height (caar rest)) (next (car rest) (cdr rest))]
      [else
       (define s (/ (- height (car below)) (- (caar rest) (car below))))
       (Float3-linear-interpolate (cdr below) (cdar rest) (max 0.0 s))])))

;; The globe has radius 1 around the origin of its own space, so a point is also a direction and
;; its y the sine of the latitude.
(define (land-color point u v)
  (define height (perlin-noise (Float3-scale-by-scalar point 1.9) #:octaves 8 #:seed 12))
  (define cold (+ (abs (Float3-y point)) (* 0.12 (perlin-noise (Float3-scale-by-scalar point 7) 4))))
  (if (> cold 0.9) (Float3 0.9 0.92 0.95) (ramp-color height)))

(define land (FunctionTexture land-color))
