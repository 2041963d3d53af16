#lang typed/racket/base
;; Spheres: the intersection every caller shares, the public functions, and the kernel.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/public.rkt"
         "../base/check.rkt" "../base/squares.rkt" "../sample/warp.rkt"
         "../material/material.rkt"
         "kernel.rkt" "shape.rkt")

(provide (struct-out Sphere) make-Sphere Sphere-nearest-root Sphere-surface! Sphere-uv!
         Sphere-kernel Sphere-bounds)

;; The smallest positive parameter t at which o + t d meets the sphere, or +inf.0. `dd` is d.d and
;; `inverse-dd` its reciprocal. The discriminant is taken from the point of the ray nearest to the
;; centre (Haines, Gunther, Akenine-Moller, "Precision Improvements for Ray/Sphere Intersection",
;; Ray Tracing Gems 2019), the constant term factored as (|oc| - r)(|oc| + r), so that neither
;; far small spheres nor near huge ones lose digits; a miss is decided before any root is taken.
(define-syntax-rule (Sphere-nearest-root o d dd inverse-dd center radius)
  (let-float3 ([oc (Float3-subtract o center)])
    (let ([b (Float3-dot oc d)])
      (let-float3 ([nearest (Float3-multiply-add oc (fl* -1.0 (fl* b inverse-dd)) d)])
        (let* ([squared (fl* radius radius)]
               [discriminant (fl- squared (Float3-length-squared nearest))])
          (if (fl>= discriminant 0.0)
              (let ([s (flsqrt (fl* dd discriminant))])
                (if (and (fl< (fl+ s s) (fl* -1.0 b)) (fl< (fl* squared dd) (fl* b b)))
                    ;; far enough in front for the plain root to keep its digits; what is left of
                    ;; `nearest` along d takes the roundings of b and dd out again
                    (fl- (fl* -1.0 (fl* b inverse-dd))
                         (fl* (fl+ s (Float3-dot nearest d)) inverse-dd))
                    (let* ([length (Float3-length oc)]
                           [c (fl* (fl- length radius) (fl+ length radius))])
                      (if (and (fl> b 0.0) (fl>= c 0.0))
                          +inf.0
                          ;; near by, b b - c dd is the better one: it does not round r r
                          (let ([s (flsqrt (flmax 0.0 (fl- (fl* b b) (fl* c dd))))])
                            (if (fl> b 0.0)
                                (fl/ c (fl* -1.0 (fl+ b s)))
                                (if (fl> c 0.0)
                                    (fl/ c (fl- s b))
                                    (fl* (fl- s b) inverse-dd))))))))
              +inf.0))))))

;; point: the centre. radius: positive. material: the surface.
(struct Sphere Shape ([point : Float3] [radius : Flonum] [material : Material]) #:transparent)

(: make-Sphere (->* (Float3 Real) (MaterialOrColor #:material MaterialOrColor) Sphere))
(define (make-Sphere point radius [color (make-Float3 0.5 0.5 0.5)] #:material [material color])
  (Sphere (check-point 'Sphere "point" point)
          (check-positive 'Sphere "radius" radius)
          (->material material)))

(define-constructor Sphere make-Sphere (point radius material))

;; The surface at the hit in the scratch: the point is brought back onto the sphere, so its error
;; is a few roundings of the radius and the centre, however far the ray came from.
(define-syntax-rule (Sphere-surface! r center radius)
  (let-float3 ([c center]
               [out (Float3-subtract (Float3-multiply-add (Float3-in r ray-origin)
                                                          (flvector-ref r hit-t)
                                                          (Float3-in r ray-direction))
                                     c)])
    (let ([inverse-length (fl/ 1.0 (Float3-length out))])
      ;; nearly a unit vector, and one step of Newton's iteration: within an ulp of the sphere
      (let-float3 ([near-unit (Float3-scale-by-scalar out inverse-length)])
        (let ([excess (squares-excess (Float3-x near-unit) (Float3-y near-unit)
                                      (Float3-z near-unit) 1.0 1.0)])
          (let-float3 ([normal (Float3-multiply-add near-unit (fl* -0.5 excess) near-unit)]
                       [point (Float3-multiply-add c radius normal)])
            (put-surface! r point normal
                          (fl* (fl* 16.0 (ROUNDING))
                               (fl+ radius (Float3-largest-magnitude c))))))))))

;; Texture coordinates from the normal: u around the y axis from -x, v from the south pole up.
(: Sphere-uv! (-> FlVector FxVector Void))
(define (Sphere-uv! r i)
  (let-float3 ([n (Float3-in r surface-normal)])
    (flvector-set! r surface-uv
                   (fl+ 0.5 (fl* (fl/ 0.5 (PI)) (atan (fl* -1.0 (Float3-z n)) (Float3-x n)))))
    (flvector-set! r (fx+ surface-uv 1)
                   (fl- 1.0 (fl* (INVERSE-PI)
                                 (flacos (flmax -1.0 (flmin 1.0 (Float3-y n)))))))))

;; The kernel a sphere has where it stands alone; worlds pack theirs and use the same macros.
(: Sphere-kernel (-> Sphere ShapeKernel))
(define (Sphere-kernel sphere)
  (define center (Sphere-point sphere))
  (define radius (Sphere-radius sphere))
  (: nearest (-> FlVector FxVector Boolean))
  (define (nearest r i)
    (let-float3 ([d (Float3-in r ray-direction)])
      (let* ([dd (Float3-length-squared d)]
             [inverse-dd (fl/ 1.0 dd)])
        (let-float3 ([o (Float3-in r ray-origin)] [c center])
          (let ([t (Sphere-nearest-root o d dd inverse-dd c radius)])
            (and (closer? r i t)
                 (begin (flvector-set! r hit-t t) #t)))))))
  (ShapeKernel (Sphere-bounds sphere) nearest nearest
               (lambda ([r : FlVector] [i : FxVector]) (Sphere-surface! r center radius))
               Sphere-uv! 0 0))

(: Sphere-bounds (-> Sphere FlVector))
(define (Sphere-bounds sphere)
  (define radius (Sphere-radius sphere))
  (let-float3 ([c (Sphere-point sphere)])
    (flvector (fl- (Float3-x c) radius) (fl- (Float3-y c) radius) (fl- (Float3-z c) radius)
              (fl+ (Float3-x c) radius) (fl+ (Float3-y c) radius) (fl+ (Float3-z c) radius))))
