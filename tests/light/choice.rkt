#lang racket/base
;; The choice among lights: probabilities that add up to 1 and are those of the choices made, the
;; same light as from all of them, with less noise than choosing uniformly.

(module+ test
  (require racket/list racket/math rackunit "../../main.rkt" "../statistics.rkt"
           "light-choices.rkt")

  (define uniform (seeded 1))
  (define (random-float3 low high) (Float3 (uniform low high) (uniform low high) (uniform low high)))
  (define (random-unit)
    (define v (random-float3 -1.0 1.0))
    (if (< 0.1 (Float3-length v) 1.0) (Float3-normalized v) (random-unit)))
  (define (random-color) (random-float3 0.1 3.0))
  (define black (Float3 0 0 0))

  ;; One light of every kind in turn: as a pair of a list of shapes and a list of lights.
  (define (random-light k)
    (define at (random-float3 -10.0 10.0))
    (define shines (Emitter (random-color) #:two-sided? (= 0 (random-integer 3))))
    (case (remainder k 8)
      [(0) (Sphere at (uniform 0.05 0.5) shines)]
      [(1) (Quad at (random-unit) (random-unit) shines)]
      [(2) (PointLight at (random-color))]
      [(3) (Triangle at (Float3-add at (random-unit)) (Float3-add at (random-unit)) shines)]
      [(4) (SpotLight at (random-unit) (random-color) (uniform 0.2 1.2) 0.1)]
      [(5) (Disk at (random-unit) (uniform 0.1 0.6) shines)]
      [(6) (Box at (Float3-add at (random-float3 0.1 0.7)) shines)]
      [(7) (if (= 0 (random-integer 4))
               (DistantLight (random-unit) (Float3-scale-by-scalar (random-color) 0.001))
               (Sphere at 0.02 shines))]))
  (define (random-integer n) (inexact->exact (floor (uniform 0.0 n))))
  (define (world-of all)
    (World (filter Shape? all) (filter Light? all) black))
  (define (random-world n) (world-of (for/list ([k n]) (random-light k))))

  (define worlds (for/list ([n '(1 2 16 17 1000)]) (random-world n)))

  (test-case "probabilities add up to 1, within 1e-12, wherever the surface"
    (for* ([world worlds] [k 20] [transmits? '(#f #t)])
      (define point (random-float3 -15.0 15.0))
      (define all (light-probabilities world point (random-unit) transmits?))
      (check-equal? (length all) (light-count world))
      (check-= (apply + all) 1.0 1e-12)))

  (test-case "probabilities add up to 1 where no light is in front, or all are black"
    (define (row color)
      (world-of (for/list ([k 20]) (Sphere (Float3 k 0 0) 0.1 (Emitter color)))))
    (for ([world (list (row (Float3 1 1 1)) (row black))] [y '(-1 1)])
      (check-= (apply + (light-probabilities world (Float3 3 y 0) (Float3 0 -1 0) #f)) 1.0 1e-12)))

  ;; Cells with 20 expected choices or more, and one for all others together.
  (define (choice-deviate counts probabilities total)
    (define-values (often seldom)
      (partition (lambda (pair) (>= (* total (cdr pair)) 20.0)) (map cons counts probabilities)))
    (define rest-expected (* total (for/sum ([p seldom]) (cdr p))))
    (define cells
      (if (>= rest-expected 20.0)
          (cons (cons (for/sum ([p seldom]) (car p)) (/ rest-expected total)) often)
          often))
    (if (< (length cells) 2)
        0.0
        (chi-square-deviate (map car cells) (map (lambda (p) (* total (cdr p))) cells))))

  ;; the deviate of level .01 for all fifteen chi-square tests together (Sidak)
  (define SIDAK 3.21)
  (test-case "choices: as often as the probabilities say, chi-square, and as reported"
    (define total (stressed 100000 1000000))
    (for* ([world worlds] [seed 3])
      (define-values (point normal) (values (random-float3 -11.0 11.0) (random-unit)))
      (define transmits? (= seed 2))
      (define probabilities (light-probabilities world point normal transmits?))
      (define-values (counts reported)
        (light-choices world point normal transmits? total seed))
      (define z (choice-deviate counts probabilities (exact->inexact total)))
      (check-true (< z SIDAK) (format "~a lights: deviate ~a" (light-count world) z))
      (for ([p probabilities] [q reported] [n counts])
        (cond
          [(> n 0) (unless (< (abs (- p q)) (* 1e-12 p)) (fail (format "~a reported ~a" p q)))]
          [else (unless (< (* total p) 30.0) (fail (format "~a never chosen" p)))])
        ;; the light of probability 0 is not chosen
        (when (= p 0.0) (check-equal? n 0)))))

  (test-case "a light in front that shines to the surface always has a probability"
    (for ([world (list (third worlds) (last worlds))] [k 40])
      (define-values (point normal) (values (random-float3 -12.0 12.0) (random-unit)))
      (define all (light-probabilities world point normal #f))
      (for ([light (World-lights world)]
            [p (drop all (- (length all) (length (World-lights world))))]
            #:when (PointLight? light))
        (define to-light (Float3-subtract (PointLight-point light) point))
        (when (> (Float3-dot to-light normal) 0.0) (check-true (> p 0.0))))))

  (test-case "one light is every choice; two are chosen by what they bring"
    (define-values (a b) (values (PointLight (Float3 0 1 0) (Float3 1 1 1))
                                 (PointLight (Float3 0 2 0) (Float3 8 8 8))))
    (define up (Float3 0 1 0))
    (check-equal? (light-probabilities (world-of (list a)) black up #f) '(1.0))
    (define two (light-probabilities (world-of (list a b)) black up #f))
    (check-= (first two) 1/3 1e-15)
    (define aside (light-probabilities (world-of (list a b)) (Float3 0 1.5 0) up #f))
    (check-equal? aside '(0.0 1.0))
    (check-true (< 0.1 (first (light-probabilities (world-of (list a b)) (Float3 0 1.5 0) up #t)))))

  ;; Lights above the floor y = 0, all facing it.
  (define (hall n)
    (world-of
     (for/list ([k n])
       (define at (Float3 (uniform -20.0 20.0) (uniform 0.2 4.0) (uniform -20.0 20.0)))
       (if (even? k)
           (Sphere at 0.05 (Emitter (random-color)))
           (Quad at (Float3 0.2 0 0) (Float3 0 0 0.2) (Emitter (random-color)))))))

  (test-case "the irradiance of all lights, one at a time: 4 standard errors, error below 2%"
    (for ([n '(2 16 17 300)])
      (define world (hall n))
      (for ([k 3])
        (define-values (point up)
          (values (Float3 (uniform -15.0 15.0) 0.0 (uniform -15.0 15.0)) (Float3 0 1 0)))
        ;; each shape alone, by the same kernels but without a choice
        (define expected
          (for/list ([shape (World-shapes world)])
            (define samples (irradiance-samples (World (list shape) '() black) point up 256 5 #f))
            (cons (mean samples) (/ (expt (standard-deviation samples) 2) 256))))
        (define estimates (irradiance-samples world point up 40000 k #f))
        (define error (sqrt (+ (expt (standard-error estimates) 2) (apply + (map cdr expected)))))
        (define sum (apply + (map car expected)))
        (check-true (< error (* 0.02 sum)) (format "error ~a of ~a" error sum))
        (check-true (< (abs (- (mean estimates) sum)) (* 4.0 error))
                    (format "~a lights: ~a, sum ~a, error ~a" n (mean estimates) sum error)))))

  ;; What a floor of albedo 1/2 sends up, by the path integrator, from independent seeds.
  (define (floor-radiances lights seeds)
    (define floor (Disk black (Float3 0 1 0) 50 (Lambertian (Float3 0.5 0.5 0.5))))
    (define world (world-of (cons floor lights)))
    (define camera
      (Camera-look-at (Float3 0.1 0.2 0.15) black #:vertical-field-of-view-degrees 1e-6))
    (for/list ([seed seeds])
      (define-values (red green blue)
        (Image-pixel (render world camera #:width 1 #:height 1 #:samples 64 #:seed seed
                             #:integrator 'path #:max-depth 1 #:schedule 'sequential)
                     0 0))
      red))

  (test-case "point lights, spots and suns together light a floor by the sum of their closed forms"
    (for ([n '(5 16 17 1000)])
      (define lights
        (for/list ([k n])
          (define at (Float3 (uniform -9.0 9.0) (uniform -1.0 6.0) (uniform -9.0 9.0)))
          (if (< k 3)
              (DistantLight at (Float3 0.2 1 1))
              (PointLight at (Float3 (uniform) 1 1)))))
      (define irradiance
        (for/sum ([light lights])
          (cond
            [(DistantLight? light) (* 0.2 (max 0.0 (Float3-y (DistantLight-direction light))))]
            [else
             (define at (PointLight-point light))
             (define d (Float3-length at))
             (* (Float3-x (PointLight-intensity light)) (max 0.0 (Float3-y at))
                (/ 1.0 (expt d 3)))])))
      (check-mean (format "~a lights" n) (floor-radiances lights 48) (/ irradiance 2 pi) 0.03)))

  (test-case "sphere lights, sampled and hit, light a floor by the sum of their closed forms"
    (for ([n '(3 16 60)])
      ;; a shell of directions so far apart that no light shadows another
      (define lights
        (for/list ([k n])
          (define height (/ (+ k 1.0) (+ n 1.0)))
          (define side (sqrt (- 1.0 (* height height))))
          (define turn (* k pi (- 3 (sqrt 5))))
          (define distance (uniform 2.0 6.0))
          (Sphere (Float3 (* distance side (cos turn)) (* distance height)
                          (* distance side (sin turn)))
                  (* distance (min 0.09 (* 0.9 height))) (Emitter (random-color)))))
      (define irradiance
        (for/sum ([light lights])
          (define at (Sphere-point light))
          (define d (Float3-length at))
          (* pi (Float3-x (Emitter-radiance (Sphere-material light)))
             (expt (/ (Sphere-radius light) d) 2) (/ (Float3-y at) d))))
      (check-mean (format "~a lights" n) (floor-radiances lights 48) (/ irradiance 2 pi) 0.02)))

  (test-case "1,000 lights: less than half the variance of the uniform choice"
    (define world (hall 1000))
    (for ([k 3])
      (define-values (point up)
        (values (Float3 (uniform -15.0 15.0) 0.0 (uniform -15.0 15.0)) (Float3 0 1 0)))
      (define (variance uniform?)
        (expt (standard-deviation (irradiance-samples world point up 20000 k uniform?)) 2))
      (define ratio (/ (variance #f) (variance #t)))
      (printf "variance with the tree / uniform, 1,000 lights: ~a\n" ratio)
      (check-true (< ratio 0.5) (format "ratio ~a" ratio))))

  ;; the timer of the runtime allocates too, about half a byte a choice; a boxed number takes 16
  (test-case "a choice allocates nothing: less than 4 bytes"
    (for ([world (cdr worlds)])
      (define bytes (bytes-per-choice world (Float3 1 2 3) (Float3 0 1 0) 100000))
      (check-true (< bytes 4.0) (format "~a lights: ~a bytes" (light-count world) bytes)))))
