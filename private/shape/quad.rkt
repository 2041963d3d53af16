#lang typed/racket/base
;; Parallelograms, seen from both sides: two triangles without a seam.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/public.rkt"
         "../base/check.rkt" "../material/material.rkt" "kernel.rkt" "shape.rkt" "triangle.rkt")

(provide (struct-out Quad) make-Quad Quad-kernel Quad-bounds Quad-normal)

;; corner, and the edges from it: the points corner + a edge-u + b edge-v with a and b from 0 to 1.
;; Outside is where the edges turn counter-clockwise. material: the surface.
(struct Quad Shape
  ([corner : Float3] [edge-u : Float3] [edge-v : Float3] [material : Material])
  #:transparent)

(: make-Quad (->* (Float3 Float3 Float3) (MaterialOrColor #:material MaterialOrColor) Quad))
(define (make-Quad corner edge-u edge-v [color (make-Float3 0.5 0.5 0.5)]
                   #:material [material color])
  (check-point 'Quad "corner" corner)
  (check-direction 'Quad "edge-u" edge-u)
  (check-direction 'Quad "edge-v" edge-v)
  (unless (triangle-normal corner (Float3-add corner edge-u) (Float3-add corner edge-v))
    (raise-expected 'Quad "edge-v" "an edge that spans an area with edge-u at this corner" edge-v))
  (Quad corner edge-u edge-v (->material material)))

(define-constructor Quad make-Quad (corner edge-u edge-v material))

;; The unit vector along edge-u x edge-v.
(: Quad-normal (-> Quad Float3))
(define (Quad-normal quad)
  (or (triangle-normal (make-Float3 0 0 0) (Quad-edge-u quad) (Quad-edge-v quad))
      (raise-expected 'Quad "edge-v" "an edge that spans an area with edge-u" (Quad-edge-v quad))))

;; The corners in order around the quad, three places each.
(: Quad-corners (-> Quad FlVector))
(define (Quad-corners quad)
  (define corners (make-flvector 12))
  (let-float3 ([corner (Quad-corner quad)] [u (Quad-edge-u quad)] [v (Quad-edge-v quad)])
    (Float3-put! corners 0 corner)
    (Float3-put! corners 3 (Float3-add corner u))
    (Float3-put! corners 6 (Float3-add (Float3-add corner u) v))
    (Float3-put! corners 9 (Float3-add corner v)))
  corners)

;; The ray is tested against the four corners as a mesh's triangles are (see triangle.rkt), so no
;; ray passes between quads whose common edge has the same two corners to the bit. Corners are
;; sums: where they round, quads that meet on paper may leave a slit as wide as the rounding.
(: Quad-kernel (-> Quad ShapeKernel))
(define (Quad-kernel quad)
  (define corner (Quad-corner quad))
  (define edge-u (Quad-edge-u quad))
  (define edge-v (Quad-edge-v quad))
  (define normal (Quad-normal quad))
  (define corners (Quad-corners quad))
  (define error-bound
    (fl* (fl* 32.0 (ROUNDING))
         (fl+ (Float3-largest-magnitude corner)
              (fl+ (Float3-largest-magnitude edge-u) (Float3-largest-magnitude edge-v)))))
  (: nearest (-> FlVector FxVector Boolean))
  (define (nearest r i)
    (let-sheared-ray (kx ky kz ox oy oz sx sy sz) r
      (let-sheared-vertex (ax ay az) (kx ky kz ox oy oz sx sy) (corners 0)
        (let-sheared-vertex (bx by bz) (kx ky kz ox oy oz sx sy) (corners 3)
          (let-sheared-vertex (cx cy cz) (kx ky kz ox oy oz sx sy) (corners 6)
            (let-sheared-vertex (dx dy dz) (kx ky kz ox oy oz sx sy) (corners 9)
              (let* ([ab (edge-function ax ay bx by)]
                     [bc (edge-function bx by cx cy)]
                     [cd (edge-function cx cy dx dy)]
                     [da (edge-function dx dy ax ay)]
                     [ac (edge-function ax ay cx cy)]
                     [ca (fl* -1.0 ac)]
                     [abc? (same-sign? ab bc ca)])
                (and (or abc? (same-sign? ac cd da))
                     ;; the triangle's edge functions are the weights of the opposite corners
                     (let* ([a (if abc? bc cd)]
                            [b (if abc? ca 0.0)]
                            [c (if abc? ab da)]
                            [d (if abc? 0.0 ac)]
                            [det (fl+ (fl+ a c) (fl+ b d))]
                            [scaled (fl+ (fl+ (fl* a az) (fl* c cz))
                                         (fl+ (fl* b bz) (fl* d dz)))]
                            [t (fl* (fl/ scaled det) sz)])
                       (and (closer? r i t)
                            (front-parameter? scaled det sz
                                              (ax bx cx dx) (ay by cy dy) (az bz cz dz))
                            (begin (flvector-set! r hit-t t)
                                   (flvector-set! r hit-u (fl/ (fl+ b c) det))
                                   (flvector-set! r hit-v (fl/ (fl+ c d) det))
                                   #t)))))))))))
  (: surface (-> FlVector FxVector Void))
  (define (surface r i)
    (let-float3 ([from-corner (Float3-multiply-add
                               (Float3-scale-by-scalar edge-u (flvector-ref r hit-u))
                               (flvector-ref r hit-v) edge-v)])
      (put-surface! r (Float3-add corner from-corner) normal error-bound)))
  (: uv (-> FlVector FxVector Void))
  (define (uv r i)
    (let ([u (flvector-ref r hit-u)] [v (flvector-ref r hit-v)])
      (flvector-set! r surface-uv u)
      (flvector-set! r (fx+ surface-uv 1) v)))
  (ShapeKernel (Quad-bounds quad) nearest nearest surface uv 0 0))

(: Quad-bounds (-> Quad FlVector))
(define (Quad-bounds quad)
  (define corners (Quad-corners quad))
  (points-bounds (for/list : (Listof Float3) ([k (in-range 4)]) (Float3-in corners (fx* 3 k)))))
