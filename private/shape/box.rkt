#lang typed/racket/base
;; Axis-aligned boxes, closed, hit from outside and from inside.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/public.rkt"
         "../base/check.rkt" "../material/material.rkt" "kernel.rkt" "shape.rkt" "triangle.rkt")

(provide (struct-out Box) make-Box Box-kernel Box-bounds)

;; low, high: the corners of least and largest coordinates. material: the surface.
(struct Box Shape ([low : Float3] [high : Float3] [material : Material]) #:transparent)

(: make-Box (->* (Float3 Float3) (MaterialOrColor #:material MaterialOrColor) Box))
(define (make-Box low high [color (make-Float3 0.5 0.5 0.5)] #:material [material color])
  (check-point 'Box "low" low)
  (check-point 'Box "high" high)
  (unless (and (fl< (Float3-x low) (Float3-x high))
               (fl< (Float3-y low) (Float3-y high))
               (fl< (Float3-z low) (Float3-z high)))
    (raise-expected 'Box "high" "three coordinates greater than those of low" high))
  (Box low high (->material material)))

(define-constructor Box make-Box (low high material))

;; Binds enter and leave to the parameters between which low <= o + t d <= high; a ray along the
;; slab is in it always or never, whatever the sign of its zero.
(define-syntax-rule (let-closed-slab (enter leave) (o d low high) body ...)
  (let* ([enter (if (fl> d 0.0)
                    (fl/ (fl- low o) d)
                    (if (fl< d 0.0)
                        (fl/ (fl- high o) d)
                        (if (and (fl= d 0.0) (fl<= low o) (fl<= o high)) -inf.0 +inf.0)))]
         [leave (if (fl> d 0.0)
                    (fl/ (fl- high o) d)
                    (if (fl< d 0.0) (fl/ (fl- low o) d) +inf.0))])
    body ...))

;; 1 + 10 roundings: two parameters of one point differ by less, so a ray aimed at an edge from
;; outside is not lost between entering one slab and leaving the other.
(define-syntax-rule (WIDENING) 1.000000000000001)

;; hit-u keeps the face: 0 and 1 for low and high x, 2 and 3 for y, 4 and 5 for z.
(: Box-kernel (-> Box ShapeKernel))
(define (Box-kernel box)
  (define low (Box-low box))
  (define high (Box-high box))
  (define bounds (Box-bounds box))
  (define error-bound
    (fl* (fl* 16.0 (ROUNDING))
         (flmax (Float3-largest-magnitude low) (Float3-largest-magnitude high))))
  (define-syntax-rule (low-or-high d low-face) (if (fl> d 0.0) low-face (fl+ low-face 1.0)))
  (define-syntax-rule (high-or-low d low-face) (if (fl> d 0.0) (fl+ low-face 1.0) low-face))
  (: nearest (-> FlVector FxVector Boolean))
  (define (nearest r i)
    (let-float3 ([o (Float3-in r ray-origin)] [d (Float3-in r ray-direction)]
                 [lo low] [hi high])
      (let* ([dx (Float3-x d)] [dy (Float3-y d)] [dz (Float3-z d)])
        (let-closed-slab (enter-x leave-x) ((Float3-x o) dx (Float3-x lo) (Float3-x hi))
          (let-closed-slab (enter-y leave-y) ((Float3-y o) dy (Float3-y lo) (Float3-y hi))
            (let-closed-slab (enter-z leave-z) ((Float3-z o) dz (Float3-z lo) (Float3-z hi))
              (let* ([enter-xy (if (fl< enter-x enter-y) enter-y enter-x)]
                     [enter (if (fl< enter-xy enter-z) enter-z enter-xy)]
                     [leave-xy (if (fl< leave-y leave-x) leave-y leave-x)]
                     [leave (if (fl< leave-z leave-xy) leave-z leave-xy)]
                     [both (fl+ enter-y enter-z)])
                (and (fl<= enter (fl* leave (WIDENING)))
                     (fl= both both) ; not so where a coordinate is no number
                     (if (fl> enter 0.0)
                         (put-face-hit! r i enter
                                        (if (fl= enter enter-x) (low-or-high dx 0.0)
                                            (if (fl= enter enter-y) (low-or-high dy 2.0)
                                                (low-or-high dz 4.0))))
                         (put-face-hit! r i leave
                                        (if (fl= leave leave-x) (high-or-low dx 0.0)
                                            (if (fl= leave leave-y) (high-or-low dy 2.0)
                                                (high-or-low dz 4.0)))))))))))))
  ;; The coordinate of the face is the box's own, the others are kept within it.
  (: surface (-> FlVector FxVector Void))
  (define (surface r i)
    (define face (fl->fx (flvector-ref r hit-u)))
    (define axis (fxrshift face 1))
    (define side (fxand face 1))
    (let-float3 ([lo low] [hi high]
                 [p (Float3-multiply-add (Float3-in r ray-origin) (flvector-ref r hit-t)
                                         (Float3-in r ray-direction))])
      (put-surface! r (Float3 (flmax (Float3-x lo) (flmin (Float3-x hi) (Float3-x p)))
                              (flmax (Float3-y lo) (flmin (Float3-y hi) (Float3-y p)))
                              (flmax (Float3-z lo) (flmin (Float3-z hi) (Float3-z p))))
                    (Float3 0.0 0.0 0.0) error-bound))
    (let ([outward (fl- (fl* 2.0 (fx->fl side)) 1.0)])
      (flvector-set! r (fx+ surface-point axis) (flvector-ref bounds (fx+ axis (fx* 3 side))))
      (flvector-set! r (fx+ surface-normal axis) outward)
      (flvector-set! r (fx+ surface-shading-normal axis) outward)))
  ;; On each face from 0 to 1, u to the right and v up, seen from outside with y up; on the top
  ;; and bottom v runs along -z and z.
  (: uv (-> FlVector FxVector Void))
  (define (uv r i)
    (define face (fl->fx (flvector-ref r hit-u)))
    (let-float3 ([lo low] [hi high] [p (Float3-in r surface-point)])
      (let* ([x (fl/ (fl- (Float3-x p) (Float3-x lo)) (fl- (Float3-x hi) (Float3-x lo)))]
             [y (fl/ (fl- (Float3-y p) (Float3-y lo)) (fl- (Float3-y hi) (Float3-y lo)))]
             [z (fl/ (fl- (Float3-z p) (Float3-z lo)) (fl- (Float3-z hi) (Float3-z lo)))])
        (flvector-set! r surface-uv
                       (if (fx= face 0) z
                           (if (fx= face 1) (fl- 1.0 z) (if (fx= face 4) (fl- 1.0 x) x))))
        (flvector-set! r (fx+ surface-uv 1)
                       (if (fx= face 2) z (if (fx= face 3) (fl- 1.0 z) y))))))
  (ShapeKernel bounds nearest nearest surface uv 0 0))

(define-syntax-rule (put-face-hit! r i t face)
  (and (closer? r i t)
       (begin (flvector-set! r hit-t t)
              (flvector-set! r hit-u face)
              #t)))

(: Box-bounds (-> Box FlVector))
(define (Box-bounds box)
  (points-bounds (list (Box-low box) (Box-high box))))
