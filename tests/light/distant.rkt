#lang racket/base
;; Distant lights: the same direction and irradiance everywhere.

(module+ test
  (require racket/list rackunit "../../main.rkt" "../statistics.rkt" "light-samples.rkt")

  (define uniform (seeded 1))
  (define (random-float3) (Float3 (uniform -5.0 5.0) (uniform -5.0 5.0) (uniform -5.0 5.0)))

  (test-case "unit direction, infinite distance, the colour as irradiance, from every point"
    (for ([k 300])
      (define direction (random-float3))
      (define unit (Float3-normalized direction))
      (define world (World '() (DistantLight direction (Float3 1 0.8 0.65))))
      (check-equal? (sample-light world (random-float3) (uniform) (uniform))
                    (list (Float3-x unit) (Float3-y unit) (Float3-z unit) +inf.0
                          1.0 0.8 0.65 +inf.0))
      (check-equal? (light-density-toward world (random-float3) unit) 0.0)))

  (test-case "the article's names"
    (define sun (DistantLight (Float3 0 3 4) (Float3 1 0.8 0.65)))
    (check-= (Float3-distance (DistantLight-direction sun) (Float3 0 0.6 0.8)) 0.0 2e-16)
    (check-equal? (DistantLight-color sun) (Float3 1 0.8 0.65))
    (check-equal? (World-sun (World '() sun)) sun))

  (test-case "refused: one line that names the argument"
    (for ([bad (list (Float3 0 0 0) (Float3 +nan.0 0 0) (Float3 0 +inf.0 0))])
      (check-exn #rx"^DistantLight: [^\n]*direction[^\n]*$"
                 (lambda () (DistantLight bad (Float3 1 1 1)))))
    (check-exn #rx"^DistantLight: [^\n]*color[^\n]*$"
               (lambda () (DistantLight (Float3 0 1 0) (Float3 1 -1 1))))))
