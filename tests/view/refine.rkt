#lang racket/base
;; A picture that becomes better: its stages, that it is the picture a render gives, and who is
;; obeyed.
(module+ test
  (require racket/file racket/flonum rackunit raytrace "../../private/view/refine.rkt"
           "../../private/view/background.rkt" "../../private/view/watch.rkt"
           (only-in "../../private/image/image.rkt" make-Image)
           (only-in "../../private/image/error.rkt" Image-relative-error))

  (define world
    (World (list (Sphere (Float3 0 0 0) 1 (Lambertian (Float3 0.6 0.3 0.2)))
                 (Sphere (Float3 0 -101 0) 100 (Lambertian (Float3 0.5 0.5 0.5))))
           '() (GradientSky (Float3 0.8 0.8 0.9) (Float3 0.3 0.4 0.8))))
  (define camera (Camera-look-at (Float3 1 2 6) (Float3 0 0 0)))
  (define (scene-of #:samples [samples #f] #:error [error #f] #:camera [camera camera]
                    #:integrator [integrator 'auto] #:world [world world])
    (scene world camera 48 32 integrator samples error 7 #f 'phong))
  (define black (Image-crop (preview world camera #:width 48 #:height 32) 0 0 48 32))

  ;; all that refine shows
  (define (refined given)
    (define all '())
    (refine given black (lambda (seen) (set! all (cons seen all))))
    all)

  (define (flonums v) (for/list ([x (in-flvector v)]) x))

  ;; sums that are added up in other parts: a few units in the last place
  (test-case "the picture of so many samples is the render's, up to rounding, though it came in parts"
    (define last (car (refined (scene-of #:samples 8))))
    (define one (render world camera #:width 48 #:height 32 #:samples 8 #:error 1e-9 #:seed 7))
    (for ([a (in-flvector (Image-pixels (shown-image last)))] [b (in-flvector (Image-pixels one))])
      (check-= (/ a b) 1.0 1e-14))
    (check-equal? (shown-samples last) 8)
    (check-true (shown-done? last))
    (check-= (shown-error last) (Image-relative-error one) 1e-12))

  (test-case "an error that is asked for is reached, in stages that do not lose samples"
    (define all (refined (scene-of #:error 0.02)))
    (define last (car all))
    (check-true (shown-done? last))
    (check-true (<= (shown-error last) 0.02))
    (check-true (> (shown-samples last) 8))
    (define samples (map shown-samples (reverse all)))
    (check-equal? samples (sort samples <))
    ;; within five of its own standard errors of a picture with many more samples
    (define truth (render world camera #:width 48 #:height 32 #:samples 1024 #:seed 99))
    (define rmse
      (let ([a (Image-pixels (shown-image last))] [b (Image-pixels truth)])
        (sqrt (/ (for/sum ([x (in-flvector a)] [y (in-flvector b)]) (* (- x y) (- x y)))
                 (flvector-length a)))))
    (define mean (/ (for/sum ([x (in-flvector (Image-pixels truth))]) x)
                    (flvector-length (Image-pixels truth))))
    (check-true (< (/ rmse mean) (* 1.5 0.02)) (format "~a" (/ rmse mean))))

  (test-case "goals of the stages"
    (define (goal . arguments) (call-with-values (lambda () (apply stage-goal arguments)) list))
    (check-equal? (goal 0 #f 1000 #f) '(2 1e-9))
    (check-equal? (goal 1 0.5 1000 0.01) '(8 0.01))
    (check-equal? (goal 1 0.5 2 0.01) '(#f #f))
    (check-equal? (goal 1 0.5 4 #f) '(4 1e-9))
    (check-equal? (goal 2 0.5 1000 #f) '(1000 0.35))
    (check-equal? (goal 2 0.5 1000 0.4) '(1000 0.4))
    (check-equal? (goal 2 0.4 1000 0.4) '(#f #f))
    (check-equal? (goal 2 0.0 1000 #f) '(#f #f))
    (check-equal? (goal 2 0.5 8 #f) '(#f #f)))

  (test-case "pixels without samples show what is under them"
    (define image (make-Image 2 1 (flvector +nan.0 +nan.0 +nan.0 1.0 2.0 3.0)))
    (define under (make-Image 2 1 (flvector 4.0 5.0 6.0 7.0 8.0 9.0)))
    (check-equal? (flonums (Image-pixels (over image under))) '(4.0 5.0 6.0 1.0 2.0 3.0))
    (check-eq? (over under image) under))

  (test-case "previews become coarser where they take long, and finer where they do not; no further"
    (define (settled divisor full-seconds)
      (for/fold ([divisor divisor]) ([k 20])
        (next-divisor divisor (/ full-seconds (* divisor divisor)))))
    (check-equal? (map (lambda (seconds) (settled 2 seconds)) '(0.01 0.3 0.6 1.3 100.0)) '(1 2 2 3 4))
    (for* ([seconds '(0.01 0.09 0.3 0.5 1.0 3.0)] [divisor '(1 2 3 4)])
      (define found (settled divisor seconds))
      (check-equal? (next-divisor found (/ seconds (* found found))) found)))

  (test-case "the status tells samples, error, time and exposure"
    (define (text samples error stops done?)
      (status-text (shown black samples error 12.34 0 done?) stops))
    (check-equal? (text 0 #f 0.0 #f) "preview")
    (check-equal? (text 2 #f 0.5 #f) "2.0 samples a pixel, error not known yet, 12.3 s, +0.5 stops")
    (check-equal? (text 63.7 0.0123 -1.0 #t)
                  "64 samples a pixel, error 1.23%, 12.3 s, -1.0 stops, done")
    (check-equal? (status-text (shown black 8 0.5 1.0 3 #f) 0.0)
                  "8.0 samples a pixel, error 50.0%, 1.0 s, 3 pixels could not be rendered"))

  ;; Waits until (ready?) for at most half a minute.
  (define (wait ready?)
    (let try ([k 600])
      (or (ready?) (and (> k 0) (begin (sleep 0.05) (try (- k 1)))))))

  (test-case "background: the newest order is obeyed, with a preview first, and it ends"
    (define all '())
    (define background
      (start-background (lambda (number seen) (set! all (cons (cons number seen) all)))
                        (lambda (number e) (raise e))))
    (define orders
      (for/list ([k 5])
        (order! background (scene-of #:camera (Camera-pan camera k) #:error 1e-4))))
    (check-equal? orders '(1 2 3 4 5))
    (define (of number) (filter (lambda (pair) (= number (car pair))) all))
    (check-true (wait (lambda () (ormap (lambda (pair) (> (shown-samples (cdr pair)) 2)) (of 5)))))
    (check-equal? (shown-samples (cdar (reverse (of 5)))) 0)
    ;; the next order interrupts a job that would take long
    (define next (order! background (scene-of #:samples 2)))
    (check-true (wait (lambda () (ormap (lambda (pair) (shown-done? (cdr pair))) (of next)))))
    (check-equal? (map car all) (sort (map car all) >))
    (stop-background! background)
    (define count (length all))
    (sleep 0.5)
    (check-equal? (length all) count))

  (test-case "background: what raises is told, what never ends is left, and the next order is obeyed"
    (define (hanging point u v) (let loop () (loop)))
    (define bad
      (World (list (Sphere (Float3 0 0 0) 1 (Lambertian (FunctionTexture hanging))))))
    (define failures '())
    (define shown-numbers '())
    (define background
      (start-background (lambda (number seen)
                          (when (shown-done? seen) (set! shown-numbers (cons number shown-numbers))))
                        (lambda (number e) (set! failures (cons number failures)))))
    (order! background (scene-of #:integrator 'no-such-integrator))
    (check-true (wait (lambda () (equal? failures '(1)))))
    (order! background (scene-of #:world bad))
    (sleep 0.3)
    (define good (order! background (scene-of #:samples 2)))
    (check-not-false (wait (lambda () (member good shown-numbers))))
    (stop-background! background)
    (check-equal? failures '(1)))

  (test-case "files: a change is told once it rests, also of a file that comes and goes"
    (define folder (make-temporary-file "watch~a" 'directory))
    (define file (build-path folder "a.rkt"))
    (define changes 0)
    (define watcher (watch-files (lambda () (list file)) (lambda () (set! changes (+ changes 1)))))
    (define (changes-to act)
      (define before changes)
      (sleep 0.6)
      (check-equal? changes before)
      (act)
      (check-true (wait (lambda () (= changes (+ before 1))))))
    (changes-to (lambda () (display-to-file "1" file)))
    (changes-to (lambda () (display-to-file "2" file #:exists 'truncate)))
    (changes-to (lambda () (delete-file file)))
    (kill-thread watcher)
    (delete-directory/files folder)))
