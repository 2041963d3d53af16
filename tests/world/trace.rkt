#lang racket/base
;; The hierarchy against the linear scan: the same primitive and the same bits of t for random,
;; axis-parallel, grazing and on-face rays (S07, S08); ties (S17); unusual numbers (S12); allocation.

(module+ test
  (require racket/flonum racket/list rackunit "../../main.rkt" "../statistics.rkt"
           "rays.rkt" "worlds.rkt")

  ;; rays of each kind for each world: 10^5 in all, 10^7 under stress, in rounds of fresh rays
  (define count 3600)
  (define rounds (stressed 1 100))

  (define (check-same what world rays least-hits)
    (define found (compare-with-scan world rays))
    (define (ray k) (for/list ([c 7]) (flvector-ref rays (+ c (* 7 k)))))
    (for ([k (second found)]) (fail (format "~a: scan differs for ray ~a" what (ray k))))
    (for ([k (third found)]) (fail (format "~a: occlusion differs for ray ~a" what (ray k))))
    (check-true (>= (first found) least-hits) (format "~a: only ~a hits" what (first found))))

  (define (check-world name size least-part make-shapes)
    (test-case (format "~a: hierarchy and scan agree to the bit" name)
      (for ([round rounds])
        (define uniform (seeded (+ 1 round)))
        (define world (World (make-shapes uniform)))
        (define least (* least-part count))
        (check-same "random" world (random-rays uniform count size) least)
        (check-same "axis-parallel" world (axis-parallel-rays uniform count size) (* 0.5 least))
        (check-same "grazing" world (grazing-rays uniform count world size) least)
        (check-same "on faces" world (on-face-rays uniform count world) least))))

  (check-world "one sphere" 2.0 0.01 (lambda (uniform) (list (Sphere (Float3 0.5 -0.25 1) 1))))
  (check-world "five" 5.0 0.004 (lambda (uniform) (random-spheres uniform 5 5.0)))
  (check-world "three hundred" 10.0 0.1 (lambda (uniform) (random-spheres uniform 300)))
  (check-world "three hundred that overlap" 10.0 0.3
               (lambda (uniform) (random-spheres uniform 300 10.0 4.0)))
  (check-world "all at one point" 3.0 0.05
               (lambda (uniform) (for/list ([k 60]) (Sphere (Float3 1 1 1) (uniform 0.5 1.5)))))
  (check-world "nested duplicates" 5.0 0.05 (lambda (uniform) (nested-duplicates uniform 6)))
  (check-world "extents from 1e-9 to 1e9" 1.0 0.1 (lambda (uniform) (many-scales uniform 200)))
  (check-world "spheres, triangles, quads, boxes, disks and a plane" 6.0 0.3
               (lambda (uniform) (mixed-shapes uniform 20)))

  (test-case "none: nothing is hit, nothing occludes"
    (define found
      (compare-with-scan (World '()) (axis-parallel-rays (seeded 1) 1000 3.0)))
    (check-equal? found '(0 () ())))

  (test-case "the hierarchy finds what another formula finds: 300 spheres, 2,000 rays, t to 1e-12"
    (define uniform (seeded 3))
    (define spheres (random-spheres uniform 300))
    (define world (World spheres))
    (define rays (random-rays uniform 2000 10.0))
    (define (textbook-root o d s)
      (define oc (Float3-subtract o (Sphere-point s)))
      (define-values (a half-b c)
        (values (Float3-dot d d) (Float3-dot oc d)
                (- (Float3-dot oc oc) (* (Sphere-radius s) (Sphere-radius s)))))
      (define discriminant (- (* half-b half-b) (* a c)))
      (cond
        [(< discriminant 0.0) +inf.0]
        [else
         (define roots (list (/ (- (- half-b) (sqrt discriminant)) a)
                             (/ (+ (- half-b) (sqrt discriminant)) a)))
         (for/first ([t (append roots '(+inf.0))] #:when (> t 0.0)) t)]))
    (define hits
      (for/sum ([k 2000])
        (define ray (flvector-copy rays (* 7 k) (* 7 (+ k 1))))
        (define-values (o d)
          (values (Float3 (flvector-ref ray 0) (flvector-ref ray 1) (flvector-ref ray 2))
                  (Float3 (flvector-ref ray 3) (flvector-ref ray 4) (flvector-ref ray 5))))
        (define ts (for/list ([s spheres]) (textbook-root o d s)))
        (define expected (apply min ts))
        (define found (nearest-of world ray))
        (cond
          [(< expected (flvector-ref ray 6))
           (check-= (cdr found) expected (* 1e-12 (+ 1.0 expected)))
           (check-equal? (car found) (index-of ts expected))
           1]
          [else (check-false found) 0])))
    (check-true (> hits 200)))

  (test-case "S17: of coincident surfaces the lowest index is hit, whatever stands around"
    (define (ray . numbers) (apply flvector (append numbers '(+inf.0))))
    (define straight (ray 0.0 0.0 9.0 0.0 0.0 -1.0))
    (for ([others '(0 1 7 50)] [seed (in-naturals 1)])
      (define (around) (random-spheres (seeded seed) others 2.0 0.3))
      (define (far) (map (lambda (s) (Sphere (Float3-add (Sphere-point s) (Float3 30 0 0)) 0.2))
                         (around)))
      (define spheres (for/list ([k 9]) (Sphere (Float3 0 0 0) 3)))
      (check-equal? (car (nearest-of (World (append (far) spheres)) straight)) others)
      (check-equal? (car (nearest-of (World (append spheres (far))) straight)) 0)
      (define quads
        (for/list ([k 9]) (Quad (Float3 (- -1 k) -1 5) (Float3 (+ 2 k) 0 0) (Float3 0 2 0))))
      (check-equal? (car (nearest-of (World (append (far) quads)) straight)) others)
      (check-equal? (car (nearest-of (World (append (far) (reverse quads))) straight)) others)))

  (test-case "occlusion: what lies at the limit does not, the ignored primitive does not"
    (define world (World (list (Sphere (Float3 0 0 0) 1) (Sphere (Float3 0 0 -5) 1))))
    (define (occluded? limit ignored)
      (occluded-of world (flvector 0.0 0.0 3.0 0.0 0.0 -1.0 limit) ignored))
    (check-false (occluded? 2.0 -1))
    (check-true (occluded? (+ 2.0 1e-15) -1))
    (check-false (occluded? 6.9 0))
    (check-true (occluded? 7.1 0))
    (check-true (occluded? +inf.0 1)))

  (test-case "S12: directions at the ends of the numbers hit rightly or miss; never a NaN"
    (define world (World (list (Sphere (Float3 0 0 0) 1))))
    (for* ([length '(4.9e-324 1e-310 1e-200 1e-150 1.0 1e150 1e200 1e308)]
           [direction (list (Float3 0 0 (- length)) (Float3 0 (- length) 0)
                            (Float3 (* 0.1 length) 0 (- length)))])
      (define hit (World-nearest-hit world (Ray (Float3 0 0 3) direction)))
      (define t (Intersection-t hit))
      (unless (= t INTERSECTION-T-MAX)
        (check-= (Float3-length (Ray-point-at (Ray (Float3 0 0 3) direction) t)) 1.0 1e-9)
        (check-= (Float3-length (Intersection-point hit)) 1.0 1e-12)
        (check-= (Float3-length (Intersection-normal hit)) 1.0 1e-12))
      (define color
        (World-ray-trace world (Ray (Float3 0 0 3) direction)))
      (for ([c (list (Float3-x color) (Float3-y color) (Float3-z color))])
        (check-true (and (>= c 0.0) (< c +inf.0))
                    (format "direction ~a: colour ~a" direction color))))
    (for ([bad (list (Float3 0 0 0) (Float3 0 -0.0 0) (Float3 +nan.0 1 0) (Float3 1 +inf.0 0))])
      (check-exn #rx"^Ray: [^\n]*direction[^\n]*$" (lambda () (Ray (Float3 0 0 0) bad))))
    (for ([bad (list (Float3 +nan.0 1 0) (Float3 1 -inf.0 0))])
      (check-exn #rx"^Ray: [^\n]*point[^\n]*$" (lambda () (Ray bad (Float3 1 0 0))))
      (check-exn #rx"^Sphere: [^\n]*point[^\n]*$" (lambda () (Sphere bad 1))))
    (for ([bad '(0 -1 +nan.0 +inf.0)])
      (check-exn #rx"^Sphere: [^\n]*radius[^\n]*$" (lambda () (Sphere (Float3 0 0 0) bad)))))

  (test-case "allocation: at most 4 bytes a ray, for nearest hits with their surface and for occlusion"
    (define (check-allocation name world rays)
      (for ([bytes (bytes-per-ray world rays (lambda () (current-memory-use 'cumulative)))]
            [kernel '("nearest" "occluded")])
        (check-true (<= bytes 4.0) (format "~a, ~a: ~a bytes a ray" name kernel
                                           (exact->inexact bytes)))))
    (define uniform (seeded 1))
    (check-allocation "300 spheres" (World (random-spheres uniform 300))
                      (random-rays uniform 100000 10.0))
    (check-allocation "mixed shapes" (World (mixed-shapes uniform 20))
                      (random-rays uniform 20000 6.0))))
