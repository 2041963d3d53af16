#lang racket/base
;; Reflected parts and refracted directions against closed forms. Cases E01 to E08, D09b, D14, D15
;; to 1e-12; S15.

(module+ test
  (require rackunit racket/flonum racket/math
           "../../private/material/fresnel.rkt" "../../private/base/fuse.rkt")

  (define glass 1.5)
  (define (cosine degrees) (cos (degrees->radians degrees)))
  (define generator (vector->pseudo-random-generator (vector 1 2 3 4 5 6)))

  (test-case "E01: air to glass, exact and Schlick, relative 1e-12"
    (for ([row (in-list '((0 0.04 0.04)
                          (30 0.04152262597582154 0.040041436543139367)
                          (45 0.05023991101223594 0.04206927312437236)
                          (75 0.25306056299031965 0.25472988408661434)
                          (85 0.6127996452648273 0.6484917182355181)
                          (89 0.9041849497801892 0.9191018917997219)))])
      (define c (cosine (car row)))
      (check-= (/ (Fresnel-dielectric/function c glass) (cadr row)) 1.0 1e-12)
      (check-= (/ (Fresnel-schlick-dielectric/function c glass) (caddr row)) 1.0 1e-12)
      (check-= (/ (Fresnel-schlick/function c 0.04) (caddr row)) 1.0 1e-12)))

  (test-case "E03: from inside glass; Schlick by the refracted cosine, and as in the book"
    (for ([row (in-list '((30 0.055190167295375916 0.04427034925264154 0.040041436543139367)
                          (41 0.3797512659624401 0.4009763891003381 0.04085246030532483)))])
      (define c (cosine (car row)))
      (define refracted (sqrt (- 1.0 (* 2.25 (- 1.0 (* c c))))))
      (check-= (/ (Fresnel-dielectric/function c (/ 1.0 glass)) (cadr row)) 1.0 1e-12)
      (check-= (/ (Fresnel-schlick/function refracted 0.04) (caddr row)) 1.0 1e-12)
      (check-= (/ (Fresnel-schlick-dielectric/function c (/ 1.0 glass)) (cadddr row)) 1.0 1e-12)))

  (test-case "E04: total internal reflection from the critical angle on, relative 1e-12"
    (define critical 41.810314895778596)
    (for ([reflected (list Fresnel-dielectric/function Fresnel-schlick-dielectric/function)])
      (check-equal? (reflected (cosine (* critical (+ 1.0 1e-12))) (/ 1.0 glass)) 1.0)
      (check-true (< (reflected (cosine (* critical (- 1.0 1e-12))) (/ 1.0 glass)) 1.0))))

  (test-case "E07: the refracted vector at 45 degrees, and E06: its angle at 30, to 1e-15"
    (define (refract degrees eta)
      (define theta (degrees->radians degrees))
      (Float3-refract/function (Float3 (- (sin theta)) (cos theta) 0.0) (Float3 0.0 1.0 0.0) eta))
    (define d (refract 45 glass))
    (check-= (Float3-x d) 0.4714045207910317 1e-15)
    (check-= (Float3-y d) -0.8819171036881969 1e-15)
    (check-= (Float3-z d) 0.0 0.0)
    (define e (refract 30 glass))
    (check-= (radians->degrees (atan (Float3-x e) (- (Float3-y e)))) 19.47122063449069 1e-13))

  (test-case "E08: a conductor of index 2 + 4i, to 1e-15"
    (check-= (Fresnel-conductor/function 1.0 2.0 4.0) 0.68 1e-15)
    (check-= (Fresnel-conductor/function (cosine 60) 2.0 4.0) 0.6565328500670229 1e-15)
    (define three (Fresnel-conductor-color/function 0.5 (Float3 2.0 1.5 0.2) (Float3 4.0 0.0 3.0)))
    (check-equal? (Float3-x three) (Fresnel-conductor/function 0.5 2.0 4.0))
    (check-equal? (Float3-y three) (Fresnel-conductor/function 0.5 1.5 0.0))
    (check-equal? (Float3-z three) (Fresnel-conductor/function 0.5 0.2 3.0)))

  (test-case "a conductor that does not absorb is a dielectric, inside and out, to 1e-12"
    (for ([k (in-range 1000)])
      (define c (random generator))
      (define eta (exp (* 2.0 (- (random generator) 0.5))))
      (check-= (Fresnel-conductor/function c eta 0.0) (Fresnel-dielectric/function c eta) 1e-12)))

  (test-case "D09b: the same part is reflected on both ways through a boundary, to 1e-12"
    (define impact 0.9)
    (define (cosine-of sine) (sqrt (- 1.0 (* sine sine))))
    (check-= (Fresnel-dielectric/function (cosine-of impact) glass) 0.11414110022135394 1e-12)
    (check-= (Fresnel-dielectric/function (cosine-of (/ impact glass)) (/ 1.0 glass))
             0.11414110022135394 1e-12))

  ;; the part reflected at a double's cosine, by exact arithmetic and a root of 300 bits
  (define (exact-dielectric c eta)
    (define-values (C N) (values (inexact->exact c) (inexact->exact eta)))
    (define g (/ (integer-sqrt (floor (* (+ (* N N) -1 (* C C)) (expt 2 600)))) (expt 2 300)))
    (define across (/ (- C g) (+ C g)))
    (define within (/ (- (* N N C) g) (+ (* N N C) g)))
    (/ (+ (* across across) (* within within)) 2))

  (test-case "S15: grazing light, against exact arithmetic to 1e-15 and 1 in the limit"
    (define grazing (cosine 89.999999))
    (check-= (Fresnel-dielectric/function grazing glass)
             (exact->inexact (exact-dielectric grazing glass)) 1e-15)
    (for ([c (in-list '(1e-13 1e-16 1e-160 1e-300 0.0))])
      (for ([eta (in-list '(1.5 0.6666666666666666 1.0000001 2.42 1e6))])
        (when (or (< c 1e-15) (= eta 1.5))
          (define part (Fresnel-dielectric/function c eta))
          (check-true (<= (- 1.0 part) (max 1e-12 (* 1e4 eta c))) (format "~a ~a ~a" c eta part))
          (check-true (<= part 1.0))))
      (check-= (Fresnel-dielectric/function c 1.5) 1.0 1e-12)
      (check-= (Fresnel-conductor/function c 0.2 3.0) 1.0 3e-12)))

  (test-case "random cosines and indices: to 1e-12 of exact arithmetic, and never above 1"
    (for ([k (in-range 1000)])
      (define c (expt (random generator) 3))
      (define eta (+ 1.0 (expt 10.0 (- (* 5.0 (random generator)) 4.0))))
      (define part (Fresnel-dielectric/function c eta))
      (define exact (exact->inexact (exact-dielectric c eta)))
      (check-true (<= 0.0 part 1.0))
      (check-= part exact 1e-12)))

  (test-case "equal indices reflect nothing and refract straight on"
    (check-equal? (Fresnel-dielectric/function 0.3 1.0) 0.0)
    (define v (Float3 -0.6 0.8 0.0))
    (define d (Float3-refract/function v (Float3 0.0 1.0 0.0) 1.0))
    (check-equal? (list (Float3-x d) (Float3-y d)) '(0.6 -0.8)))

  ;; 2 F(c) c dc with c = a sinh x, g = a cosh x, where F is rational in tanh x: Simpson's rule
  (define (average-by-quadrature eta)
    (define a (sqrt (* (- eta 1.0) (+ eta 1.0))))
    (define (f x)
      (define across (exp (* -2.0 x)))
      (define scaled (* eta eta (tanh x)))
      (define within (/ (- scaled 1.0) (+ scaled 1.0)))
      (* a a (sinh x) (cosh x) (+ (* across across) (* within within))))
    (define end (log (/ (+ 1.0 eta) a)))
    (define steps 20000)
    (define h (/ end steps))
    (for/fold ([sum 0.0] #:result (* sum (/ h 3.0))) ([k (in-range (+ steps 1))])
      (define weight (cond [(or (= k 0) (= k steps)) 1.0] [(odd? k) 4.0] [else 2.0]))
      (+ sum (* weight (f (* h k))))))

  (test-case "D14, D15: the averages for diffuse light, relative 1e-14"
    (check-= (/ (Fresnel-average 1.5) 0.09177795934235121) 1.0 1e-14)
    (check-= (/ (Fresnel-average-inside 1.5) 0.5963457597077116) 1.0 1e-14)
    (check-equal? (Fresnel-average 1.0) 0.0)
    (check-equal? (Fresnel-average-inside 1.0) 0.0))

  (test-case "the average against quadrature, to its stated error"
    (for ([eta (in-list '(1.0000005 1.000001 1.00001 1.0001 1.001 1.01 1.1 1.33 2.42 4.0 10.0 100.0))])
      (check-= (Fresnel-average eta) (average-by-quadrature eta) (if (< eta 1.01) 1e-9 1e-13)
               (number->string eta)))))
