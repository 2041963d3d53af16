#lang typed/racket/base
;; How a ray finds its hit: the nearest-hit and any-hit kernels over a compiled world, and the
;; surface at a hit. Rays and hits are in the worker's scratch (see base/registers.rkt).
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt"
         "../shape/kernel.rkt" "../shape/sphere.rkt" "scene.rkt" "traverse.rkt")

(provide Scene-nearest! Scene-occluded? Scene-surface! Scene-uv! Scene-nearest-by-scan!)

;; Whether the ray hits anything with 0 < t < ray-limit; the nearest hit, of the lowest primitive
;; where several are equally near, into hit-t and hit-primitive (-1 for none).
(: Scene-nearest! (-> Scene FlVector FxVector Boolean))
(define (Scene-nearest! scene r i)
  (define bounds (Scene-bounds scene))
  (define links (Scene-links scene))
  (define order (Scene-order scene))
  (define spheres (Scene-spheres scene))
  (fxvector-set! i nearest-rays (fx+ 1 (fxvector-ref i nearest-rays)))
  (fxvector-set! i hit-primitive -1)
  (unless (Scene-only-spheres? scene) (nearest-unbounded! scene r i))
  (traverse
   (bounds links r i) (o d) limit
   #:leaf (first end top next again)
   (let* ([dd (Float3-length-squared d)]
          [inverse-dd (fl/ 1.0 dd)])
     (let try ([place : Fixnum first] [limit : Flonum limit])
       (if (fx= place end)
           (next limit)
           (let ([radius (flvector-ref spheres (fx+ 3 (fx* 4 place)))])
             (if (fl> radius 0.0)
                 (let-float3 ([center (Float3-in spheres (fx* 4 place))])
                   (let ([t (Sphere-nearest-root o d dd inverse-dd center radius)])
                     (if (and (fl<= t limit) (fl> t 0.0)
                              (or (fl< t limit)
                                  (lower-primitive? i (fxvector-ref order place))))
                         (begin
                           (put-hit! r i t (fxvector-ref order place))
                           (try (fx+ place 1) t))
                         (try (fx+ place 1) limit))))
                 (begin
                   (nearest-kernels! scene place end top r i)
                   (again)))))))
   #:done (fx>= (fxvector-ref i hit-primitive) 0)))

;; Whether anything but the ignored primitive is hit with 0 < t < ray-limit.
(: Scene-occluded? (-> Scene FlVector FxVector Boolean))
(define (Scene-occluded? scene r i)
  (define bounds (Scene-bounds scene))
  (define links (Scene-links scene))
  (define order (Scene-order scene))
  (define spheres (Scene-spheres scene))
  (define ignored (fxvector-ref i ignored-primitive))
  (fxvector-set! i occlusion-rays (fx+ 1 (fxvector-ref i occlusion-rays)))
  (or
   (and (not (Scene-only-spheres? scene)) (occluded-unbounded? scene r i))
   (traverse
    (bounds links r i) (o d) limit
    #:leaf (first end top next again)
    (let* ([dd (Float3-length-squared d)]
           [inverse-dd (fl/ 1.0 dd)])
      (let try ([place : Fixnum first])
        (if (fx= place end)
            (next limit)
            (let ([radius (flvector-ref spheres (fx+ 3 (fx* 4 place)))])
              (if (fl> radius 0.0)
                  (let-float3 ([center (Float3-in spheres (fx* 4 place))])
                    (let ([t (Sphere-nearest-root o d dd inverse-dd center radius)])
                      (if (and (fl< t limit) (fl> t 0.0)
                               (not (fx= ignored (fxvector-ref order place))))
                          #t
                          (try (fx+ place 1)))))
                  (if (occluded-kernels? scene place end top r i)
                      #t
                      (again)))))))
    #:done #f)))

;; The same answer as Scene-nearest! from trying every primitive in turn: the reference for tests.
(: Scene-nearest-by-scan! (-> Scene FlVector FxVector Boolean))
(define (Scene-nearest-by-scan! scene r i)
  (fxvector-set! i hit-primitive -1)
  (nearest-unbounded! scene r i)
  (nearest-kernels! scene 0 (fxvector-length (Scene-order scene)) (fxvector-ref i stack-base) r i)
  (fx>= (fxvector-ref i hit-primitive) 0))

(define-syntax-rule (put-hit! r i t primitive)
  (begin
    (flvector-set! r hit-t t)
    (flvector-set! r ray-limit t)
    (fxvector-set! i hit-primitive primitive)))

;; Whether a hit as near as the known one should replace it.
(define-syntax-rule (lower-primitive? i primitive)
  (fx< primitive (fxvector-ref i hit-primitive)))

;; Out of line, the primitives at places first .. end-1 of a leaf that holds more than spheres.
(: nearest-kernels! (-> Scene Fixnum Fixnum Fixnum FlVector FxVector Void))
(define (nearest-kernels! scene first end top r i)
  (define order (Scene-order scene))
  (define kernels (Scene-kernels scene))
  (fxvector-set! i stack-base top)
  (let loop ([place first])
    (when (fx< place end)
      (let* ([primitive (fxvector-ref order place)]
             [kernel (vector-ref kernels primitive)])
        (if kernel
            (nearest-kernel! kernel primitive r i)
            (nearest-sphere! scene place primitive r i)))
      (loop (fx+ place 1)))))

(: nearest-kernel! (-> ShapeKernel Fixnum FlVector FxVector Void))
(define (nearest-kernel! kernel primitive r i)
  (fxvector-set! i accept-ties (if (lower-primitive? i primitive) 1 0))
  (when ((ShapeKernel-nearest kernel) r i)
    (flvector-set! r ray-limit (flvector-ref r hit-t))
    (fxvector-set! i hit-primitive primitive)))

(define-syntax-rule (sphere-root scene place r)
  (let ([spheres (Scene-spheres scene)])
    (let-float3 ([o (Float3-in r ray-origin)]
                 [d (Float3-in r ray-direction)]
                 [center (Float3-in spheres (fx* 4 place))])
      (let* ([dd (Float3-length-squared d)]
             [inverse-dd (fl/ 1.0 dd)]
             [radius (flvector-ref spheres (fx+ 3 (fx* 4 place)))])
        (Sphere-nearest-root o d dd inverse-dd center radius)))))

(: nearest-sphere! (-> Scene Fixnum Fixnum FlVector FxVector Void))
(define (nearest-sphere! scene place primitive r i)
  (let ([t (sphere-root scene place r)]
        [limit (flvector-ref r ray-limit)])
    (when (and (fl<= t limit) (fl> t 0.0)
               (or (fl< t limit) (lower-primitive? i primitive)))
      (put-hit! r i t primitive))))

(: nearest-unbounded! (-> Scene FlVector FxVector Void))
(define (nearest-unbounded! scene r i)
  (define unbounded (Scene-unbounded scene))
  (define kernels (Scene-kernels scene))
  (let loop ([k : Fixnum 0])
    (when (fx< k (fxvector-length unbounded))
      (let ([kernel (vector-ref kernels (fxvector-ref unbounded k))])
        (when kernel (nearest-kernel! kernel (fxvector-ref unbounded k) r i)))
      (loop (fx+ k 1)))))

(: occluded-kernels? (-> Scene Fixnum Fixnum Fixnum FlVector FxVector Boolean))
(define (occluded-kernels? scene first end top r i)
  (define order (Scene-order scene))
  (define kernels (Scene-kernels scene))
  (define base (fxvector-ref i stack-base))
  (fxvector-set! i stack-base top)
  (fxvector-set! i accept-ties 0)
  (define occluded?
    (let loop : Boolean ([place : Fixnum first])
      (and (fx< place end)
           (let* ([primitive (fxvector-ref order place)]
                  [kernel (vector-ref kernels primitive)])
             (or (and (not (fx= primitive (fxvector-ref i ignored-primitive)))
                      (if kernel
                          ((ShapeKernel-occluded kernel) r i)
                          (let ([t (sphere-root scene place r)])
                            (and (fl< t (flvector-ref r ray-limit)) (fl> t 0.0)))))
                 (loop (fx+ place 1)))))))
  (fxvector-set! i stack-base base)
  occluded?)

(: occluded-unbounded? (-> Scene FlVector FxVector Boolean))
(define (occluded-unbounded? scene r i)
  (define unbounded (Scene-unbounded scene))
  (define kernels (Scene-kernels scene))
  (fxvector-set! i accept-ties 0)
  (let loop ([k : Fixnum 0])
    (and (fx< k (fxvector-length unbounded))
         (let* ([primitive (fxvector-ref unbounded k)]
                [kernel (vector-ref kernels primitive)])
           (or (and kernel
                    (not (fx= primitive (fxvector-ref i ignored-primitive)))
                    ((ShapeKernel-occluded kernel) r i))
               (loop (fx+ k 1)))))))

;; The surface at the hit in the scratch: point, normals, error bound, and the material's number.
(: Scene-surface! (-> Scene FlVector FxVector Void))
(define (Scene-surface! scene r i)
  (define primitive (fxvector-ref i hit-primitive))
  (define kernel (vector-ref (Scene-kernels scene) primitive))
  (fxvector-set! i hit-material (fxvector-ref (Scene-primitive-materials scene) primitive))
  (if kernel
      ((ShapeKernel-surface kernel) r i)
      (let* ([packed (Scene-primitive-spheres scene)]
             [radius (flvector-ref packed (fx+ 3 (fx* 4 primitive)))])
        (let-float3 ([center (Float3-in packed (fx* 4 primitive))])
          (Sphere-surface! r center radius)))))

;; What textures are asked with, for the surface in the scratch while its normals still point
;; outside: texture coordinates, and the point in the space the shape was made in.
(: Scene-uv! (-> Scene FlVector FxVector Void))
(define (Scene-uv! scene r i)
  (define kernel (vector-ref (Scene-kernels scene) (fxvector-ref i hit-primitive)))
  (Float3-put! r texture-point (Float3-in r surface-point))
  (if kernel
      ((ShapeKernel-uv kernel) r i)
      (Sphere-uv! r i)))
