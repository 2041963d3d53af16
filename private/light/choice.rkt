#lang typed/racket/base
;; Which light to sample: each with a probability in proportion to a bound on what it contributes
;; at the surface in the scratch, among many lights down a binary tree of such bounds (Conty Estevez
;; and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", 2018).
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt"
         "../world/hierarchy.rkt" "light.rkt" "bound.rkt")

(provide LightChoice make-light-choice choose-light! put-light-probability! light-probability)

;; Up to so many lights are all weighed at every choice.
(define-syntax-rule (MOST-WEIGHED) 16)

;; entries: what the first step chooses among, packed bounds in entry-bounds: numbers of lights, and
;; -1 for the tree. Tree nodes have packed bounds in node-bounds; children: the first of a pair of
;; siblings, or -1 - light in a leaf; pairs are nodes 1 and 2, 3 and 4, ... places: for every light
;; its leaf, or -1 - its entry.
(struct LightChoice
  ([entries : FxVector] [entry-bounds : FlVector]
   [children : FxVector] [parents : FxVector] [node-bounds : FlVector]
   [places : FxVector]))

;; Where the probability of the choice is in the scratch: the end of the workspace, which no light
;; needs when it is sampled.
(define-syntax-rule (light-probability) (fx+ workspace 23))

;; --- building ---

;; make-light-choice : O(n log n) for n lights; they keep their numbers.
(: make-light-choice (-> (Vectorof LightKernel) LightChoice))
(define (make-light-choice lights)
  (define bounds : (Vectorof LightBound)
    (for/vector : (Vectorof LightBound) ([light (in-vector lights)]) (LightKernel-bound light)))
  (define all
    (for/list : (Listof Fixnum) ([k : Nonnegative-Fixnum (in-range (vector-length lights))]) k))
  (define many? (> (vector-length lights) (MOST-WEIGHED)))
  (: in-tree? (-> Fixnum Boolean))
  (define (in-tree? k) (and many? (LightBound-box (vector-ref bounds k)) #t))
  (define tree-lights (filter in-tree? all))
  (define tree? (pair? tree-lights))
  (define weighed (filter (lambda ([k : Fixnum]) (not (in-tree? k))) all))
  (define entries (if tree? (append weighed (list -1)) weighed))
  (define places (make-fxvector (vector-length lights) 0))
  (define node-count (if tree? (- (* 2 (length tree-lights)) 1) 0))
  (define node-bounds (make-flvector (* (BOUND-STRIDE) node-count) 0.0))
  (define children (make-fxvector node-count 0))
  (define parents (make-fxvector node-count 0))
  (define root (and tree? (build-tree! bounds tree-lights node-bounds children parents places)))
  (define entry-bounds (make-flvector (* (BOUND-STRIDE) (length entries)) 0.0))
  (for ([light (in-list entries)] [k : Nonnegative-Fixnum (in-range (length entries))])
    (define bound (if (fx< light 0) root (vector-ref bounds light)))
    (when bound (pack-bound! entry-bounds (fx* (BOUND-STRIDE) k) bound))
    (when (fx>= light 0) (fxvector-set! places light (fx- -1 k))))
  (LightChoice (fxvector-from entries) entry-bounds children parents node-bounds places))

(: fxvector-from (-> (Listof Fixnum) FxVector))
(define (fxvector-from numbers)
  (define v (make-fxvector (length numbers) 0))
  (for ([n (in-list numbers)] [k : Nonnegative-Fixnum (in-range (length numbers))])
    (fxvector-set! v k n))
  v)

;; Fills the nodes, the tree's shape being that of a hierarchy over the lights' boxes; returns the
;; bound of all.
(: build-tree! (-> (Vectorof LightBound) (Listof Fixnum) FlVector FxVector FxVector FxVector
                   LightBound))
(define (build-tree! bounds tree-lights node-bounds children parents places)
  (define numbers (fxvector-from tree-lights))
  (define count (fxvector-length numbers))
  (define boxes (make-flvector (* 6 count) 0.0))
  (for ([k : Nonnegative-Fixnum (in-range count)])
    (define box (LightBound-box (vector-ref bounds (fxvector-ref numbers k))))
    (when box
      (for ([axis : Nonnegative-Fixnum (in-range 6)])
        (flvector-set! boxes (fx+ (fx* 6 k) axis) (flvector-ref box axis)))))
  (define hierarchy (build-hierarchy boxes count))
  (define links (Hierarchy-links hierarchy))
  (define order (Hierarchy-order hierarchy))
  (define used : Fixnum 1)

  (: place-node! (-> Fixnum Fixnum LightBound))
  (define (place-node! node at)
    (define link (fxvector-ref links node))
    (define size (link-count link))
    (if (fx> size 0)
        (place-range! (link-payload link) (fx+ (link-payload link) size) at)
        (place-pair! at
                     (lambda ([first : Fixnum]) (place-node! (fx+ node 1) first))
                     (lambda ([second : Fixnum]) (place-node! (link-payload link) second)))))

  ;; The boxes at places first .. last-1 of the hierarchy's order.
  (: place-range! (-> Fixnum Fixnum Fixnum LightBound))
  (define (place-range! first last at)
    (cond
      [(fx= 1 (fx- last first))
       (define light (fxvector-ref numbers (fxvector-ref order first)))
       (define bound (vector-ref bounds light))
       (fxvector-set! children at (fx- -1 light))
       (fxvector-set! places light at)
       (pack-bound! node-bounds (fx* (BOUND-STRIDE) at) bound)
       bound]
      [else
       (define middle (fxrshift (fx+ first last) 1))
       (place-pair! at
                    (lambda ([left : Fixnum]) (place-range! first middle left))
                    (lambda ([right : Fixnum]) (place-range! middle last right)))]))

  (: place-pair! (-> Fixnum (-> Fixnum LightBound) (-> Fixnum LightBound) LightBound))
  (define (place-pair! at place-left! place-right!)
    (define pair used)
    (set! used (fx+ used 2))
    (fxvector-set! children at pair)
    (fxvector-set! parents pair at)
    (fxvector-set! parents (fx+ pair 1) at)
    (define left (place-left! pair))
    (define both (LightBound-union left (place-right! (fx+ pair 1))))
    (pack-bound! node-bounds (fx* (BOUND-STRIDE) at) both)
    both)

  (place-node! 0 0))

;; --- choosing ---

;; choose-light! : the number of a light, by the pair in sample-u and sample-v, for the surface in
;; the scratch; its probability goes to light-probability. transmits?: whether light from behind
;; the surface counts too. Nothing but rounding keeps the probabilities from adding up to 1. The
;; choice leaves sample-u changed.
(: choose-light! (-> LightChoice Boolean FlVector Fixnum))
(define (choose-light! choice transmits? r)
  (flvector-set! r (light-probability) 1.0)
  ;; every step takes what the last has left of one number, so it needs all its digits
  (flvector-set! r sample-u (fl+ (flvector-ref r sample-u)
                                 (fl* 2.3283064365386963e-10 (flvector-ref r sample-v))))
  (let* ([entries (LightChoice-entries choice)]
         [entry (if (fx= 1 (fxvector-length entries)) 0 (choose-entry! choice transmits? r))]
         [light (fxvector-ref entries entry)])
    (if (fx>= light 0) light (descend! choice transmits? r))))

;; Weights by which nothing can be chosen: all 0, or beyond the numbers.
(define-syntax-rule (useless? total) (not (and (fl> total 0.0) (fl< total +inf.0))))

;; The share of a in a + b, one half where that is no number.
(define-syntax-rule (share-of a b)
  (let* ([x a] [y b] [share (fl/ x (fl+ x y))])
    (if (fl<= share 1.0) share 0.5)))

(: choose-entry! (-> LightChoice Boolean FlVector Fixnum))
(define (choose-entry! choice transmits? r)
  (define bounds (LightChoice-entry-bounds choice))
  (define count (fxvector-length (LightChoice-entries choice)))
  (define-syntax-rule (put-choice! probability left)
    (begin (flvector-set! r (light-probability) probability)
           (flvector-set! r sample-u left)))
  (let-float3 ([x (Float3-in r surface-point)] [n (Float3-in r surface-normal)])
    (let add ([k : Fixnum 0] [total : Flonum 0.0])
      (cond
        [(fx< k count)
         (add (fx+ k 1) (fl+ total (importance bounds (fx* (BOUND-STRIDE) k) transmits? x n)))]
        [(useless? total)
         (let* ([place (fl* (flvector-ref r sample-u) (fx->fl count))]
                [whole (fl->fx place)]
                [entry (if (fx< whole count) whole (fx- count 1))])
           (put-choice! (fl/ 1.0 (fx->fl count)) (fl- place (fx->fl entry)))
           entry)]
        [else
         (let ([start (fl* total (flvector-ref r sample-u))])
           (let find ([k : Fixnum 0] [left : Flonum start]
                      [last : Fixnum 0] [last-weight : Flonum 0.0])
             (cond
               [(fx= k count)
                ;; rounding has left something behind all weights
                (put-choice! (fl/ last-weight total) 0.5)
                last]
               [else
                (let ([weight (importance bounds (fx* (BOUND-STRIDE) k) transmits? x n)])
                  (cond
                    [(fl< left weight)
                     (put-choice! (fl/ weight total) (fl/ left weight))
                     k]
                    [(fl> weight 0.0) (find (fx+ k 1) (fl- left weight) k weight)]
                    [else (find (fx+ k 1) left last last-weight)]))])))]))))

;; Down the tree from its root, by sample-u.
(: descend! (-> LightChoice Boolean FlVector Fixnum))
(define (descend! choice transmits? r)
  (define bounds (LightChoice-node-bounds choice))
  (define children (LightChoice-children choice))
  (let-float3 ([x (Float3-in r surface-point)] [n (Float3-in r surface-normal)])
    (let ([u0 (flvector-ref r sample-u)] [probability0 (flvector-ref r (light-probability))])
      (let down ([node : Fixnum 0] [u : Flonum u0] [probability : Flonum probability0])
        (let ([first (fxvector-ref children node)])
          (cond
            [(fx< first 0)
             (flvector-set! r (light-probability) probability)
             (fx- -1 first)]
            [else
             (let* ([at (fx* (BOUND-STRIDE) first)]
                    [left (share-of (importance bounds at transmits? x n)
                                    (importance bounds (fx+ at (BOUND-STRIDE)) transmits? x n))]
                    [right (fl- 1.0 left)])
               (if (or (fl< u left) (fl= right 0.0))
                   (down first (fl/ u left) (fl* probability left))
                   (down (fx+ first 1) (fl/ (fl- u left) right)
                         (fl* probability right))))]))))))

;; put-light-probability! : the probability with which choose-light! would choose that light for
;; the surface in the scratch, into light-probability.
(: put-light-probability! (-> LightChoice Fixnum Boolean FlVector Void))
(define (put-light-probability! choice light transmits? r)
  (define place (fxvector-ref (LightChoice-places choice) light))
  (define count (fxvector-length (LightChoice-entries choice)))
  (flvector-set! r (light-probability) 1.0)
  (when (fx>= place 0) (put-descent-probability! choice place transmits? r))
  (when (fx> count 1)
    (times-entry-probability! choice (if (fx>= place 0) (fx- count 1) (fx- -1 place))
                              transmits? r)))

(: put-descent-probability! (-> LightChoice Fixnum Boolean FlVector Void))
(define (put-descent-probability! choice leaf transmits? r)
  (define bounds (LightChoice-node-bounds choice))
  (define parents (LightChoice-parents choice))
  (let-float3 ([x (Float3-in r surface-point)] [n (Float3-in r surface-normal)])
    (let up ([node : Fixnum leaf] [probability : Flonum 1.0])
      (cond
        [(fx= node 0) (flvector-set! r (light-probability) probability)]
        [else
         (let* ([odd (fxand node 1)]
                [at (fx* (BOUND-STRIDE) (fx- (fx+ node odd) 1))]
                [left (share-of (importance bounds at transmits? x n)
                                (importance bounds (fx+ at (BOUND-STRIDE)) transmits? x n))])
           (up (fxvector-ref parents node)
               (fl* probability (if (fx= odd 1) left (fl- 1.0 left)))))]))))

(: times-entry-probability! (-> LightChoice Fixnum Boolean FlVector Void))
(define (times-entry-probability! choice entry transmits? r)
  (define bounds (LightChoice-entry-bounds choice))
  (define count (fxvector-length (LightChoice-entries choice)))
  (let-float3 ([x (Float3-in r surface-point)] [n (Float3-in r surface-normal)])
    (let add ([k : Fixnum 0] [total : Flonum 0.0] [own : Flonum 0.0])
      (cond
        [(fx= k count)
         (flvector-set! r (light-probability)
                        (fl* (flvector-ref r (light-probability))
                             (if (useless? total) (fl/ 1.0 (fx->fl count)) (fl/ own total))))]
        [else
         (let ([weight (importance bounds (fx* (BOUND-STRIDE) k) transmits? x n)])
           (add (fx+ k 1) (fl+ total weight) (if (fx= k entry) weight own)))]))))
