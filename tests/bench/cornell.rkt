#lang racket/base
;; cornell-diffuse at 256x256 against its reference (see cornell-reference.rkt): RMSE1, bias, time,
;; and the cost to error 0.01, which for an unbiased picture is the same at every sample count.
;;   racket tests/bench/cornell.rkt
(require raytrace racket/format racket/runtime-path
         (only-in raytrace/private/render/render render/statistics)
         raytrace/private/render/statistics
         raytrace/scenes/cornell-diffuse)

(provide write-cornell)

(define-runtime-path reference-file "references/cornell-diffuse.pfm")
(define side 256)

;; The RMSE1 of the picture's pixels of even rows and columns, and the bias of their mean.
(define (compare image reference)
  (define-values (squares sum right)
    (for*/fold ([squares 0.0] [sum 0.0] [right 0.0])
               ([y (quotient side 2)] [x (quotient side 2)])
      (define-values (r g b) (Image-pixel image (* 2 x) (* 2 y)))
      (define-values (rr gg bb) (Image-pixel reference x y))
      (for/fold ([squares squares] [sum sum] [right right]) ([p (list r g b)] [q (list rr gg bb)])
        (define-values (p1 q1) (values (min p 1.0) (min q 1.0)))
        (values (+ squares (expt (- p1 q1) 2)) (+ sum p1) (+ right q1)))))
  (values (sqrt (/ squares 3/4 side side)) (- (/ sum right) 1.0)))

;; unit: seconds of one cu.
(define (write-cornell out unit)
  (define reference (Image-read reference-file))
  (fprintf out "cornell-diffuse, ~ax~a\n\n" side side)
  (fprintf out "| samples | cu | rays a sample | µs a ray | RMSE1 | bias | to error 0.01, cu |\n")
  (fprintf out "|---|---|---|---|---|---|---|\n")
  (for ([samples '(16 64)])
    (define-values (image statistics)
      (render/statistics world camera #:width side #:height side #:samples samples #:seed 7
                         #:integrator 'path #:schedule 'sequential))
    (define seconds (Statistics-processor-seconds statistics))
    (define rays (+ (Statistics-nearest-rays statistics) (Statistics-occlusion-rays statistics)))
    (define-values (error bias) (compare image reference))
    (fprintf out "| ~a | ~a | ~a | ~a | ~a | ~a% | ~a |\n" samples
             (~r (/ seconds unit) #:precision '(= 2))
             (~r (/ rays 1.0 side side samples) #:precision '(= 2))
             (~r (/ (* 1e6 seconds) rays) #:precision '(= 2))
             (~r error #:precision '(= 5))
             (~r (* 100 bias) #:precision '(= 2))
             (~r (* (/ seconds unit) (expt (/ error 0.01) 2)) #:precision '(= 1)))))

(module+ main
  (require "unit.rkt")
  (define before (calibration-unit))
  (write-cornell (current-output-port) before)
  (printf "1 cu = ~a s before, ~a s after\n" before (calibration-unit)))
