#lang typed/racket/base
;; Shapes as tests see them: points and directions are lists of three flonums, rays are shot at a
;; shape's kernel by itself.
(require "../../private/base/unsafe.rkt" "../../private/base/registers.rkt"
         "../../private/base/float3.rkt" "../../private/shape/kernel.rkt"
         "../../private/shape/shape.rkt" "../../private/shape/kernels.rkt"
         "../../private/shape/cylinder.rkt" "../../private/shape/cone.rkt"
         "../../private/shape/torus.rkt")

(provide cylinder cone torus probe probe? shoot shoot-occluded surface-at bounds crossings
         (struct-out Surface))

(define-type Triple (Listof Flonum))

(: float3 (-> Triple Float3))
(define (float3 l) (make-Float3 (car l) (cadr l) (caddr l)))

(: cylinder (->* (Triple Triple Real) (Boolean) Shape))
(define (cylinder base top radius [caps? #t])
  (make-Cylinder (float3 base) (float3 top) radius #:caps? caps?))

(: cone (->* (Triple Real Triple) (Boolean) Shape))
(define (cone base radius apex [caps? #t])
  (make-Cone (float3 base) radius (float3 apex) #:caps? caps?))

(: torus (-> Triple Triple Real Real Shape))
(define (torus center axis major minor) (make-Torus (float3 center) (float3 axis) major minor))

;; A shape's kernel and a scratch.
(struct Probe ([shape : Shape] [kernel : ShapeKernel] [r : FlVector] [i : FxVector]))

(: probe (-> Shape Probe))
(define (probe shape)
  (Probe shape (Shape-kernel shape) (make-flonum-registers) (make-fixnum-registers)))

(: probe? (-> Any Boolean))
(define (probe? v) (Probe? v))

(: put-ray! (-> FlVector Triple Triple Flonum Void))
(define (put-ray! r o d limit)
  (Float3-put! r ray-origin (float3 o))
  (Float3-put! r ray-direction (float3 d))
  (flvector-set! r ray-limit limit))

;; The parameter of the nearest hit before the limit, or #f.
(: shoot (->* (Probe Triple Triple) (Flonum) (U #f Flonum)))
(define (shoot p o d [limit 1e300])
  (define r (Probe-r p))
  (put-ray! r o d limit)
  (and ((ShapeKernel-nearest (Probe-kernel p)) r (Probe-i p))
       (flvector-ref r hit-t)))

(: shoot-occluded (-> Probe Triple Triple Flonum Boolean))
(define (shoot-occluded p o d limit)
  (put-ray! (Probe-r p) o d limit)
  ((ShapeKernel-occluded (Probe-kernel p)) (Probe-r p) (Probe-i p)))

(struct Surface ([point : Triple] [normal : Triple] [error : Flonum] [u : Flonum] [v : Flonum]))

;; The surface at the hit just found.
(: surface-at (-> Probe Surface))
(define (surface-at p)
  (define r (Probe-r p))
  ((ShapeKernel-surface (Probe-kernel p)) r (Probe-i p))
  ((ShapeKernel-uv (Probe-kernel p)) r (Probe-i p))
  (: triple (-> Fixnum Triple))
  (define (triple at)
    (list (flvector-ref r at) (flvector-ref r (fx+ 1 at)) (flvector-ref r (fx+ 2 at))))
  (Surface (triple surface-point) (triple surface-normal) (flvector-ref r surface-error)
           (flvector-ref r surface-uv) (flvector-ref r (fx+ 1 surface-uv))))

;; Low and high corner.
(: bounds (-> Probe (List Triple Triple)))
(define (bounds p)
  (define b (ShapeKernel-bounds (Probe-kernel p)))
  (list (list (flvector-ref b 0) (flvector-ref b 1) (flvector-ref b 2))
        (list (flvector-ref b 3) (flvector-ref b 4) (flvector-ref b 5))))

;; The parameters of all crossings of a torus by a line.
(: crossings (-> Probe Triple Triple (Listof Flonum)))
(define (crossings p o d)
  (define shape (Probe-shape p))
  (put-ray! (Probe-r p) o d 1e300)
  (Torus-crossings (assert shape Torus?) (Probe-r p) (Probe-i p)))
