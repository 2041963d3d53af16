#lang racket/base
;; Each warp has the density it names: chi-square in cells, means, unit lengths.

(module+ test
  (require racket/math rackunit "../statistics.rkt" "warps.rkt")

  (define count (stressed 100000 1000000))
  (define (points seed warp)
    (define uniform (seeded seed))
    (for/list ([k count]) (warp (uniform) (uniform))))

  ;; The part of a turn of (x, y), and two numbers that should be independent and uniform, as one
  ;; cell number over 16 x 16 cells.
  (define (turn p)
    (define angle (/ (atan (cadr p) (car p)) (* 2.0 pi)))
    (if (< angle 0.0) (+ 1.0 angle) angle))
  (define (paired a b) (/ (+ (floor (* 16.0 (min a 0.999999999))) (min b 0.999999999)) 16.0))

  ;; height: what of a point should be uniform in [0, 1), by the density the warp names.
  (define (check-density points height)
    (define z (uniform-deviate (for/list ([p points]) (paired (height p) (turn p))) 256))
    (check-true (< (abs z) SIDAK) (format "chi-square deviate ~a" z)))
  ;; level .01 for the nine of them together (Sidak), both tails
  (define SIDAK 3.26)
  (define (check-unit points)
    (for ([p points])
      (define length (sqrt (apply + (map * p p))))
      (unless (<= (abs (- length 1.0)) 5e-16) (fail (format "length ~a of ~a" length p)))))
  (define (check-means points expected spread)
    (for ([coordinate (list car cadr caddr)] [e expected])
      (define m (mean (map coordinate points)))
      (check-true (<= (abs (- m e)) (* 4.0 (/ spread (sqrt count)))) (format "mean ~a, not ~a" m e))))
  (define (square x) (* x x))

  (test-case "disk: uniform by area"
    (define all (points 1 disk))
    (check-density all (lambda (p) (+ (square (car p)) (square (cadr p)))))
    (check-means all '(0.0 0.0 0.0) 0.5)
    (check-true (andmap (lambda (p) (= 0.0 (caddr p))) all)))

  (test-case "cosine hemisphere: height squared is uniform, mean height 2/3"
    (define all (points 2 cosine-hemisphere))
    (check-unit all)
    (check-density all (lambda (p) (square (caddr p))))
    (check-means all '(0.0 0.0 0.6666666666666666) 0.5)
    (check-true (andmap (lambda (p) (>= (caddr p) 0.0)) all)))

  (test-case "uniform hemisphere: height is uniform, mean 1/2"
    (define all (points 3 uniform-hemisphere))
    (check-unit all)
    (check-density all caddr)
    (check-means all '(0.0 0.0 0.5) 0.58)
    (check-true (andmap (lambda (p) (> (caddr p) 0.0)) all)))

  (test-case "sphere: height is uniform from -1 to 1"
    (define all (points 4 uniform-sphere))
    (check-unit all)
    (check-density all (lambda (p) (* 0.5 (+ 1.0 (caddr p)))))
    (check-means all '(0.0 0.0 0.0) 0.58))

  (test-case "cones: height is uniform above the rim"
    (for ([h '(0.001 0.5 1.0 2.0)])
      (define all (points 5 (lambda (u v) (cone u v h))))
      (check-unit all)
      (check-density all (lambda (p) (max 0.0 (/ (- 1.0 (caddr p)) h))))
      (check-means (map (lambda (p) (list (car p) (cadr p) (- 1.0 (caddr p)))) all)
                   (list 0.0 0.0 (* 0.5 h)) (sqrt h))))

  (test-case "a cone of 1e-8 radians is not empty: the squared radius is uniform"
    (define h 5e-17)
    (check-density (points 6 (lambda (u v) (cone u v h)))
                   (lambda (p) (/ (+ (square (car p)) (square (cadr p))) (* 2.0 h)))))

  (test-case "corners of the unit square: finite, unit, on the right side"
    (define almost-one (- 1.0 (expt 2.0 -32)))
    (for* ([u (list 0.0 almost-one)] [v (list 0.0 almost-one)])
      (define all
        (list (cosine-hemisphere u v) (uniform-hemisphere u v) (uniform-sphere u v) (cone u v 1e-3)))
      (check-unit all)
      (for ([p (list (car all) (cadr all) (cadddr all))]) (check-true (>= (caddr p) 0.0))))))
