#lang typed/racket/base
;; Shapes that move while the shutter is open: every point along a straight line, at even speed.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/matrix.rkt"
         "../base/transform.rkt" "../base/public.rkt" "../base/check.rkt"
         "../material/material.rkt" "kernel.rkt" "shape.rkt" "composite.rkt" "instance.rkt")

(provide (struct-out Moving) make-Moving Moving-kernel)

;; shape: what moves, made in a space of its own. from, to: from there to where it is when the
;; shutter opens (ray time 0) and when it closes (1).
(struct Moving Composite ([shape : Shape] [from : Transform] [to : Transform]) #:transparent)

;; Moving : the shape on its way from one place to another. If it shines, scattered rays alone find
;; it. Raises where composites nest too deep and where the shape would be flat on its way, as one
;; that turns by half a circle.
(: make-Moving (-> Shape Transform Transform Moving))
(define (make-Moving shape from to)
  (unless (never-flat? from to)
    (raise-expected 'Moving "to" "a transform near enough to `from` for no flat shape between" to))
  (Moving (check-nesting 'Moving (list shape)) shape from to))

(define-constructor Moving make-Moving (shape from to) #:struct (_ shape from to))

;; Whether the determinant on the way, a cubic in time, has no root: by its Bernstein coefficients,
;; halving the time where their signs differ.
(: never-flat? (-> Transform Transform Boolean))
(define (never-flat? from to)
  (: determinant-at (-> Exact-Rational Exact-Rational))
  (define (determinant-at time)
    (define (entry [place : Fixnum])
      (+ (* (- 1 time) (inexact->exact (flvector-ref (Transform-matrix from) place)))
         (* time (inexact->exact (flvector-ref (Transform-matrix to) place)))))
    (define-values (a b c) (values (entry 0) (entry 1) (entry 2)))
    (define-values (d e f) (values (entry 4) (entry 5) (entry 6)))
    (define-values (g h k) (values (entry 8) (entry 9) (entry 10)))
    (+ (* a (- (* e k) (* f h))) (* b (- (* f g) (* d k))) (* c (- (* d h) (* e g)))))
  (: one-sign? (-> Exact-Rational Exact-Rational Exact-Rational Exact-Rational Integer Boolean))
  (define (one-sign? p q r s depth)
    (cond
      [(or (and (> p 0) (> q 0) (> r 0) (> s 0)) (and (< p 0) (< q 0) (< r 0) (< s 0))) #t]
      [(or (= depth 0) (<= (* p s) 0)) #f]
      [else
       (define-values (pq qr rs) (values (/ (+ p q) 2) (/ (+ q r) 2) (/ (+ r s) 2)))
       (define-values (pqr qrs) (values (/ (+ pq qr) 2) (/ (+ qr rs) 2)))
       (define middle (/ (+ pqr qrs) 2))
       (and (one-sign? p pq pqr middle (- depth 1)) (one-sign? middle qrs rs s (- depth 1)))]))
  (define-values (p u v s)
    (values (determinant-at 0) (determinant-at 1/3) (determinant-at 2/3) (determinant-at 1)))
  ;; the cubic through four values as a Bernstein polynomial
  (one-sign? p
             (/ (+ (* -5 p) (* 18 u) (* -9 v) (* 2 s)) 6)
             (/ (+ (* 2 p) (* -9 u) (* 18 v) (* -5 s)) 6)
             s 24))

;; Places in the workspace, only between two calls: the matrix at the ray's time, its inverse.
(define-syntax-rule (MATRIX) workspace)
(define-syntax-rule (INVERSE) (fx+ workspace 12))

;; Writes the matrix at the ray's time and its inverse (by cofactors) into the workspace.
(: put-matrices! (-> FlVector FlVector FlVector Void))
(define (put-matrices! from to r)
  (let* ([time (flvector-ref r ray-time)] [rest (fl- 1.0 time)])
    (let loop ([k : Fixnum 0])
      (when (fx< k 12)
        (flvector-set! r (fx+ (MATRIX) k)
                       (fl+ (fl* rest (flvector-ref from k)) (fl* time (flvector-ref to k))))
        (loop (fx+ k 1)))))
  (let-syntax ([entry (syntax-rules () [(_ k) (flvector-ref r (fx+ (MATRIX) k))])])
    (let-float3 ([a (Float3 (entry 0) (entry 4) (entry 8))]
                 [b (Float3 (entry 1) (entry 5) (entry 9))]
                 [c (Float3 (entry 2) (entry 6) (entry 10))]
                 [bc (Float3-cross b c)]
                 [ca (Float3-cross c a)]
                 [ab (Float3-cross a b)])
      (let ([inverse-determinant (fl/ 1.0 (Float3-dot a bc))])
        (Float3-put! r (INVERSE) (Float3-scale-by-scalar bc inverse-determinant))
        (Float3-put! r (fx+ (INVERSE) 4) (Float3-scale-by-scalar ca inverse-determinant))
        (Float3-put! r (fx+ (INVERSE) 8) (Float3-scale-by-scalar ab inverse-determinant))))))

(: Moving-kernel (-> Moving CompileShape ShapeKernel))
(define (Moving-kernel moving compile)
  (define from (Transform-matrix (Moving-from moving)))
  (define to (Transform-matrix (Moving-to moving)))
  (define kernel (compile (Moving-shape moving)))
  ;; no matrix on the way has larger norms than both ends
  (define growth (flmax (matrix-growth from) (matrix-growth to)))
  (define out (flmax (largest-row-sum from 0) (largest-row-sum to 0)))

  (: in-local-space (-> (-> FlVector FxVector Boolean) (-> FlVector FxVector Boolean)))
  (define (in-local-space hit?)
    (lambda ([r : FlVector] [i : FxVector])
      (save-ray! r i)
      (put-matrices! from to r)
      (put-local-ray! r (r (MATRIX)) (r (INVERSE)))
      (let ([found? (with-next-level i : Boolean (hit? r i))])
        (restore-ray! r i)
        found?)))

  (define shape-surface! (ShapeKernel-surface kernel))
  (: surface! (-> FlVector FxVector Void))
  (define (surface! r i)
    (save-ray! r i)
    (put-matrices! from to r)
    (put-local-ray! r (r (MATRIX)) (r (INVERSE)))
    (with-next-level i : Void (shape-surface! r i))
    (restore-ray! r i)
    (put-matrices! from to r)
    (define missed (missed-by-inverse r (MATRIX) r (INVERSE)))
    (define in (largest-row-sum r (INVERSE)))
    (define local-rounding
      (fl+ (fl* growth missed)
           (fl* (fl* 8.0 (ROUNDING)) (fl+ out (fl* growth (fl* out in))))))
    (put-world-surface! r (r (MATRIX)) (r (INVERSE)) growth local-rounding))

  (define shape-uv! (ShapeKernel-uv kernel))
  (: uv! (-> FlVector FxVector Void))
  (define (uv! r i)
    (put-matrices! from to r)
    (put-local-normal! r i (r (MATRIX)) (r (INVERSE)))
    (with-next-level i : Void (shape-uv! r i))
    (restore-surface! r i))

  (ShapeKernel (box-around (transform-box from (ShapeKernel-bounds kernel))
                           (transform-box to (ShapeKernel-bounds kernel)))
               (in-local-space (ShapeKernel-nearest kernel))
               (in-local-space (ShapeKernel-occluded kernel))
               surface! uv!
               (fx+ 1 (ShapeKernel-nesting kernel)) (ShapeKernel-stack kernel)))

(: box-around (-> FlVector FlVector FlVector))
(define (box-around a b)
  (define around (flvector-copy a))
  (for ([axis : Nonnegative-Fixnum (in-range 3)])
    (flvector-set! around axis (flmin (flvector-ref a axis) (flvector-ref b axis)))
    (flvector-set! around (fx+ 3 axis)
                   (flmax (flvector-ref a (fx+ 3 axis)) (flvector-ref b (fx+ 3 axis)))))
  around)
