#lang racket/base
;; S16, S17, S20: shading normals, coincident surfaces, deep mirrors.

(provide cases)

(require racket/flonum racket/list "case.rkt" "../../main.rkt" "../world/worlds.rkt"
         (only-in "../world/rays.rkt" nearest-of) (only-in "../shape/mesh-examples.rkt" icosphere))

(define black (Float3 0 0 0))
(define (grey x) (Float3 x x x))

;; --- S16 ---

;; Light seen where the sun is below the surface, and the light that smooth normals send out of a
;; coarse sphere less that of the flat one, over random lines and suns, in standard errors.
(define (terminator size)
  (define uniform (seeded 16))
  (define ball (icosphere 1))
  (define (mesh normals)
    (Mesh (Mesh-positions ball) (Mesh-triangles ball) #:normals normals
          #:material (Lambertian (grey 1))))
  (define-values (flat smooth) (values (mesh #f) (mesh (Mesh-positions ball))))
  (define-values (leaks rays sum squares)
    (for*/fold ([leaks 0] [rays 0] [sum 0.0] [squares 0.0]) ([_ (in-range (amount 20000 size 300))])
      (define sun (random-unit uniform))
      (define light (DistantLight (point sun) (grey 1)))
      (define-values (one two)
        (values (World (list flat) light black) (World (list smooth) light black)))
      (for/fold ([leaks leaks] [rays rays] [sum sum] [squares squares]) ([k (in-range 50)])
        (define d (random-unit uniform))
        (define across (scale (sqrt (uniform)) (unit (cross d (random-unit uniform)))))
        (define ray (Ray (point (subtract across (scale 3.0 d))) (point d)))
        (define found (World-nearest-hit one ray))
        (define (red world) (Float3-x (World-ray-trace world ray)))
        (define more (- (red two) (red one)))
        (define below?
          (and (< (Intersection-t found) INTERSECTION-T-MAX)
               (< (dot sun (numbers (Intersection-normal found))) -1e-12)))
        (values (if (and below? (> (red two) 0.0)) (+ leaks 1) leaks)
                (+ rays 1) (+ sum more) (+ squares (* more more))))))
  (define mean (/ sum rays))
  (define error (sqrt (/ (- (/ squares rays) (* mean mean)) rays)))
  (values (format "~a leaks of ~a rays; smooth less flat ~a +- ~a" leaks rays (rounded mean)
                  (rounded error))
          (and (= leaks 0) (<= mean (* 4.0 error)))))

;; --- S17 ---

;; Every shape three times and quads that overlap in a plane, in random order, alone and between
;; other shapes: hits that are not of the lowest copy, or not the same in both; then pictures by
;; other workers and tiles that differ.
(define (coincident size)
  (define uniform (seeded 17))
  (define-values (wrong rays)
    (for*/fold ([wrong 0] [rays 0]) ([_ (in-range (amount 1000 size 4))])
      (define few (append (random-spheres uniform 8 4.0 1.5) (drop-right (mixed-shapes uniform 4) 1)))
      (define copies (shuffled uniform (append few few few)))
      (define quads
        (for/list ([k 6]) (Quad (Float3 (- -5 k) -5 6) (Float3 (+ 9 k) 0 0) (Float3 0 9 0))))
      (define all (append quads copies))
      (define others (random-spheres uniform 40 30.0 0.1))
      (define mixed (append (take others 20) all (drop others 20)))
      (define-values (alone between) (values (World all) (World mixed)))
      (for/fold ([wrong wrong] [rays rays]) ([k (in-range 250)])
        (define o (if (even? k)
                      (scale 20.0 (random-unit uniform))
                      (list (floor (uniform -6.0 6.0)) (floor (uniform -6.0 6.0)) 20.0)))
        (define d (if (even? k) (subtract (scale 4.0 (random-unit uniform)) o) '(0.0 0.0 -1.0)))
        (define ray (apply flvector (append o d '(+inf.0))))
        (define-values (a b) (values (nearest-of alone ray) (nearest-of between ray)))
        (define (first-of l k) (index-of l (list-ref l k) eq?))
        (define straight-at-quads?
          (and (odd? k) (< -5.0 (first o) 4.0) (< -5.0 (second o) 4.0) a (= (cdr a) 14.0)))
        (define other? (and b (not (memq (list-ref mixed (car b)) all))))
        (define fine?
          (and (cond
                 [other? #t] ; one of the others is in front
                 [(and a b)
                  (and (= (car a) (first-of all (car a))) (= (car b) (first-of mixed (car b)))
                       (eqv? (cdr a) (cdr b))
                       (eq? (list-ref all (car a)) (list-ref mixed (car b))))]
                 [else (not (or a b))])
               (or (not straight-at-quads?) (= 0 (car a)))))
        (values (if fine? wrong (+ wrong 1)) (+ rays 1)))))
  (define spheres
    (for/list ([k 9]) (Sphere black 3 (Emitter (Float3 k (- 9 k) 1)))))
  (define world (World (append spheres (random-spheres uniform 20 5.0 1.0)) '() (grey 0.1)))
  (define camera (Camera-look-at (Float3 1 2 14) black))
  (define (picture workers tile)
    (Image-pixels (render world camera #:width 67 #:height 38 #:samples 2 #:workers workers
                          #:tile tile #:integrator 'path)))
  (define reference (picture 1 16))
  (define different
    (for*/sum ([workers (in-list '(2 3 7))] [tile (in-list '(1 5 16))])
      (if (equal? (picture workers tile) reference) 0 1)))
  (values (format "~a wrong winners of ~a rays, ~a of 9 pictures differ" wrong rays different)
          (= 0 wrong different)))

(define (shuffled uniform l) (sort l < #:key (lambda (x) (uniform)) #:cache-keys? #t))

;; --- S20 ---

;; x^n for an exact x below 1 to 280 bits.
(define (power x n)
  (define one (expt 2 300))
  (define (times a b) (quotient (* a b) one))
  (let loop ([base (floor (* x one))] [n n] [result one])
    (if (= n 0)
        (/ result one)
        (loop (times base base) (quotient n 2) (if (odd? n) (times result base) result)))))

;; In a closed box of mirrors of reflectivity r, ambient light a: the radiance after n bounces is
;; a (1 - r^(n + 1)). Relative error for n of 0 to 100,000, and bytes a bounce of the deepest.
(define (mirrors size)
  (define uniform (seeded 20))
  (define (box r bounces)
    (World (list (Box (grey -1) (Float3 1 1.5 2) (Phong (grey 1) #:reflectivity r))) '() black
           #:ambient-color (grey 10) #:ambient-samples 0 #:mirror-bounces bounces))
  (define (seen world)
    (Float3-x (World-ray-trace world (Ray (Float3 0.1 0.2 0.3) (point (random-unit uniform))))))
  (define worst
    (for*/fold ([worst 0.0]) ([n (in-list '(0 1 8 50 1000 100000))]
                              [r (in-list (if (= n 100000) '(0.9999) '(0.5 0.9 0.999)))])
      (define right (* 10 (- 1 (power (inexact->exact r) (+ n 1)))))
      (for/fold ([worst worst]) ([k (in-range (amount 100 size 2))])
        (define found (inexact->exact (seen (box r n))))
        (max worst (abs (exact->inexact (/ (- found right) right)))))))
  (define deep (box 0.9999 100000))
  (seen deep)
  (define before (current-memory-use 'cumulative))
  (seen deep)
  (define bytes (/ (- (current-memory-use 'cumulative) before) 100000.0))
  ;; between two mirrors the path leaves after m bounces: a cap of m sees the sky, m - 1 does not
  (define wrong-caps
    (for/sum ([m (in-range 1 31)])
      (define slope (/ 1.0 (* 2 m)))
      (define world
        (World (for/list ([z '(-1 1)])
                 (Quad (Float3 -1 -1 z) (Float3 2 0 0) (Float3 0 2 0) (Mirror)))
               '() (grey 1)))
      (define camera (Camera-look-at black (Float3 slope 0 1)))
      (for/sum ([cap (in-list (list m (- m 1)))] [expected (in-list '(1.0 0.0))])
        (define image (render world camera #:width 1 #:height 1 #:samples 1 #:integrator 'path
                              #:max-depth cap #:schedule 'sequential))
        (if (= expected (flvector-ref (Image-pixels image) 0)) 0 1))))
  (values (format "relative ~a, ~a bytes a bounce at 100,000 bounces, ~a of 60 caps wrong"
                  (rounded worst) (rounded bytes) wrong-caps)
          (and (<= worst 1e-13) (<= bytes 16.0) (= 0 wrong-caps))))

(define cases
  (list (stress-case "S16 terminator and shading normals" "0 leaks, energy at most the flat one's"
                     terminator)
        (stress-case "S17 coincident surfaces" "the lowest wins, always" coincident)
        (stress-case "S20 deep mirrors" "relative 1e-13, caps exact, at most 16 bytes a bounce"
                     mirrors)))
