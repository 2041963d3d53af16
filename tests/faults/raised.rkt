#lang racket/base
;; A scene's function may raise anything: values that are no exceptions leave magenta pixels too, on every
;; schedule of this process, and a render never hangs on them.
(module+ test
  (require racket/flonum rackunit raytrace)

  (define (distance x y z)
    (if (> x 0.3) (raise 'nothing) (- (sqrt (+ (* x x) (* y y) (* z z))) 1.0)))
  (define world
    (World (list (DistanceShape distance (Float3 -1 -1 -1) (Float3 1 1 1) (Float3 0.5 0.5 0.5)))
           '() (Float3 1 1 1)))
  (define camera (Camera-look-at (Float3 0 0 5) (Float3 0 0 0)))

  (define (pixels schedule)
    (define done (make-channel))
    (define worker
      (thread
       (lambda ()
         (channel-put done (Image-pixels (render world camera #:width 16 #:height 16 #:samples 4
                                                 #:tile 4 #:schedule schedule #:workers 2))))))
    (sync/timeout 60 done))

  (define alone (pixels 'sequential))
  (check-equal? (pixels 'futures) alone)
  (check-true
   (for/or ([k (in-range (* 16 16))])
     (and (= 1.0 (flvector-ref alone (* 3 k)) (flvector-ref alone (+ 2 (* 3 k))))
          (= 0.0 (flvector-ref alone (+ 1 (* 3 k))))))))
