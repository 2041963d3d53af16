#lang racket/base
;; The fill rule by counting: triangles that share edges cover every sample of what they cover
;; together exactly once, clipped or not.

(module+ test
  (require racket/flonum racket/fixnum racket/list rackunit "../../private/raster/scan.rkt"
           "../../private/raster/raster.rkt" "../statistics.rkt")

  (define width 64)
  (define height 48)
  (define (canvas samples)
    (make-Canvas width height 0 0 width height (coverage-offsets samples 4096) 4096))

  ;; How often the triangles, one at a time, cover each sample.
  (define (count-coverage corners triangles samples [near 1e-6])
    (define counts (make-fxvector (* width height samples) 0))
    (for ([k (in-range 0 (fxvector-length triangles) 3)])
      (define c (canvas samples))
      (draw-mesh! c corners (fxvector (fxvector-ref triangles k) (fxvector-ref triangles (+ k 1))
                                      (fxvector-ref triangles (+ k 2)))
                  0 0 #f near +inf.0)
      (for ([id (in-fxvector (Canvas-ids c))] [at (in-naturals)] #:when (= id 0))
        (fxvector-set! counts at (+ 1 (fxvector-ref counts at)))))
    counts)

  ;; A net of points over the film and beyond, jittered: corners of 2 n n triangles. on-grid?: at places
  ;; where samples lie, so that edges and corners run through them. depth: of a corner.
  (define (net n reach on-grid? depth uniform)
    (define points
      (for*/list ([j (+ n 1)] [i (+ n 1)])
        (define border? (or (= i 0) (= j 0) (= i n) (= j n)))
        (define (place k) (* reach (- (/ (* 2.0 (+ k (if border? 0.0 (uniform -0.24 0.24)))) n) 1)))
        (define (snapped x side)
          (if on-grid? (- (/ (* 2.0 (+ 0.5 (round (* 0.5 side (+ x 1))))) side) 1) x))
        (define w (depth))
        (list (* w (snapped (place i) width)) (* w (snapped (place j) height)) w 1.0)))
    (values
     (apply flvector (map exact->inexact (append* points)))
     (apply fxvector
            (append* (for*/list ([j n] [i n])
                       (define a (+ i (* j (+ n 1))))
                       (define-values (b c d) (values (+ a 1) (+ a n 2) (+ a n 1)))
                       ;; either diagonal, either turn
                       (if (< (uniform 0.0 1.0) 0.5)
                           (list a b c a d c)
                           (list a b d b c d)))))))

  (test-case "a net over the film and beyond: every sample exactly once"
    (define uniform (seeded 11))
    (for* ([samples '(1 4 5)] [on-grid? '(#f #t)] [reach '(1.1 1.5 3.0)])
      (define-values (corners triangles) (net 8 reach on-grid? (lambda () 1.0) uniform))
      (for ([count (in-fxvector (count-coverage corners triangles samples))])
        (check-eqv? count 1))))

  (test-case "a net inside the film: no sample twice, all between its borders once"
    (define uniform (seeded 12))
    (for ([on-grid? '(#f #t)])
      (define-values (corners triangles) (net 9 0.8 on-grid? (lambda () 1.0) uniform))
      (define counts (count-coverage corners triangles 1))
      (for* ([y height] [x width])
        (define-values (a b) (values (- (/ (* 2 (+ x 0.5)) width) 1) (- 1 (/ (* 2 (+ y 0.5)) height))))
        (define count (fxvector-ref counts (+ x (* y width))))
        (check-true (<= count 1))
        (when (< (max (abs a) (abs b)) 0.75) (check-eqv? count 1))
        (when (> (max (abs a) (abs b)) 0.85) (check-eqv? count 0)))))

  (test-case "corners at different depths and far outside: clipped edges still meet"
    (define uniform (seeded 13))
    (for ([samples '(1 3)])
      (define-values (corners triangles) (net 6 9.0 #f (lambda () (uniform 1.0 20.0)) uniform))
      ;; a corner of the grid belongs to all its triangles, so the net has no holes in perspective
      (for ([count (in-fxvector (count-coverage corners triangles samples))])
        (check-eqv? count 1))))

  (test-case "a fan around a corner behind the eye: no sample twice"
    ;; the ground below the eye, in four quarters, from behind it to far before it
    (define corners
      (flvector 0.0 -1.0 0.0 1.0  -50.0 -1.0 -50.0 1.0  50.0 -1.0 -50.0 1.0
                50.0 -1.0 50.0 1.0  -50.0 -1.0 50.0 1.0))
    (define triangles (fxvector 0 1 2 0 2 3 0 3 4 0 4 1))
    (define counts (count-coverage corners triangles 1))
    (for* ([y height] [x width])
      (define b (- 1 (/ (* 2 (+ y 0.5)) height)))
      ;; the ground is seen below its far edge, at b = -1/50
      (check-eqv? (fxvector-ref counts (+ x (* y width))) (if (< b -0.02) 1 0))))

  (test-case "keys are linear in the picture and the nearest stays; equal ones keep the first"
    (define c (canvas 1))
    (define corners (flvector -4.0 -4.0 2.0 1.0  16.0 -8.0 4.0 1.0  -8.0 16.0 4.0 1.0))
    (draw-mesh! c corners (fxvector 0 1 2) 7 0 #f 1e-6 +inf.0)
    (define before (flvector-copy (Canvas-keys c)))
    (for* ([y height] [x width])
      (define-values (a b) (values (- (/ (* 2 (+ x 0.5)) width) 1) (- 1 (/ (* 2 (+ y 0.5)) height))))
      ;; the plane through 1/w = 1/2 at (-2, -2) and 1/4 at (4, -2) and (-2, 4); corners are rounded
      ;; to 1/4096 of a pixel
      (check-= (flvector-ref before (+ x (* y width)))
               (- 0.5 (* 0.25 (+ (/ (+ a 2) 6) (/ (+ b 2) 6)))) 1e-5))
    (draw-mesh! c corners (fxvector 0 1 2) 9 0 #f 1e-6 +inf.0)
    (check-equal? (Canvas-keys c) before)
    (check-true (for/and ([id (in-fxvector (Canvas-ids c))]) (= id 7))))

  (test-case "faces: the turn of the corners in the picture"
    (define corners (flvector -1.0 -1.0 1.0 1.0  1.0 -1.0 1.0 1.0  0.0 1.0 1.0 1.0))
    (define (covered triangles faces)
      (define c (canvas 1))
      (draw-mesh! c corners triangles 0 faces #f 1e-6 +inf.0)
      (for/sum ([id (in-fxvector (Canvas-ids c))]) (if (= id 0) 1 0)))
    (define all (covered (fxvector 0 1 2) 0))
    (check-true (< 1400 all 1600)) ; half the film
    (check-equal? (covered (fxvector 0 1 2) 1) all)
    (check-equal? (covered (fxvector 0 1 2) 2) 0)
    (check-equal? (covered (fxvector 0 2 1) 1) 0)
    (check-equal? (covered (fxvector 0 2 1) 2) all))

  (test-case "edges: lines a pixel wide"
    (define c (canvas 1))
    (draw-mesh! c (flvector -0.5 0.01 1.0 1.0  0.5 0.01 1.0 1.0  0.0 0.01 1.0 1.0) (fxvector 0 1 2)
                0 0 #t 1e-6 +inf.0)
    (check-= (for/sum ([id (in-fxvector (Canvas-ids c))]) (if (= id 0) 1 0)) 32 1))

  (test-case "coverage samples: one in every row and column, their mean in the middle"
    (for ([n (in-range 1 65)])
      (define offsets (coverage-offsets n 4096))
      (define xs (for/list ([k n]) (fxvector-ref offsets (* 2 k))))
      (define ys (for/list ([k n]) (fxvector-ref offsets (+ 1 (* 2 k)))))
      (for ([l (list xs ys)])
        (check-equal? (sort (map (lambda (x) (quotient (* x n) 4096)) l) <) (range n))
        (check-= (/ (apply + l) n 4096.0) 0.5 0.0002)))))
