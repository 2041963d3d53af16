#lang typed/racket/base
;; Walking a hierarchy with a ray: the one loop behind nearest hits, occlusion and meshes.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "hierarchy.rkt")

(provide traverse)

;; (traverse (bounds links r i) (o d) limit #:leaf (first end next again) leaf #:done done)
;; visits the leaves whose box the ray in the scratch enters before `limit`, near side first. `leaf`
;; sees places first .. end-1 and goes on with (next limit*), or, when it called out of line and
;; so may hold no flonums, with (again), which takes everything back from the scratch; whatever
;; else it returns is the result. `top` is the first place of the stack a kernel it calls may use. `done` is the result when no box is left. The boxes are tested
;; by pairs of slabs, near and far chosen by the direction's signs: with a zero component the
;; products are infinite, or NaN on a face, and every comparison with NaN keeps the box.
;; The far side is widened by more than the rounding of its product (Ize, "Robust BVH Ray
;; Traversal", JCGT 2013).
(define-syntax-rule
  (traverse (bounds links r i) (o d) limit
            #:leaf (first end top next again) leaf
            #:done done)
  (let ([base (fxvector-ref i stack-base)])
    (put-inverse! r)
    (let again-at ([node : Fixnum 0] [top : Fixnum base])
      (let-float3 ([o (Float3-in r ray-origin)]
                   [d (Float3-in r ray-direction)])
        (let* ([inverse-x (flvector-ref r ray-inverse)]
               [inverse-y (flvector-ref r (fx+ ray-inverse 1))]
               [inverse-z (flvector-ref r (fx+ ray-inverse 2))]
               [wide-x (fl* inverse-x (FAR-WIDENING))]
               [wide-y (fl* inverse-y (FAR-WIDENING))]
               [wide-z (fl* inverse-z (FAR-WIDENING))]
               [near-x (if (fl< inverse-x 0.0) 3 0)]
               [near-y (if (fl< inverse-y 0.0) 4 1)]
               [near-z (if (fl< inverse-z 0.0) 5 2)]
               [far-x (fx- 3 near-x)]
               [far-y (fx- 5 near-y)]
               [far-z (fx- 7 near-z)]
               [start-limit (flvector-ref r ray-limit)])
          (let walk ([node : Fixnum node] [top : Fixnum top] [limit : Flonum start-limit])
            (define-syntax-rule (pop limit*)
              (if (fx= top base)
                  done
                  (walk (fxvector-ref i (fx+ stack (fx- top 1))) (fx- top 1) limit*)))
            (if (fx< node 0)
                (pop limit)
                (let* ([box (fx* 6 node)]
                       [x-near (fl* (fl- (flvector-ref bounds (fx+ box near-x)) (Float3-x o)) inverse-x)]
                       [x-far (fl* (fl- (flvector-ref bounds (fx+ box far-x)) (Float3-x o)) wide-x)]
                       [y-near (fl* (fl- (flvector-ref bounds (fx+ box near-y)) (Float3-y o)) inverse-y)]
                       [y-far (fl* (fl- (flvector-ref bounds (fx+ box far-y)) (Float3-y o)) wide-y)])
                  (if (or (fl> x-near y-far) (fl> y-near x-far)
                          (fl> x-near limit) (fl> y-near limit)
                          (fl< x-far 0.0) (fl< y-far 0.0))
                      (pop limit)
                      (let* ([z-near (fl* (fl- (flvector-ref bounds (fx+ box near-z)) (Float3-z o))
                                          inverse-z)]
                             [z-far (fl* (fl- (flvector-ref bounds (fx+ box far-z)) (Float3-z o))
                                         wide-z)])
                        (if (or (fl> x-near z-far) (fl> z-near x-far)
                                (fl> y-near z-far) (fl> z-near y-far)
                                (fl> z-near limit) (fl< z-far 0.0))
                            (pop limit)
                            (let* ([link (fxvector-ref links node)]
                                   [count (link-count link)])
                              (if (fx= count 0)
                                  (let ([right (link-payload link)]
                                        [axis (link-axis link)])
                                    (if (if (fx= axis 0) (fx= near-x 0)
                                            (if (fx= axis 1) (fx= near-y 1) (fx= near-z 2)))
                                        (begin
                                          (fxvector-set! i (fx+ stack top) right)
                                          (walk (fx+ node 1) (fx+ top 1) limit))
                                        (begin
                                          (fxvector-set! i (fx+ stack top) (fx+ node 1))
                                          (walk right (fx+ top 1) limit))))
                                  (let* ([first (link-payload link)]
                                         [end (fx+ first count)])
                                    (define-syntax-rule (next limit*) (pop limit*))
                                    (define-syntax-rule (again)
                                      (begin
                                        (fxvector-set! i stack-base base)
                                        (again-at -1 top)))
                                    leaf))))))))))))))

(define-syntax-rule (put-inverse! r)
  (let-float3 ([d (Float3-in r ray-direction)])
    (Float3-put! r ray-inverse
                 (Float3 (fl/ 1.0 (Float3-x d)) (fl/ 1.0 (Float3-y d)) (fl/ 1.0 (Float3-z d))))))

;; 1 + 2 gamma(3)
(define-syntax-rule (FAR-WIDENING) 1.0000000000000007)
