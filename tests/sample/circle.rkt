#lang racket/base
;; Points on the circle against the exact cosine and sine.

(module+ test
  (require racket/list rackunit "../statistics.rkt" "../turn.rkt" "warps.rkt")

  (define uniform (seeded 1))
  ;; the disk's rim is the bare circle
  (define (check-turn v)
    (define-values (c s) (exact-turn (inexact->exact v)))
    (define found (disk 1.0 v))
    (max (abs (- (inexact->exact (car found)) c)) (abs (- (inexact->exact (cadr found)) s))))

  (test-case "cosine and sine within 3e-16: random turns, and around all sector bounds"
    (define bounds
      (for*/list ([k (in-list (map exact->inexact (range 129)))] [step '(-1.0 0.0 1.0)]
                  [v (in-value (+ (* k 0.0078125) (* step 1.2e-16)))] #:when (<= 0.0 v 1.0))
        v))
    (define turns (append bounds (for/list ([k (stressed 3000 100000)]) (uniform))))
    (define worst (apply max (map check-turn turns)))
    (check-true (<= worst 3e-16) (format "off by ~a" (exact->inexact worst))))

  (test-case "exact at the quarters"
    (for ([v '(0.0 0.25 0.5 0.75 1.0)]
          [expected '((1.0 0.0) (0.0 1.0) (-1.0 0.0) (0.0 -1.0) (1.0 0.0))])
      (for ([c (disk 1.0 v)] [e expected]) (check-= c e 0.0))))

  (test-case "the largest number below 1, and tiny turns"
    (for ([v (list (- 1.0 1.2e-16) (- 1.0 2.4e-10) 1e-300 4.9e-324 2.4e-10)])
      (check-true (<= (check-turn v) 3e-16)))))
