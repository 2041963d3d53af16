#lang racket/base
;; Mix through its kernel. Its distribution is tested in sampling.rkt.

(module+ test
  (require rackunit racket/flonum racket/math "support.rkt" "properties.rkt" "chi-square.rkt"
           "../../private/base/float3.rkt" "../../private/material/mix.rkt"
           "../../private/material/lambertian.rkt" "../../private/material/mirror.rkt"
           "../../private/material/metal.rkt" "../../private/material/dielectric.rkt"
           "../../private/material/plastic.rkt" "../../private/material/modified-phong.rkt"
           "../../private/material/emitter.rkt" "../../private/material/interior.rkt"
           "../../private/medium/medium.rkt" "../../private/material/kernel.rkt")

  (define red (make-Lambertian (make-Float3 0.8 0.1 0.1)))
  (define shiny (make-ModifiedPhong (make-Float3 0 0.2 0.4) (make-Float3 0.5 0.5 0.5) 40))
  (define coated (make-Plastic (make-Float3 0.2 0.5 0.9)))
  (define mirror (make-Mirror (make-Float3 0.9 0.9 0.5)))
  (define glass (make-Dielectric 1.5))

  ;; red 0.35 * 0.6, shiny 0.35 * 0.4, coated 0.65 * 0.8, mirror 0.65 * 0.2
  (define parts (list red shiny coated mirror))
  (define weights '(0.21 0.14 0.52 0.13))
  (define nested (make-bench (make-Mix (make-Mix red shiny 0.4) (make-Mix coated mirror 0.2) 0.65)))

  (test-case "value and density are the weighted sums of the parts', to 1e-15"
    (define out (direction-at NORMAL 50.0))
    (define in (direction-at NORMAL 45.0 3.0))
    (define-values (values-sum density-sum)
      (for/fold ([sum '(0.0 0.0 0.0)] [density 0.0]) ([part parts] [weight weights])
        (define b (make-bench part))
        (face! b out)
        (evaluate! b in)
        (values (for/list ([s sum] [v (in-flvector (sampled-weight b))]) (+ s (* weight v)))
                (+ density (* weight (sampled-density b))))))
    (face! nested out)
    (evaluate! nested in)
    (check-true (close? (sampled-weight nested) values-sum 1e-15))
    (check-= (sampled-density nested) density-sum 1e-15))

  (test-case "sample and evaluate agree"
    (for ([degrees INCIDENCES])
      (face! nested (direction-at NORMAL degrees))
      (check-consistency nested 300)))

  (test-case "furnace at ten angles: the weighted sum of what the parts return, specular ones too"
    (define half (make-bench (make-Mix red shiny 0.4)))
    (define mirrored (make-bench (make-Mix (make-Mix red shiny 0.4) mirror 0.25)))
    (for ([degrees INCIDENCES])
      (face! half (direction-at NORMAL degrees))
      (define expected (+ (* 0.75 (value-integral half 0)) (* 0.25 0.9)))
      (face! mirrored (direction-at NORMAL degrees))
      (check-furnace mirrored 16384 (list expected) degrees)))

  (test-case "white parts return 1 for any weight: plastic, mirror, glass and a matte one"
    (define white (make-Float3 1 1 1))
    (define b (make-bench (make-Mix (make-Mix (make-Plastic white) (make-Mirror) 0.3)
                                    (make-Mix glass (make-Lambertian white) 0.5) 0.6)))
    (check-true (MaterialKernel-transmits? (bench-kernel b)))
    (for ([degrees INCIDENCES])
      (face! b (direction-at NORMAL degrees))
      (check-furnace b 16384 '(1.0 1.0 1.0) degrees)))

  (test-case "reciprocity" (check-reciprocity nested 200))

  (test-case "two specular parts: the chosen part's weight, by its probability"
    (define b (make-bench (make-Mix mirror (make-Metal (make-Float3 0.2 0.4 0.6)) 0.25)))
    (check-true (MaterialKernel-specular? (bench-kernel b)))
    (check-false (MaterialKernel-transmits? (bench-kernel b)))
    (face! b (direction-at NORMAL 20.0))
    (define count 16384)
    (define second
      (for/sum ([k (in-range count)])
        (draw! b 7 k)
        (define w (sampled-weight b))
        (check-true (or (equal? w (flvector 0.9 0.9 0.5)) (equal? w (flvector 0.2 0.4 0.6))))
        (if (equal? w (flvector 0.2 0.4 0.6)) 1 0)))
    ;; a net of 2^14 points
    (check-equal? second (/ count 4)))

  (test-case "weights 0 and 1 leave one material, exactly"
    (define out (direction-at NORMAL 35.0))
    (define alone (make-bench shiny))
    (for ([b (list (make-bench (make-Mix shiny glass 0)) (make-bench (make-Mix glass shiny 1)))])
      (check-false (MaterialKernel-transmits? (bench-kernel b)))
      (face! b out)
      (face! alone out)
      (for ([k (in-range 100)])
        (draw! b k)
        (draw! alone k)
        (check-equal? (sampled-weight b) (sampled-weight alone))
        (check-equal? (sampled-direction b) (sampled-direction alone)))))

  (test-case "bad arguments"
    (check-exn #rx"^Mix: expected a number from 0.0 to 1.0 as weight"
               (lambda () (make-Mix red glass 1.5)))
    (check-exn #rx"^Mix: expected a material that reflects as second"
               (lambda () (make-Mix red (make-Emitter (make-Float3 1 1 1)) 0.5)))
    (check-exn #rx"^Mix: expected a material that bounds no medium as first"
               (lambda () (make-Mix (make-Interior (make-Medium 1 (make-Float3 1 1 1))) red 0.5)))))
