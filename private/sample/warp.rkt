#lang typed/racket/base
;; From the unit square to directions and points, as fusing operations: each maps a pair (u, v)
;; with uniform density to the named distribution.
(require "../base/unsafe.rkt" "../base/float3.rkt" "circle.rkt")

(provide TWO-PI PI INVERSE-PI
         warp-cosine-hemisphere warp-uniform-hemisphere warp-uniform-sphere warp-cone warp-disk)

(define-syntax-rule (PI) 3.141592653589793)
(define-syntax-rule (TWO-PI) 6.283185307179586)
(define-syntax-rule (INVERSE-PI) 0.3183098861837907)

;; Uniform on the unit disk in the plane z = 0, by polar coordinates of equal area.
(define-circle-operation (warp-disk [u : Flonum] [v : Flonum])
  #:let () (flsqrt u) v 0.0)

;; Around +z with density cos / pi (Malley's method: a disk sample projected up).
(define-circle-operation (warp-cosine-hemisphere [u : Flonum] [v : Flonum])
  #:let () (flsqrt u) v (flsqrt (fl- 1.0 u)))

;; Around +z with density 1 / 2 pi.
(define-circle-operation (warp-uniform-hemisphere [u : Flonum] [v : Flonum])
  #:let () (flsqrt (fl* u (fl- 2.0 u))) v (fl- 1.0 u))

;; With density 1 / 4 pi.
(define-circle-operation (warp-uniform-sphere [u : Flonum] [v : Flonum])
  #:let () (flsqrt (fl* 4.0 (fl* u (fl- 1.0 u)))) v (fl- 1.0 (fl* 2.0 u)))

;; Around +z within a cone of height h = 1 - cos(half angle), density 1 / (2 pi h). Given h and
;; not the cosine, so that a cone of 1e-8 radians is not empty.
(define-circle-operation (warp-cone [u : Flonum] [v : Flonum] [h : Flonum])
  #:let ([depth (fl* u h)]) (flsqrt (fl* depth (fl- 2.0 depth))) v (fl- 1.0 depth))
