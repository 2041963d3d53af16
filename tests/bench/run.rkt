#lang racket/base
;; The benchmark suite: racket tests/bench/run.rkt [FOLDER] writes benchmark.md and scaling.png
;; there (by default the current folder). Times are CPU seconds of one worker, medians of three
;; runs; bytes and rays are exact. `cu` is the time of a fixed loop run before and after.
(require raytrace racket/list racket/math racket/format racket/flonum racket/cmdline
         racket/lazy-require
         (only-in raytrace/private/render/render render/statistics) raytrace/private/render/statistics
         (only-in raytrace/private/world/world World-scene)
         raytrace/scenes/seed
         (prefix-in weekend: raytrace/scenes/weekend)
         (prefix-in cornell: raytrace/scenes/cornell-diffuse)
         (prefix-in shadows: raytrace/scenes/soft-shadows)
         "worlds.rkt" "scan.rkt" "meshes.rkt" "unit.rkt" "many-lights.rkt" "features.rkt" "cornell.rkt")

(lazy-require ["scaling-plot.rkt" (write-scaling-plot)])

(define (median numbers) (list-ref (sort numbers <) (quotient (length numbers) 2)))

;; One row: a world rendered three times; the world is compiled before and its time told apart.
(define (measure name world camera width height samples #:schedule [schedule 'sequential])
  (define build-start (current-process-milliseconds))
  (World-scene world)
  (define build (/ (- (current-process-milliseconds) build-start) 1000.0))
  (define runs
    (for/list ([k (in-range 3)])
      (collect-garbage)
      (define before (current-memory-use 'cumulative))
      (define-values (image statistics)
        (render/statistics world camera #:width width #:height height #:samples samples
                           #:schedule schedule))
      (cons statistics (- (current-memory-use 'cumulative) before))))
  (define statistics (car (first runs)))
  (define rays (+ (Statistics-nearest-rays statistics) (Statistics-occlusion-rays statistics)))
  (define seconds (median (map (lambda (run) (Statistics-processor-seconds (car run))) runs)))
  (define bytes (- (median (map cdr runs)) (* 24 width height)))
  (hash 'name name 'seconds seconds 'rays rays 'pixels (* width height)
        'bytes (/ (max 0 bytes) 1.0 rays) 'build build))

(define (row measured unit)
  (define seconds (hash-ref measured 'seconds))
  (define rays (hash-ref measured 'rays))
  (format "| ~a | ~a | ~a | ~a | ~a | ~a | ~a | ~a |"
          (hash-ref measured 'name) (~r seconds #:precision '(= 2))
          (~r (/ seconds unit) #:precision '(= 2))
          rays (~r (/ rays 1.0 (hash-ref measured 'pixels)) #:precision '(= 1))
          (~r (/ rays 1e6 (max seconds 1e-9)) #:precision '(= 2))
          (~r (hash-ref measured 'bytes) #:precision '(= 2))
          (~r (hash-ref measured 'build) #:precision '(= 3))))

(define (scene-rows unit)
  (define rows
    (list
     (measure "seed, 480x270, 64 occlusion samples" world camera 480 270 1)
     (measure "1,000 mirrors, 480x270, 4 samples" (mirror-world 1000) (front-camera 1000)
              480 270 4)
     (measure "soft-shadows, 240x100, 1 sample" shadows:world shadows:camera 240 100 1)
     (measure "weekend, 400x225, 4 samples" weekend:world weekend:camera 400 225 4)
     (measure "cornell-diffuse, 256x256, 4 samples" cornell:world cornell:camera 256 256 4)))
  (for ([measured (in-list rows)]) (displayln (row measured unit)))
  rows)

;; Wall-clock ratio of one future to two on an unbalanced picture.
(define (future-speed-up)
  (define half (half-empty-world))
  (World-scene half)
  (define camera (Camera-look-at (Float3 0 0 20) (Float3 0 0 0)))
  (define (seconds workers)
    (define-values (image statistics)
      (render/statistics half camera #:width 640 #:height 360 #:samples 1 #:workers workers))
    (Statistics-seconds statistics))
  (median (for/list ([k (in-range 5)]) (/ (seconds 1) (seconds 2)))))

(module+ main
  (define folder (command-line #:args ([folder "."]) folder))
  (define unit-before (calibration-unit))
  (printf "1 cu = ~a s\n" (~r unit-before #:precision '(= 3)))
  (printf "| scene | CPU s | cu | rays | rays a pixel | million rays/s | bytes a ray | build s |\n")
  (printf "|---|---|---|---|---|---|---|---|\n")
  (define rows (scene-rows unit-before))
  (define scaling
    (for/list ([n (in-list '(100 1000 10000 100000 1000000))])
      (define result (scaling-row n))
      (printf "| ~a spheres, random rays | ~a µs a ray | scan ~a µs | build ~a s |\n" n
              (~r (first result) #:precision '(= 3))
              (if (second result) (~r (second result) #:precision '(= 2)) "-")
              (~r (third result) #:precision '(= 2)))
      (cons n result)))
  (printf "| mesh | cu | limit |\n|---|---|---|\n")
  (define mesh-rows (measure-mesh calibration-unit))
  (define speed-up (future-speed-up))
  (printf "two futures against one, objects in one half: ~a\n" (~r speed-up #:precision '(= 2)))
  (define unit-after (calibration-unit))
  (define tables
    (let ([text (open-output-string)])
      (write-cornell text unit-after)
      (newline text)
      (write-many-lights text unit-after)
      (newline text)
      (write-features text)
      (get-output-string text)))
  (display tables)
  (printf "1 cu after = ~a s\n" (~r unit-after #:precision '(= 3)))
  (call-with-output-file (build-path folder "benchmark.md") #:exists 'truncate
    (lambda (out)
      (fprintf out "1 cu = ~a s before, ~a s after.\n\n" (~r unit-before #:precision '(= 3))
               (~r unit-after #:precision '(= 3)))
      (fprintf out
               "| scene | CPU s | cu | rays | rays a pixel | million rays/s | bytes a ray | build s |\n")
      (fprintf out "|---|---|---|---|---|---|---|---|\n")
      (for ([measured (in-list rows)]) (fprintf out "~a\n" (row measured unit-before)))
      (fprintf out "\n| spheres | µs a random ray | scan, µs | ratio | build s |\n|---|---|---|---|---|\n")
      (for ([entry (in-list scaling)])
        (define scan (third entry))
        (fprintf out "| ~a | ~a | ~a | ~a | ~a |\n" (first entry)
                 (~r (second entry) #:precision '(= 3))
                 (if scan (~r scan #:precision '(= 2)) "")
                 (if scan (~r (/ scan (second entry)) #:precision '(= 1)) "")
                 (~r (fourth entry) #:precision '(= 2))))
      (fprintf out "\n| mesh | cu | limit |\n|---|---|---|\n")
      (for ([text (in-list mesh-rows)]) (fprintf out "~a\n" text))
      (fprintf out "\nTwo futures against one, objects in one half: ~a.\n"
               (~r speed-up #:precision '(= 2)))
      (fprintf out "\n~a" tables)))
  (write-scaling-plot scaling (build-path folder "scaling.png")))
