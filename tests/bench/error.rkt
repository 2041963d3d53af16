#lang racket/base
;; Run time against error: racket tests/bench/error.rkt [--size quick|full] [--scene NAME] [FOLDER]
;; writes error.md and a plot for each scene there (by default the current folder). Six small
;; pictures by every sampler at several numbers of samples, and rendered until an error: RMSE against
;; a stored reference, CPU time of one worker, the slope of their logarithms, and the CPU time until
;; an RMSE of 0.01, in units of a fixed loop (cu).
;;   racket tests/bench/error.rkt --references SAMPLES   renders the references anew
(require racket/cmdline racket/file racket/flonum racket/format racket/lazy-require racket/list
         racket/runtime-path raytrace
         (only-in raytrace/private/render/render render/statistics)
         raytrace/private/render/statistics
         (only-in raytrace/private/world/world World-scene)
         "../accuracy/error-scenes.rkt" "unit.rkt"
         (prefix-in weekend: raytrace/scenes/weekend)
         (prefix-in cornell: raytrace/scenes/cornell-diffuse)
         (prefix-in glass: raytrace/scenes/cornell-glass)
         (prefix-in plates: raytrace/scenes/veach-mis))

(lazy-require ["error-plot.rkt" (write-error-plot)])
(define-runtime-path references-folder "references")

(define SAMPLERS '(owen-sobol stratified r2 independent))

;; short: what its files are called. width, height: of the picture. errors: relative ones to render
;; until. Where lights are in view (cut?) the RMSE is that of colours cut at 1 (RMSE1).
(struct bench (short scene width height errors cut?))

(define benches
  (list (bench "seed" (shade-scene 16) 96 54 '(0.02 0.01 0.005) #f)
        (bench "soft-shadows" disk-light-scene 96 54 '(0.1 0.05 0.02) #f)
        (bench "weekend" (scene "weekend" weekend:world weekend:camera) 96 54
               '(0.1 0.05 0.02) #f)
        (bench "cornell-diffuse" (scene "cornell-diffuse" cornell:world cornell:camera)
               72 72 '(0.2 0.1 0.05) #t)
        (bench "cornell-glass" (scene "cornell-glass" glass:world glass:camera) 72 72
               '(0.2 0.1 0.05) #t)
        (bench "veach-mis" (scene "veach-mis" plates:world plates:camera) 96 54
               '(0.5 0.2 0.1) #t)))

;; The peers' cost to error 0.01 in cu, measured elsewhere at the sizes given.
(define PEERS
  (hash "weekend"
        (string-append
         "Others at 400x225, cu to RMSE 0.01: the book's C++ 170-230, Mitsuba 3.9 (llvm) 41, tight "
         "C++ with a SAH tree 22; POV-Ray 3.7 stays at 0.034.")
        "cornell-diffuse"
        (string-append
         "Others at 256x256, cu to RMSE1 0.01: the book's C++ with light sampling 108, Blender "
         "Cycles 5.0 35, Mitsuba 3.9 scalar 31, Mitsuba 3.9 (llvm) 10.")))
(define PEER-PIXELS (hash "weekend" (* 400 225) "cornell-diffuse" (* 256 256)))

;; ----------------------------------------------------------------------------------------------
;; References.

(define (reference-path b)
  (build-path references-folder (string-append "error-" (bench-short b) ".pfm")))

;; By another seed than what is measured, and not by the default sampler.
(define (write-reference b samples)
  (make-directory* references-folder)
  (define-values (image statistics)
    (render/statistics (scene-world (bench-scene b)) (scene-camera (bench-scene b))
                       #:width (bench-width b) #:height (bench-height b) #:samples samples #:seed 4242
                       #:sampler 'stratified))
  (Image-write image (reference-path b))
  (printf "~a: relative RMSE ~a, ~a s\n" (bench-short b) (digits (Statistics-error statistics))
          (digits (Statistics-processor-seconds statistics)))
  (flush-output))

;; ----------------------------------------------------------------------------------------------
;; Measuring.

;; name, samples a pixel, RMSE, CPU seconds
(struct row (name samples rmse seconds))

(define (measured b reference name settings)
  (define s (bench-scene b))
  (define-values (image statistics)
    (keyword-apply render/statistics (map car settings) (map cdr settings)
                   (list (scene-world s) (scene-camera s))
                   #:width (bench-width b) #:height (bench-height b)
                   #:schedule 'sequential))
  (define (values-of image)
    (if (bench-cut? b)
        (for/flvector ([x (in-flvector (Image-pixels image))]) (flmin x 1.0))
        (Image-pixels image)))
  (row name (/ (Statistics-samples statistics) 1.0 (Statistics-pixels statistics))
       (sqrt (mean-square-difference (values-of image) (values-of reference)))
       (max 1e-3 (Statistics-processor-seconds statistics))))

(define (rows-of b counts)
  (define reference (Image-read (reference-path b)))
  (World-scene (scene-world (bench-scene b)))
  ;; once for nothing: the first run compiles what is compiled late
  (measured b reference "" '((#:samples . 4)))
  (append
   (for*/list ([sampler (in-list SAMPLERS)] [count (in-list counts)])
     (measured b reference (symbol->string sampler)
               (list (cons '#:sampler sampler) (cons '#:samples count))))
   (for/list ([error (in-list (bench-errors b))])
     (measured b reference "until an error" (list (cons '#:error error))))))

(define (cost r) (* (row-seconds r) (expt (/ (row-rmse r) 0.01) 2)))

;; The slope of log RMSE against log samples; #f for a single one.
(define (slope rows)
  (and (pair? (cdr rows))
       (let* ([xs (map (lambda (r) (log (row-samples r))) rows)]
              [ys (map (lambda (r) (log (row-rmse r))) rows)]
              [middle (/ (apply + xs) (length xs))]
              [spread (for/sum ([x xs]) (expt (- x middle) 2))])
         (and (> spread 0.0) (/ (for/sum ([x xs] [y ys]) (* (- x middle) y)) spread)))))

;; ----------------------------------------------------------------------------------------------
;; Writing.

(define (digits x)
  (if (< 1e-3 (abs x) 1e4)
      (~r x #:precision (if (< (abs x) 1.0) 4 2))
      (~r x #:notation 'exponential #:precision 3)))

(define (write-scene b rows before unit after out)
  (fprintf out "\n## ~a, ~ax~a\n\n" (scene-name (bench-scene b)) (bench-width b) (bench-height b))
  (fprintf out "1 cu = ~a s before, ~a s after; below it is ~a s.\n\n" (digits before) (digits after)
           (digits unit))
  (fprintf out "| sampler | samples a pixel | RMSE~a | CPU s | cu | cu to RMSE 0.01 | slope |\n"
           (if (bench-cut? b) "1" ""))
  (fprintf out "|---|---|---|---|---|---|---|\n")
  (for ([group (in-list (group-by row-name rows))])
    (define steepness (slope group))
    (for ([r (in-list group)] [k (in-naturals)])
      (fprintf out "| ~a | ~a | ~a | ~a | ~a | ~a | ~a |\n" (row-name r)
               (~r (row-samples r) #:precision 1) (digits (row-rmse r)) (digits (row-seconds r))
               (digits (/ (row-seconds r) unit)) (digits (/ (cost r) unit))
               (if (and steepness (= k 0)) (~r steepness #:precision '(= 2)) ""))))
  (define peers (hash-ref PEERS (bench-short b) #f))
  (when peers
    ;; the same error of a picture with more pixels takes so many times as long
    (define scale (/ (hash-ref PEER-PIXELS (bench-short b)) 1.0 (bench-width b) (bench-height b)))
    (define best (argmin cost rows))
    (fprintf out "\n~a At as many pixels the best row here, ~a at ~a samples, costs ~a cu.\n" peers
             (row-name best) (~r (row-samples best) #:precision 1)
             (digits (* scale (/ (cost best) unit)))))
  (flush-output out))

(define (write-plot b rows unit folder)
  (write-error-plot (scene-name (bench-scene b))
                    (for/list ([group (in-list (group-by row-name rows))])
                      (list (row-name (car group))
                            (for/list ([r (in-list group)])
                              (cons (/ (row-seconds r) unit) (row-rmse r)))))
                    (build-path folder (format "error-~a.png" (bench-short b)))))

(module+ main
  (define counts '(1 4 16 64 256))
  (define chosen benches)
  (define reference-samples #f)
  (define folder
    (command-line
     #:program "racket tests/bench/error.rkt"
     #:once-each
     [("--size") word "quick (4, 16, 64 samples) or full (1 to 256); full unless given"
                 (case word
                   [("quick") (set! counts '(4 16 64))]
                   [("full") (void)]
                   [else (raise-user-error
                          (format "--size: expected quick or full, given ~a" word))])]
     [("--scene") name "only this scene, such as weekend"
                  (set! chosen (filter (lambda (b) (equal? (bench-short b) name)) benches))
                  (when (null? chosen)
                    (raise-user-error (format "--scene: expected one of ~a, given ~a"
                                              (map bench-short benches) name)))]
     [("--references") samples "render the references with so many samples instead"
                       (set! reference-samples (string->number samples))
                       (unless (exact-positive-integer? reference-samples)
                         (raise-user-error
                          (format "--references: expected a number of samples, given ~a" samples)))]
     #:args ([folder "."])
     folder))
  (cond
    [reference-samples (for ([b (in-list chosen)]) (write-reference b reference-samples))]
    [else
     (make-directory* folder)
     (call-with-output-file (build-path folder "error.md") #:exists 'truncate
       (lambda (file)
         (for ([b (in-list chosen)])
           (define before (calibration-unit))
           (define rows (rows-of b counts))
           (define after (calibration-unit))
           (define unit (* 0.5 (+ before after)))
           (for ([out (in-list (list file (current-output-port)))])
             (write-scene b rows before unit after out))
           (write-plot b rows unit folder))))]))
