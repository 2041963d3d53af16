#lang racket/base
;; The article's ambient occlusion against closed forms: uniform and cosine weights, linear and
;; binary falloff. Each case: the mean over independent seeds within 4 standard errors.

(module+ test
  (require racket/flonum racket/list racket/math rackunit
           "../../main.rkt" "../statistics.rkt")

  (define x-axis (Float3 1 0 0))
  (define y-axis (Float3 0 1 0))
  (define (opposite v) (Float3-negate v))
  (define far 1e9)

  ;; Estimates from 24 seeds, `samples` rays each, at a point of the plane y = 0.
  (define (estimates shapes point weighting falloff distance
                     #:normal [normal y-axis] #:samples [samples 1024] #:seeds [seeds 24])
    (define world
      (World shapes #:ambient-samples samples #:max-occlusion-distance distance
             #:ambient-weighting weighting #:occlusion-falloff falloff))
    (for/list ([seed seeds]) (World-get-ambient-percent world point normal #:seed seed)))

  ;; precision: the standard error these samples must reach, as a part of the value.
  (define-syntax-rule (case-is name expected argument ...)
    (test-case name (check-mean name (estimates argument ...) expected 5e-3)))

  (define floor (Plane (Float3 0 0 0) y-axis))
  (define (sphere-at height) (Sphere (Float3 0 height 0) 1))

  ;; --- spheres ---
  (define beside (Float3 1 0 0))
  (case-is "C01 a sphere that touches the floor, cosine" (- 1.0 (/ 1.0 (sqrt 8.0)))
           (list floor (sphere-at 1)) beside 'cosine 'binary far)
  (case-is "C02 the same, uniform" (sqrt 0.5)
           (list floor (sphere-at 1)) beside 'uniform 'binary far)
  (case-is "C03 below a floating sphere, cosine" 0.75
           (list (sphere-at 2)) (Float3 0 0 0) 'cosine 'binary far)
  (case-is "C04 the same, uniform" (sqrt 0.75)
           (list (sphere-at 2)) (Float3 0 0 0) 'uniform 'binary far)
  ;; a sphere whose centre is on the horizon: atan(1/q) - q sin^2, q = sqrt(H^2 - 1), over pi
  (case-is "C05 beside a half-buried sphere, cosine"
           (- 1.0 (/ (- (atan (/ 1.0 (sqrt 3.0))) (/ (sqrt 3.0) 4.0)) pi))
           (list floor (sphere-at 0)) (Float3 2 0 0) 'cosine 'binary far)
  (case-is "C06 the same, uniform" 0.9330127018922193
           (list floor (sphere-at 0)) (Float3 2 0 0) 'uniform 'binary far)

  ;; --- wedges: a second plane through the z axis, at an angle to the floor x > 0 ---
  (define (wall degrees)
    (define angle (degrees->radians degrees))
    (Plane (Float3 0 0 0) (Float3 (sin angle) (- (cos angle)) 0)))
  (for ([degrees '(60 90 120)])
    (case-is (format "C07 a wedge of ~a degrees, cosine" degrees)
             (* 0.5 (- 1.0 (cos (degrees->radians degrees))))
             (list floor (wall degrees)) (Float3 3 0 0) 'cosine 'binary +inf.0)
    (case-is (format "C08 a wedge of ~a degrees, uniform" degrees) (/ degrees 180.0)
             (list floor (wall degrees)) (Float3 3 0 0) 'uniform 'binary +inf.0))

  ;; --- a wall of height 1, half a unit away; its ends 1e6 away hide less than 1e-6 ---
  (define low-wall (Quad (Float3 -0.5 0 -1e6) (Float3 0 0 2e6) (Float3 0 1 0)))
  (case-is "C10 a wall of finite height, cosine" 0.7236067977499789
           (list low-wall) (Float3 0 0 0) 'cosine 'binary far)
  (case-is "C11 the same, uniform" 0.6475836176504333
           (list low-wall) (Float3 0 0 0) 'uniform 'binary far)

  ;; --- the middle of the floor of an open unit box ---
  (define box-walls
    (list (Quad (Float3 0 0 0) (Float3 0 0 1) (Float3 0 1 0))
          (Quad (Float3 1 0 0) (Float3 0 0 1) (Float3 0 1 0))
          (Quad (Float3 0 0 0) (Float3 1 0 0) (Float3 0 1 0))
          (Quad (Float3 0 0 1) (Float3 1 0 0) (Float3 0 1 0))))
  (case-is "C12 an open box, cosine" 0.23945647046077354
           box-walls (Float3 0.5 0 0.5) 'cosine 'binary far)
  ;; the square opening's solid angle from below its middle, over 2 pi
  (case-is "C13 an open box, uniform"
           (/ (* 4.0 (asin (/ 0.25 1.25))) (* 2.0 pi))
           box-walls (Float3 0.5 0 0.5) 'uniform 'binary far)

  ;; --- a ceiling at height k under a largest distance of 1 ---
  (define (ceiling height) (Plane (Float3 0 height 0) y-axis))
  (define origin (Float3 0 0 0))
  (case-is "C14 a ceiling, cosine" 0.16 (list (ceiling 0.4)) origin 'cosine 'binary 1)
  (case-is "C15 a ceiling, uniform" 0.4 (list (ceiling 0.4)) origin 'uniform 'binary 1)
  (for ([k '(0.25 0.5)] [uniform-deviation '(0.2856570520404902 0.18251892022603297)]
        [cosine-deviation '(0.2106669056591147 0.1845903309493015)])
    (case-is (format "C16 a ceiling at ~a, linear, uniform" k) (* k (- 1.0 (log k)))
             (list (ceiling k)) origin 'uniform 'linear 1)
    (case-is (format "C17 a ceiling at ~a, linear, cosine" k) (- (* 2.0 k) (* k k))
             (list (ceiling k)) origin 'cosine 'linear 1)
    (for ([weighting '(uniform cosine)] [deviation (list uniform-deviation cosine-deviation)]
          [id '("C18" "C19")])
      (test-case (format "~a a ceiling at ~a: deviation of one ~a sample, to 5%" id k weighting)
        (define all
          (estimates (list (ceiling k)) origin weighting 'linear 1
                     #:samples 1 #:seeds (stressed 4000 100000)))
        (check-= (standard-deviation all) deviation (* 0.05 deviation))
        (check-= (mean all)
                 (if (eq? weighting 'uniform) (* k (- 1.0 (log k))) (- (* 2.0 k) (* k k)))
                 (* 4.0 (standard-error all))))))
  (case-is "a ceiling out of reach does not occlude" 1.0
           (list (ceiling 1.0000001)) origin 'uniform 'linear 1)

  ;; --- linear falloff under a sphere, beside a wall, inside a sphere ---
  (case-is "C20 below a sphere, linear, uniform" 0.9470152079097092
           (list (sphere-at 2)) origin 'uniform 'linear 2)
  ;; the same integral with weight 2 cos: t = 2 u - s, s = sqrt(4 u^2 - 3), u from sqrt(3)/2 to 1
  (case-is "C21 below a sphere, linear, cosine"
           (let ([primitive (lambda (u)
                              (- (* 4/3 u u u) (/ (expt (max 0.0 (- (* 4.0 u u) 3.0)) 1.5) 6.0)))]
                 [rim (sqrt 0.75)])
             (+ 0.75 (* 0.5 (- (primitive 1.0) (primitive rim)))))
           (list (sphere-at 2)) origin 'cosine 'linear 2)
  (define wall-beside (list floor (Plane (Float3 -0.5 0 0) x-axis)))
  (case-is "C22 beside a wall, linear, uniform" 0.9232867951399863
           wall-beside origin 'uniform 'linear 1)
  (case-is "C23 beside a wall, linear, cosine" 0.9480351610902014
           wall-beside origin 'cosine 'linear 1)
  (define bubble (list (Sphere (Float3 0 1 0) 1)))
  (case-is "C24 inside a sphere, linear, uniform" 0.75 bubble origin 'uniform 'linear 1)
  ;; min(1, c / k) with weight 2 c: 1 - k^2 / 3
  (case-is "C25 inside a sphere, linear, cosine" (- 1.0 (/ 0.25 3.0))
           bubble origin 'cosine 'linear 1)

  ;; --- the same through pictures: every pixel of a view from inside a sphere is C24 ---
  (test-case "C24 as a picture: the mean of independent pixels"
    (define world
      (World (list (Sphere (Float3 0 0 0) 1)) #:ambient-samples 256 #:max-occlusion-distance 1))
    (define image
      (render world (Camera-look-at (Float3 0.3 0.2 -0.1) (Float3 0.9 0 0.4)) #:width 8 #:height 8
              #:samples 1 #:integrator 'ambient-occlusion #:schedule 'sequential))
    (check-mean "C24" (for/list ([place 64]) (flvector-ref (Image-pixels image) (* 3 place)))
                0.75 2e-3))

  (test-case "as ambient light: colour times ambient colour times the part that is open"
    (define world
      (World (list (Sphere (Float3 0 2 0) 1)
                   (Plane (Float3 0 0 0) y-axis (Phong (Float3 0.5 0.25 1) #:specularity 0)))
             '() (Float3 0.2 0.4 0.8) #:ambient-samples 1024 #:max-occlusion-distance far
             #:ambient-weighting 'cosine #:occlusion-falloff 'binary))
    (define ray (Ray (Float3 0.9 0.9 0) (Float3 -1 -1 0)))
    (for ([channel (list Float3-x Float3-y Float3-z)] [expected '(0.075 0.075 0.6)])
      (check-mean "C03" (for/list ([seed 16]) (channel (World-ray-trace world ray #:seed seed)))
                  expected 2e-3)))

  (test-case "no samples asked for: nothing occludes, nothing is traced"
    (check-equal? (remove-duplicates
                   (estimates (list (ceiling 0.1)) origin 'uniform 'linear 1 #:samples 0))
                  '(1.0))))
