#lang racket/base
;; Instances share their shape: a world's memory grows with them, not with triangles times them.

(module+ test
  (require rackunit "../../main.rkt" (only-in "../shape/mesh-examples.rkt" bumpy-sphere))

  (define (bytes-in-use)
    (for ([_ 3]) (collect-garbage))
    (current-memory-use))

  (define ray (Ray (Float3 0 0 9) (Float3 0 0 -1)))
  ;; Bytes that a world of `count` instances takes, their mesh ready before.
  (define (bytes-of mesh count)
    (World-nearest-hit (World (list (Instance mesh (Transform-identity)))) ray)
    (define before (bytes-in-use))
    (define world
      (World (for/list ([k count]) (Instance mesh (Transform-translate (* 3 k) 0 0)))))
    (check-true (< (Intersection-t (World-nearest-hit world ray)) INTERSECTION-T-MAX))
    (define taken (- (bytes-in-use) before))
    (check-equal? (length (World-shapes world)) count) ; the world is still needed here
    taken)

  (test-case "2,000 instances: under 2 kB each, of 380 triangles as of 16,000 (2 MB) within 10%"
    (define-values (small large) (values (bumpy-sphere 11 19) (bumpy-sphere 81 100)))
    (define-values (of-small of-large) (values (bytes-of small 2000) (bytes-of large 2000)))
    (check-true (< 200 (/ of-small 2000) 2000) (format "~a bytes each" (/ of-small 2000.0)))
    (check-= (/ of-large of-small 1.0) 1.0 0.1)))
