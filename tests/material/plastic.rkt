#lang racket/base
;; Plastic through its kernel. Its distribution is tested in sampling.rkt.

(module+ test
  (require rackunit racket/flonum racket/math "support.rkt" "properties.rkt" "chi-square.rkt"
           "../../private/base/float3.rkt" "../../private/material/plastic.rkt"
           "../../private/material/fresnel.rkt" "../../private/material/kernel.rkt")

  (define white (make-Float3 1 1 1))
  (define b (make-bench (make-Plastic (make-Float3 0.8 0.4 0.0))))
  (define white-plastic (make-bench (make-Plastic white)))
  (define (cosine degrees) (cos (degrees->radians degrees)))

  ;; what the coat reflects and the body returns (Saunderson 1942)
  (define (albedo-of body ior degrees)
    (define coat (Fresnel-dielectric/function (cosine degrees) ior))
    (define inside (Fresnel-average-inside ior))
    (+ coat (* (- 1.0 coat) body (/ (- 1.0 inside) (- 1.0 (* body inside))))))

  (test-case "what the integrator is told"
    (check-false (MaterialKernel-specular? (bench-kernel b)))
    (check-false (MaterialKernel-transmits? (bench-kernel b))))

  ;; a white body returns all that enters, so of what is evaluated the density is (1 - F) cos / pi
  (test-case "E01: the coat's exact reflectance in the density of a white plastic, to 1e-12"
    (for ([degrees '(0.0 30.0 45.0 75.0 85.0 89.0)]
          [coat '(0.04 0.04152262597582154 0.05023991101223594 0.25306056299031965
                       0.6127996452648273 0.9041849497801892)])
      (face! white-plastic (direction-at NORMAL degrees))
      (evaluate! white-plastic (direction-at NORMAL 20.0 1.0))
      (check-= (- 1.0 (/ (* pi (sampled-density white-plastic)) (cosine 20.0))) coat 1e-12)))

  (test-case "furnace at ten angles: coat and body as documented, a white one returns 1"
    (for ([degrees INCIDENCES])
      (face! b (direction-at NORMAL degrees))
      (check-furnace b 16384 (map (lambda (body) (albedo-of body 1.5 degrees)) '(0.8 0.4 0.0)) degrees)
      (check-= (albedo-of 1.0 1.5 degrees) 1.0 1e-15)
      (face! white-plastic (direction-at NORMAL degrees))
      (check-furnace white-plastic 16384 '(1.0 1.0 1.0) degrees)))

  (test-case "by quadrature a white body under any coat returns 1 to 1e-6"
    (for* ([ior '(1.0 1.33 1.5 2.42)] [degrees '(0.0 60.0 85.0)])
      (define plastic (make-bench (make-Plastic white #:ior ior)))
      (face! plastic (direction-at NORMAL degrees))
      (check-= (+ (Fresnel-dielectric/function (cosine degrees) ior) (value-integral plastic 0))
               1.0 1e-6)))

  (test-case "sample and evaluate agree"
    (for ([degrees INCIDENCES])
      (face! b (direction-at NORMAL degrees))
      (check-consistency b 300)))

  (test-case "density and the coat's probability add up to 1, to 1e-6"
    (for ([degrees '(0.0 50.0 80.0)])
      (face! b (direction-at NORMAL degrees))
      (define coat (Fresnel-dielectric/function (cosine degrees) 1.5))
      (define probability (/ coat (albedo-of 0.8 1.5 degrees)))
      (define density
        (density-integral (lambda (x y z) (local-density b x y z))))
      (check-= (+ density probability) 1.0 1e-6)))

  (test-case "reciprocity" (check-reciprocity b 200))

  (test-case "a coat of index 1 is none: Lambertian, to 1e-15"
    (define bare (make-bench (make-Plastic (make-Float3 0.5 0.5 0.5) #:ior 1)))
    (face! bare (direction-at NORMAL 30.0))
    (evaluate! bare (direction-at NORMAL 60.0))
    (check-= (flvector-ref (sampled-weight bare) 0) (/ 0.25 pi) 1e-15)
    (check-= (sampled-density bare) (/ 0.5 pi) 1e-15))

  (test-case "black bodies: only the coat; without a coat nothing, and no NaN"
    (define black (make-bench (make-Plastic (make-Float3 0 0 0))))
    (define nothing (make-bench (make-Plastic (make-Float3 0 0 0) 1.0)))
    (for ([degrees INCIDENCES] [k (in-naturals)])
      (face! black (direction-at NORMAL degrees))
      (draw! black k)
      (check-true (specular-sample? black))
      (check-= (flvector-ref (sampled-weight black) 0)
               (Fresnel-dielectric/function (cosine degrees) 1.5) 1e-15)
      (face! nothing (direction-at NORMAL degrees))
      (draw! nothing k)
      (check-equal? (sampled-weight nothing) (flvector 0.0 0.0 0.0))
      (evaluate! nothing (direction-at NORMAL 10.0))
      (check-equal? (sampled-weight nothing) (flvector 0.0 0.0 0.0))))

  (test-case "bad arguments"
    (check-exn #rx"^Plastic: .* as albedo" (lambda () (make-Plastic (make-Float3 2 0 0))))
    (check-exn #rx"^Plastic: expected a number from 1.0 to 100.0 as ior"
               (lambda () (make-Plastic white 0.9)))))
