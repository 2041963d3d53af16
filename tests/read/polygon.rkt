#lang racket/base
;; Triangulated polygons: the triangles' exact areas all have the polygon's sign and add up to its
;; area, so they overlap nowhere (exact rational arithmetic, no tolerance).

(module+ test
  (require rackunit
           racket/fixnum
           racket/flonum
           racket/list
           racket/math
           (only-in racket/set subset?)
           "../../private/read/polygon.rkt")

  ;; Outcome and triangles of a polygon in the plane y = 2x + z of space, given by its (x z).
  (define (triangulate points)
    (define positions
      (apply flvector (append* (for/list ([p (in-list points)])
                                 (define-values (x z) (values (car p) (cadr p)))
                                 (map real->double-flonum (list x (+ (* 2 x) z) z))))))
    (define count (length points))
    (define triangles '())
    (define outcome
      (triangulate-polygon positions (for/fxvector ([k (in-range count)]) k) count
                           (λ (i j k) (set! triangles (cons (list i j k) triangles)))))
    (values outcome (reverse triangles)))

  (define (twice-area points)
    (for/sum ([p (in-list points)] [q (in-list (append (cdr points) (list (car points))))])
      (- (* (inexact->exact (car p)) (inexact->exact (cadr q)))
         (* (inexact->exact (cadr p)) (inexact->exact (car q))))))

  (define (check-exact points)
    (define area (twice-area points))
    (define-values (outcome triangles) (triangulate points))
    (define corner (list->vector points))
    (define areas
      (for/list ([t (in-list triangles)])
        (twice-area (for/list ([k (in-list t)]) (vector-ref corner k)))))
    (check-eq? outcome 'simple)
    (check-equal? (length triangles) (- (length points) 2))
    (check-true (for/and ([a (in-list areas)]) (> (* a (sgn area)) 0)) "a triangle turned over")
    (check-equal? (apply + areas) area))

  (define (check-both-ways points)
    (check-exact points)
    (check-exact (reverse points)))

  (define L '((0 0) (2 0) (2 1) (1 1) (1 2) (0 2)))
  (define arrow '((0 0) (4 2) (0 4) (1 2)))
  (define square-with-points-on-its-sides
    '((0 0) (1 0) (2 0) (2 1) (2 2) (1 2) (0 2) (0 1)))
  (define square-with-hole
    '((0 0) (4 0) (4 4) (0 4) (0 0) (1 1) (1 3) (3 3) (3 1) (1 1)))

  (define (comb teeth)
    (append (for*/list ([i (in-range teeth)] [tip (in-list '(0 1))])
              (list (+ (* 2 i) tip) (* 100 tip)))
            (list (list (* 2 teeth) 0) (list (* 2 teeth) -1) (list 0 -1))))

  (test-case "a convex polygon is a fan"
    (define-values (outcome triangles) (triangulate '((0 0) (2 0) (3 1) (2 2) (0 2))))
    (check-equal? triangles '((0 1 2) (0 2 3) (0 3 4)))
    (check-eq? outcome 'simple))

  (test-case "concave, with points on a line, with a hole joined by a seam"
    (for-each check-both-ways (list L arrow square-with-points-on-its-sides square-with-hole))
    (check-both-ways (comb 20))
    (check-both-ways (map reverse (comb 20))))

  (test-case "300 random star-shaped polygons on an integer grid"
    (define random-source (make-pseudo-random-generator))
    (parameterize ([current-pseudo-random-generator random-source]) (random-seed 11))
    (for ([_ (in-range 300)])
      (define count (+ 4 (random 40 random-source)))
      (check-both-ways
       (for/list ([k (in-range count)])
         (define r (+ 10000 (random 1000000 random-source)))
         (define angle (/ (* 2 pi k) count))
         (list (exact-round (* r (cos angle))) (exact-round (* r (sin angle))))))))

  (test-case "the size does not matter"
    (define (scaled s) (for/list ([p (in-list L)]) (for/list ([x (in-list p)]) (* s x))))
    (define-values (outcome triangles) (triangulate L))
    (for ([s (in-list (list (expt 2.0 -1020) (expt 2.0 -500) (expt 2.0 500) (expt 2.0 1000)))])
      (define-values (other-outcome other-triangles) (triangulate (scaled s)))
      (check-equal? other-triangles triangles)))

  (test-case "20003 corners, within the search limit that is linear in them"
    (define-values (outcome triangles) (triangulate (comb 10000)))
    (check-eq? outcome 'simple)
    (check-equal? (length triangles) 20001))

  (test-case "an outline that crosses itself still gives its count of triangles"
    (define-values (outcome triangles) (triangulate '((0 0) (4 4) (4 0) (0 4))))
    (check-eq? outcome 'crossing)
    (check-equal? (length triangles) 2))

  (test-case "a corner given twice costs one triangle without area"
    (define-values (outcome triangles) (triangulate '((0 0) (2 0) (2 0) (1 1) (2 2) (0 2))))
    (check-eq? outcome 'simple)
    (check-equal? (length triangles) 4)
    (check-equal? (count (λ (t) (subset? '(1 2) t)) triangles) 1))

  (test-case "no area at all"
    (define-values (outcome triangles) (triangulate '((0 0) (1 1) (2 2) (3 3) (0 0))))
    (check-eq? outcome 'crossing)
    (check-equal? (length triangles) 3)))
