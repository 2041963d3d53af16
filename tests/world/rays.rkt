#lang typed/racket/base
;; Many rays at once through a world's kernels, for the tests. Rays are flvectors of seven numbers
;; each: origin, direction, limit.
(require racket/flonum racket/fixnum
         "../../private/base/registers.rkt" "../../private/shape/shape.rkt"
         "../../private/world/world.rkt" "../../private/world/scene.rkt"
         "../../private/world/trace.rkt")

(provide compare-with-scan nearest-of occluded-of bytes-per-ray node-boxes)

(: put-ray! (-> FlVector FxVector FlVector Fixnum Void))
(define (put-ray! r i rays k)
  (define at (fx* 7 k))
  (let loop ([c : Fixnum 0])
    (when (fx< c 3)
      (flvector-set! r (fx+ ray-origin c) (flvector-ref rays (fx+ at c)))
      (flvector-set! r (fx+ ray-direction c) (flvector-ref rays (fx+ at (fx+ 3 c))))
      (loop (fx+ c 1))))
  (flvector-set! r ray-limit (flvector-ref rays (fx+ at 6))))

(: ray-count (-> FlVector Fixnum))
(define (ray-count rays) (fxquotient (flvector-length rays) 7))

;; How many rays hit something; which differ from the linear scan in primitive or in a bit of t;
;; and for which the occlusion kernel says something else than that there is a hit.
(: compare-with-scan (-> World FlVector (List Integer (Listof Fixnum) (Listof Fixnum))))
(define (compare-with-scan world rays)
  (define scene (World-scene world))
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (define end (ray-count rays))
  (let loop : (List Integer (Listof Fixnum) (Listof Fixnum))
    ([k : Fixnum 0] [hits : Fixnum 0] [different : (Listof Fixnum) '()] [wrong : (Listof Fixnum) '()])
    (cond
      [(fx= k end) (list hits (reverse different) (reverse wrong))]
      [else
       (put-ray! r i rays k)
       (define found? (Scene-nearest! scene r i))
       (define-values (t primitive) (values (flvector-ref r hit-t) (fxvector-ref i hit-primitive)))
       (put-ray! r i rays k)
       (define scanned? (Scene-nearest-by-scan! scene r i))
       (define same?
         (and (eq? found? scanned?)
              (fx= primitive (fxvector-ref i hit-primitive))
              (or (not found?) (eqv? t (flvector-ref r hit-t)))))
       (put-ray! r i rays k)
       (define occluded? (Scene-occluded? scene r i))
       (loop (fx+ k 1)
             (if scanned? (fx+ hits 1) hits)
             (if same? different (cons k different))
             (if (eq? occluded? scanned?) wrong (cons k wrong)))])))

;; The primitive and t of one ray's nearest hit, or #f; origin, direction, limit as in rays.
(: nearest-of (-> World FlVector (U #f (Pairof Fixnum Flonum))))
(define (nearest-of world ray)
  (define-values (r i) (values (make-flonum-registers) (make-fixnum-registers)))
  (put-ray! r i ray 0)
  (and (Scene-nearest! (World-scene world) r i)
       (cons (fxvector-ref i hit-primitive) (flvector-ref r hit-t))))

;; Whether one ray is occluded, passing over a primitive (-1 for none).
(: occluded-of (-> World FlVector Fixnum Boolean))
(define (occluded-of world ray ignored)
  (define-values (r i) (values (make-flonum-registers) (make-fixnum-registers)))
  (put-ray! r i ray 0)
  (fxvector-set! i ignored-primitive ignored)
  (Scene-occluded? (World-scene world) r i))

;; Bytes allocated for each ray asked for its nearest hit and surface, and for its occlusion;
;; `allocated` tells the bytes allocated so far.
(: bytes-per-ray (-> World FlVector (-> Natural) (List Real Real)))
(define (bytes-per-ray world rays allocated)
  (define scene (World-scene world))
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (define end (ray-count rays))
  (: measure (-> (-> Void) Real))
  (define (measure trace!)
    (define (run)
      (let loop : Void ([k : Fixnum 0])
        (when (fx< k end)
          (put-ray! r i rays k)
          (trace!)
          (loop (fx+ k 1)))))
    (run)
    (let ([before (allocated)])
      (run)
      (/ (- (allocated) before) end)))
  (list (measure (lambda () (when (Scene-nearest! scene r i) (Scene-surface! scene r i))))
        (measure (lambda () (Scene-occluded? scene r i) (void)))))

;; The boxes of a world's hierarchy, lists of six numbers.
(: node-boxes (-> World (Listof (Listof Flonum))))
(define (node-boxes world)
  (define bounds (Scene-bounds (World-scene world)))
  (for/list : (Listof (Listof Flonum)) ([node (in-range (quotient (flvector-length bounds) 6))])
    (for/list : (Listof Flonum) ([k (in-range 6)]) (flvector-ref bounds (+ k (* 6 node))))))
