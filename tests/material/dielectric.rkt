#lang racket/base
;; Dielectric through its kernel: E01 to E14, D09b, D10, D11, S23.

(module+ test
  (require rackunit racket/flonum racket/math "support.rkt"
           "../../private/base/float3.rkt" "../../private/material/dielectric.rkt"
           "../../private/material/kernel.rkt")

  (define UP (flvector 0.0 1.0 0.0))
  (define glass (make-bench (make-Dielectric 1.5)))
  (define book-glass (make-bench (make-Dielectric 1.5 #:fresnel 'schlick)))
  (define white (flvector 1.0 1.0 1.0))
  (define (list-of v) (for/list ([x (in-flvector v)]) x))
  (define (negated v) (for/flvector #:length 3 ([x (in-flvector v)]) (* -1.0 x)))
  (define (scaled v s) (for/flvector #:length 3 ([x (in-flvector v)]) (* s x)))
  (define (added u v) (for/flvector #:length 3 ([x (in-flvector u)] [y (in-flvector v)]) (+ x y)))
  (define (reflected? b normal) (> (dot (sampled-direction b) normal) 0.0))

  ;; The part of 2^14 samples that is reflected. They are a (0,14,2)-net, one in each 2^-14 of the
  ;; interval the choice is made by, so it is exact to 2^-14.
  (define (reflected-part b degrees inside?)
    (face! b (direction-at NORMAL degrees) #:inside? inside?)
    (define count 16384)
    (/ (for/sum ([k (in-range count)]) (draw! b 3 k) (if (reflected? b NORMAL) 1.0 0.0)) count))
  (define NET-ERROR (expt 2.0 -14))

  (test-case "what the integrator is told"
    (check-true (MaterialKernel-specular? (bench-kernel glass)))
    (check-true (MaterialKernel-transmits? (bench-kernel glass)))
    (face! glass (direction-at NORMAL 30.0))
    (evaluate! glass (direction-at NORMAL 30.0 3.0))
    (check-equal? (sampled-weight glass) (flvector 0.0 0.0 0.0))
    (check-equal? (sampled-density glass) 0.0))

  (test-case "S23: every sample of clear glass weighs exactly 1, at ten angles, from both sides"
    (for* ([b (list glass book-glass)] [inside? '(#f #t)] [degrees INCIDENCES] [k (in-range 200)])
      (face! b (direction-at NORMAL degrees) #:inside? inside?)
      (draw! b k)
      (check-equal? (sampled-weight b) white)
      (check-true (specular-sample? b))
      (check-= (dot (sampled-direction b) (sampled-direction b)) 1.0 1e-14)))

  (test-case "E01, E03: the reflected part from air and from glass, exact and Schlick, to 2^-14"
    (for ([row (in-list '((0.0 #f 0.04 0.04)
                          (30.0 #f 0.04152262597582154 0.040041436543139367)
                          (45.0 #f 0.05023991101223594 0.04206927312437236)
                          (75.0 #f 0.25306056299031965 0.25472988408661434)
                          (85.0 #f 0.6127996452648273 0.6484917182355181)
                          (89.0 #f 0.9041849497801892 0.9191018917997219)
                          (30.0 #t 0.055190167295375916 0.040041436543139367)
                          (41.0 #t 0.3797512659624401 0.04085246030532483)))])
      (define-values (degrees inside? exact schlick) (apply values row))
      (check-= (reflected-part glass degrees inside?) exact NET-ERROR)
      (check-= (reflected-part book-glass degrees inside?) schlick NET-ERROR)))

  (test-case "D09b: impact .9 on a glass ball, the same part at entry and inside, to 2^-14"
    (define part 0.11414110022135394)
    (check-= (reflected-part glass (radians->degrees (asin 0.9)) #f) part NET-ERROR)
    (check-= (reflected-part glass (radians->degrees (asin 0.6)) #t) part NET-ERROR))

  (test-case "E04: from the critical angle on all is reflected; S15: at grazing incidence too"
    (define critical 41.810314895778596)
    (for ([b (list glass book-glass)])
      (check-equal? (reflected-part b (* critical (+ 1.0 1e-12)) #t) 1.0)
      (check-equal? (reflected-part b 89.999999 #t) 1.0)
      (check-true (< (reflected-part b (* critical (- 1.0 1e-6)) #t) 1.0)))
    (check-equal? (reflected-part glass 89.999999 #f) 1.0)
    (for ([k (in-range 1000)])
      (face! glass (flvector 1.0 1e-16 0.0) #:normal UP)
      (draw! glass k)
      (check-true (close? (sampled-direction glass) '(-1.0 1e-16 0.0) 1e-15))))

  ;; The direction after passing through, or after reflection, found by trying up to 10,000 pixels.
  (define (passed b out normal inside? [through? #t])
    (face! b out #:normal normal #:inside? inside?)
    (let try ([k 0])
      (draw! b k)
      (cond
        [(not (eq? through? (reflected? b normal))) (sampled-direction b)]
        [(< k 10000) (try (+ k 1))]
        [else (error "no sample passes, or none is reflected")])))

  (test-case "E06, E07: refracted directions, to 1e-15"
    (define s (sqrt 0.5))
    (check-true (close? (passed glass (flvector (- s) s 0.0) UP #f)
                        '(0.4714045207910317 -0.8819171036881969 0.0) 1e-15))
    (define d (passed glass (flvector -0.5 (sqrt 0.75) 0.0) UP #f))
    (check-= (radians->degrees (atan (flvector-ref d 0) (- (flvector-ref d 1))))
             19.47122063449069 1e-13)
    ;; and back out again
    (check-true (close? (passed glass (negated d) UP #t)
                        (list 0.5 (- (sqrt 0.75)) 0.0) 1e-15)))

  ;; Light along +x enters the unit ball at height h: where it enters, and its direction inside.
  (define (enter-ball b h)
    (define entry (flvector (- (sqrt (- 1.0 (* h h)))) h 0.0))
    (values entry (passed b (flvector -1.0 0.0 0.0) entry #f)))
  (define (across-ball point d) (added point (scaled d (* -2.0 (dot point d)))))

  (test-case "E10, E11: where a ball lens crosses the axis, relative 1e-12 (paraxial: 1e-8)"
    (for ([row (in-list '((1e-5 1.5 1e-8) (0.1 1.4958270630560688 1e-12)
                                          (0.5 1.3915729488893103 1e-12)))])
      (define-values (entry d) (enter-ball glass (car row)))
      (define exit (across-ball entry d))
      (define out (passed glass (negated d) (negated exit) #t))
      (define axis (- (flvector-ref exit 0)
                      (* (flvector-ref exit 1) (/ (flvector-ref out 0) (flvector-ref out 1)))))
      (check-= (/ axis (cadr row)) 1.0 (caddr row))))

  (test-case "E12: the primary rainbow, to 1e-12 degrees, and that it is the largest angle"
    (define water (make-bench (make-Dielectric (/ 4.0 3.0))))
    (define (rainbow-angle h)
      (define-values (entry d) (enter-ball water h))
      (define back (across-ball entry d))
      (define e (passed water (negated d) (negated back) #t #f))
      (define exit (across-ball back e))
      (define out (passed water (negated e) (negated exit) #t))
      (radians->degrees (atan (abs (flvector-ref out 1)) (- (flvector-ref out 0)))))
    (define h (sqrt (- 1.0 (/ (- (sqr (/ 4.0 3.0)) 1.0) 3.0))))
    (check-= (rainbow-angle h) 42.02965886569769 1e-12)
    (check-true (< (rainbow-angle (+ h 1e-3)) 42.02965))
    (check-true (< (rainbow-angle (- h 1e-3)) 42.02965)))

  (test-case "E13: least deviation of a 60 degree prism, to 1e-12 degrees"
    (define out (flvector -0.75 (sqrt (- 1.0 (sqr 0.75))) 0.0))
    (define d (passed glass out UP #f))
    ;; the outward normals of the faces are 120 degrees apart
    (define face-normal (flvector (sqrt 0.75) -0.5 0.0))
    (define e (passed glass (negated d) (negated face-normal) #t))
    (check-= (radians->degrees (acos (dot e (negated out)))) 37.18075578145828 1e-12))

  (test-case "E14: chord inside a glass ball at impact .6, to 1e-15"
    (define-values (entry d) (enter-ball glass 0.6))
    (check-= (* -2.0 (dot entry d)) 1.833030277982336 1e-15))

  (test-case "absorption: exp(-absorption distance) for light travelled inside, exactly; none outside"
    (define b (make-bench (make-Dielectric 1.5 #:absorption (make-Float3 0.5 1 0))))
    (for* ([k (in-range 100)] [distance '(0.25 2.0 1000.0)])
      (face! b (direction-at NORMAL 30.0) #:inside? #t #:distance distance)
      (draw! b k)
      (check-true (close? (sampled-weight b) (list (exp (* -0.5 distance)) (exp (- distance)) 1.0)
                          1e-15))
      (face! b (direction-at NORMAL 30.0) #:distance distance)
      (draw! b k)
      (check-equal? (sampled-weight b) white)))

  (test-case "in water the relative index counts: 30 degrees from water to glass, to 1e-15"
    (define b (make-bench (make-Dielectric 1.5 #:outside-ior 1.33)))
    (define d (passed b (flvector -0.5 (sqrt 0.75) 0.0) UP #f))
    (check-= (flvector-ref d 0) (* 0.5 (/ 1.33 1.5)) 1e-15)
    ;; matched indices: nothing is reflected, nothing is bent
    (define matched (make-bench (make-Dielectric 1.33 #:outside-ior 1.33)))
    (check-equal? (reflected-part matched 70.0 #f) 0.0)
    (check-true (close? (sampled-direction matched)
                        (list-of (negated (direction-at NORMAL 70.0))) 1e-15)))

  ;; Light falls straight on a slab of glass one unit thick; what comes back and what passes.
  (define (slab b paths seed)
    (for/fold ([back '()] [through '()]) ([path (in-range paths)])
      (define (walk d inside? weight bounce)
        (define normal (if (> (flvector-ref d 1) 0.0) (negated UP) UP))
        (face! b (negated d) #:normal normal #:inside? inside?)
        (draw! b (+ seed (* 64 path) bounce))
        (define onward (sampled-direction b))
        (define new-weight (* weight (flvector-ref (sampled-weight b) 0)))
        (if (eq? inside? (reflected? b normal))
            (walk onward #t new-weight (+ bounce 1))
            (values (if (> (flvector-ref onward 1) 0.0) new-weight 0.0)
                    (if (> (flvector-ref onward 1) 0.0) 0.0 new-weight))))
      (define-values (r t) (walk (negated UP) #f 1.0 0))
      (values (cons r back) (cons t through))))

  (test-case "D10, D11: a slab with and without absorption, within 4.5 standard errors"
    (define (check-mean samples expected)
      (define n (length samples))
      (define mean (/ (apply + samples) n))
      (define error (sqrt (/ (- (/ (for/sum ([x samples]) (* x x)) n) (* mean mean)) n)))
      (check-true (<= (abs (- mean expected)) (* 4.5 error))
                  (format "~a, expected ~a, standard error ~a" mean expected error)))
    (define paths (if (getenv "RAYTRACE_STRESS") 1000000 50000))
    (define-values (r t) (slab glass paths 0))
    (check-mean r 0.07692307692307693)
    (check-mean t 0.9230769230769231)
    (define absorbing (make-bench (make-Dielectric 1.5 #:absorption (make-Float3 0.5 0.5 0.5))))
    (define-values (r* t*) (slab absorbing paths 0))
    (check-mean r* 0.05356949482041847)
    (check-mean t* 0.5593078685769788))

  (test-case "bad arguments"
    (check-exn #rx"^Dielectric: expected a positive finite number as ior"
               (lambda () (make-Dielectric 0)))
    (check-exn #rx"^Dielectric: .* as outside-ior"
               (lambda () (make-Dielectric 1.5 #:outside-ior -1)))
    (check-exn #rx"^Dielectric: .* as absorption"
               (lambda () (make-Dielectric 1.5 #:absorption (make-Float3 -1 0 0))))
    (check-exn #rx"fresnel|schlick"
               (lambda () (make-Dielectric 1.5 #:fresnel 'fast)))))
