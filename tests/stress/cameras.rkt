#lang racket/base
;; S30: cameras of extreme fields of view, aspects and distances.

(provide cases)

(require "case.rkt" "../../main.rkt")

;; Film coordinates of a direction, from 0 to 1, in exact arithmetic: the inverse of a camera ray.
(define (film-point camera direction)
  (define-values (forward right up)
    (values (exact (numbers (Camera-forward camera))) (exact (numbers (Camera-right camera)))
            (exact (numbers (Camera-up camera)))))
  (define d (exact direction))
  (define depth (/ (dot d forward) (dot forward forward)))
  (values (/ (+ 1 (/ (dot d right) (dot right right) depth)) 2)
          (/ (- 1 (/ (dot d up) (dot up up) depth)) 2)))

(define (extremes size)
  (define uniform (seeded 30))
  (define count (amount 20000 size 300))
  (define-values (strange worst missed)
    (for/fold ([strange 0] [worst 0.0] [missed 0]) ([k (in-range count)])
      (define angle
        (cond
          [(< k 4) (list-ref '(1e-6 179.999 90.0 1e-3) k)]
          [(even? k) (expt 10.0 (uniform -6.0 2.0))]
          [else (- 180.0 (expt 10.0 (uniform -3.0 2.0)))]))
      (define distance (expt 10.0 (uniform -9.0 9.0)))
      (define eye (scale (* distance (uniform)) (random-unit uniform)))
      (define sight (scale distance (random-unit uniform)))
      (define camera
        (Camera-look-at (point eye) (point (add eye sight)) #:up (point (random-unit uniform))
                        #:vertical-field-of-view-degrees angle
                        #:aspect (expt 10.0 (uniform -3.0 3.0))))
      ;; the ratio of its axes multiplies the rounding of a unit direction
      (define lengths
        (for/list ([axis (in-list (list Camera-forward Camera-right Camera-up))])
          (norm (numbers (axis camera)))))
      (define condition (/ (apply max lengths) (apply min lengths)))
      (define-values (strange* worst*)
        (for/fold ([strange strange] [worst worst])
                  ([x (in-list (list 0.0 1.0 0.0 1.0 (uniform)))]
                   [y (in-list (list 0.0 0.0 1.0 1.0 (uniform)))])
          (define ray (Camera-ray camera x y))
          (define d (numbers (Ray-direction ray)))
          (cond
            [(and (finite-numbers? (Ray-direction ray)) (finite-numbers? (Ray-point ray))
                  (< (abs (- (norm d) 1.0)) 1e-15))
             (define-values (u v) (film-point camera d))
             (define off (max (abs (- u (inexact->exact x))) (abs (- v (inexact->exact y)))))
             (values strange (max worst (/ (exact->inexact off) condition)))]
            [else (values (+ strange 1) worst)])))
      ;; the ray through the middle meets a ball of a thousandth of the distance at the focus
      (define target (World (list (Sphere (point (add eye sight)) (* 1e-3 distance)))))
      (define t (Intersection-t (World-nearest-hit target (Camera-ray camera 0.5 0.5))))
      (values strange* worst* (if (= t INTERSECTION-T-MAX) (+ missed 1) missed))))
  (values (format "~a strange rays of ~a, film points off by ~a of the axes' ratio, ~a of ~a missed"
                  strange (* 5 count) (rounded worst) missed count)
          (and (= 0 strange missed) (<= worst 1e-12))))

(define cases
  (list (stress-case "S30 lens extremes (rays back to the film exactly; nothing unprojects depths)"
                     "1e-12 conditioned, corner rays finite" extremes)))
