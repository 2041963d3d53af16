#lang racket/base
;; The scene of pi: its estimates, their error bars and slopes, with the seeds the scene has.

(module+ test
  (require rackunit racket/math "../../scenes/pi.rkt")

  (test-case "estimates: within four standard errors of pi; one run of chance is off as theory says"
    (for ([sampler SAMPLERS])
      (define-values (mean standard-error error) (pi-error sampler 256))
      (check-true (< (abs (- mean pi)) (* 4 standard-error)) (format "~a" sampler))
      (define theory (* 4 (sqrt (/ (* (/ pi 4) (- 1 (/ pi 4))) 256))))
      ;; a root mean square of 32 runs is known to an eighth
      (if (eq? sampler 'independent)
          (check-= error theory (* 0.5 theory))
          (check-true (< error (* 0.5 theory))))))

  (test-case "slopes: a half for chance; the others fall faster"
    (check-= (pi-slope 'independent) -0.5 0.12)
    (for ([sampler '(stratified owen-sobol r2)])
      (check-true (< (pi-slope sampler) -0.6) (format "~a" sampler)))))
