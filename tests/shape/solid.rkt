#lang racket/base
;; Solids: lens, bite, drilled box and hollow ball against closed forms, random trees of solids
;; against the membership of points, instances and nesting, and what the walk leaves of the scratch.

;; The scratch's places that the test reads, which are macros of a typed module.
(module places typed/racket/base
  (require (prefix-in place: "../../private/base/registers.rkt"))
  (provide (all-defined-out))
  (define-values (ray-origin ray-limit hit-t surface-color)
    (values place:ray-origin place:ray-limit place:hit-t place:surface-color))
  (define-values (hit-primitive accept-ties nest-level stack-base)
    (values place:hit-primitive place:accept-ties place:nest-level place:stack-base)))

(module+ test
  (require (submod ".." places) racket/flonum racket/fixnum racket/list racket/math rackunit
           (except-in "../../private/base/float3.rkt" Float3)
           (only-in "../../private/base/registers.rkt" make-flonum-registers make-fixnum-registers)
           "../../private/base/transform.rkt"
           "../../private/shape/solid.rkt" "../../private/shape/sphere.rkt"
           "../../private/shape/box.rkt" "../../private/shape/plane.rkt"
           "../../private/shape/instance.rkt" "../../private/shape/group.rkt"
           "../../private/shape/kernel.rkt" "../../private/shape/kernels.rkt"
           "../../private/shape/mesh.rkt" "../../private/material/phong.rkt"
           (only-in "mesh-examples.rkt" icosphere)
           (only-in "rays.rkt" shoot-surface shoot-material leave-count)
           "probe.rkt" "axial-checks.rkt" "spawned-rays.rkt")

  (define (stressed count) (if stress? (* 10 count) count))
  (define (sphere center radius) (make-Sphere (float3 center) radius))
  (define (box low high) (make-Box (float3 low) (float3 high)))

  ;; All surfaces along a ray, as a path finds them: the next ray starts at the hit, off it by its
  ;; error. Parameters and normals.
  (define (events p o d)
    (define dd (dot d d))
    (let next ([from o] [left 50])
      (define t (shoot p from d))
      (cond
        [(or (not t) (= left 0)) '()]
        [else
         (define s (surface-at p))
         (define point (Surface-point s))
         (define along (dot (Surface-normal s) d))
         (define side (if (> along 0.0) 1.0 -1.0))
         (cons (cons (/ (dot (subtract point o) d) dd) along)
               (next (add point (scale (* side (Surface-error s)) (Surface-normal s)))
                     (- left 1)))])))
  (define (check-events p o d expected tolerance)
    (define found (events p o d))
    (check-equal? (length found) (length expected) (format "~a ~a ~a" o d found))
    (for ([f found] [e expected]) (check-= (car f) e tolerance))
    ;; in, out, in, out
    (for ([f (reverse found)] [k (in-naturals)])
      (check-equal? (> (cdr f) 0.0) (even? k))))

  (test-case "a lens: both faces and the rim in closed form, t to 4e-15"
    (define c 0.75)
    (define p (probe (make-SolidIntersection (sphere (list (- c) 0.0 0.0) 1.0)
                                             (sphere (list c 0.0 0.0) 1.0))))
    (define rim (sqrt (- 1.0 (* c c))))
    (for ([k 200])
      (define y (* rim (/ (+ k 0.5) 200)))
      (define half (- (sqrt (- 1.0 (* y y))) c))
      (check-= (shoot p (list -5.0 y 0.0) '(1.0 0.0 0.0)) (- 5.0 half) 4e-15)
      (define s (surface-at p))
      (check-= (norm (subtract (Surface-normal s) (list (- (- half) c) y 0.0))) 0.0 1e-14)
      ;; from inside, along a direction of another length
      (check-= (shoot p (list 0.0 y 0.0) '(2.0 0.0 0.0)) (* 0.5 half) 4e-15)
      (check-= (first (Surface-normal (surface-at p))) (+ half c) 1e-14)
      (check-events p (list -5.0 y 0.0) '(1.0 0.0 0.0) (list (- 5.0 half) (+ 5.0 half)) 1e-14))
    (for ([y '(0.67 0.7 0.9 1.1)])
      (check-false (shoot p (list -5.0 y 0.0) '(1.0 0.0 0.0))))
    (check-equal? (bounds p) '((-0.25 -1.0 -1.0) (0.25 1.0 1.0))))

  (test-case "a ball with a bite: the wall is the bite's, its normal turned, its uv kept; exact"
    (define bite (sphere '(-2.0 0.0 0.0) 1.0))
    (define p (probe (make-SolidDifference (sphere '(0.0 0.0 0.0) 2.0) bite)))
    (check-equal? (shoot p '(-5.0 0.0 0.0) '(1.0 0.0 0.0)) 4.0)
    (define s (surface-at p))
    (check-equal? (Surface-point s) '(-1.0 0.0 0.0))
    (check-equal? (Surface-normal s) '(-1.0 -0.0 -0.0))
    (define alone (probe bite))
    (shoot alone '(-2.0 0.0 0.0) '(1.0 0.0 0.0))
    (check-equal? (list (Surface-u s) (Surface-v s))
                  (list (Surface-u (surface-at alone)) (Surface-v (surface-at alone))))
    (check-events p '(-5.0 0.0 0.0) '(1.0 0.0 0.0) '(4.0 7.0) 0.0)
    ;; the other way, from inside, and from inside the bite
    (check-events p '(5.0 0.0 0.0) '(-1.0 0.0 0.0) '(3.0 6.0) 0.0)
    (check-events p '(0.0 0.0 0.0) '(-1.0 0.0 0.0) '(1.0) 0.0)
    (check-events p '(-1.5 0.0 0.0) '(1.0 0.0 0.0) '(0.5 3.5) 0.0)
    (check-events p '(-1.5 0.0 0.0) '(-1.0 0.0 0.0) '() 0.0)
    (check-equal? (bounds p) '((-2.0 -2.0 -2.0) (2.0 2.0 2.0))))

  (test-case "a hollow ball: four walls, t to 1e-14"
    (define uniform (make-random 50))
    (define p (probe (make-SolidDifference (sphere '(0.0 0.0 0.0) 2.0) (sphere '(0.0 0.0 0.0) 1.0))))
    (for ([_ (stressed 200)])
      (define d (random-unit uniform))
      (check-events p (scale -3.0 d) d '(1.0 2.0 4.0 5.0) 1e-14)
      (check-events p '(0.0 0.0 0.0) d '(1.0 2.0) 1e-14)
      (check-events p (scale 1.5 d) d '(0.5) 1e-14)
      (check-true (< (dot d (begin (shoot p '(0.0 0.0 0.0) d) (Surface-normal (surface-at p))))
                     -0.999999))))

  (test-case "a drilled box: walls in closed form; no film over a hole that ends in the faces"
    (define uniform (make-random 51))
    (for ([end '(1.0 1.5)])
      (define p (probe (make-SolidDifference
                        (box '(-1.0 -1.0 -1.0) '(1.0 1.0 1.0))
                        (cylinder (list 0.0 0.0 (- end)) (list 0.0 0.0 end) 0.5))))
      (for ([_ (stressed 200)])
        (define y (uniform -0.49 0.49))
        (define wall (sqrt (- 0.25 (* y y))))
        (check-events p (list -4.0 y (uniform -0.9 0.9)) '(1.0 0.0 0.0)
                      (list 3.0 (- 4.0 wall) (+ 4.0 wall) 5.0)
                      ;; the later ones beside the ray by the errors of the points before, and the
                      ;; wall is met at a slant
                      (/ 2e-14 wall))
        ;; down the hole, straight and slanting
        (define o (append (scale 0.24 (take (random-unit uniform) 2)) '(-3.0)))
        (check-false (shoot p o '(0.0 0.0 1.0)))
        (check-false (shoot p o (list (uniform -0.04 0.04) (uniform -0.04 0.04) 1.0)))
        ;; from the hole's middle: the wall only, or nothing
        (define d (random-unit uniform))
        (define t (/ 0.5 (sqrt (+ (sqr (first d)) (sqr (second d))))))
        (if (< (abs (* t (third d))) 1.0)
            (check-= (shoot p '(0.0 0.0 0.0) d) t (* 1e-14 t))
            (check-false (shoot p '(0.0 0.0 0.0) d))))))

  (test-case "a union: two surfaces along a ray from outside, none where shapes overlap or touch"
    (define uniform (make-random 52))
    (define overlapping (probe (make-SolidUnion (sphere '(-0.5 0.0 0.0) 1.0)
                                                (sphere '(0.5 0.0 0.0) 1.0))))
    (check-events overlapping '(-4.0 0.0 0.0) '(1.0 0.0 0.0) '(2.5 5.5) 0.0)
    (check-events overlapping '(0.0 0.0 0.0) '(1.0 0.0 0.0) '(1.5) 0.0)
    (define touching (probe (make-SolidUnion (box '(-1.0 -1.0 -1.0) '(0.3 1.0 1.0))
                                             (box '(0.3 -1.0 -1.0) '(1.0 1.0 1.0)))))
    (define cube (probe (box '(-1.0 -1.0 -1.0) '(1.0 1.0 1.0))))
    (for ([_ (stressed 500)])
      (define target (scale 0.6 (random-in-ball uniform)))
      (define o (add target (scale 5.0 (random-unit uniform))))
      (define d (subtract target o))
      (check-equal? (length (events overlapping o d)) 2)
      (check-events touching o d (map car (events cube o d)) 1e-14)
      (check-equal? (length (events touching target d)) 1))
    (check-equal? (bounds overlapping) '((-1.5 -1.0 -1.0) (1.5 1.0 1.0))))

  (test-case "boxes turned and joined at a face that each computes with roundings of its own: no seam"
    (define uniform (make-random 60))
    (define cube (box '(-1.0 -1.0 -1.0) '(1.0 1.0 1.0)))
    (for ([_ 30])
      (define turn (Transform-rotate (float3 (random-unit uniform)) (uniform 0.0 6.0)))
      (define (at . steps) (make-Instance cube (apply Transform-compose turn steps)))
      (define half-turn (Transform-rotate (make-Float3 0 0 1) pi))
      (define joined (probe (make-SolidUnion (at (Transform-translate -1 0 0))
                                             (at (Transform-translate 1 0 0) half-turn))))
      (define whole (probe (at (Transform-scale 2 1 1))))
      ;; of two that only touch nothing is common, and neither takes anything from the other
      (define common (probe (make-SolidIntersection (at (Transform-translate -1 0 0))
                                                    (at (Transform-translate 1 0 0) half-turn))))
      (for ([_ (stressed 20)])
        (define target (scale 0.5 (random-in-ball uniform)))
        (define o (add target (scale 5.0 (random-unit uniform))))
        (define d (subtract target o))
        (check-events joined o d (map car (events whole o d)) 1e-13)
        (check-false (shoot common o d)))))

  ;; --- random trees: a shape, and whether a point is in it ---

  (struct sample (shape in?))
  (define (random-tree uniform depth)
    (cond
      [(= depth 0)
       (define c (scale 0.8 (random-in-ball uniform)))
       (cond
         [(< (uniform) 0.5)
          (define radius (uniform 0.3 1.2))
          (sample (sphere c radius) (lambda (p) (< (norm (subtract p c)) radius)))]
         [else
          (define half (list (uniform 0.2 1.0) (uniform 0.2 1.0) (uniform 0.2 1.0)))
          (sample (box (subtract c half) (add c half))
                  (lambda (p) (andmap < (map abs (subtract p c)) half)))])]
      [else
       (define-values (a b)
         (values (random-tree uniform (- depth 1)) (random-tree uniform (- depth 1))))
       (define-values (in-a? in-b?) (values (sample-in? a) (sample-in? b)))
       (define choice (uniform))
       (define-values (make in?)
         (cond
           [(< choice 0.4) (values make-SolidUnion (lambda (p) (or (in-a? p) (in-b? p))))]
           [(< choice 0.6) (values make-SolidIntersection (lambda (p) (and (in-a? p) (in-b? p))))]
           [else (values make-SolidDifference (lambda (p) (and (in-a? p) (not (in-b? p)))))]))
       (sample (make (sample-shape a) (sample-shape b)) in?)]))

  ;; Between consecutive surfaces the middle is in the solid or not, by turns, and the last surface
  ;; leaves it. Returns the number of surfaces.
  (define (check-membership p in? o d)
    (define ts (map car (events p o d)))
    (for ([from (cons 0.0 ts)] [to (append ts '(100.0))] [left (in-range (length ts) -1 -1)])
      (when (> (- to from) 1e-9)
        (check-equal? (in? (add o (scale (* 0.5 (+ from to)) d))) (odd? left)
                      (format "~a ~a ~a" o d ts))
        ;; a finer look for a surface that was passed over
        (for ([k (in-range 1 20)])
          (check-equal? (in? (add o (scale (+ from (* k 0.05 (- to from))) d))) (odd? left)))))
    (length ts))

  (define (random-ray uniform)
    (define target (random-in-ball uniform))
    (define o (scale (uniform 0.0 3.0) (random-unit uniform)))
    (values o (subtract target o)))

  (test-case "2,000 random rays through 100 random trees: the middle between surfaces is in or out"
    (define uniform (make-random 53))
    (define surfaces
      (for/sum ([k (stressed 100)])
        (define tree (random-tree uniform (+ 1 (remainder k 3))))
        (define p (probe (sample-shape tree)))
        (for/sum ([_ 20])
          (define-values (o d) (random-ray uniform))
          (check-membership p (sample-in? tree) o d))))
    (check-true (> surfaces 2000)))

  (test-case "three differences deep, directly and with an instance at every level: the same hits"
    (define uniform (make-random 54))
    (define balls (for/list ([_ 3]) (cons (random-unit uniform) (uniform 0.4 0.9))))
    (define (in? p)
      (and (< (norm p) 1.0)
           (for/and ([b balls]) (>= (norm (subtract p (car b))) (cdr b)))))
    (define unit-ball (sphere '(0.0 0.0 0.0) 1.0))
    (define direct
      (for/fold ([solid unit-ball]) ([b balls])
        (make-SolidDifference solid (sphere (car b) (cdr b)))))
    ;; the same in other spaces: after each difference all is shifted, turned and doubled
    (define-values (nested outward)
      (for/fold ([solid unit-ball] [outward (Transform-identity)]) ([b balls] [k (in-naturals)])
        (define center (float3->list (Transform-point outward (float3 (car b)))))
        (define next
          (Transform-compose (Transform-translate 1 2 3)
                             (Transform-rotate (float3 (random-unit uniform)) 1.0)
                             (Transform-scale 2)))
        (values (make-Instance (make-SolidDifference solid (sphere center (* (expt 2.0 k) (cdr b))))
                               next)
                (Transform-compose next outward))))
    (define (outward-point p) (float3->list (Transform-point outward (float3 p))))
    (define (outward-vector v) (float3->list (Transform-vector outward (float3 v))))
    (define-values (p q) (values (probe direct) (probe nested)))
    (define surfaces
      (for/sum ([_ (stressed 200)])
        (define-values (o d) (random-ray uniform))
        (define found (check-membership p in? o d))
        (define-values (one two)
          (values (events p o d) (events q (outward-point o) (outward-vector d))))
        (check-equal? (length one) (length two))
        ;; 3e-13 across the surface, which a ray may graze
        (for ([a one] [b two])
          (check-= (* (cdr a) (- (car a) (car b))) 0.0 3e-13 (format "~a ~a" a b)))
        found))
    (check-true (> surfaces 150)))

  (test-case "what is taken from what was taken away comes back"
    (define inner (make-SolidDifference (sphere '(0.0 0.0 0.0) 2.0) (sphere '(0.0 0.0 0.0) 1.0)))
    (define p (probe (make-SolidDifference (sphere '(0.0 0.0 0.0) 3.0) inner)))
    (check-events p '(-5.0 0.0 0.0) '(1.0 0.0 0.0) '(2.0 3.0 4.0 6.0 7.0 8.0) 0.0)
    (shoot p '(-1.5 0.0 0.0) '(1.0 0.0 0.0))
    (check-equal? (Surface-normal (surface-at p)) '(-1.0 0.0 0.0)))

  (test-case "a scaled and turned instance of a difference is the difference of the instances"
    (define uniform (make-random 55))
    (for ([_ 20])
      (define transform
        (Transform-compose (Transform-translate (uniform -3.0 3.0) 1 2)
                           (Transform-rotate (float3 (random-unit uniform)) (uniform 0.0 6.0))
                           (Transform-scale (uniform 0.5 2.0) (uniform 0.5 2.0) -1)))
      (define-values (a b) (values (sphere '(0.0 0.0 0.0) 1.0) (sphere '(0.7 0.0 0.0) 0.8)))
      (define one (probe (make-Instance (make-SolidDifference a b) transform)))
      (define two (probe (make-SolidDifference (make-Instance a transform)
                                               (make-Instance b transform))))
      (for ([_ (stressed 20)])
        (define (random-place size)
          (float3->list (Transform-point transform (float3 (scale size (random-unit uniform))))))
        (define-values (o target) (values (random-place 3.0) (random-place 0.7)))
        (define d (subtract target o))
        (check-equal? (length (events one o d)) (length (events two o d)))
        (define t (shoot one o d))
        (when t
          (define s (surface-at one))
          (check-= (shoot two o d) t (* 1e-13 t))
          (check-= (norm (subtract (Surface-normal s) (Surface-normal (surface-at two)))) 0.0
                   1e-10)))))

  (test-case "meshes as parts: a hollow of two icospheres"
    (define uniform (make-random 56))
    (define mesh (icosphere 2))
    (define small (make-Instance mesh (Transform-scale 0.5)))
    (define p (probe (make-SolidDifference mesh small)))
    (define-values (outside inside) (values (probe mesh) (probe small)))
    (for ([_ (stressed 200)])
      (define d (random-unit uniform))
      (define o (add (scale -4.0 d) (scale 0.2 (random-in-ball uniform))))
      (define walls (map car (append (events outside o d) (events inside o d))))
      (check-events p o d (sort walls <) 1e-12)))

  (test-case "materials: the parts' own, the solid's instead, the outermost solid's before that"
    (define colors (for/list ([k 4]) (make-Phong (make-Float3 k 0 0))))
    (define (number m) (or (index-of colors m eq?) 9))
    (define (ball x radius k)
      (make-Sphere (make-Float3 x 0 0) radius #:material (list-ref colors k)))
    (define (look shape x d) (shoot-material shape (make-Float3 x 0 0) (make-Float3 d 0 0) number))
    (define-values (a b) (values (ball 0 2 0) (ball -2 1 1)))
    (define plain (make-SolidDifference a b))
    (check-equal? (list (look plain -5 1) (look plain 5 -1)) '(1 0))
    (define painted (make-SolidDifference a b #:material (third colors)))
    (check-equal? (list (look painted -5 1) (look painted 5 -1)) '(2 2))
    (define c (ball 10 1 3))
    (define two (make-SolidUnion painted c))
    (check-equal? (list (look two -5 1) (look two 20 -1)) '(2 3))
    (define all (make-SolidUnion painted c #:material (first colors)))
    (check-equal? (list (look all -5 1) (look all 20 -1)) '(0 0))
    (define moved (make-Instance a (Transform-scale 1) #:material (fourth colors)))
    (check-equal? (list (look (make-SolidDifference moved b) -5 1)
                        (look (make-SolidDifference moved b) 5 -1)
                        (look (make-SolidDifference moved b #:material (third colors)) 5 -1))
                  '(1 3 2))
    (check-equal? (Shape-material plain) (first colors))
    (check-equal? (Shape-material painted) (third colors)))

  (test-case "asking a solid changes nothing but hit-t, and that only for a hit"
    (define solid (make-SolidDifference
                   (make-Instance (icosphere 1) (Transform-scale 2))
                   (make-Group (list (box '(-1.0 -1.0 -1.0) '(0.5 0.5 0.5))
                                     (make-Instance (icosphere 1) (Transform-translate 3 0 0))))))
    (define kernel (Shape-kernel solid))
    (define-values (r i) (values (make-flonum-registers) (make-fixnum-registers)))
    (for* ([kernel (list (ShapeKernel-nearest kernel) (ShapeKernel-occluded kernel))] [y '(0.1 7.0)])
      (for ([k (in-range surface-color)]) (flvector-set! r k (+ 0.25 k)))
      (for ([k (in-range hit-primitive (+ 1 accept-ties))]) (fxvector-set! i k (+ 100 k)))
      (for ([k 6] [x (list -5.0 y 0.1 1.0 0.0 0.0)]) (flvector-set! r (+ ray-origin k) x))
      (flvector-set! r ray-limit 1e300)
      (fxvector-set! i nest-level 0)
      (define-values (r-before i-before) (values (flvector-copy r) (fxvector-copy i)))
      (check-equal? (kernel r i) (= y 0.1))
      (for ([k (in-range surface-color)] #:unless (and (= y 0.1) (= k hit-t)))
        (check-equal? (flvector-ref r k) (flvector-ref r-before k) (format "flonum ~a" k)))
      (for ([k (in-range stack-base)])
        (check-equal? (fxvector-ref i k) (fxvector-ref i-before k) (format "fixnum ~a" k)))
      (check-equal? (fxvector-ref i stack-base) 0)))

  (test-case "in a group, before and behind other shapes, each is seen as alone"
    (define solid (make-SolidDifference (sphere '(0.0 0.0 0.0) 2.0) (sphere '(-2.0 0.0 0.0) 1.0)))
    (define mesh (make-Instance (icosphere 2) (Transform-translate 0 0 4)))
    (define both (make-Instance (make-Group (list mesh solid)) (Transform-identity)))
    (define uniform (make-random 57))
    (define z (make-Float3 0 0 1))
    (define through
      (for/sum ([_ (stressed 200)])
        (define p (scale 0.9 (random-in-ball uniform)))
        (define from-below (make-Float3 (first p) (second p) -9.0))
        (define from-above (make-Float3 (first p) (second p) 9.0))
        (define down (make-Float3 0 0 -1))
        (define (numbers shape o d) (take (shoot-surface shape o d) 12))
        (define-values (seen alone)
          (values (numbers both from-below z) (numbers solid from-below z)))
        (for ([x seen] [y alone]) (check-= x y 1e-14))
        (for ([x (numbers both from-above down)] [y (numbers mesh from-above down)])
          (check-= x y 1e-14))
        1))
    (check-equal? through (stressed 200)))

  (test-case "rays that leave a lens outwards do not meet it again"
    (define uniform (make-random 58))
    (for* ([size '(1e-3 1.0 1e3)] [offset '(0.0 1e3)])
      (define (at x) (map (lambda (c) (* size (+ c offset))) (list x 0.0 0.0)))
      (define lens (make-SolidIntersection (sphere (at -0.5) size) (sphere (at 0.5) size)))
      (define p (probe lens))
      (define found
        (count-spawned p (stressed 300) uniform
                       (lambda ()
                         (define target (add (at 0.0) (scale (* 0.4 size) (random-in-ball uniform))))
                         (define o (add target (scale (* 5.0 size) (random-unit uniform))))
                         (values o (subtract target o)))
                       #:sides '(1.0)))
      (check-equal? (counts-rays found) (stressed 300))
      (check-equal? (counts-again found) 0 (format "~a ~a" size offset))))

  (test-case "scaled by a power of two, every number is the same to the bit"
    (define uniform (make-random 59))
    (define size (expt 2.0 40))
    (define (numbers size o d)
      (define p (probe (make-SolidDifference (sphere '(0.0 0.0 0.0) size)
                                             (sphere (list (* 0.7 size) 0.0 0.0) (* 0.6 size)))))
      (define t (shoot p (scale size o) (scale size d)))
      (define s (and t (surface-at p)))
      (and t (list t (scale (/ 1.0 size) (Surface-point s)) (Surface-normal s)
                   (/ (Surface-error s) size))))
    (for ([_ 200])
      (define-values (o d) (random-ray uniform))
      (check-equal? (numbers 1.0 o d) (numbers size o d))))

  (test-case "disjoint shapes have an empty intersection; open shapes and too many are errors"
    (define-values (a b) (values (sphere '(0.0 0.0 0.0) 1.0) (sphere '(5.0 0.0 0.0) 1.0)))
    (define nothing (probe (make-SolidIntersection a b)))
    (check-false (shoot nothing '(-5.0 0.0 0.0) '(1.0 0.0 0.0)))
    (check-true (andmap <= (first (bounds nothing)) (second (bounds nothing))))
    (define plane (make-Plane (make-Float3 0 0 0) (make-Float3 0 1 0)))
    (check-exn #rx"^SolidUnion: expected a closed shape as a" (lambda () (make-SolidUnion plane a)))
    (check-exn #rx"^SolidIntersection: expected a closed shape as b"
               (lambda () (make-SolidIntersection a (make-Instance plane (Transform-identity)))))
    (check-exn #rx"^SolidDifference: expected a closed shape as a"
               (lambda () (make-SolidDifference (cylinder '(0.0 0.0 0.0) '(0.0 0.0 1.0) 1.0 #f) a)))
    (define (row n)
      (for/fold ([solid a]) ([k (- n 1)])
        (make-SolidUnion solid (sphere (list (* 1.5 k) 0.0 0.0) 1.0))))
    (define most (row 48))
    (check-events (probe most) '(-5.0 0.0 0.0) '(1.0 0.0 0.0) '(4.0 75.0) 1e-12)
    (check-exn #rx"^SolidUnion: expected solids of at most 48 shapes together as b, given 49"
               (lambda () (row 49)))
    (define (twice solid) (make-Instance solid (Transform-scale 1)))
    (check-events (probe (make-SolidDifference (twice most) b)) '(-5.0 0.0 0.0) '(1.0 0.0 0.0)
                  '(4.0 9.0 11.0 75.0) 1e-12)
    (check-exn #rx"^World: expected solids in solids of fewer shapes"
               (lambda () (Shape-kernel (make-SolidUnion (twice (row 40)) (row 40)))))))
