#lang typed/racket/base
;; Flat disks, seen from both sides.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/public.rkt"
         "../base/check.rkt" "../base/frame.rkt" "../sample/warp.rkt" "../material/material.rkt"
         "kernel.rkt" "shape.rkt" "plane.rkt")

(provide (struct-out Disk) make-Disk Disk-kernel Disk-bounds)

;; point: the centre. normal: kept as a unit vector. radius: positive. material: the surface.
(struct Disk Shape
  ([point : Float3] [normal : Float3] [radius : Flonum] [material : Material])
  #:transparent)

(: make-Disk (->* (Float3 Float3 Real) (MaterialOrColor #:material MaterialOrColor) Disk))
(define (make-Disk point normal radius [color (make-Float3 0.5 0.5 0.5)]
                   #:material [material color])
  (Disk (check-point 'Disk "point" point)
        (Float3-normalized/checked (check-direction 'Disk "normal" normal))
        (check-positive 'Disk "radius" radius)
        (->material material)))

(define-constructor Disk make-Disk (point normal radius material))

(: Disk-kernel (-> Disk ShapeKernel))
(define (Disk-kernel disk)
  (define center (Disk-point disk))
  (define normal (Disk-normal disk))
  (define radius (Disk-radius disk))
  (define error-bound
    (fl* (fl* 32.0 (ROUNDING)) (fl+ radius (Float3-largest-magnitude center))))
  (: nearest (-> FlVector FxVector Boolean))
  (define (nearest r i)
    (let-float3 ([o (Float3-in r ray-origin)] [d (Float3-in r ray-direction)]
                 [c center] [n normal])
      (let ([t (plane-parameter o d c n)])
        (and (closer? r i t)
             (let-float3 ([offset (plane-offset o t d c n)])
               (fl<= (Float3-length-squared offset) (fl* radius radius)))
             (begin (flvector-set! r hit-t t) #t)))))
  (: surface (-> FlVector FxVector Void))
  (define (surface r i)
    (let-float3 ([c center] [n normal]
                 [offset (plane-offset (Float3-in r ray-origin) (flvector-ref r hit-t)
                                       (Float3-in r ray-direction) c n)])
      (put-surface! r (Float3-add c offset) n error-bound)))
  ;; u around the normal as a part of a turn, v from the centre out.
  (: uv (-> FlVector FxVector Void))
  (define (uv r i)
    (let-float3 ([n normal] [offset (Float3-subtract (Float3-in r surface-point) center)])
      (let-frame (tangent bitangent) n
        (let ([x (Float3-dot offset tangent)] [y (Float3-dot offset bitangent)])
          (flvector-set! r surface-uv (fl+ 0.5 (fl* (fl/ 0.5 (PI)) (atan y x))))
          (flvector-set! r (fx+ surface-uv 1)
                         (flmin 1.0 (fl/ (flsqrt (fl+ (fl* x x) (fl* y y))) radius)))))))
  (ShapeKernel (Disk-bounds disk) nearest nearest surface uv 0 0))

;; Along an axis the disk reaches radius times the sine between the axis and the normal.
(: Disk-bounds (-> Disk FlVector))
(define (Disk-bounds disk)
  (define radius (Disk-radius disk))
  (: reach (-> Flonum Flonum Flonum))
  (define (reach a b) (fl* radius (flsqrt (fl+ (fl* a a) (fl* b b)))))
  (let-float3 ([c (Disk-point disk)] [n (Disk-normal disk)])
    (let ([x (reach (Float3-y n) (Float3-z n))]
          [y (reach (Float3-x n) (Float3-z n))]
          [z (reach (Float3-x n) (Float3-y n))])
      (flvector (fl- (Float3-x c) x) (fl- (Float3-y c) y) (fl- (Float3-z c) z)
                (fl+ (Float3-x c) x) (fl+ (Float3-y c) y) (fl+ (Float3-z c) z)))))
