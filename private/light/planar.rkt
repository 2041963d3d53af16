#lang typed/racket/base
;; Flat shapes that shine, sampled by area: disks, triangles, and parallelograms that are no
;; rectangles or too small or far for anything better.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/frame.rkt"
         "../sample/warp.rkt"
         "../shape/disk.rkt" "../shape/triangle.rkt" "../material/emitter.rkt" "light.rkt")

(provide Disk-light-kernel Triangle-light-kernel put-area-sample! put-area-density! end-short! dark!)

;; From a point of the light in `workspace`: direction, distance, radiance over density. The light
;; shines to the side of `normal`, or to both.
(define-syntax-rule (put-area-sample! r normal area radiance two-sided?)
  (let-float3 ([to-light (Float3-subtract (Float3-in r workspace) (Float3-in r surface-point))]
               [n normal])
    (let* ([squared (Float3-length-squared to-light)]
           [distance (flsqrt squared)]
           [towards (fl* -1.0 (fl/ (Float3-dot to-light n) distance))]
           [cosine (if two-sided? (flabs towards) towards)])
      (cond
        [(and (fl> distance 0.0) (fl> cosine 0.0))
         (let ([density (fl/ squared (fl* cosine area))])
           (Float3-put! r light-direction (Float3-scale-by-scalar to-light (fl/ 1.0 distance)))
           (flvector-set! r light-distance distance)
           (Float3-put! r light-radiance (Float3-scale-by-scalar radiance (fl/ 1.0 density)))
           (flvector-set! r light-density density))]
        [else (dark! r)]))))

;; The density of that choice for in-direction, which is known to meet the light's plane there.
(define-syntax-rule (put-area-density! r point normal area two-sided?)
  (let-float3 ([d (Float3-in r in-direction)]
               [n normal]
               [to-plane (Float3-subtract point (Float3-in r surface-point))])
    (let* ([towards (fl* -1.0 (Float3-dot d n))]
           [cosine (if two-sided? (flabs towards) towards)]
           [distance (fl/ (Float3-dot to-plane n) (Float3-dot d n))])
      (flvector-set! r light-density
                     (if (fl> cosine 0.0)
                         (fl/ (fl* distance distance) (fl* cosine area))
                         0.0)))))

;; Ends the way to the light short of it, by a length and a part of the way, across the light: the
;; flatter the way meets it, the more. The shadow ray starts off the surface by the error of its point,
;; so it meets the light so much sooner too.
(define-syntax-rule (end-short! r absolute relative cosine)
  (let* ([distance (flvector-ref r light-distance)]
         [off (fl+ (flvector-ref r surface-error) absolute)]
         [shorter (fl- distance (fl/ (fl+ off (fl* relative distance)) cosine))])
    (if (fl> shorter 0.0)
        (flvector-set! r light-distance shorter)
        (dark! r))))

;; Nothing arrives.
(define-syntax-rule (dark! r)
  (begin
    (Float3-put! r light-radiance (Float3 0.0 0.0 0.0))
    (flvector-set! r light-density 0.0)))

(: Disk-light-kernel (-> Disk Emitter Fixnum LightKernel))
(define (Disk-light-kernel disk emitter primitive)
  (define center (Disk-point disk))
  (define normal (Disk-normal disk))
  (define radius (Disk-radius disk))
  (define area (fl* (PI) (fl* radius radius)))
  (define radiance (Emitter-constant-radiance emitter))
  (define two-sided? (Emitter-two-sided? emitter))
  (LightKernel
   (lambda ([r : FlVector] [i : FxVector])
     (let-float3 ([n normal]
                  [on-disk (Float3-scale-by-scalar
                            (warp-disk (flvector-ref r sample-u) (flvector-ref r sample-v))
                            radius)])
       (let-frame (tangent bitangent) n
         (Float3-put! r workspace
                      (Float3-add center (Frame-to-world tangent bitangent n on-disk)))))
     (put-area-sample! r normal area radiance two-sided?))
   (lambda ([r : FlVector] [i : FxVector])
     (put-area-density! r center normal area two-sided?))
   #t
   primitive
   (flat-bound (Disk-bounds disk) radiance area normal 0.0 two-sided?)))

(: Triangle-light-kernel (-> Triangle Emitter Fixnum LightKernel))
(define (Triangle-light-kernel triangle emitter primitive)
  (define a (Triangle-a triangle))
  (define ab (Float3-subtract (Triangle-b triangle) a))
  (define ac (Float3-subtract (Triangle-c triangle) a))
  (define across (Float3-cross ab ac))
  (define double-area (Float3-length across))
  (define normal
    (if (fl> double-area 0.0) (Float3-scale-by-scalar across (fl/ 1.0 double-area)) across))
  (define area (fl* 0.5 double-area))
  (define radiance (Emitter-constant-radiance emitter))
  (define two-sided? (Emitter-two-sided? emitter))
  (LightKernel
   (lambda ([r : FlVector] [i : FxVector])
     ;; uniform barycentrics by a square root (Osada et al. 2002)
     (let* ([root (flsqrt (flvector-ref r sample-u))]
            [second (fl* root (fl- 1.0 (flvector-ref r sample-v)))]
            [third (fl* root (flvector-ref r sample-v))])
       (Float3-put! r workspace
                    (Float3-multiply-add (Float3-multiply-add a second ab) third ac)))
     (put-area-sample! r normal area radiance two-sided?))
   (lambda ([r : FlVector] [i : FxVector])
     (put-area-density! r a normal area two-sided?))
   #t
   primitive
   (flat-bound (Triangle-bounds triangle) radiance area normal 0.0 two-sided?)))
