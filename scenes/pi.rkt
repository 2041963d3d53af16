#lang racket/base
;; The Monte Carlo method on the seed's example: pi from the part of points in the unit square that
;; fall into the quarter disk, by each of the samplers, with an error bar and with the slope of the
;; error over the number of points.
;; racket -l raytrace/scenes/pi prints the table; raco raytrace pi draws 1024 points of it.
(require racket/math raytrace)

(provide world camera settings SAMPLERS pi-estimate pi-error pi-slope)

(define SAMPLERS '(independent stratified owen-sobol r2))

;; Whether the point that a sampler gives is inside the quarter disk.
(define (inside? sampler index count seed)
  (define-values (x y) (sample-point sampler #:index index #:count count #:seed seed))
  (<= (+ (* x x) (* y y)) 1.0))

;; pi-estimate : four times the part of `count` points that are inside.
(define (pi-estimate sampler count [seed 0])
  (* 4.0 (/ (for/sum ([index (in-range count)]) (if (inside? sampler index count seed) 1 0))
            count)))

;; pi-error : the estimate of `repeats` independent runs of `count` points each, as three numbers: their
;; mean; its standard error, estimated from how they scatter; and the root mean square of what one run
;; is off, which only one who knows pi can say.
(define (pi-error sampler count [repeats 32])
  (define estimates (for/list ([seed (in-range repeats)]) (pi-estimate sampler count seed)))
  (define mean (/ (apply + estimates) repeats))
  (define variance
    (/ (for/sum ([estimate estimates]) (sqr (- estimate mean))) (- repeats 1)))
  (values mean (sqrt (/ variance repeats))
          (sqrt (/ (for/sum ([estimate estimates]) (sqr (- estimate pi))) repeats))))

;; pi-slope : how the error falls with the number of points: the slope of the straight line through
;; log error over log count, by least squares. -1/2 is what chance gives.
(define (pi-slope sampler [counts '(16 64 256 1024)] [repeats 32])
  (define points
    (for/list ([count counts])
      (define-values (mean standard-error error) (pi-error sampler count repeats))
      (cons (log count) (log error))))
  (define (mean-of part) (/ (apply + (map part points)) (length points)))
  (define-values (x y) (values (mean-of car) (mean-of cdr)))
  (/ (for/sum ([p points]) (* (- (car p) x) (- (cdr p) y)))
     (for/sum ([p points]) (sqr (- (car p) x)))))

;; --- the picture: points inside and outside, a sphere each, and the quarter circle ---

(define POINTS 1024)

(define dots
  (for/list ([index (in-range POINTS)])
    (define-values (x y) (sample-point 'owen-sobol #:index index #:count POINTS))
    (Sphere (Float3 x y 0) 0.008
            (if (inside? 'owen-sobol index POINTS 0)
                (Float3 0.9 0.35 0.15)
                (Float3 0.2 0.35 0.75)))))

(define arc
  (for/list ([k (in-range 64)])
    (define (corner k) (Float3 (cos (* pi 1/128 k)) (sin (* pi 1/128 k)) 0))
    (Cylinder (corner k) (corner (+ k 1)) 0.004 (Float3 0.1 0.1 0.1))))

(define world
  (World (append dots arc) '() (Float3 1 1 1) #:ambient-samples 0))

(define camera
  (Camera-orthographic (Float3 0.5 0.5 3) (Float3 0.5 0.5 0) #:height 1.08))

(define settings (hash 'size '(600 600) 'integrator 'raster 'samples 16))

;; ----------------------------------------------------------------------------------------------

(module+ main
  (printf "pi is ~a. Estimates from 1024 points, means of 32 runs:\n" (real->decimal-string pi 5))
  (for ([sampler SAMPLERS])
    (define-values (mean standard-error error) (pi-error sampler 1024))
    (define name (symbol->string sampler))
    (printf "~a~a~a +- ~a   one run is off by ~a   slope ~a\n" name
            (make-string (- 13 (string-length name)) #\space)
            (real->decimal-string mean 5) (real->decimal-string standard-error 5) (real->decimal-string error 5) (real->decimal-string (pi-slope sampler) 2))))
