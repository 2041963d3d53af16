#lang racket/base
;; Point lights: direction, distance, and the inverse square.

(module+ test
  (require racket/list rackunit "../../main.rkt" "../statistics.rkt" "light-samples.rkt")

  (define uniform (seeded 1))
  (define (random-float3) (Float3 (uniform -5.0 5.0) (uniform -5.0 5.0) (uniform -5.0 5.0)))
  (define (world-of point intensity) (World '() (PointLight point intensity)))

  (test-case "A14: irradiance I z / d^3 to 1e-12"
    (define world (world-of (Float3 1 2 3) (Float3 10 10 10)))
    (define s (sample-light world (Float3 0 0 0) 0.3 0.6))
    (check-= (* (third s) (fifth s)) 0.5727026612409094 1e-12))

  (test-case "towards the light, at its distance, by the inverse square, whatever the sample"
    (for ([k 300])
      (define-values (point light) (values (random-float3) (random-float3)))
      (define world (world-of light (Float3 1 2 3)))
      (define s (sample-light world point (uniform) (uniform)))
      (define to-light (Float3-subtract light point))
      (define distance (Float3-length to-light))
      (for ([c (take s 3)] [e (list (Float3-x to-light) (Float3-y to-light) (Float3-z to-light))])
        (check-= c (/ e distance) 1e-15))
      (check-= (fourth s) distance (* 1e-15 distance))
      (for ([c (take (drop s 4) 3)] [e '(1 2 3)])
        (check-= c (/ e distance distance) (* 4e-15 (/ e distance distance))))
      ;; no scattered ray finds it
      (check-equal? (last s) +inf.0)
      (check-equal? (light-density-toward world point (Float3-normalized to-light)) 0.0)))

  (test-case "at the light itself nothing arrives, and nothing is NaN"
    (define s (sample-light (world-of (Float3 1 2 3) (Float3 1 1 1)) (Float3 1 2 3) 0.5 0.5))
    (check-equal? (take (drop s 4) 3) '(0.0 0.0 0.0))
    (for ([x s]) (check-true (= x x))))

  (test-case "refused: one line that names the argument"
    (check-exn #rx"^PointLight: [^\n]*point[^\n]*$"
               (lambda () (PointLight (Float3 0 +nan.0 0) (Float3 1 1 1))))
    (check-exn #rx"^PointLight: [^\n]*intensity[^\n]*$"
               (lambda () (PointLight (Float3 0 0 0) (Float3 1 -1 1))))))
