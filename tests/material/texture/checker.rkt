#lang racket/base
;; Checkers: parity by formula, in space and in uv, at borders, and nested.
(module+ test
  (require rackunit racket/math raytrace "support.rkt")

  (define black (Float3 0 0 0))
  (define white (Float3 1 1 1))
  (define (bit look x y) (car (components (look x y))))

  (test-case "cubes: the parity of the sum of three floors, on planes at every height"
    (random-seed 1)
    (for* ([size '(1 1/3 0.2)] [z '(-1.7 -0.05 0.4 2.55)])
      (define look
        (looker (Quad (Float3 -4 -4 z) (Float3 8 0 0) (Float3 0 8 0)
                      (shining (Checker black white size)))))
      (for ([k 100])
        (define x (- (* 8 (random)) 4))
        (define y (- (* 8 (random)) 4))
        (define sum (for/sum ([c (list x y z)]) (exact-floor (/ c size))))
        (check-equal? (bit look x y) (if (even? sum) 0.0 1.0) (format "~a ~a ~a ~a" size x y z)))))

  (test-case "no speckles where a surface lies in the border between cubes"
    (define ground (Sphere (Float3 0 -1000 0) 1000 (shining (Checker black white 5000))))
    (define world (World (list ground) '() (Float3 9 9 9)))
    ;; heights on the sphere round to both sides of 0; the cube below 0 is odd, that above even
    (for ([k 200])
      (define at (* 1e-5 k))
      (check-equal? (World-ray-trace world (Ray (Float3 at 1 at) (Float3 0 -1 0))) black)))

  (test-case "rectangles of u and v"
    (define look (seen (CheckerUV black white 5 3)))
    (for* ([i 5] [j 3])
      (define expected (if (even? (+ i j)) 0.0 1.0))
      (check-equal? (look (/ (+ i 0.02) 5) (/ (+ j 0.97) 3)) (list expected expected expected)))
    (check-equal? (CheckerUV-rows (CheckerUV black white 6)) 6.0))

  (test-case "a checker of checkers"
    (define look (seen (CheckerUV (CheckerUV black white 4) (Float3 0.5 0 0) 2)))
    (check-equal? (look 0.1 0.1) '(0.0 0.0 0.0))
    (check-equal? (look 0.3 0.1) '(1.0 1.0 1.0))
    (check-equal? (look 0.6 0.1) '(0.5 0.0 0.0))))
