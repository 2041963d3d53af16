#lang racket/base
;; Places killed at random moments, scene functions that raise, exit or stall: the picture has the bits
;; of an undisturbed one, or magenta where a pixel can never be rendered. Exact.
(module+ test
  (require racket/place racket/file racket/runtime-path racket/list racket/flonum rackunit raytrace
           (only-in "../../private/render/render.rkt" render/statistics)
           "../../private/render/statistics.rkt"
           "../../private/render/schedule/places.rkt")
  (define-runtime-path scene "scenes/raising.rkt")
  (define world (dynamic-require scene 'world))
  (define camera (dynamic-require scene 'camera))
  (define (fault! word) (putenv "RAYTRACE_TEST_FAULT" word))

  (define (picture schedule #:error [error #f] #:strict? [strict? #f] #:workers [workers 2])
    (define-values (image statistics)
      (render/statistics world camera #:width 64 #:height 36 #:samples (if error 64 4) #:error error
                         #:schedule schedule #:workers workers #:tile 8 #:scene scene
                         #:strict? strict?))
    (list (Image-pixels image) (Statistics-failed-pixels statistics) (Statistics-faults statistics)))

  (fault! "")
  (define whole (picture 'sequential))
  (define whole-adaptive (picture 'sequential #:error 0.03))
  (check-equal? (cdr whole) '(0 ()))

  ;; what raises for the first time only leaves no trace
  (for ([schedule (in-list '(sequential futures places))])
    (define again (dynamic-require scene 'start-again!))
    (again)
    (fault! "once")
    (check-equal? (picture schedule) whole (format "once, ~a" schedule)))

  ;; what always raises, or exits, is magenta in the same pixels and told once
  (for ([word (in-list '("always" "exit"))] [text (in-list '("no distance here" "left by (exit)"))])
    (fault! word)
    (define found (picture 'sequential))
    (check-equal? (map car (third found)) (list text))
    (check-true (> (second found) 0))
    (define magenta
      (for/sum ([k (in-range (* 64 36))])
        (if (equal? (for/list ([c (in-range 3)]) (flvector-ref (first found) (+ c (* 3 k))))
                    '(1.0 0.0 1.0))
            1 0)))
    (check-equal? magenta (second found))
    (for ([schedule (in-list '(futures places))])
      (check-equal? (picture schedule) found (format "~a, ~a" word schedule)))
    (check-equal? (picture 'futures #:error 0.05) (picture 'sequential #:error 0.05))
    (check-exn (regexp (regexp-quote (string-append text ", at pixel")))
               (lambda () (picture 'futures #:strict? #t))))

  ;; a place that stalls is given up: only the first to come there does, as a file tells
  (define mark (make-temporary-file))
  (delete-file mark)
  (putenv "RAYTRACE_TEST_FILE" (path->string mark))
  (fault! "stall")
  (parameterize ([least-stall-seconds 2.0] [stall-factor 1.0])
    (check-equal? (picture 'places) whole "stall"))
  (check-true (file-exists? mark))
  (delete-file mark)

  ;; places killed at random moments, half of them while they start, in fixed and adaptive renders: 12,
  ;; or 60 with RAYTRACE_STRESS
  (define KILLS (if (getenv "RAYTRACE_STRESS") 60 12))
  (fault! "")
  (define random-moments (make-pseudo-random-generator))
  (parameterize ([current-pseudo-random-generator random-moments]) (random-seed 8))
  (define kills 0)
  (define (kill-some place moment)
    (when (and (< kills KILLS) (eq? moment (if (even? kills) 'started 'ready)))
      (set! kills (+ kills 1))
      (thread (lambda ()
                (sleep (* 0.2 (random random-moments)))
                (place-kill place)))))
  (parameterize ([place-watch kill-some])
    (let loop ([k 0])
      (when (< kills KILLS)
        (if (even? k)
            (check-equal? (picture 'places) whole "killed")
            (check-equal? (picture 'places #:error 0.03) whole-adaptive "killed, adaptive"))
        (loop (+ k 1))))))
