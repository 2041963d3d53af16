#lang racket/base
;; Occlusion by what was gathered around a point is occlusion by the whole world, to the bit.

(module+ test
  (require racket/flonum racket/list rackunit "../../main.rkt" "../statistics.rkt"
           "gathering.rkt" "worlds.rkt")

  (define (random-point uniform size)
    (Float3 (uniform (- size) size) (uniform (- size) size) (uniform (- size) size)))

  ;; Points seen by random rays, 32 rays from each. least: how many of the points must have
  ;; gathered some, none, and too many, and how many rays must have hit.
  (define (check-gathered name shapes size distances least #:center [center (Float3 0 0 0)])
    (test-case (format "~a: each ray finds the same among what was gathered" name)
      (define uniform (seeded 7))
      (define world (World shapes))
      (define found
        (for*/list ([distance distances] [k (stressed 300 30000)])
          (define o (Float3-add center (random-point uniform (* 1.5 size))))
          (define found (compare-gathered world o (random-point uniform 1.0) distance 32))
          (unless (zero? (third found))
            (fail (format "~a of 32 rays differ, distance ~a, ~a gathered" (third found) distance
                          (first found))))
          found))
      (define (number of?) (count (lambda (f) (and (first f) (of? (first f)))) found))
      (for ([n (list (number positive?) (number zero?) (number negative?)
                     (apply + (map second found)))]
            [l least] [what '("some" "none" "too many" "hits")])
        (check-true (>= n l) (format "~a: only ~a" what n)))))

  (define uniform (seeded 1))
  (define (moved spheres by)
    (for/list ([s spheres]) (Sphere (Float3-add (Sphere-point s) by) (Sphere-radius s))))
  (check-gathered "sparse" (random-spheres uniform 60 6.0) 6.0 '(0.5 3.0 8.0) '(20 10 0 20))
  (check-gathered "dense" (random-spheres uniform 200 6.0 1.5) 6.0 '(0.1 1.0 4.0)
                  '(50 50 50 1000))
  (check-gathered "a floor of a sphere"
                  (cons (Sphere (Float3 0 -1000 0) 999) (random-spheres uniform 20 4.0))
                  4.0 '(0.5 2.0) '(50 50 0 100))
  (check-gathered "inside a hollow sphere"
                  (cons (Sphere (Float3 0 0 0) 20) (random-spheres uniform 15 5.0))
                  5.0 '(1.0 10.0 45.0) '(500 0 0 1000))
  (check-gathered "no limit" (random-spheres uniform 12 4.0 3.0) 4.0 '(+inf.0) '(100 0 0 500))
  (check-gathered "nested duplicates" (nested-duplicates uniform 2) 5.0 '(0.5 2.0) '(20 0 0 100))
  (check-gathered "extents from 1e-9 to 1e9" (many-scales uniform 14) 1.0 '(1e-9 1e-3 1.0 1e9)
                  '(50 50 0 100))
  (check-gathered "tiny, far from the origin"
                  (moved (random-spheres uniform 60 1e-3 3e-4) (Float3 1000 -500 0))
                  1e-3 '(3e-4) '(50 5 0 50) #:center (Float3 1000 -500 0))

  ;; A triangle hidden inside a sphere makes the world one of mixed shapes, for which nothing is
  ;; gathered; nothing else about the picture changes.
  (define (with-hidden-triangle spheres)
    (define s (car spheres))
    (define e (* 0.1 (Sphere-radius s)))
    (define c (Sphere-point s))
    (append spheres (list (Triangle c (Float3-add c (Float3 e 0 0)) (Float3-add c (Float3 0 e 0))))))

  (for* ([weighting '(uniform cosine)] [falloff '(linear binary)] [distance '(0.3 2.0 1e9)])
    (test-case (format "pictures with and without gathering, ~a ~a ~a: equal to the bit"
                       weighting falloff distance)
      (define uniform (seeded 5))
      (define spheres (random-spheres uniform 40 4.0 1.2))
      (define (picture shapes)
        (define world
          (World shapes '() (Float3 1 1 1) #:ambient-samples 8 #:max-occlusion-distance distance
                 #:ambient-weighting weighting #:occlusion-falloff falloff))
        (render world (Camera-look-at (Float3 0 3 10) (Float3 0 0 0)) #:width 48 #:height 27
                #:samples 2 #:integrator 'ambient-occlusion #:schedule 'sequential))
      (define gathered (Image-pixels (picture spheres)))
      (check-equal? gathered (Image-pixels (picture (with-hidden-triangle spheres))))
      ;; some pixels are partly occluded, so that there is something to compare
      (check-true (> (for/sum ([v (in-flvector gathered)]) (if (< 0.05 v 0.95) 1 0)) 50))))

  (test-case "World-get-ambient-percent, with and without gathering: equal to the bit"
    (define spheres (random-spheres (seeded 6) 40 4.0 1.2))
    (define-values (plain mixed)
      (values (World spheres) (World (with-hidden-triangle spheres))))
    (define uniform (seeded 8))
    (for ([k 100])
      (define s (list-ref spheres (modulo k 40)))
      (define n (Float3-normalized (random-point uniform 1.0)))
      (define p (Float3-add (Sphere-point s) (Float3-scale-by-scalar n (Sphere-radius s))))
      (check-equal? (World-get-ambient-percent plain p n #:seed k)
                    (World-get-ambient-percent mixed p n #:seed k)))))
