#lang racket/base
;; Pictures tell their error truly, and rendering until an error is reached does what it says: it
;; adds no bias to speak of, spends nothing where nothing varies, keeps to its limits, and gives the
;; same bits on every schedule. The stress suite measures the first two with 64 seeds.

(module+ test
  (require racket/flonum racket/list rackunit "../../main.rkt"
           (only-in "../../private/render/render.rkt" render/statistics)
           "../../private/render/statistics.rkt" "films.rkt" "error-scenes.rkt" "error-measures.rkt")

  (define SEEDS 24)

  ;; Few seeds leave the ratio uncertain: it may be off by its own 4 standard errors beyond 15%.
  (define (check-estimate name settings)
    (define found (measure-estimate (scene-named name) SEEDS settings))
    (check-true (< (estimated-uncertainty found) 0.15)
                (format "~a: ratio ~a +- ~a" name (estimated-ratio found)
                        (estimated-uncertainty found)))
    (check-= (estimated-ratio found) 1.0 (+ 0.15 (* 4.0 (estimated-uncertainty found))) name))

  (for ([s error-scenes])
    (test-case (format "~a: the true RMSE is the estimate, 15% and 4 standard errors" (scene-name s))
      (check-estimate (scene-name s) '((#:samples . 16)))))

  (test-case "the estimate holds for every sampler, and for an odd number of samples"
    (for ([sampler '(independent stratified r2)])
      (check-estimate "soft shadows under a disk light"
                      (list '(#:samples . 8) (cons '#:sampler sampler))))
    (check-estimate "seed ambient occlusion" '((#:samples . 5))))

  (test-case "a picture rendered until an error has that error"
    (for ([name '("soft shadows under a disk light" "glass and mirrors")])
      (define found (measure-estimate (scene-named name) 8 '((#:error . 0.05))))
      (check-= (estimated-ratio found) 1.0 (+ 0.15 (* 4.0 (estimated-uncertainty found))) name)
      (check-true (< (estimated-error found) (* 0.05 (+ 1.15 (* 4.0 (estimated-uncertainty found)))))
                  name)))

  (test-case "stopping at an error of 5% moves the mean by less than a quarter of that"
    (for ([name '("soft shadows under a disk light" "glass and mirrors")])
      (define-values (bias uncertainty) (measure-bias (scene-named name) 8 0.05 64))
      (check-true (< (+ (abs bias) (* 2.0 uncertainty)) (/ 0.05 4.0))
                  (format "~a: ~a +- ~a" name bias uncertainty))))

  ;; ----------------------------------------------------------------------------------------------

  (define ball-scene
    (scene "a ball and a lamp"
           (World (list (Sphere (Float3 0 0 0) 1 (Lambertian (Float3 0.5 0.5 0.5)))
                        (Sphere (Float3 1 1.5 1) 0.4 (Emitter (Float3 9 9 9))))
                  '() (Float3 0.2 0.3 0.4))
           (Camera-look-at (Float3 0 0 8) (Float3 0 0 0))))

  (test-case "a pixel of the constant background gets its pilot samples only"
    (define-values (width height) (values 40 24))
    (define taken
      (film-samples (scene-world ball-scene) (scene-camera ball-scene) width height 0.005))
    (define image
      (render (scene-world ball-scene) (scene-camera ball-scene) #:width width #:height height))
    ;; a pixel is constant for certain when 16 samples in all pixels around it show the background
    (define (background? x y)
      (for*/and ([nx (in-range (- x 3) (+ x 4))] [ny (in-range (- y 3) (+ y 4))])
        (or (not (and (< -1 nx width) (< -1 ny height)))
            (let-values ([(red green blue) (Image-pixel image nx ny)])
              (and (= red 0.2) (= green 0.3) (= blue 0.4))))))
    (define-values (constant other)
      (partition (lambda (at) (background? (car at) (cdr at)))
                 (for*/list ([y height] [x width]) (cons x y))))
    (define (samples-at at) (vector-ref taken (+ (car at) (* width (cdr at)))))
    (check-true (> (length constant) 300))
    (check-equal? (remove-duplicates (map samples-at constant)) '(8.0))
    (check-true (> (apply max (map samples-at other)) 64.0)))

  (define rendered
    (make-keyword-procedure
     (lambda (keywords settings)
       (keyword-apply render/statistics keywords settings
                      (list (scene-world disk-light-scene) (scene-camera disk-light-scene))))))

  (test-case "nothing varies: the pilot is all, and the error 0"
    (define-values (image statistics)
      (render/statistics (World '() '() (Float3 1 2 3)) (scene-camera disk-light-scene)
                         #:width 20 #:height 10 #:error 1e-6))
    (check-equal? (Statistics-samples statistics) (* 8 200))
    (check-equal? (Statistics-passes statistics) 1)
    (check-equal? (Statistics-stopped-by statistics) 'error)
    (check-equal? (Image-relative-error image) 0.0))

  (test-case "#:samples is the most a pixel gets, and reaching it is told"
    ;; the floor: samples differ everywhere
    (for ([most '(16 21)])
      (define-values (image statistics)
        (rendered #:width 32 #:height 18 #:crop '(0 12 32 6) #:error 1e-5 #:samples most))
      (check-equal? (Statistics-stopped-by statistics) 'most-samples)
      (define each (/ (Statistics-samples statistics) 192.0))
      (check-true (<= (- most 1) each most) (format "~a samples a pixel, ~a at most" each most))))

  (test-case "#:seconds 2 takes between 1 and 3 seconds"
    (define-values (image statistics) (rendered #:width 48 #:height 27 #:seconds 2))
    (check-equal? (Statistics-stopped-by statistics) 'seconds)
    (check-true (< 1.0 (Statistics-seconds statistics) 3.0)
                (format "~a s" (Statistics-seconds statistics)))
    (check-true (< 0.0 (Statistics-error statistics) 0.5)))

  (test-case "the picture for an error is the same, to the bit, on every schedule and tile size"
    (define (picture schedule workers tile)
      (define-values (image statistics)
        (rendered #:width 41 #:height 23 #:error 0.05 #:seed 7
                  #:schedule schedule #:workers workers #:tile tile))
      (check-true (> (Statistics-passes statistics) 1))
      (list (Image-pixels image) (Image-standard-error image) (Statistics-samples statistics)))
    (define reference (picture 'sequential 1 16))
    (check-equal? (picture 'futures 3 16) reference)
    (check-equal? (picture 'futures 2 5) reference)
    (check-equal? (picture 'sequential 1 64) reference)
    (check-equal? (picture 'places 2 16) reference)))
