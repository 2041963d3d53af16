#lang racket/base
;; S31: points on, in and beside lights.

(provide cases)

(require racket/math "case.rkt" "../../main.rkt" "../statistics.rkt" "../light/light-samples.rkt")

(define (grey x) (Float3 x x x))
(define (shining two-sided?) (Emitter (grey 1) #:two-sided? two-sided?))

;; Irradiance against closed forms: how many standard errors (or 1e-12 where there are none) the
;; mean of 64 estimates is off, and whether it is no finite number.
(define (compare light-world at normal expected samples)
  (define estimates
    (for/list ([seed 64]) (light-irradiance light-world (point at) (point normal) samples seed)))
  (define off (deviations estimates expected))
  (if (andmap (lambda (e) (< -inf.0 e +inf.0)) estimates) off +nan.0))

(define (touching size)
  (define uniform (seeded 31))
  (define-values (samples rounds) (values (amount 4096 size 256) (amount 100 size 2)))
  (define worst 0.0)
  (define strange 0)
  (define (check! . arguments)
    (define off (apply compare arguments))
    (if (< off +inf.0)
        (set! worst (max worst off))
        (set! strange (+ strange 1))))
  (for* ([round (in-range rounds)] [two-sided? (in-list '(#f #t))]
         [radius (in-list '(1e-6 1.0 1e6))])
    (define away (random-unit uniform))
    (define (sphere distance)
      (World (list (Sphere (point (scale (* distance radius) away)) radius (shining two-sided?)))))
    (define origin '(0.0 0.0 0.0))
    ;; on the sphere: a hemisphere of light with cosine c to the normal, pi (1 + c) / 2
    (define normal (random-unit uniform))
    (define c (dot normal away))
    (check! (sphere 1.0) origin away pi samples)
    (check! (sphere 1.0) origin normal (* pi 0.5 (+ 1.0 c)) samples)
    ;; inside: pi from a light that shines inwards, else dark
    (define part (uniform 0.0 0.95))
    (check! (sphere part) origin normal (if two-sided? pi 0.0) samples)
    ;; in the plane of a square, beside it: dark
    (define square
      (World (list (Quad (point (scale (- radius) '(1.0 1.0 0.0)))
                         (point (list (* 2.0 radius) 0.0 0.0))
                         (point (list 0.0 (* 2.0 radius) 0.0)) (shining two-sided?)))))
    (check! square (list (* radius (uniform 1.1 5.0)) (* radius (uniform -2.0 2.0)) 0.0)
            (random-unit uniform) 0.0 samples))
  ;; what a path tracer sees of floors that touch, cut or carry lights: no finite number
  (define-values (bad colors)
    (for*/fold ([bad 0] [colors 0]) ([height (in-list '(-0.5 0.0 0.5 1.0 1.0000000000000002))]
                                     [two-sided? (in-list '(#f #t))])
      (define world
        (World (list (Plane (grey 0) (Float3 0 1 0) (Lambertian (grey 0.5)))
                     (Sphere (Float3 0 height 0) 1 (shining two-sided?))
                     (Quad (Float3 2 0 -1) (Float3 0 0 2) (Float3 2 0 0) (shining two-sided?))
                     (Quad (Float3 -4 0 -1) (Float3 0 0 2) (Float3 0 2 0) (shining two-sided?)))
               (PointLight (Float3 0 0 3) (grey 1)) (grey 0.1)))
      (for/fold ([bad bad] [colors colors]) ([k (in-range (amount 20000 size 200))])
        ;; at the points of contact, near them and anywhere
        (define near (expt 10.0 (uniform -17.0 0.0)))
        (define target
          (add (list-ref '((0.0 0.0 0.0) (0.0 0.0 3.0) (-4.0 0.0 0.0) (2.0 0.0 0.5)) (modulo k 4))
               (list (* near (uniform -1.0 1.0)) 0.0 (* near (uniform -1.0 1.0)))))
        (define o (list (uniform -5.0 5.0) (uniform 0.1 4.0) (uniform -5.0 5.0)))
        (define color (World-ray-trace world (Ray (point o) (point (subtract target o))) #:seed k))
        (values (if (and (finite-numbers? color) (andmap (lambda (x) (>= x 0.0)) (numbers color)))
                    bad
                    (+ bad 1))
                (+ colors 1)))))
  (values (format (string-append "irradiance ~a standard errors off at worst of ~a, ~a not finite; "
                                 "~a of ~a colours not finite")
                  (rounded worst) (* 24 rounds) strange bad colors)
          (and (< worst 5.0) (= 0 strange bad))))

(define cases
  (list (stress-case "S31 points on, in and beside lights"
                     "all finite, closed forms within 5 standard errors" touching)))
