#lang racket/base
;; The scene of 10,000 lights at 16 samples: time, rays, and RMSE1 against the same library that
;; chooses among lights uniformly.
;;   racket tests/bench/many-lights.rkt
(require racket/format "features.rkt")

(provide write-many-lights uniform-choice)

(define-values (width height samples) (values 120 68 16))

;; uniform-choice : the choice by the tree and its probability replaced in the path integrator.
(define path-file "private/integrate/path.rkt")
(define uniform-choice
  (list (edit path-file
              "(choose-light! (Scene-light-choice scene) (MaterialKernel-transmits? kernel) r)" 1
              "(let* ([whole (fl->fx (fl* (flvector-ref r sample-u) (fx->fl count)))])
                 (flvector-set! r (light-probability) (fl/ 1.0 (fx->fl count)))
                 whole)")
        (edit path-file
              "(put-light-probability! (Scene-light-choice scene) light transmitting? r)" 1
              "(flvector-set! r (light-probability) (fl/ 1.0 (fx->fl (vector-length lights))))")))

;; CPU seconds of a picture, rays, and RMSE1 from two independent pictures.
(define (measure edits)
  (parameterize ([current-namespace (load-library edits)])
    (define-values (world camera)
      (values (dynamic-require 'raytrace/scenes/many-lights 'world)
              (dynamic-require 'raytrace/scenes/many-lights 'camera)))
    (define render/statistics
      (dynamic-require 'raytrace/private/render/render 'render/statistics))
    (define (statistic name)
      (dynamic-require 'raytrace/private/render/statistics
                       (string->symbol (format "Statistics-~a" name))))
    (define pixel (dynamic-require 'raytrace 'Image-pixel))
    (define (picture seed)
      (render/statistics world camera #:width width #:height height #:samples samples #:seed seed
                         #:integrator 'path #:schedule 'sequential))
    (define-values (a statistics) (picture 1))
    (define-values (b other) (picture 2))
    (define squares
      (for*/fold ([sum 0.0]) ([y height] [x width])
        (define-values (r1 g1 b1) (pixel a x y))
        (define-values (r2 g2 b2) (pixel b x y))
        (for/fold ([sum sum]) ([p (list r1 g1 b1)] [q (list r2 g2 b2)])
          (+ sum (expt (- (min p 1.0) (min q 1.0)) 2)))))
    (values (/ (+ ((statistic 'processor-seconds) statistics) ((statistic 'processor-seconds) other))
               2)
            (+ ((statistic 'nearest-rays) statistics) ((statistic 'occlusion-rays) statistics))
            (sqrt (/ squares 2 3 width height)))))

;; unit: seconds of one cu.
(define (write-many-lights out unit)
  (fprintf out "many-lights, 10,000 lights, ~ax~a, ~a samples\n\n" width height samples)
  (fprintf out "| choice | cu | rays a sample | µs a ray | RMSE1 | cost to error 0.01, cu |\n")
  (fprintf out "|---|---|---|---|---|---|\n")
  (for ([name '("light tree" "uniform")] [edits (list '() uniform-choice)])
    (define-values (seconds rays error) (measure edits))
    (fprintf out "| ~a | ~a | ~a | ~a | ~a | ~a |\n" name
             (~r (/ seconds unit) #:precision '(= 2))
             (~r (/ rays 1.0 (* width height samples)) #:precision '(= 2))
             (~r (/ (* 1e6 seconds) rays) #:precision '(= 2))
             (~r error #:precision '(= 4))
             (~r (* (/ seconds unit) (expt (/ error 0.01) 2)) #:precision '(= 1)))))

(module+ main
  (require "unit.rkt")
  (write-many-lights (current-output-port) (calibration-unit)))
