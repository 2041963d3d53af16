#lang racket/base
;; S13, S14, S15: frames, small angles and grazing rays against exact arithmetic.

(provide cases)

(require racket/math "case.rkt" "../../main.rkt" "../base/frame-vectors.rkt"
         (only-in "../base/roots.rkt" exact-square-root)
         (only-in "../light/light-samples.rkt" sample-light)
         (only-in "../../private/material/fresnel.rkt" Fresnel-dielectric/function))

;; --- S13 ---

;; Root mean square of how far the products of the rows are from the unit matrix.
(define (deviation rows)
  (define-values (a b c) (values (take-three rows 0) (take-three rows 3) (take-three rows 6)))
  (define squares
    (for*/sum ([p (in-list (list a b c))] [q (in-list (list a b c))])
      (define off (- (dot p q) (if (eq? p q) 1 0)))
      (* off off)))
  (sqrt (real->double-flonum (/ squares 9))))

(define (take-three rows start)
  (exact (for/list ([k 3]) (list-ref rows (+ start k)))))

(define (frames size)
  (define uniform (seeded 13))
  (define count (amount 1000000 size 5000))
  (define (near-minus-z)
    (define-values (off angle) (values (expt 10.0 (uniform -9.0 0.0)) (uniform 0.0 (* 2.0 pi))))
    (unit (list (* off (cos angle)) (* off (sin angle)) -1.0)))
  (define worst
    (for/fold ([worst 0.0]) ([k (in-range count)])
      (max worst (deviation
                  (apply frame-of (if (even? k) (near-minus-z) (random-unit uniform)))))))
  (values (format "root mean square ~a at worst of ~a" (rounded worst) count) (<= worst 4e-16)))

;; --- S14 ---

(define PI #e3.14159265358979323846264338327950288419716939937510)

;; The solid angle of a sphere of radius 1 seen from `distance`, 2 pi sin^2 / (1 + cos), exactly.
(define (solid-angle distance-squared)
  (define sine-squared (/ 1 distance-squared))
  (/ (* 2 PI sine-squared) (+ 1 (exact-square-root (- 1 sine-squared)))))

;; Sphere lights that are seen under half angles t from 1e-9 to 1.5: what they take as their density
;; is one over the solid angle, whose relative error times (1 - cos t) / (t sin t) is the angle's.
(define (small-angles size)
  (define uniform (seeded 14))
  (define count (amount 100000 size 3000))
  (define worst
    (for/fold ([worst 0.0]) ([k (in-range count)])
      (define angle (exp (uniform (log 1e-9) (log 1.5))))
      (define distance (/ 1.0 (sin angle)))
      (define center (scale distance (random-unit uniform)))
      (define light (World (list (Sphere (point center) 1 (Emitter (Float3 1 1 1))))))
      (define density (list-ref (sample-light light (Float3 0 0 0) (uniform) (uniform)) 7))
      (define c (exact center))
      (define relative
        (exact->inexact (- 1 (* (inexact->exact density) (solid-angle (dot c c))))))
      (define half-sine (sin (* 0.5 angle)))
      (max worst (abs (/ (* relative 2.0 half-sine half-sine) (sin angle) (spacing angle))))))
  (values (format "~a ulp at worst of ~a" (rounded worst) count) (<= worst 4.0)))

;; --- S15 ---

;; The part that a boundary reflects, to 300 bits.
(define (exact-fresnel cosine eta)
  (define-values (c n) (values (inexact->exact cosine) (inexact->exact eta)))
  (define g (exact-square-root (+ (* n n) -1 (* c c))))
  (define-values (across within)
    (values (/ (- c g) (+ c g)) (/ (- (* n n c) g) (+ (* n n c) g))))
  (/ (+ (* across across) (* within within)) 2))

(define grey (Float3 0.5 0.5 0.5))
(define materials
  (list (Phong grey #:reflectivity 0.5) (Lambertian grey) (Mirror) (Metal grey 0.3)
        (Dielectric 1.5) (Plastic grey) (ModifiedPhong grey (Float3 0.3 0.3 0.3) 50)
        (RoughConductor 0.3 grey) (RoughConductor 0.001 grey) (RoughDielectric 1.5 0.2)
        (Mix (Lambertian grey) (Mirror) 0.5)))

;; Rays along a plane and a sphere with cosines from 1e-300 to 1e-3: colours that are no finite
;; non-negative number, of all.
(define (strange-colors size)
  (define uniform (seeded 15))
  (define lamp (Sphere (Float3 2 3 -4) 1 (Emitter (Float3 5 5 5) #:two-sided? #t)))
  (define lights (list (PointLight (Float3 1 5 2) (Float3 9 9 9)) (DistantLight (Float3 0 1 0) grey)
                       (DistantLight (Float3 1 1e-16 0) grey)))
  (for*/fold ([strange 0] [all 0]) ([material (in-list materials)] [ball? (in-list '(#f #t))])
    (define world
      (World (list lamp (if ball?
                            (Sphere (Float3 0 -1 0) 1 material)
                            (Plane (Float3 0 0 0) (Float3 0 1 0) material)))
             lights (GradientSky (Float3 1 1 1) (Float3 0.5 0.7 1)) #:ambient-samples 2))
    (for/fold ([strange strange] [all all]) ([k (in-range (amount 20000 size 60))])
      (define cosine (expt 10.0 (- (if (even? k) (uniform 3.0 18.0) (uniform 18.0 300.0)))))
      (define angle (uniform 0.0 (* 2.0 pi)))
      (define d (list (cos angle) (- cosine) (sin angle)))
      (define o
        (if (and ball? (= 0 (modulo k 3))) (scale -2.0 d) (list 0.0 (* 2.0 cosine) 0.0)))
      (define color (World-ray-trace world (Ray (point o) (point d)) #:seed k))
      (define fine? (and (finite-numbers? color) (andmap (lambda (c) (>= c 0.0)) (numbers color))))
      (values (if fine? strange (+ strange 1)) (+ all 1)))))

(define (grazing size)
  (define uniform (seeded 150))
  (define-values (off limit-off)
    (for/fold ([off 0.0] [limit-off 0.0]) ([k (in-range (amount 100000 size 2000))])
      (define eta (+ 1.0 (expt 10.0 (uniform -2.0 1.0))))
      (define cosine (expt 10.0 (uniform -12.0 0.0)))
      (define part (Fresnel-dielectric/function cosine eta))
      (define limit (Fresnel-dielectric/function (expt 10.0 (uniform -300.0 -15.0)) eta))
      (values (max off (abs (- part (real->double-flonum (exact-fresnel cosine eta)))))
              (max limit-off (abs (- limit 1.0))))))
  (define degrees (Fresnel-dielectric/function (cos (degrees->radians 89.999999)) 1.5))
  (define degrees-off
    (abs (- degrees (exact-fresnel (cos (degrees->radians 89.999999)) 1.5))))
  (define-values (strange all) (strange-colors size))
  (values (format (string-append "Fresnel off by ~a, by ~a at 89.999999 degrees, by ~a from 1 below "
                                 "a cosine of 1e-15; ~a strange colours of ~a")
                  (rounded off) (rounded (real->double-flonum degrees-off)) (rounded limit-off)
                  strange all)
          (and (<= (max off degrees-off limit-off) 1e-12) (= strange 0))))

(define cases
  (list (stress-case "S13 orthonormal frames" "root mean square 4e-16" frames)
        (stress-case "S14 small angles (by solid angles of sphere lights; there is no angle function)"
                     "4 ulp" small-angles)
        (stress-case "S15 grazing rays" "1e-12, all colours finite and not negative" grazing)))
