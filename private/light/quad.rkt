#lang typed/racket/base
;; Parallelograms that shine. A rectangle is sampled uniformly in the solid angle it fills (Urena,
;; Fajardo, King, "An Area-Preserving Parametrization for Spherical Rectangles", 2013), by area
;; where that angle is tiny; other parallelograms by area.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt"
         "../sample/warp.rkt"
         "../shape/quad.rkt" "../material/emitter.rkt" "light.rkt" "planar.rkt")

(provide Quad-light-kernel)

;; Below this solid angle the differences of angles lose more digits than they win.
(define-syntax-rule (SMALLEST-ANGLE) 1e-5)

(: Quad-light-kernel (-> Quad Emitter Fixnum LightKernel))
(define (Quad-light-kernel quad emitter primitive)
  (define corner (Quad-corner quad))
  (define edge-u (Quad-edge-u quad))
  (define edge-v (Quad-edge-v quad))
  (define across (Float3-cross edge-u edge-v))
  (define area (Float3-length across))
  (define normal (Float3-scale-by-scalar across (fl/ 1.0 area)))
  (define radiance (Emitter-constant-radiance emitter))
  (define two-sided? (Emitter-two-sided? emitter))
  (define length-u (Float3-length edge-u))
  (define length-v (Float3-length edge-v))
  (define axis-x (Float3-scale-by-scalar edge-u (fl/ 1.0 length-u)))
  (define axis-y (Float3-scale-by-scalar edge-v (fl/ 1.0 length-v)))
  (define rectangle? (fl< (flabs (Float3-dot axis-x axis-y)) 1e-12))

  (: sample-by-area! (-> FlVector Void))
  (define (sample-by-area! r)
    (Float3-put! r workspace
                 (Float3-multiply-add
                  (Float3-multiply-add corner (flvector-ref r sample-u) edge-u)
                  (flvector-ref r sample-v) edge-v))
    (put-area-sample! r normal area radiance two-sided?))

  (: sample (-> FlVector FxVector Void))
  (define (sample r i)
    (let-float3 ([to-corner (Float3-subtract corner (Float3-in r surface-point))])
      (let ([height (Float3-dot to-corner normal)])
        ;; in front of the light the corner lies against its normal
        (cond
          [(and (fl>= height 0.0) (not two-sided?)) (dark! r)]
          [(or (not rectangle?) (fl= height 0.0)) (sample-by-area! r)]
          [else
           (let-angles (x0 x1 y0 y1 z0 b0 b1 k angle) to-corner height
             (if (fl< angle (SMALLEST-ANGLE))
                 (sample-by-area! r)
                 (let* ([au (fl+ k (fl* angle (flvector-ref r sample-u)))]
                        [fu (fl/ (fl- (fl* (flcos au) b0) b1) (flsin au))]
                        [cu-size (fl/ 1.0 (flsqrt (fl+ (fl* fu fu) (fl* b0 b0))))]
                        [cu (clamped (if (fl> fu 0.0) cu-size (fl* -1.0 cu-size)) -1.0 1.0)]
                        [x (clamped (fl/ (fl* -1.0 (fl* cu z0))
                                         (flsqrt (flmax 1e-300 (fl- 1.0 (fl* cu cu)))))
                                    x0 x1)]
                        [plane-squared (fl+ (fl* x x) (fl* z0 z0))]
                        [h0 (fl/ y0 (flsqrt (fl+ plane-squared (fl* y0 y0))))]
                        [h1 (fl/ y1 (flsqrt (fl+ plane-squared (fl* y1 y1))))]
                        [h (fl+ h0 (fl* (flvector-ref r sample-v) (fl- h1 h0)))]
                        [y (clamped (fl/ (fl* h (flsqrt plane-squared))
                                         (flsqrt (flmax 1e-300 (fl- 1.0 (fl* h h)))))
                                    y0 y1)]
                        [distance (flsqrt (fl+ plane-squared (fl* y y)))])
                   (let-float3 ([to-light (Float3-multiply-add
                                           (Float3-multiply-add
                                            (Float3-scale-by-scalar normal height)
                                            x axis-x)
                                           y axis-y)])
                     (Float3-put! r light-direction
                                  (Float3-scale-by-scalar to-light (fl/ 1.0 distance)))
                     (flvector-set! r light-distance distance)
                     (Float3-put! r light-radiance (Float3-scale-by-scalar radiance angle))
                     (flvector-set! r light-density (fl/ 1.0 angle))))))]))))

  (: density (-> FlVector FxVector Void))
  (define (density r i)
    (let-float3 ([to-corner (Float3-subtract corner (Float3-in r surface-point))])
      (let ([height (Float3-dot to-corner normal)])
        (cond
          [(and (fl>= height 0.0) (not two-sided?)) (flvector-set! r light-density 0.0)]
          [(or (not rectangle?) (fl= height 0.0))
           (put-area-density! r corner normal area two-sided?)]
          [else
           (let-angles (x0 x1 y0 y1 z0 b0 b1 k angle) to-corner height
             (if (fl< angle (SMALLEST-ANGLE))
                 (put-area-density! r corner normal area two-sided?)
                 (flvector-set! r light-density (fl/ 1.0 angle))))]))))

  ;; The rectangle seen from the surface: its extent along its axes, the distance of its plane as a
  ;; negative z0, and what the inversion needs; `angle` is its solid angle.
  (define-syntax-rule (let-angles (x0 x1 y0 y1 z0 b0 b1 k angle) to-corner height body)
    (let* ([x0 (Float3-dot to-corner axis-x)]
           [y0 (Float3-dot to-corner axis-y)]
           [x1 (fl+ x0 length-u)]
           [y1 (fl+ y0 length-v)]
           [z0 (fl* -1.0 (flabs height))]
           [zz (fl* z0 z0)]
           [b0 (fl/ (fl* -1.0 y0) (flsqrt (fl+ zz (fl* y0 y0))))]
           [n1 (fl/ x1 (flsqrt (fl+ zz (fl* x1 x1))))]
           [b1 (fl/ y1 (flsqrt (fl+ zz (fl* y1 y1))))]
           [n3 (fl/ (fl* -1.0 x0) (flsqrt (fl+ zz (fl* x0 x0))))]
           [g0 (flacos (fl* -1.0 (fl* b0 n1)))]
           [g1 (flacos (fl* -1.0 (fl* n1 b1)))]
           [g2 (flacos (fl* -1.0 (fl* b1 n3)))]
           [g3 (flacos (fl* -1.0 (fl* n3 b0)))]
           [k (fl- (TWO-PI) (fl+ g2 g3))]
           [angle (fl- (fl+ g0 g1) k)])
      body))

  (LightKernel sample density #t primitive
               (flat-bound (Quad-bounds quad) radiance area normal 0.0 two-sided?)))

(define-syntax-rule (clamped x low high)
  (let ([value x]) (if (fl< value low) low (if (fl> value high) high value))))
