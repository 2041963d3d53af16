#lang racket/base
;; Spot lights: intensity by the angle to the axis, and the light they bring to a plane.

(module+ test
  (require racket/list racket/math rackunit "../../main.rkt" "../statistics.rkt" "light-samples.rkt")

  (define uniform (seeded 1))
  (define (random-float3) (Float3 (uniform -5.0 5.0) (uniform -5.0 5.0) (uniform -5.0 5.0)))
  (define (world-of . arguments) (World '() (apply SpotLight arguments)))
  (define white (Float3 1 1 1))

  (define (smoothstep low high x)
    (define t (max 0.0 (min 1.0 (/ (- x low) (- high low)))))
    (* t t (- 3.0 (* 2.0 t))))

  (test-case "irradiance I(angle) cos / d^2 on a floor below, to 1e-12"
    ;; from height h straight down onto the floor y = 0
    (define-values (h cone falloff) (values 3.0 0.6 0.35))
    (define world (world-of (Float3 0 h 0) (Float3 0 -2 0) (Float3 5 5 5) cone falloff))
    (for ([angle '(0.0 0.1 0.349 0.351 0.4 0.5 0.599 0.601 1.0)])
      (define s (sample-light world (Float3 (* h (tan angle)) 0 0) (uniform) (uniform)))
      (define expected
        (* 5.0 (smoothstep (cos cone) (cos falloff) (cos angle)) (expt (cos angle) 3) (/ 1.0 h h)))
      (check-= (* (second s) (fifth s)) expected (* 1e-12 5.0))))

  (test-case "flux on a floor is 2 pi I ((1 - cos f) + (cos f - cos c) / 2), to 1e-4"
    (define-values (cone falloff) (values 0.9 0.4))
    (define world (world-of (Float3 0 1 0) (Float3 0 -1 0) white cone falloff))
    ;; the floor by rings of the midpoint rule
    (define rings 4000)
    (define radius (* 1.0001 (tan cone)))
    (define flux
      (for/fold ([sum 0.0]) ([k rings])
        (define x (* radius (/ (+ k 0.5) rings)))
        (define s (sample-light world (Float3 x 0 0) 0.5 0.5))
        (+ sum (* 2.0 pi x (/ radius rings) (second s) (fifth s)))))
    (define expected
      (* 2.0 pi (+ (- 1.0 (cos falloff)) (* 0.5 (- (cos falloff) (cos cone))))))
    (check-= (/ flux expected) 1.0 1e-4))

  (test-case "towards the light at its distance; outside the cone, behind and at the light, nothing"
    (for ([k 300])
      (define-values (point light axis) (values (random-float3) (random-float3) (random-float3)))
      (define s (sample-light (world-of light axis white 0.8 0.8) point (uniform) (uniform)))
      (define to-light (Float3-subtract light point))
      (define distance (Float3-length to-light))
      (define cosine (/ (- (Float3-dot to-light axis)) distance (Float3-length axis)))
      (cond
        [(< cosine (- (cos 0.8) 1e-12)) (check-equal? (take (drop s 4) 3) '(0.0 0.0 0.0))]
        [(> cosine (+ (cos 0.8) 1e-12))
         (check-= (fourth s) distance (* 1e-15 distance))
         (check-= (* (first s) distance) (Float3-x to-light) (* 1e-15 distance))
         ;; a sharp edge: all of it or nothing
         (check-= (* (fifth s) distance distance) 1.0 4e-15)]))
    (define here (Float3 1 2 3))
    (define at (sample-light (world-of here (Float3 0 0 1) white 0.8 0.3) here 0.5 0.5))
    (check-equal? (take (drop at 4) 3) '(0.0 0.0 0.0))
    (for ([x at]) (check-true (= x x))))

  (test-case "through the renderer: a floor under a spot is I rho / (pi h^2) bright, to 1e-7"
    (define world
      (World (list (Disk (Float3 0 0 0) (Float3 0 1 0) 5 (Lambertian (Float3 0.6 0.6 0.6))))
             (list (SpotLight (Float3 0 2 0) (Float3 0 -1 0) (Float3 8 8 8) 0.5 0.2)) (Float3 0 0 0)))
    (define image
      (render world (Camera-look-at (Float3 0.5 1 0) (Float3 0 0 0)
                                    #:vertical-field-of-view-degrees 1e-6)
              #:width 1 #:height 1 #:samples 4 #:integrator 'path #:max-depth 1))
    (define-values (red green blue) (Image-pixel image 0 0))
    (check-= red (/ (* 8 0.6) pi 4) 1e-7))

  (test-case "accessors, and refused values: one line that names the argument"
    (define spot (SpotLight (Float3 1 2 3) (Float3 0 -3 4) white 0.5 0.2))
    (check-= (Float3-distance (SpotLight-direction spot) (Float3 0 -0.6 0.8)) 0.0 2e-16)
    (check-equal? (list (SpotLight-point spot) (SpotLight-intensity spot)
                        (SpotLight-cone-angle spot) (SpotLight-falloff-angle spot))
                  (list (Float3 1 2 3) white 0.5 0.2))
    (for ([name '("point" "direction" "intensity" "cone-angle" "cone-angle" "falloff-angle"
                  "falloff-angle")]
          [bad (list (list (Float3 0 +nan.0 0) white white 0.5 0.2)
                     (list white (Float3 0 0 0) white 0.5 0.2)
                     (list white white (Float3 0 -1 0) 0.5 0.2)
                     (list white white white 0 0)
                     (list white white white 3.2 0.2)
                     (list white white white 0.5 0.6)
                     (list white white white 0.5 -0.1))])
      (check-exn (regexp (string-append "^SpotLight: [^\n]*" name "[^\n]*$"))
                 (lambda () (apply SpotLight bad))))))
