#lang racket/base
;; The article's shading under one light against closed forms. A surface's colour multiplies the
;; irradiance as it is.

(module+ test
  (require racket/math rackunit "../../main.rkt" "../statistics.rkt")

  (define black (Float3 0 0 0))
  (define white (Float3 1 1 1))
  (define chalk (Phong (Float3 1 0.5 0.25) #:specularity 0))
  (define (floor material) (Plane (Float3 0 0 0) (Float3 0 0 1) material))
  (define (world-of material lights #:shapes [shapes '()] #:ambient [ambient black]
                    #:samples [samples 1024])
    (World (cons (floor material) shapes) lights black #:ambient-color ambient
           #:ambient-samples 0 #:shadow-samples samples))
  ;; What the origin sends towards a direction.
  (define (towards world direction #:seed [seed 0])
    (World-ray-trace world
                     (Ray (Float3-scale-by-scalar direction 0.01) (Float3-negate direction))
                     #:seed seed))
  (define up (Float3 0 0 1))

  (test-case "A14: a point light, irradiance to 1e-12, times the colour"
    (define light (PointLight (Float3 1 2 3) (Float3 10 10 10)))
    (define seen (towards (world-of chalk light) up))
    (for ([c (list (Float3-x seen) (Float3-y seen) (Float3-z seen))] [part '(1.0 0.5 0.25)])
      (check-= c (* part 0.5727026612409094) 1e-12)))

  (test-case "a distant light: colour times cosine, the same everywhere"
    (define world (world-of chalk (DistantLight (Float3 3 0 4) (Float3 2 2 2))))
    (check-= (Float3-x (towards world up)) 1.6 1e-15)
    (for ([x '(-100.0 0.0 1e6)])
      (check-= (Float3-x (World-ray-trace world (Ray (Float3 x 0 1) (Float3 0 0 -1)))) 1.6 1e-15)))

  (test-case "lights add up"
    (define lights (list (DistantLight (Float3 3 0 4) white) (PointLight (Float3 0 0 2) white)))
    (check-= (Float3-x (towards (world-of chalk lights) up)) (+ 0.8 0.25) 1e-15))

  (define (sphere-light c distance)
    (Sphere (Float3 (* distance (sqrt (- 1.0 (* c c)))) 0 (* distance c)) 1 (Emitter white)))
  (define (estimates c distance)
    (define world (world-of chalk '() #:shapes (list (sphere-light c distance))))
    (for/list ([seed 16]) (Float3-x (towards world up #:seed seed))))

  (test-case "A08, A09, A10: spheres that shine on, below and above the horizon, error below 2%"
    (for ([c '(0.0 -0.3 0.3)]
          [expected '(0.09058607370607955 0.011672369894608133 0.24729181891384264)])
      (check-mean (format "cosine ~a" c) (estimates c 2.0) expected 0.02)))

  (test-case "spheres that shine from above: pi (R/d)^2 cos, error below 0.1%"
    (for* ([c '(1.0 0.8)] [distance '(2.0 20.0 1e5)])
      (check-mean (format "cosine ~a, distance ~a" c distance)
                  (estimates c distance) (* pi (/ c (* distance distance))) 1e-3)))

  ;; --- flat lights, seen by the origin; two-sided where they need not face it ---
  (define (shining two-sided?) (Emitter white two-sided?))
  (define-syntax-rule (flat-light-case name expected light)
    (test-case (format "~a: 4 standard errors, error below 0.5%" name)
      (define world (world-of chalk '() #:shapes (list light)))
      (check-mean name (for/list ([seed 16]) (Float3-x (towards world up #:seed seed)))
                  expected 5e-3)))
  (flat-light-case "A01 a rectangle's corner above" 0.4352098756835516
                   (Quad (Float3 0 0 1) (Float3 0 1 0) (Float3 1 0 0) (shining #f)))
  (flat-light-case "A02 a rectangle's middle above" 1.7408395027342063
                   (Quad (Float3 -1 -1 1) (Float3 0 2 0) (Float3 2 0 0) (shining #f)))
  (flat-light-case "A04 a rectangle that stands upright" 0.2986647456419607
                   (Quad (Float3 1 0 0) (Float3 0 0 2) (Float3 0 1 0) (shining #f)))
  (flat-light-case "A05 a triangle" 0.21650809210405844
                   (Triangle (Float3 1 0 2) (Float3 2 1.5 3) (Float3 -1 1 1.5) (shining #t)))
  (flat-light-case "A06 a rectangle partly below the horizon" 0.5173714719892747
                   (Quad (Float3 2 -1 -1) (Float3 0 2 0) (Float3 -1 0 3) (shining #t)))
  (flat-light-case "A12 a disk off the axis" 0.39676851439432764
                   (Disk (Float3 1.5 0 1) (Float3 0 0 -1) 1 (shining #f)))
  (flat-light-case "A13 a disk across" 0.26832404625866063
                   (Disk (Float3 1 0 2) (Float3 -1 0 0) 1 (shining #f)))
  (test-case "a one-sided light does not shine backwards"
    (for ([light (list (Quad (Float3 -1 -1 1) (Float3 2 0 0) (Float3 0 2 0) (shining #f))
                       (Disk (Float3 0 0 1) (Float3 0 0 1) 1 (shining #f)))])
      (check-equal? (towards (world-of chalk '() #:shapes (list light)) up) black)))

  (test-case "a light seen directly is its radiance, from outside"
    (define world (World (list (Sphere (Float3 0 0 0) 1 (Emitter (Float3 3 2 1)))) '() black))
    (check-equal? (World-ray-trace world (Ray (Float3 0 0 3) (Float3 0 0 -1))) (Float3 3 2 1))
    (check-equal? (World-ray-trace world (Ray (Float3 0 0 0) (Float3 0 0 -1))) black))

  ;; D17: ambient 0.1, diffuse 0.9, highlight 0.9 with exponent 200, a white light.
  (define shiny (Phong (Float3 0.9 0.9 0.9) #:specularity 0.9 #:shininess 200))
  (define half (sqrt 0.5))
  (define aslant (Float3 0 half half))
  (define (lighting light-direction eye-direction)
    (Float3-x (towards (world-of shiny (DistantLight light-direction white)
                                 #:ambient (Float3 (/ 0.1 0.9) (/ 0.1 0.9) (/ 0.1 0.9)))
                       eye-direction)))
  (test-case "D17: ambient, diffuse and highlight of Phong's formula, to 1e-12"
    (for ([light (list up aslant aslant up (Float3 0 0 -1))]
          [eye (list up up (Float3 0 (- half) half) aslant up)]
          [expected '(1.9 0.7363961030678928 1.6363961030678928 1.0 0.1)])
      (check-= (lighting light eye) expected 1e-12)))
  (test-case "D17 in a shadow: ambient light alone"
    (define world
      (world-of shiny (DistantLight up white) #:shapes (list (Sphere (Float3 0 0 3) 1))
                #:ambient (Float3 (/ 0.1 0.9) (/ 0.1 0.9) (/ 0.1 0.9))))
    (check-= (Float3-x (towards world up)) 0.1 1e-15))

  (test-case "a mirror: its part of what it sees, the rest of its own shading"
    (define half-mirror (Phong white #:specularity 0 #:reflectivity (Float3 0.5 0.25 1)))
    (define world
      (World (list (floor half-mirror)) (DistantLight up white) (Float3 0.2 0.4 0.8)
             #:ambient-color black #:ambient-samples 0))
    (define seen (towards world aslant))
    (for ([c (list (Float3-x seen) (Float3-y seen) (Float3-z seen))]
          [e (list (+ 0.5 0.1) (+ 0.75 0.1) (+ 0.0 0.8))])
      (check-= c e 1e-15)))

  (test-case "between two perfect mirrors 50 bounces, then black; fewer when asked for fewer"
    (define mirror (Phong white #:specularity 0 #:reflectivity 0.5))
    (define (world bounces)
      (World (list (floor mirror) (Plane (Float3 0 0 1) (Float3 0 0 -1) mirror))
             '() white #:ambient-color white #:ambient-samples 0 #:mirror-bounces bounces))
    ;; each surface gives half of the white ambient light and half of what it mirrors
    (for ([bounces '(0 1 2 10 50)])
      (check-= (Float3-x (World-ray-trace (world bounces) (Ray (Float3 0 0 0.5) (Float3 0 0 -1))))
               (- 1.0 (expt 0.5 (+ bounces 1.0))) 1e-14))))
