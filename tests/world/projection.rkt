#lang racket/base
;; Projection matrices: the G cases, both ways, and agreement with the rays of a camera.

(module+ test
  (require rackunit "../../main.rkt" "../statistics.rkt")

  (define (check-components found expected tolerance)
    (for ([c (list (Float3-x found) (Float3-y found) (Float3-z found))] [e expected])
      (check-= c e (* tolerance (max 1.0 (abs e))))))
  (define perspective
    (Projection-perspective #:vertical-field-of-view-degrees 60 #:aspect 4/3 #:near 0.1 #:far 100))
  (define orthographic
    (Projection-orthographic #:left -4 #:right 4 #:bottom -3 #:top 3 #:near 1 #:far 11))

  (test-case "G02: eye-space (1, .5, -5) to device coordinates, 1e-12"
    (check-components (Projection-point perspective (Float3 1 0.5 -5))
                      '(0.25980762113533157 0.17320508075688773 0.9619619619619619) 1e-12))
  (test-case "G03: depth is not linear: device z of -1, -10 and -100, 1e-12"
    (for ([z '(-1 -10 -100)] [expected '(0.8018018018018018 0.9819819819819819 1.0)])
      (check-= (Float3-z (Projection-point perspective (Float3 0 0 z))) expected 1e-12)))
  (test-case "G04: the orthographic box, 1e-12"
    (check-components (Projection-point orthographic (Float3 1 2 -5)) '(0.25 2/3 -0.2) 1e-12))

  (test-case "there and back, 1e-12 of the distance"
    (define uniform (seeded 3))
    (for* ([projection (list perspective orthographic)] [k 500])
      (define p (Float3 (uniform -3.0 3.0) (uniform -3.0 3.0) (uniform -20.0 -0.2)))
      (define back (Projection-unproject projection (Projection-point projection p)))
      ;; depth is told apart by 1/z: what is lost grows with z^2 / near
      (check-true (<= (Float3-distance p back) (* 1e-12 (Float3-length p))))))

  (test-case "the rows are the map: a homogeneous product by hand"
    (for ([projection (list perspective orthographic)])
      (define p '(0.7 -0.4 -3.0 1.0))
      (define products
        (for/list ([row (Projection-matrix-rows projection)]) (apply + (map * row p))))
      (check-components (Projection-point projection (Float3 0.7 -0.4 -3.0))
                        (for/list ([c products] [_ 3]) (/ c (list-ref products 3))) 1e-15)))

  (test-case "a camera's ray through a pixel meets the points projected there, 1e-12"
    (define camera
      (Camera-look-at (Float3 0 0 0) (Float3 0 0 -1) #:vertical-field-of-view-degrees 60
                      #:aspect 4/3))
    (for* ([x '(0.1 0.5 0.83)] [y '(0.2 0.5 0.9)] [t '(0.5 7.0 40.0)])
      (define point (Float3-scale-by-scalar (Camera-get-ray-direction camera x y) t))
      (define seen (Projection-point perspective point))
      (check-= (Float3-x seen) (- (* 2 x) 1) 1e-12)
      (check-= (Float3-y seen) (- 1 (* 2 y)) 1e-12)))

  (test-case "refused"
    (check-exn #rx"far" (lambda () (Projection-perspective #:vertical-field-of-view-degrees 60
                                                           #:aspect 1 #:near 2 #:far 1)))
    (check-exn #rx"right" (lambda () (Projection-orthographic #:left 1 #:right 1 #:bottom 0 #:top 1
                                                              #:near 0 #:far 1)))))
