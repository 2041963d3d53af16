#lang racket/base
;; The digest of a world: the same for worlds that are equal, another for one that differs in any part.
(module+ test
  (require rackunit raytrace "../../private/render/digest.rkt")

  (define (digest world) (content-digest (list world) (lambda () #"scene")))

  (define (world #:shapes [shapes (list (Sphere (Float3 0 0 0) 1))]
                 #:lights [lights '()]
                 #:background [background (Float3 1 1 1)]
                 #:medium [medium (Medium 0.5 (Float3 1 1 1))]
                 #:samples [samples 4])
    (World shapes lights background #:medium medium #:ambient-samples samples))

  (define whole (digest (world)))
  (check-equal? (digest (world)) whole)
  (for ([other (in-list (list (world #:shapes '())
                              (world #:lights (DistantLight (Float3 0 1 0) (Float3 1 1 1)))
                              (world #:background (Float3 1 1 0))
                              (world #:medium (Medium 0.25 (Float3 1 1 1)))
                              (world #:medium #f)
                              (world #:samples 5)))])
    (check-not-equal? (digest other) whole))

  ;; what cannot be looked into counts by the bytes that stand for it
  (define (cloud bytes)
    (content-digest (list (world #:shapes (list (CustomShape (Float3 0 0 0) (Float3 1 1 1)
                                                             (lambda (o d t) #f)))))
                    (lambda () bytes)))
  (check-equal? (cloud #"a") (cloud #"a"))
  (check-not-equal? (cloud #"a") (cloud #"b")))
