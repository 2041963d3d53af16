#lang typed/racket/base
;; Functions on the unit square whose integrals are known, and how far the means over a sampler's
;; points are from them: what ambient occlusion, soft shadows and edges of pixels ask of a sampler.
(require racket/flonum racket/fixnum racket/math
         "../../private/base/registers.rkt" "../../private/sample/sampler.rkt")

(provide INTEGRANDS relative-errors)

;; Each with its integral.
;;   quarter-disk .. bilinear: Christensen, Kensler and Kilpatrick, "Progressive Multi-Jittered Sample
;;   Sequences", 2018. ambient-sphere: what a unit sphere that touches the floor one unit away hides,
;;   directions by cosine or uniform. ceiling: the article's weight min(1, t) below a ceiling at 1/2.
;;   half-shadow: a disk light of radius 1/2 at height 4, half of it behind a straight edge.
;;   disk-light: one of radius 1 at height 2. Disks by the concentric map.
(define INTEGRANDS : (Listof Symbol)
  '(quarter-disk half-plane gauss bilinear ambient-sphere-cosine ambient-sphere-uniform
    ceiling-uniform ceiling-cosine half-shadow disk-light))
(define-syntax-rule (COUNT) 10)

(define-syntax-rule (indicator condition) (if condition 1.0 0.0))

;; Whether a ray from the origin in a direction meets the unit sphere around (1, 0, 1); z is up.
(define-syntax-rule (free? x y z)
  (let ([along (fl+ x z)])
    (indicator (not (and (fl> along 0.0) (fl>= (fl* along along) 1.0))))))

(define-syntax-rule (polar-direction z0 v body)
  (let* ([z z0]
         [s (flsqrt (flmax 0.0 (fl- 1.0 (fl* z z))))]
         [angle (fl* (fl* 2.0 pi) v)])
    (body (fl* s (flcos angle)) (fl* s (flsin angle)) z)))

;; x of the concentric map and the squared radius (Shirley and Chiu 1997).
(define-syntax-rule (on-disk u v (x squared-radius) body)
  (let* ([a (fl- (fl* 2.0 u) 1.0)]
         [b (fl- (fl* 2.0 v) 1.0)]
         [wide? (fl> (flabs a) (flabs b))]
         [radius (if wide? a b)]
         [angle (cond
                  [wide? (fl* (fl/ pi 4.0) (fl/ b a))]
                  [(fl= b 0.0) 0.0]
                  [else (fl- (fl/ pi 2.0) (fl* (fl/ pi 4.0) (fl/ a b)))])]
         [x (fl* radius (flcos angle))]
         [squared-radius (fl* radius radius)])
    body))

;; What a part of a disk light sends to a floor below it: the fourth power of cosines.
(define-syntax-rule (square x) (let ([y x]) (fl* y y)))
(define-syntax-rule (falloff ratio squared-radius)
  (square (fl/ 1.0 (fl+ 1.0 (fl* (fl* ratio ratio) squared-radius)))))

(: add-values! (-> FlVector Flonum Flonum Void))
(define (add-values! sums u v)
  (define-syntax-rule (add! k value)
    (flvector-set! sums k (fl+ (flvector-ref sums k) value)))
  (define rr (fl+ (fl* u u) (fl* v v)))
  (add! 0 (indicator (fl< rr (fl/ 2.0 pi))))
  (add! 1 (indicator (fl< v u)))
  (add! 2 (flexp (fl- 0.0 rr)))
  (add! 3 (fl* u v))
  (add! 4 (polar-direction (flsqrt (fl- 1.0 u)) v free?))
  (add! 5 (polar-direction u v free?))
  (add! 6 (flmin 1.0 (fl/ 0.5 (flmax 1e-300 u))))
  (add! 7 (flmin 1.0 (fl/ 0.5 (flsqrt (fl- 1.0 u)))))
  (add! 8 (on-disk u v (x squared-radius)
            (fl* (indicator (fl> x 0.0)) (falloff 0.125 squared-radius))))
  (add! 9 (on-disk u v (x squared-radius) (falloff 0.5 squared-radius))))

;; The integrals, in that order.
(define EXACT : FlVector
  (flvector 0.5 0.5
            ;; (sqrt(pi) erf(1) / 2)^2
            (square 0.7468241328124271) 0.25
            ;; 1 - sin(45 degrees) / 2 and cos(45 degrees)
            (fl- 1.0 (fl* 0.5 (flsqrt 0.5))) (flsqrt 0.5)
            ;; k (1 - ln k) and 2 k - k^2 at k = 1/2
            (fl* 0.5 (fl+ 1.0 (fllog 2.0))) 0.75
            ;; the mean of (1 + c s)^-2 for s in [0, 1] is 1 / (1 + c)
            (fl/ 0.5 (fl+ 1.0 (fl/ 1.0 64.0))) 0.8))

;; relative-errors : the RMSE of means over the first n points of a sampler by name, relative to each
;; integral, in the order of INTEGRANDS. Its grids have n points; `repeats` seeds, a mean for each.
(: relative-errors (-> Symbol Positive-Fixnum Positive-Fixnum (Listof Flonum)))
(define (relative-errors name n repeats)
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (define squares (make-flvector (COUNT)))
  (define sums (make-flvector (COUNT)))
  (Sampler-choose! i (sampler-number name) n)
  (for ([seed (in-range repeats)])
    (for ([k (in-range (COUNT))]) (flvector-set! sums k 0.0))
    (Sampler-start! i 0 (assert seed fixnum?) 0)
    (for ([index (in-range n)])
      (sample-pair! r i 0 (assert index fixnum?))
      (add-values! sums (flvector-ref r sample-u) (flvector-ref r sample-v)))
    (for ([k (in-range (COUNT))])
      (flvector-set! squares k
                     (fl+ (flvector-ref squares k)
                          (square (fl- (fl/ (flvector-ref sums k) (->fl n))
                                       (flvector-ref EXACT k)))))))
  (for/list : (Listof Flonum) ([k (in-range (COUNT))])
    (fl/ (flsqrt (fl/ (flvector-ref squares k) (->fl repeats))) (flvector-ref EXACT k))))
