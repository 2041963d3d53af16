#lang racket/base
;; A hall at night lit by 10,000 small lights: ribbons of lanterns around its columns, and a swarm
;; above a golden ball.
;; raco raytrace scenes/many-lights.rkt -o many-lights.png
(require raytrace racket/math)

(provide world camera settings)

;; Three uniform numbers for the k-th of something, always the same.
(define (numbers seed k)
  (define triple (Float3-random-color #:seed seed #:index k))
  (values (Float3-x triple) (Float3-y triple) (Float3-z triple)))

(define palette
  (vector (Float3 1.0 0.30 0.08) (Float3 1.0 0.62 0.16) (Float3 1.0 0.16 0.30)
          (Float3 0.55 0.22 1.0) (Float3 0.16 0.50 1.0) (Float3 0.10 0.90 0.70)))

(define (lantern at radius color brightness)
  (Sphere at radius #:material (Emitter (Float3-scale-by-scalar color brightness))))

;; Around a column at (x, z): a ribbon that climbs in four turns, its lights a little off it.
(define (ribbon number x z)
  (define color (vector-ref palette number))
  (for/list ([k (in-range 1100)])
    (define-values (along out up) (numbers (+ 40 number) k))
    (define angle (+ (* 8 pi along) (* number 1.1)))
    (define distance (+ 0.62 (* 0.28 out out)))
    (lantern (Float3 (+ x (* distance (cos angle)))
                     (+ 0.12 (* 5.6 along) (* 0.25 (- up 0.5)))
                     (+ z (* distance (sin angle))))
             (+ 0.018 (* 0.016 up)) color (+ 2.5 (* 5 out)))))

;; Two arms of a spiral, warm in the middle and cold outside.
(define swarm
  (for/list ([k (in-range 3400)])
    (define-values (s side height) (numbers 60 k))
    (define distance (* 3.4 (sqrt s)))
    (define angle (+ (* 1.5 distance) (if (even? k) 0.0 pi) (* 1.1 (- side 0.5))))
    (define-values (color other mix) (numbers 61 k))
    (define warm (vector-ref palette (if (< color 0.75) 1 0)))
    (define cold (vector-ref palette (if (< color 0.5) 4 5)))
    (lantern (Float3 (* distance (cos angle))
                     (+ 3.3 (* 0.7 (- height 0.5) (/ 1.2 (+ 0.5 distance))))
                     (* distance (sin angle)))
             (+ 0.014 (* 0.014 other))
             (Float3-linear-interpolate warm cold (min 1.0 (* s (+ 0.6 (* 0.8 mix)))))
             (+ 2.5 (* 5 mix)))))

(define places
  (list '(-5.2 -4.6) '(5.2 -4.6) '(-5.6 -0.2) '(5.6 -0.2) '(-5.0 3.8) '(5.0 3.8)))

(define ribbons
  (apply append (for/list ([place places] [number (in-range 6)])
                  (ribbon number (car place) (cadr place)))))

(define stone (Lambertian (Float3 0.55 0.53 0.50)))
(define columns
  (for/list ([place places])
    (Cylinder (Float3 (car place) 0 (cadr place)) (Float3 (car place) 6 (cadr place)) 0.45
              #:material stone)))

;; rough enough that light in them is sampled
(define polished (ModifiedPhong (Float3 0.16 0.15 0.15) (Float3 0.35 0.35 0.35) 400))
(define hall
  (list (Quad (Float3 -8 0 -7) (Float3 0 0 20) (Float3 16 0 0) #:material polished)
        (Quad (Float3 -8 6 -7) (Float3 16 0 0) (Float3 0 0 20) #:material stone)
        (Quad (Float3 -8 0 -7) (Float3 16 0 0) (Float3 0 6 0) #:material stone)
        (Quad (Float3 -8 0 13) (Float3 0 0 -20) (Float3 0 6 0) #:material stone)
        (Quad (Float3 8 0 -7) (Float3 0 0 20) (Float3 0 6 0) #:material stone)))

(define white (Lambertian (Float3 0.8 0.8 0.8)))
(define things
  (list (Sphere (Float3 0 1.15 0) 1.15 #:material (gold 0.15))
        (Sphere (Float3 -2.4 0.6 1.9) 0.6 #:material white)
        (Sphere (Float3 2.5 0.55 2.1) 0.55 #:material (silver 0.2))
        (Box (Float3 -3.4 0 -2.6) (Float3 -2.2 1.5 -1.4) #:material white)
        (Box (Float3 2.3 0 -2.9) (Float3 3.4 2.1 -1.8) #:material white)))

(define world (World (append hall columns things ribbons swarm) '() (Float3 0 0 0)))

(define camera
  (Camera-look-at (Float3 0.6 2.5 11.5) (Float3 0 2.35 0) #:vertical-field-of-view-degrees 42))

(define settings (hash 'size '(960 540) 'samples 64))
