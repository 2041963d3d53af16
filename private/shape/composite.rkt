#lang typed/racket/base
;; Shapes made of other shapes: how deep they nest, and how a ray is taken into the space of a
;; part and what it finds there is brought back.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/matrix.rkt"
         "../base/check.rkt" "../material/material.rkt" "kernel.rkt" "shape.rkt")

(provide (struct-out Composite) CompileShape NumberMaterial check-nesting
         with-next-level put-material!
         save-ray! restore-ray! put-local-ray! put-world-surface! put-local-normal!
         restore-surface!)

;; nesting: how many levels of composites there are, this one included.
(struct Composite Shape ([nesting : Fixnum]) #:transparent)

;; What a composite's kernel is made with: kernels for its parts, each made once in a world, and
;; the world's numbers of their materials (-1 where there is no world).
(define-type CompileShape (-> Shape ShapeKernel))
(define-type NumberMaterial (-> Material Fixnum))

;; The nesting of a composite of these parts. Every level has its own place for the path to a hit
;; and for the ray outside, and a part of the stack, so there is an end to them.
(: check-nesting (-> Symbol (Listof Shape) Fixnum))
(define (check-nesting who parts)
  (define nesting
    (for/fold ([deepest : Fixnum 1]) ([part (in-list parts)])
      (if (Composite? part) (fxmax deepest (fx+ 1 (Composite-nesting part))) deepest)))
  (if (fx< nesting (NEST-LIMIT))
      nesting
      (raise-expected who "shapes"
                      (format "shapes nested at most ~a levels deep" (- (NEST-LIMIT) 1)) nesting)))

(define-syntax-rule (fxmax a b) (let ([x a] [y b]) (if (fx> x y) x y)))

;; The body's value; in it the next level of nesting is current.
(define-syntax-rule (with-next-level i colon type body ...)
  (let ([level (fxvector-ref i nest-level)])
    (fxvector-set! i nest-level (fx+ level 1))
    (let ([result colon type (let () body ...)])
      (fxvector-set! i nest-level level)
      result)))

;; A part's material, where the part does not say itself.
(define-syntax-rule (put-material! i number)
  (when (fx>= number 0) (fxvector-set! i hit-material number)))

(define-syntax-rule (saved i) (fx+ saved-rays (fx* 9 (fxvector-ref i nest-level))))

(define-syntax-rule (copy-three! r to from) (Float3-put! r to (Float3-in r from)))

(define-syntax-rule (save-ray! r i)
  (let ([place (saved i)])
    (copy-three! r place ray-origin)
    (copy-three! r (fx+ place 3) ray-direction)
    (copy-three! r (fx+ place 6) ray-inverse)))

(define-syntax-rule (restore-ray! r i)
  (let ([place (saved i)])
    (copy-three! r ray-origin place)
    (copy-three! r ray-direction (fx+ place 3))
    (copy-three! r ray-inverse (fx+ place 6))))

;; Takes the ray into the space of the part. Its direction keeps its length there, so parameters
;; are the same. The offset is taken off first: what is near to the part keeps its digits wherever
;; the part is. matrix and inverse are at places m and n.
(define-syntax-rule (put-local-ray! r (matrix m) (inverse n))
  (begin
    (Float3-put! r ray-origin
                 (matrix-vector inverse n (Float3-subtract (Float3-in r ray-origin)
                                                           (matrix-origin matrix m))))
    (Float3-put! r ray-direction (matrix-vector inverse n (Float3-in r ray-direction)))))

;; Brings the surface in the scratch out of the space of the part. The error of the point grows by
;; at most `growth`; to it come the roundings of the point's way out, and of the way back in of a
;; ray that starts there, bounded by local-rounding times the local point's size.
(define-syntax-rule
  (put-world-surface! r (matrix m) (inverse n) growth local-rounding)
  (let-float3 ([local (Float3-in r surface-point)]
               [normal (matrix-normal inverse n (Float3-in r surface-normal))]
               [shading (matrix-normal inverse n (Float3-in r surface-shading-normal))]
               [world (matrix-point matrix m local)])
    (let ([error (fl+ (fl+ (fl* growth (flvector-ref r surface-error))
                           (fl* local-rounding (Float3-largest-magnitude local)))
                      (fl* (fl* 8.0 (ROUNDING)) (Float3-largest-magnitude world)))])
      (Float3-put! r surface-point world)
      (Float3-put! r surface-normal (scaled-to-unit normal))
      (Float3-put! r surface-shading-normal (scaled-to-unit shading))
      (flvector-set! r surface-error error))))

;; Divided by the largest component first, so that no scale makes the squares vanish.
(define-syntax-rule (scaled-to-unit v)
  (Float3-normalized (Float3-scale-by-scalar v (fl/ 1.0 (Float3-largest-magnitude v)))))

;; Takes the point and the normal of the surface into the space of the part, for its texture
;; and its texture coordinates, and keeps them as they were.
(define-syntax-rule (put-local-normal! r i (matrix m) (inverse n))
  (let ([place (saved i)])
    (copy-three! r place surface-point)
    (copy-three! r (fx+ place 3) surface-normal)
    (let-float3 ([normal (matrix-normal matrix m (Float3-in r surface-normal))])
      (Float3-put! r surface-normal (scaled-to-unit normal))
      (let-float3 ([local (matrix-vector inverse n (Float3-subtract (Float3-in r surface-point)
                                                                    (matrix-origin matrix m)))])
        (Float3-put! r surface-point local)
        (Float3-put! r texture-point local)))))

(define-syntax-rule (restore-surface! r i)
  (let ([place (saved i)])
    (copy-three! r surface-point place)
    (copy-three! r surface-normal (fx+ place 3))))
