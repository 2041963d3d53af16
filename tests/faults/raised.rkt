#lang racket/base
;; A scene's function may raise: exceptions leave magenta pixels on every schedule of this process, so do
;; values that are no exceptions without futures, and a render never hangs on them. What guards against
;; it leaves the futures free.
(module+ test
  (require racket/flonum rackunit raytrace)

  (define ((ball fail) x y z)
    (if (> x 0.3) (fail) (- (sqrt (+ (* x x) (* y y) (* z z))) 1.0)))
  (define (world fail)
    (World (list (DistanceShape (ball fail) (Float3 -1 -1 -1) (Float3 1 1 1) (Float3 0.5 0.5 0.5)))
           '() (Float3 1 1 1)))
  (define camera (Camera-look-at (Float3 0 0 5) (Float3 0 0 0)))

  (define (pixels fail schedule)
    (define done (make-channel))
    (thread
     (lambda ()
       (channel-put done (Image-pixels (render (world fail) camera #:width 16 #:height 16 #:samples 4
                                               #:tile 4 #:schedule schedule #:workers 2)))))
    (sync/timeout 60 done))

  (define (magenta? pixels k)
    (and (= 1.0 (flvector-ref pixels (* 3 k)) (flvector-ref pixels (+ 2 (* 3 k))))
         (= 0.0 (flvector-ref pixels (+ 1 (* 3 k))))))

  (define alone (pixels (lambda () (error "too far right")) 'sequential))
  (check-true (for/or ([k (in-range (* 16 16))]) (magenta? alone k)))
  (for ([fail (in-list (list (lambda () (error "too far right"))
                             (lambda () (raise-user-error "too far right"))
                             (lambda () (vector-ref (vector 1 2) 2))
                             (lambda () (raise (exn:fail "too far" (current-continuation-marks))))))])
    (check-equal? (pixels fail 'futures) alone))
  (check-equal? (pixels (lambda () (raise 'nothing)) 'sequential) alone)

  (test-case "no future waits for the main thread"
    (define events (make-log-receiver (current-logger) 'debug 'future))
    (render (World (list (Sphere (Float3 0 0 0) 1 (Lambertian (Float3 0.5 0.5 0.5)))) '() (Float3 1 1 1))
            camera #:width 64 #:height 64 #:samples 16 #:schedule 'futures #:workers 2)
    (define actions
      (let next ()
        (define event (sync/timeout 0.5 events))
        (if event (cons (vector-ref (struct->vector (vector-ref event 2)) 3) (next)) '())))
    (check-true (and (memq 'start-work actions) #t))
    (for ([action (in-list '(block touch suspend sync))])
      (check-false (memq action actions) (format "~a" action)))))
