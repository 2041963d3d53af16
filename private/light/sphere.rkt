#lang typed/racket/base
;; A sphere that shines, as a light: sampled by the cone it fills, seen from outside.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/frame.rkt"
         "../base/squares.rkt"
         "../sample/warp.rkt" "../shape/sphere.rkt" "../material/emitter.rkt" "light.rkt")

(provide Sphere-light-kernel)

;; From outside: uniform in the cone (Shirley, Wang, Zimmerman 1996), whose height 1 - cos is taken
;; as sin^2 / (1 + cos) so that distant small spheres keep their solid angle. From inside: uniform
;; over the sphere's area, and dark unless the emitter is two-sided. A point on the sphere, up to
;; rounding, is outside: the light fills its hemisphere.
(: Sphere-light-kernel (-> Sphere Emitter Fixnum LightKernel))
(define (Sphere-light-kernel sphere emitter primitive)
  (define center (Sphere-point sphere))
  (define radius (Sphere-radius sphere))
  (define radiance (Emitter-constant-radiance emitter))
  (define two-sided? (Emitter-two-sided? emitter))
  ;; from near by, the cosine comes from the difference of the squares, which would cancel
  (define unit (power-of-two-above radius))
  (define-syntax-rule (cone-height to-center squared)
    (let* ([r-squared (fl* radius radius)]
           [sine-squared (flmin 1.0 (fl/ r-squared squared))]
           [cosine-squared
            (if (fl> sine-squared 0.25)
                (fl/ (squares-excess (Float3-x to-center) (Float3-y to-center)
                                     (Float3-z to-center) radius unit)
                     squared)
                (fl- 1.0 sine-squared))])
      (fl/ sine-squared (fl+ 1.0 (flsqrt (flmax 0.0 cosine-squared))))))

  (: sample (-> FlVector FxVector Void))
  (define (sample r i)
    (define r-squared (fl* radius radius))
    (let-float3 ([to-center (Float3-subtract center (Float3-in r surface-point))])
      (let ([squared (Float3-length-squared to-center)])
        (cond
          [(fl> squared (fl* 0.999999999999 r-squared))
           (let ([height (cone-height to-center squared)])
             (let-float3 ([axis (Float3-scale-by-scalar to-center (fl/ 1.0 (flsqrt squared)))]
                          [local (warp-cone (flvector-ref r sample-u) (flvector-ref r sample-v)
                                            height)])
               (let-frame (tangent bitangent) axis
                 (let* ([along (fl* (flsqrt squared) (Float3-z local))]
                        [aside-squared
                         (fl* squared (fl- 1.0 (fl* (Float3-z local) (Float3-z local))))]
                        [half-chord (flsqrt (flmax 0.0 (fl- r-squared aside-squared)))]
                        [solid-angle (fl* (TWO-PI) height)])
                   (Float3-put! r light-direction (Frame-to-world tangent bitangent axis local))
                   ;; from the wall of a room it is the wall on the other side
                   (flvector-set! r light-distance
                                  (if (and two-sided? (fl< squared (fl* 1.000000000001 r-squared)))
                                      (fl+ along half-chord)
                                      (fl- along half-chord)))
                   (Float3-put! r light-radiance (Float3-scale-by-scalar radiance solid-angle))
                   (flvector-set! r light-density (fl/ 1.0 solid-angle))))))]
          [two-sided?
           (let-float3 ([out (warp-uniform-sphere (flvector-ref r sample-u)
                                                  (flvector-ref r sample-v))]
                        [to-light (Float3-multiply-add to-center radius out)])
             (let* ([squared (Float3-length-squared to-light)]
                    [distance (flsqrt squared)]
                    [cosine (fl/ (Float3-dot to-light out) distance)]
                    [density (fl/ squared (fl* cosine (fl* (fl* 4.0 (PI)) r-squared)))])
               (cond
                 [(and (fl> distance 0.0) (fl> cosine 0.0))
                  (Float3-put! r light-direction
                               (Float3-scale-by-scalar to-light (fl/ 1.0 distance)))
                  (flvector-set! r light-distance distance)
                  (Float3-put! r light-radiance
                               (Float3-scale-by-scalar radiance (fl/ 1.0 density)))
                  (flvector-set! r light-density density)]
                 [else (dark! r)])))]
          [else (dark! r)]))))

  (: density (-> FlVector FxVector Void))
  (define (density r i)
    (define r-squared (fl* radius radius))
    (let-float3 ([to-center (Float3-subtract center (Float3-in r surface-point))])
      (let ([squared (Float3-length-squared to-center)])
        (flvector-set!
         r light-density
         (cond
           [(fl> squared (fl* 0.999999999999 r-squared))
            (fl/ 1.0 (fl* (TWO-PI) (cone-height to-center squared)))]
           [two-sided?
            ;; distance along in-direction to the wall, and the cosine there
            (let-float3 ([d (Float3-in r in-direction)])
              (let* ([along (Float3-dot to-center d)]
                     [aside-squared (fl- squared (fl* along along))]
                     [half-chord (flsqrt (flmax 0.0 (fl- r-squared aside-squared)))]
                     [distance (fl+ along half-chord)])
                (fl/ (fl* distance distance)
                     (fl* (fl/ half-chord radius) (fl* (fl* 4.0 (PI)) r-squared)))))]
           [else 0.0])))))

  (LightKernel sample density #t primitive
               (round-bound (Sphere-bounds sphere) radiance
                            (fl* (fl* 4.0 (PI)) (fl* radius radius)))))

;; The least power of two above a positive number, or the largest there is.
(: power-of-two-above (-> Flonum Flonum))
(define (power-of-two-above x)
  (define (search [from : Flonum] [factor : Flonum] [enough? : (-> Flonum Boolean)]) : Flonum
    (if (enough? from) from (search (fl* from factor) factor enough?)))
  (search (search 1.0 0.5 (lambda (p) (or (fl<= p x) (fl= p 0.0)))) 2.0
          (lambda (p) (or (fl> p x) (fl> p 4e307)))))

(: dark! (-> FlVector Void))
(define (dark! r)
  (Float3-put! r light-radiance (Float3 0.0 0.0 0.0))
  (flvector-set! r light-density 0.0))
