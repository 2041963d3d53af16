#lang racket/base
;; Participating media against closed forms and quadrature: absorption, light scattered once, white
;; media in a furnace, boundaries, overlaps and cameras inside.
(require racket/math raytrace "measure.rkt")

(define one (Float3 1 1 1))
(define origin (Float3 0 0 0))
(define ahead (Float3 0 0 -1))
(define camera (look-from origin ahead))

(define (wall distance material)
  (Quad (Float3 -100 -100 (- distance)) (Float3 200 0 0) (Float3 0 200 0) material))

(define (ball medium [surface #f])
  (Sphere (Float3 0 0 -3) 1 #:material (Interior medium surface)))

(define (simpson f a b)
  (define n 4000)
  (define h (/ (- b a) n))
  (* (/ h 3)
     (for/sum ([k (in-range (+ n 1))])
       (* (cond [(or (= k 0) (= k n)) 1] [(odd? k) 4] [else 2]) (f (+ a (* k h)))))))

;; Henyey and Greenstein's phase function, as in their paper.
(define (phase g cosine)
  (/ (- 1 (* g g)) (* 4 pi (expt (+ 1 (* g g) (* -2 g cosine)) 1.5))))

;; What a point light of intensity 1 at (0, y, -2) brings to the eye at the origin by one scattering
;; at distances from a to b, where all is filled with a medium from the distance `near` on a ball's
;; other side: lost(t) is the length in the medium before and after the point.
(define (single-scattering extinction albedo g y a b lost)
  (simpson (lambda (t)
             (define squared (+ (* y y) (sqr (- 2 t))))
             (* extinction albedo (exp (* -1 extinction (lost t)))
                (phase g (/ (- 2 t) (sqrt squared)))
                (/ 1 squared)))
           a b))

(module+ test
  (require rackunit)

  (test-case "what is absorbed: exp(-extinction distance), to rounding"
    (define world
      (World (list (wall 3 (Emitter one #:two-sided? #t))) '() origin
             #:medium (Medium (Float3 0.5 0.5 0.5) origin)))
    (check-radiance world camera (exp -1.5) #:samples 2 #:seeds 2)
    (check-radiance (World (list (ball (Medium 0.7 origin))) '() one) camera (exp -1.4)
                    #:samples 2 #:seeds 2))

  (test-case "a camera inside a shape's medium, and inside two"
    (define inner (Sphere (Float3 0 0 -3) 0.6 #:material (Interior (Medium 1.1 origin))))
    (define world (World (list (ball (Medium 0.7 origin)) inner) '() one))
    (check-radiance world (look-from (Float3 0 0 -2.3) (Float3 0 0 -9)) (exp (- (+ 1.19 1.32)))
                    #:samples 2 #:seeds 2)
    (check-radiance world (look-from (Float3 0 0 -3) (Float3 0 0 -9)) (exp (- (+ 0.7 0.66)))
                    #:samples 2 #:seeds 2))

  (test-case "white media in a furnace return everything"
    (for ([medium (list (Medium 1 one) (Medium 5 one #:anisotropy 0.7)
                        (Medium 4 one #:density (lambda (p) (abs (sin (* 7 (Float3-x p))))))
                        (Medium (Float3 1 2 4) one #:anisotropy -0.3
                                #:density (lambda (p) (abs (Float3-y p)))))])
      ;; chances of collisions are numbers of 32 bits: 1e-6 beside the standard error
      (define-values (mean error)
        (measure (World (list (ball medium)) '() one) camera #:samples 64 #:seeds 16))
      (check-= mean 1 (+ 1e-6 (* 4.5 error)))
      (check-true (< error 0.002)))
    (check-radiance (World (list (ball (Medium (Float3 0.5 1 2) one #:anisotropy 0.5))) '() one)
                    camera 1 #:samples 1024 #:seeds 16 #:precision 0.004)
    (check-radiance (World (list (ball (Medium 3 one) (Dielectric 1.5))) '() one)
                    camera 1 #:samples 512 #:seeds 32 #:precision 0.003))

  (test-case "media that overlap are both there"
    (define inner (Sphere (Float3 0.2 0.1 -3) 0.7 #:material (Interior (Medium 2 one 0.5))))
    (check-radiance (World (list (ball (Medium 1 one)) inner) '() one) camera 1
                    #:samples 64 #:seeds 16 #:precision 0.002))

  (test-case "light scattered once on the way to a wall, beside quadrature"
    (for* ([y '(1.0 0.05)] [g '(0.0 0.6 -0.4)])
      (define world
        (World (list (wall 4 (grey 0))) (PointLight (Float3 0 y -2) one) origin
               #:medium (Medium 0.3 (Float3 0.8 0.8 0.8) #:anisotropy g)))
      (check-radiance
       world camera
       (single-scattering 0.3 0.8 g y 0.0 4.0
                          (lambda (t) (+ t (sqrt (+ (* y y) (sqr (- 2 t)))))))
       #:samples 256 #:seeds 16 #:max-depth 1 #:precision 0.002)))

  (test-case "the same in a ball, whose boundary the light passes, constant and by tracking"
    (for ([medium (list (Medium 0.9 one) (Medium 0.9 one #:density (lambda (p) 1) #:majorant 2))])
      (define world (World (list (ball medium)) (PointLight (Float3 0 3 -2) one) origin))
      ;; length within the ball of the way from distance t to the light
      (define (inside t)
        (define dy 3.0)
        (define dz (- t 2.0))
        (define oz (- 3.0 t))
        (define a (+ (* dy dy) (* dz dz)))
        (define b (* oz dz))
        (define c (- (* oz oz) 1))
        (* (sqrt a) (/ (+ (- b) (sqrt (- (* b b) (* a c)))) a)))
      (define expected
        (simpson (lambda (t)
                   (define squared (+ 9.0 (sqr (- 2 t))))
                   (/ (* 0.9 (exp (* -0.9 (+ (- t 2) (inside t)))) (/ 1 (* 4 pi))) squared))
                 2.0 4.0))
      (check-radiance world camera expected #:samples 1024 #:seeds 16 #:max-depth 1
                      #:precision 0.01)))

  (test-case "a shining ball is found by three ways that are weighted together"
    ;; the quadrature over distances and the ball's cone; the ray ends on the ball
    (define g 0.9)
    (define end (- 3 (sqrt (- 0.0225 0.01))))
    (define (from-ball t)
      (define squared (+ 0.01 (sqr (- 3 t))))
      (define distance (sqrt squared))
      (define cosine-most (sqrt (max 0 (- 1 (/ 0.0225 squared)))))
      (define-values (y z) (values (/ 0.1 distance) (/ (- t 3) distance)))
      (define n 48)
      (for*/fold ([sum 0.0] #:result (/ (* sum 2 pi (- 1 cosine-most)) (* n n)))
                 ([j n] [k n])
        (define c (- 1 (* (- 1 cosine-most) (/ (+ j 0.5) n))))
        (define s (sqrt (max 0 (- 1 (* c c)))))
        (define turn (* 2 pi (/ (+ k 0.5) n)))
        (define half-chord (sqrt (max 0 (- 0.0225 (* squared s s)))))
        (define way (- (* distance c) half-chord))
        (+ sum (* (phase g (- (+ (* c z) (* s (sin turn) -1 y)))) 10 (exp (* -0.3 way))))))
    (define n 300)
    (define expected
      (+ (* 10 (exp (* -0.3 end)))
         (* (/ end n)
            (for/sum ([k n])
              (define t (* end (/ (+ k 0.5) n)))
              (* 0.3 (exp (* -0.3 t)) (from-ball t))))))
    (define world
      (World (list (wall 4 (grey 0))
                   (Sphere (Float3 0 0.1 -3) 0.15 #:material (Emitter (Float3 10 10 10))))
             '() origin #:medium (Medium 0.3 one #:anisotropy g)))
    (check-radiance world camera expected #:samples 4096 #:seeds 16 #:max-depth 1
                    #:precision 0.001))

  (test-case "the picture is the same with any schedule"
    (define world
      (World (list (ball (Medium 2 one #:density (lambda (p) (abs (Float3-x p))))) (wall 6 (grey 0.5)))
             (PointLight (Float3 2 3 0) one) (Float3 0.1 0.2 0.3)))
    (define wide (Camera-look-at origin ahead))
    (define (picture . options)
      (keyword-apply render '(#:height #:samples #:schedule #:tile #:width)
                     (list 12 4 (car options) (cadr options) 16) (list world wide)))
    (check-equal? (Image-pixels (picture 'sequential 16)) (Image-pixels (picture 'futures 3))))

  (test-case "bad media"
    (check-exn #rx"Medium: .*albedo" (lambda () (Medium 1 (Float3 2 0 0))))
    (check-exn #rx"Medium: .*anisotropy" (lambda () (Medium 1 one 1)))
    (check-exn #rx"Medium: .*majorant" (lambda () (Medium 1 one #:majorant 0)))
    (check-exn #rx"Interior: .*surface" (lambda () (Interior (Medium 1 one) (Emitter one))))
    (check-exn #rx"World: .*medium"
               (lambda () (World #:medium (Medium 1 one #:density (lambda (p) 1)))))))
