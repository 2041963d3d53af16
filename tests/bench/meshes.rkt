#lang racket/base
;; The bumpy sphere of 100,172 triangles: building it, and rays by the million through watertight
;; triangles and through leaky ones.
(require racket/flonum racket/math
         (only-in "../shape/mesh-examples.rkt" bumpy-sphere make-generator random-direction)
         (only-in "../../main.rkt" Mesh Mesh-positions Mesh-triangles Mesh-triangle-count)
         "moller-trumbore.rkt")

(provide measure-mesh)

;; a million rays in parts so short that the least time of some rounds is undisturbed
(define RAYS 100000)
(define PARTS 10)
(define ROUNDS 4)

;; `next!` writes a ray from place `at` of the flvector.
(define (make-rays next!)
  (define rays (make-flvector (* 6 RAYS)))
  (for ([k (in-range RAYS)]) (next! rays (* 6 k) k))
  rays)

(define (put! rays at numbers)
  (for ([x (in-list numbers)] [j (in-naturals at)]) (flvector-set! rays j (exact->inexact x))))

(define (scaled s p) (for/list ([c (in-list p)]) (* s c)))

;; A view that the sphere fills, 1000 by 1000.
(define (primary-rays part)
  (define (place k) (* 0.3 (- (* 2.0 (/ (+ k 0.5) 1000.0)) 1.0)))
  (make-rays (lambda (rays at k)
               (put! rays at (list 0.0 0.0 4.0 (place (remainder k 1000))
                                   (place (+ (* 100 part) (quotient k 1000))) -1.0)))))

;; From a sphere of twice the size to points uniform in the unit ball.
(define (outside-rays part)
  (define g (make-generator (+ 1 part)))
  (make-rays (lambda (rays at k)
               (define o (scaled 2.0 (random-direction g)))
               (define target (scaled (expt (random g) 1/3) (random-direction g)))
               (put! rays at (append o (map - target o))))))

;; From within 0.9 of the middle in any direction.
(define (inside-rays part)
  (define g (make-generator (+ 1000 part)))
  (make-rays (lambda (rays at k)
               (put! rays at (append (scaled (* 0.9 (expt (random g) 1/3)) (random-direction g))
                                     (random-direction g))))))

(define (seconds thunk)
  (collect-garbage)
  (define start (current-process-milliseconds))
  (thunk)
  (/ (- (current-process-milliseconds) start) 1000.0))

;; The least CPU seconds of several rounds in turn, one for each thunk.
(define (least-seconds . thunks)
  (for/fold ([least (map (lambda (_) +inf.0) thunks)]) ([round (in-range ROUNDS)])
    (for/list ([before (in-list least)] [thunk (in-list thunks)]) (min before (seconds thunk)))))

;; unit: a procedure that measures the seconds of one cu here and now; it is taken
;; after the build and after each part of the rays. Shows rows `| what | cu | limit |` and returns
;; them.
(define (measure-mesh unit)
  (define rows '())
  (define (row! what cu limit)
    (define text
      (format "| ~a | ~a | ~a |" what (if cu (/ (round (* 100.0 cu)) 100.0) "") limit))
    (displayln text)
    (flush-output)
    (set! rows (cons text rows)))
  (define model (bumpy-sphere 318 158))
  (define-values (positions triangles) (values (Mesh-positions model) (Mesh-triangles model)))
  (define (build) (shape-kernels (Mesh positions triangles)))
  (define build-seconds (car (least-seconds build)))
  (row! (format "~a triangles, build" (Mesh-triangle-count model)) (/ build-seconds (unit))
        "1.2 cu")
  (define-values (watertight leaky) (values (build) (leaky-kernels positions triangles)))
  (for ([rays (in-list (list primary-rays outside-rays))]
        [name (in-list '("primary" "random from outside"))]
        [limit (in-list '("3.5 cu" "14 cu"))])
    (define-values (times units)
      (for/fold ([times '(0.0 0.0 0.0 0.0)] [units '()]) ([part (in-range PARTS)])
        (define shot (rays part))
        (define more
          (apply least-seconds
                 (for/list ([kernel (in-list (append watertight leaky))])
                   (lambda () (count-hits kernel shot)))))
        (values (map + times more) (cons (unit) units))))
    (define cu (/ (apply + units) PARTS))
    (define-values (nearest occluded leaky-nearest leaky-occluded)
      (apply values (map (lambda (time) (/ time cu)) times)))
    (row! (format "10^6 ~a rays, nearest hit" name) nearest limit)
    (row! (format "10^6 ~a rays, any hit" name) occluded "no slower than nearest")
    (row! (format "~a, leaky triangles, nearest hit: watertight costs ~a%" name
                  (percent nearest leaky-nearest))
          leaky-nearest "15%")
    (row! (format "~a, leaky triangles, any hit: watertight costs ~a%" name
                  (percent occluded leaky-occluded))
          leaky-occluded "15%"))
  (for ([kernels (in-list (list watertight leaky))] [name (in-list '("watertight" "leaky"))]
        [batches (in-list '(100 10))])
    (define missed
      (for/sum ([seed (in-range batches)]) (- RAYS (count-hits (car kernels) (inside-rays seed)))))
    (row! (format "~a rays from inside, ~a: ~a leave" (* batches RAYS) name missed) #f
          (if (eq? kernels watertight) "0 leave" "")))
  (reverse rows))

(define (percent a b) (/ (round (* 1000.0 (- (/ a b) 1.0))) 10.0))

(module+ main
  (require "unit.rkt")
  (void (measure-mesh calibration-unit)))
