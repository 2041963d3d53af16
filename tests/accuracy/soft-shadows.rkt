#lang racket/base
;; Shadows against closed forms: an eclipse, a hard edge, umbra and penumbra.

(module+ test
  (require racket/math rackunit "../../main.rkt" "../statistics.rkt"
           "../light/light-samples.rkt")

  (define chalk (Phong (Float3 1 1 1) #:specularity 0))
  (define floor (Plane (Float3 0 0 0) (Float3 0 0 1) chalk))
  (define black (Float3 0 0 0))
  (define (shining center radius)
    (Sphere center radius (Emitter (Float3 1 1 1))))
  (define (world-of shapes [lights '()] #:samples [samples 1])
    (World shapes lights black #:ambient-color black #:ambient-samples 0
           #:shadow-samples samples))

  ;; The red light of the floor point (x, 0), seen from just above it: what is more than the
  ;; height h above the floor is behind the viewer.
  (define (seen world x #:seed [seed 0] #:h [h 0.01])
    (Float3-x (World-ray-trace world (Ray (Float3 x 0 h) (Float3 0 0 -1)) #:seed seed)))

  ;; --- a straight edge: the half-plane z = 2, x < edge, below a disk or a square at z = 4 ---
  (define (half-plane edge)
    (Quad (Float3 (- edge 1e4) -1e4 2) (Float3 1e4 0 0) (Float3 0 2e4 0)))
  (define white-light (Emitter (Float3 1 1 1)))
  (define disk-light (Disk (Float3 0 0 4) (Float3 0 0 -1) 0.5 white-light))
  (define square-light
    (Quad (Float3 -0.5 -0.5 4) (Float3 0 1 0) (Float3 1 0 0) white-light))

  (test-case "B01: the part of a disk's area that an edge leaves, 4 standard errors"
    (define world (world-of (list disk-light (half-plane 0.0625))))
    (check-mean "B01" (for/list ([seed 16]) (light-visible-part world (Float3 0 0 0) 4096 seed))
                0.3425188212371463 2e-3))

  (define (check-edge name light x expected)
    (define world (world-of (list floor light (half-plane 0)) #:samples 2048))
    (check-mean name (for/list ([seed 16]) (seen world x #:seed seed)) expected 1e-2))
  (test-case "B02: irradiance in a disk's penumbra, 4 standard errors, error below 1%"
    (for ([x '(-0.4 -0.25 0.25 0.4)]
          [expected '(0.00233796097791169 0.009126095768637973
                      0.03884206954924924 0.04507035269143468)])
      (check-edge (format "B02 at ~a" x) disk-light x expected)))
  (test-case "B04: irradiance in a square's penumbra"
    (check-edge "B04" square-light 0.1 0.036931664891124816))
  (test-case "B03: the penumbra is as wide as it should be"
    (for ([light (list disk-light square-light)])
      (define-values (edged open)
        (values (world-of (list floor light (half-plane 0)) #:samples 2048)
                (world-of (list floor light) #:samples 2048)))
      (check-equal? (seen edged -0.5001) 0.0)
      (check-true (> (seen edged -0.48) 0.0))
      (check-equal? (seen edged 0.5001) (seen open 0.5001))
      (check-true (< (seen edged 0.48) (seen open 0.48)))))

  ;; B05, B06: seen from the origin, a light of half-angle a behind a ball of half-angle b, their
  ;; centres at the angle c apart.
  (define (visible-part a b c seed)
    (define world
      (world-of (list (shining (Float3 0 0 10) (* 10 (sin a)))
                      (Sphere (Float3 (* 4 (sin c)) 0 (* 4 (cos c))) (* 4 (sin b))))))
    (light-visible-part world (Float3 0 0 0) 4096 seed))

  (test-case "B05, B06: an eclipse, solid angle hidden and part visible, 4 standard errors"
    (define parts (for/list ([seed 16]) (visible-part 0.3 0.5 0.6 seed)))
    (check-mean "B06" parts 0.7504552079321828 1e-3)
    (define cone (* 2.0 pi (- 1.0 (cos 0.3))))
    (check-mean "B05" (map (lambda (p) (* cone (- 1.0 p))) parts) 0.07002953422397915 3e-3))

  (test-case "eclipses that are none, or total: exactly"
    (check-equal? (visible-part 0.3 0.5 0.81 0) 1.0)
    (check-equal? (visible-part 0.3 0.5 0.19 0) 0.0))

  (test-case "B08: a point light's hard shadow ends at its radius, to 1e-9"
    (define world
      (world-of (list floor (Sphere (Float3 0 0 2) 1)) (list (PointLight (Float3 0 0 5) black))))
    (define lit
      (world-of (list floor (Sphere (Float3 0 0 2) 1))
                (list (PointLight (Float3 0 0 5) (Float3 1 1 1)))))
    (check-equal? (seen world 3) 0.0)
    (define edge
      (let bisect ([dark 0.0] [light 4.0] [steps 60])
        (define middle (* 0.5 (+ dark light)))
        (cond
          [(zero? steps) middle]
          [(= 0.0 (seen lit middle)) (bisect middle light (- steps 1))]
          [else (bisect dark middle (- steps 1))])))
    (check-= edge 1.7677669529663689 1e-9)
    ;; beyond it, the whole light: I cos / d^2
    (for ([x '(1.77 2.0 5.0)])
      (check-= (seen lit x) (/ 5.0 (expt (+ 25.0 (* x x)) 1.5)) 1e-15)))

  (test-case "B09: within the umbra no light, beyond the penumbra all of it, between them a part"
    (define-values (umbra penumbra) (values 1.6724840200141815 2.566755791678992))
    (define light (shining (Float3 0 0 8) 1))
    (define-values (blocked open)
      (values (world-of (list floor light (Sphere (Float3 0 0 2) 1.5)) #:samples 1024)
              (world-of (list floor light) #:samples 1024)))
    (for ([part '(0.0 0.5 0.9 0.999)]) (check-equal? (seen blocked (* part umbra)) 0.0))
    (for ([part '(1.001 1.1 2.0)])
      (check-equal? (seen blocked (* part penumbra)) (seen open (* part penumbra))))
    (for ([x (list (* 1.02 umbra) (* 0.98 penumbra))])
      (check-true (< 0.0 (seen blocked x) (* (- 1.0 1e-4) (seen open x)))))
    ;; the light grows all the way
    (define steps
      (for/list ([k 15])
        (define x (+ umbra (* (/ (+ k 0.5) 15) (- penumbra umbra))))
        (/ (seen blocked x) (seen open x))))
    (check-true (apply < steps)))

  (test-case "the light is not its own shadow, nor is the sphere it shines on"
    (define world (world-of (list floor (shining (Float3 0 0 8) 1)) #:samples 256))
    (check-mean "pi (R/d)^2" (for/list ([seed 16]) (seen world 0 #:seed seed)) (/ pi 64.0) 1e-3))

  (test-case "B10: one shadow ray at half visibility deviates by half, to 5%"
    (define parts
      (for/list ([seed (stressed 2000 40000)])
        (define world
          (world-of (list (shining (Float3 0 0 1000) 1)
                          ;; so large a ball has a straight edge
                          (Sphere (Float3 0 1e5 500) 1e5))))
        (light-visible-part world (Float3 0 0 0) 1 seed)))
    (check-= (mean parts) 0.5 0.05)
    (check-= (standard-deviation parts) 0.5 0.025))

  (test-case "no shadow samples: no shadows"
    (define world (world-of (list floor (Sphere (Float3 0 0 2) 1))
                            (list (PointLight (Float3 0 0 5) (Float3 25 25 25))) #:samples 0))
    (check-= (seen world 0) 1.0 1e-15)))
