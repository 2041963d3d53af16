#lang typed/racket/base
;; Building a bounding volume hierarchy over boxes: binned surface-area heuristic (Wald 2007),
;; deterministic, O(n log n), leaves of at most four.
(require "../base/unsafe.rkt")

(provide (struct-out Hierarchy) build-hierarchy LEAF-SIZE link-count link-axis link-payload)

;; bounds: six flonums a node, low x y z then high x y z; a node's left child is the next node.
;; links: per node payload, split axis and count; a leaf has count > 0 and its first place in
;; `order` as payload, an inner node count 0 and its right child. order: the box at each place.
;; depth: nodes on the longest way down.
(struct Hierarchy ([bounds : FlVector] [links : FxVector] [order : FxVector] [depth : Fixnum]))

(define-syntax-rule (link-count link) (fxand link 7))
(define-syntax-rule (link-axis link) (fxand (fxrshift link 3) 3))
(define-syntax-rule (link-payload link) (fxrshift link 5))
(define-syntax-rule (make-link payload axis count)
  (fxior (fxlshift payload 5) (fxior (fxlshift axis 3) count)))

(define-syntax-rule (LEAF-SIZE) 4)
(define-syntax-rule (BINS) 16)
;; a node is cut into fewer bins than that when it has fewer boxes
(define-syntax-rule (bins-for size)
  (if (fx> size 12) (BINS) (if (fx> size 5) 8 4)))
;; below this depth splits halve the count, so no input makes a deep tree
(define-syntax-rule (BALANCED-DEPTH) 40)
;; the cost of visiting a node, in primitive intersections
(define-syntax-rule (VISIT-COST) 4.0)

(define-syntax-rule (lesser a b) (let ([x a] [y b]) (if (fl< x y) x y)))
(define-syntax-rule (greater a b) (let ([x a] [y b]) (if (fl> x y) x y)))

;; Twice the centre of a box along an axis.
(define-syntax-rule (centroid boxes box axis)
  (fl+ (flvector-ref boxes (fx+ (fx* 6 box) axis))
       (flvector-ref boxes (fx+ (fx* 6 box) (fx+ 3 axis)))))

;; Half the surface of the box that starts at place p.
(define-syntax-rule (half-area v p)
  (let ([x (fl- (flvector-ref v (fx+ p 3)) (flvector-ref v p))]
        [y (fl- (flvector-ref v (fx+ p 4)) (flvector-ref v (fx+ p 1)))]
        [z (fl- (flvector-ref v (fx+ p 5)) (flvector-ref v (fx+ p 2)))])
    (fl+ (fl* x y) (fl+ (fl* y z) (fl* z x)))))

(: set-empty! (-> FlVector Fixnum Void))
(define (set-empty! v p)
  (for ([k : Nonnegative-Fixnum (in-range 3)])
    (flvector-set! v (fx+ p k) +inf.0)
    (flvector-set! v (fx+ p (fx+ 3 k)) -inf.0)))

;; Grows the box at place p of `into` by the box at place q of `from`.
(: grow! (-> FlVector Fixnum FlVector Fixnum Void))
(define (grow! into p from q)
  (define-syntax-rule (low! k)
    (let ([value (flvector-ref from (fx+ q k))])
      (when (fl< value (flvector-ref into (fx+ p k))) (flvector-set! into (fx+ p k) value))))
  (define-syntax-rule (high! k)
    (let ([value (flvector-ref from (fx+ q k))])
      (when (fl> value (flvector-ref into (fx+ p k))) (flvector-set! into (fx+ p k) value))))
  (low! 0) (low! 1) (low! 2) (high! 3) (high! 4) (high! 5))

;; build-hierarchy : boxes as six flonums each (low x y z, high x y z), finite -> Hierarchy.
;; `count` may be 0: then the single node is an empty leaf no ray meets.
(: build-hierarchy (-> FlVector Nonnegative-Fixnum Hierarchy))
(define (build-hierarchy boxes count)
  (define bounds (make-flvector (* 6 (max 1 (- (* 2 count) 1))) 0.0))
  (define links (make-fxvector (max 1 (- (* 2 count) 1)) 0))
  (define order (make-fxvector count 0))
  (let number! ([k : Fixnum 0])
    (when (fx< k count)
      (fxvector-set! order k k)
      (number! (fx+ k 1))))
  ;; scratch: the centroids' bounds, bin counts and bin boxes of the three axes, right-hand sweep
  (define centroids (make-flvector 6 0.0))
  (define bin-counts (make-fxvector (fx* 3 (BINS)) 0))
  (define bin-boxes (make-flvector (fx* 18 (BINS)) 0.0))
  (define right-areas (make-flvector (BINS) 0.0))
  (define sweep (make-flvector 6 0.0))

  (: measure! (-> Fixnum Fixnum Fixnum Void))
  (define (measure! node first last)
    (set-empty! bounds (fx* 6 node))
    (set-empty! centroids 0)
    (let loop ([k first])
      (when (fx< k last)
        (let ([box (fxvector-ref order k)])
          (grow! bounds (fx* 6 node) boxes (fx* 6 box))
          (let axes ([axis : Fixnum 0])
            (when (fx< axis 3)
              (let ([c (centroid boxes box axis)])
                (when (fl< c (flvector-ref centroids axis)) (flvector-set! centroids axis c))
                (when (fl> c (flvector-ref centroids (fx+ 3 axis)))
                  (flvector-set! centroids (fx+ 3 axis) c)))
              (axes (fx+ axis 1)))))
        (loop (fx+ k 1)))))

  ;; Bins a unit of centroid, or 0 where the centroids agree or the extent is not usable.
  (: bin-scale (-> Fixnum Fixnum Flonum))
  (define (bin-scale axis bins)
    (define extent (fl- (flvector-ref centroids (fx+ 3 axis)) (flvector-ref centroids axis)))
    (define scale (fl/ (fx->fl bins) extent))
    (if (and (fl> extent 0.0) (fl< scale +inf.0) (fl> scale 0.0)) scale 0.0))

  (define-syntax-rule (bin-of box axis scale bins)
    (let ([bin (fl->fx (fl* (fl- (centroid boxes box axis) (flvector-ref centroids axis)) scale))])
      (if (fx< bin bins) bin (fx- bins 1))))

  (: fill-bins! (-> Fixnum Fixnum Fixnum Flonum Fixnum Void))
  (define (fill-bins! axis first last scale bins)
    (let clear ([bin : Fixnum 0])
      (when (fx< bin bins)
        (fxvector-set! bin-counts (fx+ (fx* axis (BINS)) bin) 0)
        (set-empty! bin-boxes (fx* 6 (fx+ (fx* axis (BINS)) bin)))
        (clear (fx+ bin 1))))
    (let loop ([k first])
      (when (fx< k last)
        (let* ([box (fxvector-ref order k)]
               [bin (fx+ (fx* axis (BINS)) (bin-of box axis scale bins))])
          (fxvector-set! bin-counts bin (fx+ 1 (fxvector-ref bin-counts bin)))
          (grow! bin-boxes (fx* 6 bin) boxes (fx* 6 box)))
        (loop (fx+ k 1)))))

  ;; The cheapest split of one axis as (place after which to split, area-weighted count).
  (: cheapest-split (-> Fixnum Fixnum (Values Fixnum Flonum)))
  (define (cheapest-split axis bins)
    (define start (fx* axis (BINS)))
    (set-empty! sweep 0)
    (let right ([bin (fx- bins 1)] [count : Fixnum 0])
      (when (fx> bin 0)
        (grow! sweep 0 bin-boxes (fx* 6 (fx+ start bin)))
        (let ([count (fx+ count (fxvector-ref bin-counts (fx+ start bin)))])
          (flvector-set! right-areas bin
                         (if (fx= count 0) +inf.0 (fl* (fx->fl count) (half-area sweep 0))))
          (right (fx- bin 1) count))))
    (set-empty! sweep 0)
    (let left ([bin : Fixnum 0] [count : Fixnum 0] [best : Fixnum -1] [best-cost : Flonum +inf.0])
      (if (fx= bin (fx- bins 1))
          (values best best-cost)
          (begin
            (grow! sweep 0 bin-boxes (fx* 6 (fx+ start bin)))
            (let* ([count (fx+ count (fxvector-ref bin-counts (fx+ start bin)))]
                   [cost (if (fx= count 0)
                             +inf.0
                             (fl+ (fl* (fx->fl count) (half-area sweep 0))
                                  (flvector-ref right-areas (fx+ bin 1))))])
              (if (fl< cost best-cost)
                  (left (fx+ bin 1) count bin cost)
                  (left (fx+ bin 1) count best best-cost)))))))

  ;; Brings boxes of bins up to `split` to the front; the place of the first other one.
  (: partition! (-> Fixnum Fixnum Fixnum Flonum Fixnum Fixnum Fixnum))
  (define (partition! axis first last scale bins split)
    (let loop ([low first] [high (fx- last 1)])
      (if (fx> low high)
          low
          (let ([box (fxvector-ref order low)])
            (cond
              [(fx<= (bin-of box axis scale bins) split) (loop (fx+ low 1) high)]
              [else
               (fxvector-set! order low (fxvector-ref order high))
               (fxvector-set! order high box)
               (loop low (fx- high 1))])))))

  (: best-split (-> Fixnum Fixnum (Values Fixnum Fixnum Flonum)))
  (define (best-split first last)
    (define bins (bins-for (fx- last first)))
    (for/fold ([best-axis : Fixnum -1] [best-bin : Fixnum -1] [best-cost : Flonum +inf.0])
              ([axis : Nonnegative-Fixnum (in-range 3)])
      (define scale (bin-scale axis bins))
      (cond
        [(fl= scale 0.0) (values best-axis best-bin best-cost)]
        [else
         (fill-bins! axis first last scale bins)
         (define-values (bin cost) (cheapest-split axis bins))
         (if (fl< cost best-cost) (values axis bin cost) (values best-axis best-bin best-cost))])))

  ;; Builds the node over places first .. last-1; the number of nodes used and the depth.
  (: build! (-> Fixnum Fixnum Fixnum Fixnum (Values Fixnum Fixnum)))
  (define (build! node first last depth)
    (define size (fx- last first))
    (measure! node first last)
    (define (leaf!)
      (fxvector-set! links node (make-link first 0 size))
      (values (fx+ node 1) depth))
    (define (split! [axis : Fixnum] [middle : Fixnum])
      (define-values (after-left left-depth) (build! (fx+ node 1) first middle (fx+ depth 1)))
      (fxvector-set! links node (make-link after-left axis 0))
      (define-values (after-right right-depth) (build! after-left middle last (fx+ depth 1)))
      (values after-right (if (fx> left-depth right-depth) left-depth right-depth)))
    (cond
      [(fx<= size 1) (leaf!)]
      [else
       (define-values (axis bin cost)
         (if (fx< depth (BALANCED-DEPTH)) (best-split first last) (values -1 -1 +inf.0)))
       (define area (half-area bounds (fx* 6 node)))
       (define leaf-cost (fl* (fx->fl size) area))
       (cond
         [(and (fx<= size (LEAF-SIZE)) (not (fl< (fl+ cost (fl* (VISIT-COST) area)) leaf-cost)))
          (leaf!)]
         [(and (fx>= axis 0) (fl< cost +inf.0))
          (let ([bins (bins-for size)])
            (split! axis (partition! axis first last (bin-scale axis bins) bins bin)))]
         ;; all centroids agree, or areas are beyond the numbers: halve by place
         [else (split! 0 (fxrshift (fx+ first last) 1))])]))

  (define-values (used depth) (if (eqv? count 0) (values 1 1) (build! 0 0 count 1)))
  (when (eqv? count 0) (set-empty! bounds 0))
  (Hierarchy (flvector-copy bounds 0 (fx* 6 used)) (fxvector-copy links 0 used) order depth))
