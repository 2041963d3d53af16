#lang typed/racket/base
;; Boxes that shine: sampled by area on the faces that are seen, which are the three at most that
;; the point is in front of, or from within all six.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt"
         "../shape/box.rkt" "../material/emitter.rkt" "light.rkt" "planar.rkt")

(provide Box-light-kernel)

(: Box-light-kernel (-> Box Emitter Fixnum LightKernel))
(define (Box-light-kernel box emitter primitive)
  (define low (Box-low box))
  (define high (Box-high box))
  (define extent (Float3-subtract high low))
  (define radiance (Emitter-constant-radiance emitter))
  (define two-sided? (Emitter-two-sided? emitter))
  (define area-x (fl* (Float3-y extent) (Float3-z extent)))
  (define area-y (fl* (Float3-z extent) (Float3-x extent)))
  (define area-z (fl* (Float3-x extent) (Float3-y extent)))

  ;; Binds the areas seen of both faces of each axis; from within, all count where the light is
  ;; two-sided.
  (define-syntax-rule (let-seen-areas (low-x high-x low-y high-y low-z high-z area) r body)
    (let-float3 ([x (Float3-in r surface-point)] [lo low] [hi high])
      (let* ([below-x (fl< (Float3-x x) (Float3-x lo))] [above-x (fl> (Float3-x x) (Float3-x hi))]
             [below-y (fl< (Float3-y x) (Float3-y lo))] [above-y (fl> (Float3-y x) (Float3-y hi))]
             [below-z (fl< (Float3-z x) (Float3-z lo))] [above-z (fl> (Float3-z x) (Float3-z hi))]
             [within? (not (or below-x above-x below-y above-y below-z above-z))]
             [all? (and two-sided? within?)]
             [low-x (if (or all? below-x) area-x 0.0)] [high-x (if (or all? above-x) area-x 0.0)]
             [low-y (if (or all? below-y) area-y 0.0)] [high-y (if (or all? above-y) area-y 0.0)]
             [low-z (if (or all? below-z) area-z 0.0)] [high-z (if (or all? above-z) area-z 0.0)]
             [area (fl+ (fl+ (fl+ low-x high-x) (fl+ low-y high-y)) (fl+ low-z high-z))])
        body)))

  (: sample (-> FlVector FxVector Void))
  (define (sample r i)
    (let-seen-areas (low-x high-x low-y high-y low-z high-z area) r
      (let* ([target (fl* area (flvector-ref r sample-u))]
             [end-x (fl+ low-x high-x)]
             [end-y (fl+ end-x (fl+ low-y high-y))]
             [v (flvector-ref r sample-v)])
        ;; what is left of the number on its face is uniform again
        (define-syntax-rule (on-axis before low-area face-area (u side) place normal)
          (let* ([left (fl- target before)]
                 [low-face? (fl< left low-area)]
                 [u (fl/ (if low-face? left (fl- left low-area)) face-area)]
                 [side (if low-face? 0.0 1.0)])
            (Float3-put! r workspace
                         (Float3-add low (Float3-scale-by-vector extent place)))
            (put-area-sample! r normal area radiance #t)))
        (cond
          [(fl= area 0.0) (dark! r)]
          [(fl< target end-x)
           (on-axis 0.0 low-x area-x (u side) (Float3 side u v) (Float3 1.0 0.0 0.0))]
          [(fl< target end-y)
           (on-axis end-x low-y area-y (u side) (Float3 u side v) (Float3 0.0 1.0 0.0))]
          [else (on-axis end-y low-z area-z (u side) (Float3 u v side) (Float3 0.0 0.0 1.0))]))))

  ;; At the hit, on the face that was hit.
  (: density (-> FlVector FxVector Void))
  (define (density r i)
    (let-seen-areas (low-x high-x low-y high-y low-z high-z area) r
      (let* ([distance (fl+ (flvector-ref r travelled) (flvector-ref r hit-t))]
             [axis (fxrshift (fl->fx (flvector-ref r hit-u)) 1)]
             [cosine (flabs (flvector-ref r (fx+ in-direction axis)))])
        (flvector-set! r light-density
                       (if (and (fl> area 0.0) (fl> cosine 0.0))
                           (fl/ (fl* distance distance) (fl* cosine area))
                           0.0)))))

  (LightKernel sample density #t primitive
               (round-bound (Box-bounds box) radiance
                            (fl* 2.0 (fl+ area-x (fl+ area-y area-z))))))
