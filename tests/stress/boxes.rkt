#lang racket/base
;; S08: boxes and rays parallel to their faces, from exactly on them, against rational arithmetic.

(provide cases)

(require racket/list "case.rkt" "../../main.rkt" (prefix-in probe: "../shape/probe.rkt")
         "../world/worlds.rkt" (only-in "../world/rays.rkt" compare-with-scan))

;; Where the line of a ray is inside the closed box, as two exact parameters; #f for nowhere.
(define (exact-interval low high o d)
  (for/fold ([interval (cons -inf.0 +inf.0)])
            ([l (exact low)] [h (exact high)] [o (exact o)] [d (exact d)])
    (cond
      [(not interval) #f]
      [(zero? d) (and (<= l o h) interval)]
      [else
       (define-values (a b) (values (/ (- l o) d) (/ (- h o) d)))
       (define-values (near far)
         (values (larger (car interval) (min a b)) (smaller (cdr interval) (max a b))))
       (and (<= near far) (cons near far))])))

;; max and min that keep exact numbers exact.
(define (larger a b) (if (> a b) a b))
(define (smaller a b) (if (< a b) a b))

;; The parameter of the nearest hit, or #f: on the way in, or on the way out where the ray starts
;; in the closed box.
(define (exact-hit low high o d)
  (define interval (exact-interval low high o d))
  (cond
    [(not interval) #f]
    [(> (car interval) 0) (car interval)]
    [(> (cdr interval) 0) (cdr interval)]
    [else #f]))

(define (next-up x) (+ x (spacing x)))

(define (random-box uniform)
  (define size (expt 10.0 (uniform -9.0 9.0)))
  (define offset (* size (list-ref '(0.0 1.0 1e3 1e6) (floor-of (uniform 0.0 4.0)))))
  (define low (for/list ([_ 3]) (* size (uniform -1.0 0.0))))
  (define high (for/list ([l low]) (+ l (* size (uniform 0.1 2.0)))))
  (for/lists (lows highs) ([l low] [h high]) (values (+ l offset) (+ h offset))))

(define (floor-of x) (inexact->exact (floor x)))
(define (pick uniform l) (list-ref l (floor-of (uniform 0.0 (length l)))))

;; A ray with one or two components of either zero. Each coordinate of the origin is on a face, in
;; between, one ulp outside of one, or well outside.
(define (parallel-ray uniform low high)
  (define o
    (for/list ([l low] [h high])
      (define width (- h l))
      (pick uniform (list l h l h (+ l (* (uniform) width)) (- l width) (+ h width)
                          (next-up (max (abs l) (abs h)))))))
  (define d
    (let ([zeros (if (< (uniform) 0.7) 2 1)] [start (floor-of (uniform 0.0 3.0))])
      (for/list ([axis 3])
        (if (< (modulo (+ axis start) 3) zeros)
            (pick uniform '(0.0 -0.0))
            (pick uniform (list 1.0 -1.0 (uniform 0.1 9.0) (uniform -9.0 -0.1)))))))
  (values o d))

;; With two zero components every hit of rational arithmetic must be found, touching included, and
;; nothing else, t within 2 ulp. With one zero component an edge decides by rounded parameters:
;; there the hits that must be found are those that stay inside for more than 8 roundings of them.
(define (slabs size)
  (define uniform (seeded 8))
  (define boxes (amount 20000 size 100))
  (define-values (rays hits misses extra worst)
    (for*/fold ([rays 0] [hits 0] [misses 0] [extra 0] [worst 0.0]) ([b (in-range boxes)])
      (define-values (low high) (random-box uniform))
      (define p (probe:probe (Box (point low) (point high))))
      (for/fold ([rays rays] [hits hits] [misses misses] [extra extra] [worst worst])
                ([k (in-range 100)])
        (define-values (o d) (parallel-ray uniform low high))
        (define interval (exact-interval low high o d))
        (define right (exact-hit low high o d))
        (define t (probe:shoot p o d +inf.0))
        (define occluded? (probe:shoot-occluded p o d +inf.0))
        (define sure?
          (or (= 2 (count zero? d))
              (and right
                   (> (- (cdr interval) (larger 0 (car interval)))
                      (* 8 (expt 2 -53) (larger (abs (cdr interval)) (abs (car interval))))))))
        (values (+ rays 1)
                (if right (+ hits 1) hits)
                (if (and right sure? (not (and t occluded?))) (+ misses 1) misses)
                (if (and (not right) sure? (or t occluded?)) (+ extra 1) extra)
                (if (and right sure? t) (max worst (ulps t right)) worst)))))
  (define-values (tree-rays tree-differences) (hierarchy-faces size))
  (values (format (string-append "~a false misses, ~a false hits of ~a rays (~a hits), t to ~a ulp; "
                                 "~a differences at ~a rays on faces of hierarchies")
                  misses extra rays hits (rounded worst) tree-differences tree-rays)
          (and (= 0 misses extra tree-differences) (> hits (* 0.1 rays)) (<= worst 2.0))))

;; Rays from faces, edges and corners of the boxes of hierarchies, along them and through them:
;; what the hierarchy misses and a linear scan does not.
(define (hierarchy-faces size)
  (define uniform (seeded 80))
  (define rounds (amount 250 size 1))
  (for*/fold ([rays 0] [different 0]) ([round (in-range rounds)])
    (define world (World (if (even? round) (mixed-shapes uniform 20) (random-spheres uniform 300))))
    (define found (compare-with-scan world (on-face-rays uniform 2000 world)))
    (values (+ rays 2000) (+ different (length (second found)) (length (third found))))))

(define cases
  (list (stress-case "S08 rays parallel to faces and from on them" "0 false misses" slabs)))
