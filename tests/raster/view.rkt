#lang racket/base
;; Points to pixels and back: against the rays of the same camera, and the matrices against each other.

(module+ test
  (require rackunit "../../main.rkt" "../statistics.rkt")

  (define (distance-from-ray ray point)
    (define offset (Float3-subtract point (Ray-point ray)))
    (Float3-length (Float3-subtract offset
                                    (Float3-scale-by-scalar (Ray-direction ray)
                                                            (Float3-dot offset
                                                                        (Ray-direction ray))))))
  (define eye (Float3 1 2 3))
  (define focus (Float3 0.3 -0.5 -4))
  (define square ; what Camera-fitted makes of an aspect of 4/3, which Camera-ray does not do
    (list (Camera-look-at eye focus #:aspect 4/3 #:zoom 1.3)
          (Camera-look-at eye focus #:aspect 4/3 #:vertical-field-of-view-degrees 100
                          #:lens-radius 0.1)
          (Camera-panoramic eye focus)))

  (test-case "every pixel's ray passes through the unprojected point, 1e-12 of the distance"
    (for* ([camera square] [x '(0.5 17.25 100.0 255.5)] [y '(0.5 33.0 191.5)]
           [distance '(1e-3 1.0 40.0)])
      (define seen (Float3 x y distance))
      (define point (Camera-unproject camera seen #:width 256 #:height 192))
      (check-true (<= (distance-from-ray (Camera-ray camera (/ x 256) (/ y 192)) point)
                      (* 1e-12 (+ distance (Float3-length eye)))))))

  (define cameras
    (append square
            (list (Camera-orthographic eye focus #:height 9)
                  (Camera-fisheye eye focus #:field-of-view-degrees 200)
                  (Camera-moving (Camera-look-at eye focus) (Camera-look-at focus eye))
                  ;; axes neither square to each other nor of one length
                  (Camera (Float3 1 0 0) (Float3 0 0.2 -2) (Float3 1.5 0.1 0) (Float3 0.3 1 0.2)))))

  (test-case "there and back, 1e-12 of the picture's width and of the distance"
    (define uniform (seeded 5))
    (for* ([camera cameras] [k 200])
      (define seen (Float3 (uniform 0.0 320.0) (uniform 0.0 200.0) (uniform 0.5 50.0)))
      (define point (Camera-unproject camera seen #:width 320 #:height 200))
      (define back (Camera-project camera point #:width 320 #:height 200))
      ;; rounding of the point, seen from that near: its coordinates reach 60
      (check-= (Float3-x back) (Float3-x seen) (* 320 1e-12))
      (check-= (Float3-y back) (Float3-y seen) (* 320 1e-12))
      (check-= (Float3-z back) (Float3-z seen) (* 50 1e-12))))

  (test-case "the middle of the picture is straight ahead; what is behind is nowhere"
    (for ([camera cameras] #:unless (eq? camera (list-ref cameras 6)))
      (define seen (Camera-project camera focus #:width 320 #:height 200))
      (check-= (Float3-x seen) 160.0 1e-10)
      (check-= (Float3-y seen) 100.0 1e-10)
      (check-= (Float3-z seen) (Float3-length (Float3-subtract focus eye)) 1e-12))
    (define behind (Float3-subtract (Float3-scale-by-scalar eye 2) focus))
    (for ([camera (list (car cameras) (list-ref cameras 3))])
      (check-false (Camera-project camera behind)))
    (check-false (Camera-project (car cameras) eye)))

  (test-case "view, frustum and viewport matrices say the same as Camera-project, 1e-12"
    (define uniform (seeded 6))
    (for* ([camera (list (car cameras) (cadr cameras) (list-ref cameras 3))] [k 100])
      (define point
        (Camera-unproject camera (Float3 (uniform 0.0 320.0) (uniform 0.0 200.0) (uniform 1.0 30.0))
                          #:width 320 #:height 200))
      (define in-eye-space (Transform-point (Camera-view camera) point))
      (define frustum (Camera-frustum camera #:near 0.1 #:far 100 #:width 320 #:height 200))
      (define device (Projection-point frustum in-eye-space))
      (define pixel (Transform-point (Transform-viewport 320 200) device))
      (define expected (Camera-project camera point #:width 320 #:height 200))
      (check-= (Float3-x pixel) (Float3-x expected) (* 320 1e-12))
      (check-= (Float3-y pixel) (Float3-y expected) (* 320 1e-12))
      (check-true (< 0.0 (Float3-z pixel) 1.0))
      ;; and it lies between all clip planes, by the distances that they say
      (for ([plane (Projection-clip-planes frustum)])
        (define distance
          (+ (* (car plane) (Float3-x in-eye-space)) (* (cadr plane) (Float3-y in-eye-space))
             (* (caddr plane) (Float3-z in-eye-space)) (cadddr plane)))
        (check-true (>= distance -1e-12)))))

  (test-case "corners of the frustum lie on three planes each; near and far are where they were asked"
    (for ([camera (list (car cameras) (list-ref cameras 3))])
      (define frustum (Camera-frustum camera #:near 0.5 #:far 20))
      (for ([corner (Projection-frustum-corners frustum)] [k 8])
        (check-= (Float3-z corner) (if (< k 4) -0.5 -20.0) 1e-11)
        (check-equal? (for/sum ([plane (Projection-clip-planes frustum)])
                        (define distance
                          (+ (* (car plane) (Float3-x corner)) (* (cadr plane) (Float3-y corner))
                             (* (caddr plane) (Float3-z corner)) (cadddr plane)))
                        (if (< (abs distance) 1e-11) 1 0))
                      3))))

  (test-case "a perspective without an end: five planes, and the limit of far ones, to 1e-9"
    (define endless (Camera-frustum (car cameras) #:near 0.5))
    (define far (Camera-frustum (car cameras) #:near 0.5 #:far 1e12))
    (check-equal? (length (Projection-clip-planes endless)) 5)
    (check-equal? (length (Projection-clip-planes far)) 6)
    (for ([row (Projection-matrix-rows endless)] [other (Projection-matrix-rows far)])
      (for ([x row] [y other]) (check-= x y 1e-9)))
    (for ([plane (Projection-clip-planes endless)] [other (Projection-clip-planes far)])
      (for ([x plane] [y other]) (check-= x y 1e-9)))
    (define point (Float3 1 2 -3000))
    (define back (Projection-unproject endless (Projection-point endless point)))
    (check-= (Float3-z back) -3000 1e-6)
    (check-equal? (Projection-matrix-rows
                   (Projection-perspective #:vertical-field-of-view-degrees 50 #:aspect 1.5
                                           #:near 2 #:far +inf.0))
                  (let ([rows (Projection-matrix-rows
                               (Projection-perspective #:vertical-field-of-view-degrees 50
                                                       #:aspect 1.5 #:near 2 #:far 10))])
                    (list (car rows) (cadr rows) '(0.0 0.0 -1.0 -4.0) (cadddr rows))))
    (check-exn #rx"far plane" (lambda () (Projection-frustum-corners endless)))
    (check-exn #rx"far" (lambda () (Camera-frustum (list-ref cameras 3) #:near 1))))

  (test-case "refused"
    (check-exn #rx"perspective or orthographic"
               (lambda () (Camera-frustum (Camera-panoramic eye focus) #:near 1 #:far 2)))
    (check-exn #rx"far" (lambda () (Camera-frustum (car cameras) #:near 3 #:far 2)))
    (check-exn #rx"width" (lambda () (Camera-project (car cameras) focus #:width 0)))))
