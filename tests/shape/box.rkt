#lang racket/base
;; Boxes: H07, H08, edges and corners from both sides, S08, rays that leave the surface.

(module+ test
  (require racket/list racket/math rackunit
           "../../private/shape/box.rkt"
           "../../private/integrate/query.rkt" "../../private/world/ray.rkt"
           "probe.rkt" "axial-checks.rkt" "spawned-rays.rkt")

  (define roundoff (expt 2.0 -53))
  (define (stressed count) (if stress? (* 100 count) count))
  (define (box low high) (make-Box (float3 low) (float3 high)))
  (define unit-box (box '(-1.0 -1.0 -1.0) '(1.0 1.0 1.0)))

  (test-case "H07, H08: entering and leaving, t to 1e-12"
    (define (found o d) (Shape-intersect unit-box (make-Ray (float3 o) (float3 d))))
    (define near (found '(-3.0 0.5 0.25) '(1.0 -0.2 0.1)))
    (check-= (Intersection-t near) 2.0 2e-12)
    (check-equal? (float3->list (Intersection-normal near)) '(-1.0 0.0 0.0))
    (check-equal? (car (float3->list (Intersection-point near))) -1.0)
    (define far (found '(0.0 -0.1 0.55) '(1.0 -0.2 0.1)))
    (check-= (Intersection-t far) 1.0 1e-12)
    (define inside (found '(0.2 -0.1 0.0) '(1.0 2.0 3.0)))
    (check-= (Intersection-t inside) 0.3333333333333333 1e-12)
    (check-equal? (float3->list (Intersection-normal inside)) '(0.0 0.0 1.0))
    (check-equal? (third (float3->list (Intersection-point inside))) 1.0))

  (test-case "the same t as in rational arithmetic to 2 ulp"
    (define uniform (make-random 41))
    (define (exact-t low high o d)
      (define slabs
        (for/list ([l (exact low)] [h (exact high)] [o (exact o)] [d (exact d)])
          (sort (list (/ (- l o) d) (/ (- h o) d)) <)))
      (define-values (near far) (values (apply max (map first slabs)) (apply min (map second slabs))))
      (and (< near far) (> far 0) (if (> near 0) near far)))
    (for ([k (stressed 1500)])
      (define low (random-unit uniform))
      (define high (add low (list (uniform 0.1 2.0) (uniform 0.1 2.0) (uniform 0.1 2.0))))
      (define o (scale (uniform 0.0 4.0) (random-unit uniform)))
      (define d (subtract (scale 0.5 (add low (add high (random-unit uniform)))) o))
      (define p (probe (box low high)))
      (define expected (exact-t low high o d))
      (define t (shoot p o d))
      (check-equal? (and t #t) (and expected #t))
      (when t (check-true (<= (abs (- t expected)) (* 4.0 roundoff t))))))

  (define axes '(0 1 2))
  (define (on-axis axis x) (for/list ([k axes]) (if (= k axis) x 0.0)))

  (test-case "every face from outside and inside: t, point, normal, uv"
    (define p (probe (box '(1.0 2.0 3.0) '(2.0 4.0 6.0))))
    (define center '(1.5 3.0 4.5))
    (for* ([axis axes] [side '(1.0 -1.0)])
      (define half (list-ref '(0.5 1.0 1.5) axis))
      (define out (on-axis axis side))
      (define face (add center (scale half out)))
      (for ([o (list (add face (scale 2.0 out)) center)] [d (list (scale -1.0 out) out)]
            [t (list 2.0 half)])
        (check-equal? (shoot p o d) t)
        (define s (surface-at p))
        (check-equal? (Surface-point s) face)
        (check-equal? (Surface-normal s) out)
        (check-equal? (list (Surface-u s) (Surface-v s)) '(0.5 0.5)))
      (check-false (shoot p (add face (scale 2.0 out)) out)))
    ;; seen from outside u runs to the right
    (define (uv o d) (shoot p o d) (list (Surface-u (surface-at p)) (Surface-v (surface-at p))))
    (check-equal? (uv '(1.25 3.5 9.0) '(0.0 0.0 -1.0)) '(0.25 0.75))
    (check-equal? (uv '(1.25 3.5 0.0) '(0.0 0.0 1.0)) '(0.75 0.75))
    (check-equal? (uv '(9.0 3.5 3.75) '(-1.0 0.0 0.0)) '(0.75 0.75))
    (check-equal? (uv '(0.0 3.5 3.75) '(1.0 0.0 0.0)) '(0.25 0.75))
    (check-equal? (uv '(1.25 9.0 3.75) '(0.0 -1.0 0.0)) '(0.25 0.75))
    (check-equal? (uv '(1.25 0.0 3.75) '(0.0 1.0 0.0)) '(0.25 0.25)))

  (define coordinates '(-1.0 0.25 1.0))
  (define zeros '(0.0 -0.0))

  (test-case "S08: axis-parallel rays with either zero that start on, pass along or hit the box"
    (define p (probe unit-box))
    (for* ([axis axes] [side '(1.0 -1.0)] [a coordinates] [b coordinates]
           [zero-a zeros] [zero-b zeros]
           [start '(-3.0 -1.0 0.25 1.0 3.0)])
      (define-values (j k) (apply values (remove axis axes)))
      (define (place x y z) (for/list ([n axes]) (cond [(= n axis) x] [(= n j) y] [else z])))
      (define t (shoot p (place start a b) (place side zero-a zero-b)))
      (define to-far (- 1.0 (* start side)))
      (define to-near (- -1.0 (* start side)))
      (check-equal? t (cond [(> to-near 0.0) to-near] [(> to-far 0.0) to-far] [else #f])))
    ;; beside the box by one ulp: never
    (for* ([axis axes] [side '(1.0 -1.0)] [zero zeros])
      (define-values (j k) (apply values (remove axis axes)))
      (define (place x y z) (for/list ([n axes]) (cond [(= n axis) x] [(= n j) y] [else z])))
      (for ([start '(-3.0 0.0 3.0)])
        (check-false (shoot p (place start 1.0000000000000002 0.0) (place side zero zero)))
        (check-false (shoot p (place start 0.0 -1.0000000000000002) (place side zero zero))))))

  (test-case "a ray from a face, edge or corner hits where it goes in and misses where it goes out"
    (define uniform (make-random 42))
    (define p (probe unit-box))
    (for* ([x coordinates] [y coordinates] [z coordinates] [k 20])
      (define o (list x y z))
      (define d (random-unit uniform))
      (define goes-out? (for/or ([x o] [d d]) (and (= 1.0 (abs x)) (> (* x d) 0.0))))
      (check-equal? (and (shoot p o d) #t) (not goes-out?))))

  ;; Targets exactly on an edge or at a corner of the box.
  (define (edge-target low high uniform)
    (define free (exact-floor (uniform 0.0 4.0)))
    (for/list ([l low] [h high] [axis 3])
      (cond [(= axis free) (max l (min h (+ l (* (uniform) (- h l)))))]
            [(< (uniform) 0.5) l]
            [else h])))

  (test-case "10^5 rays aimed at edges and corners from inside and outside, 0 leaks"
    (define uniform (make-random 43))
    (for* ([offset '(0.0 1e3 1e6)] [unit? '(#f #t)] [from '(0.9 3.0 100.0)])
      (define low (placed (list (scale 0.5 (random-unit uniform))) 1.0 (- offset 2.0)))
      (define high (placed (list (scale 0.5 (random-unit uniform))) 1.0 (+ offset 2.0)))
      (define p (probe (box (car low) (car high))))
      (define leaks
        (for/sum ([k (stressed 6000)])
          (define target (edge-target (car low) (car high) uniform))
          (define o (map (lambda (x) (+ offset x)) (scale (* 1.2 from) (random-unit uniform))))
          (define aimed (subtract target o))
          (define d (if unit? (unit aimed) aimed))
          (define on-it?
            (and (shoot p o d)
                 (for/and ([l (car low)] [x (Surface-point (surface-at p))] [h (car high)])
                   (<= l x h))))
          (if on-it? 0 1)))
      (check-equal? leaks 0 (format "~a ~a ~a" offset unit? from))))

  (define (random-aim low high uniform reach)
    (lambda ()
      (define target
        (for/list ([l low] [h high]) (+ l (* (uniform) (- h l)))))
      (define direction (random-unit uniform))
      (values (subtract target (scale reach direction)) direction)))

  (test-case "S04: no ray from outside meets the box again; from inside each finds another face"
    (define uniform (make-random 44))
    (for* ([size '(1e-9 1e-3 1.0 1e3 1e9)] [offset '(0.0 1.0 1e4 1e8)])
      (define-values (low high)
        (apply values (placed '((-0.7 -0.4 -0.9) (0.6 0.8 0.5)) size offset)))
      (define p (probe (box low high)))
      (define outside
        (count-spawned p (stressed 300) uniform (random-aim low high uniform (* 5.0 size))
                       #:sides '(1.0)))
      (check-equal? (counts-rays outside) (stressed 300))
      (check-equal? (counts-again outside) 0 (format "~a ~a" size offset))
      (define (same-face? left met) (equal? (Surface-normal left) (Surface-normal met)))
      (define inside
        (count-spawned p (stressed 300) uniform (random-aim low high uniform (* 5.0 size))
                       #:sides '(-1.0) #:again? same-face? #:beyond (lambda (side) p)))
      (check-equal? (counts-rays inside) (stressed 300))
      (check-equal? (counts-again inside) 0 (format "~a ~a" size offset))
      (check-equal? (counts-leaked inside) 0 (format "~a ~a" size offset))))

  (test-case "scaled by a power of two, every number is the same to the bit"
    (define uniform (make-random 45))
    (for ([k 200])
      (define-values (o d)
        (let ([o (scale 3.0 (random-unit uniform))])
          (values o (subtract (random-unit uniform) o))))
      (define (numbers size)
        (define p (probe (box (list (- size) (* -0.5 size) (- size)) (list size size (* 0.7 size)))))
        (define t (shoot p (scale size o) (scale size d)))
        (define s (and t (surface-at p)))
        (and t (list t (scale (/ 1.0 size) (Surface-point s)) (Surface-normal s)
                     (Surface-u s) (Surface-v s) (/ (Surface-error s) size))))
      (check-equal? (numbers 1.0) (numbers (expt 2.0 40)))))

  (test-case "the bounds are the corners; a flat or inverted box is an error that names the argument"
    (check-equal? (bounds (probe unit-box)) '((-1.0 -1.0 -1.0) (1.0 1.0 1.0)))
    (for ([high '((1.0 1.0 0.0) (1.0 -1.0 1.0) (0.0 1.0 1.0))])
      (check-exn #rx"Box: expected three coordinates greater than those of low as high"
                 (lambda () (box '(0.0 0.0 0.0) high))))
    (check-exn #rx"Box: expected three finite coordinates as low"
               (lambda () (box '(0.0 -inf.0 0.0) '(1.0 1.0 1.0))))))
