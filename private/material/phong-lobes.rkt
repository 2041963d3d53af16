#lang typed/racket/base
;; The kernel that the Phong materials share: a matte part, a highlight around the mirrored
;; direction that falls off as a power of the cosine, and perhaps a mirror.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/frame.rkt"
         "../sample/sampler.rkt" "../sample/warp.rkt" "../sample/circle.rkt"
         "kernel.rkt" "scatter.rkt" "texture/texture.rkt" "texture/kernels.rkt")

(provide phong-lobes-kernel)

;; Around +z with density (n + 1) / (2 pi) cos^n; `inverse` is 1 / (n + 1).
(define-circle-operation (warp-power-cosine [u : Flonum] [v : Flonum] [inverse : Flonum])
  #:let ([cosine (flexpt u inverse)])
  (flsqrt (fl* (fl- 1.0 cosine) (fl+ 1.0 cosine))) v cosine)

;; Value times cosine is color share cos / pi + peak cos^shininess(alpha), alpha the angle to the
;; mirrored direction, the second times the cosine too where foreshortened?; and mirror's share
;; goes to the mirrored direction itself. The three parts are chosen by their largest component,
;; for the highlight that of its whole lobe. Draws one pair, whose first number chooses and is
;; stretched again. Below the surface the value is 0 and the highlight's density is not.
(: phong-lobes-kernel
   (-> ColorOrTexture Float3 Float3 Flonum Boolean Float3 MaterialKernel))
(define (phong-lobes-kernel color share peak shininess foreshortened? mirror)
  (: times-share! (-> FlVector Fixnum Void))
  (define (times-share! v at)
    (Float3-put! v at (Float3-scale-by-vector share (Float3-in v at))))
  (define-values (constant place prepare) (albedo-source color times-share!))
  (define lobe-norm (fl/ (fl+ shininess 1.0) (TWO-PI)))
  (define inverse (fl/ 1.0 (fl+ shininess 1.0)))
  ;; a texture may be as bright as white
  (define diffuse-part
    (Float3-largest-component (if constant (Float3-in constant 0) share)))
  (define highlight-part (fl/ (Float3-largest-component peak) lobe-norm))
  (define mirror-part (Float3-largest-component mirror))
  (define total (fl+ mirror-part (fl+ highlight-part diffuse-part)))
  (define (probability [part : Flonum]) (if (fl> total 0.0) (fl/ part total) 0.0))
  (define choose-mirror (probability mirror-part))
  (define choose-highlight (probability highlight-part))
  (define choose-diffuse (probability diffuse-part))
  (define mirror-weight
    (Float3-scale-by-scalar mirror (if (fl> choose-mirror 0.0) (fl/ 1.0 choose-mirror) 0.0)))
  (define highlight-end (if (fl> choose-diffuse 0.0) (fl+ choose-mirror choose-highlight) 1.0))

  ;; value and density for in-direction
  (define-syntax-rule (put-lobes! r n out)
    (let-float3 ([d (Float3-in r in-direction)])
      (let* ([cosine (Float3-dot n d)]
             [along (Float3-dot (Float3-reflect out n) d)]
             [power (if (fl> along 0.0) (flexpt (flmin 1.0 along) shininess) 0.0)]
             [highlight (if foreshortened? (fl* cosine power) power)])
        (flvector-set! r bsdf-density
                       (fl+ (fl* choose-highlight (fl* lobe-norm power))
                            (fl* choose-diffuse (fl* (INVERSE-PI) (flmax 0.0 cosine)))))
        (if (fl> cosine 0.0)
            (Float3-put! r bsdf-weight
                         (Float3-multiply-add
                          (Float3-scale-by-scalar (Float3-in (or constant r) place)
                                                  (fl* (INVERSE-PI) cosine))
                          highlight peak))
            (Float3-put! r bsdf-weight (Float3 0.0 0.0 0.0))))))

  (: sample (-> FlVector FxVector Void))
  (define (sample r i)
    (sample-next-pair! r i)
    (let-facing-normal r (n out cosine)
      (let ([u (flvector-ref r sample-u)] [v (flvector-ref r sample-v)])
        (cond
          [(fl< u choose-mirror)
           (put-specular! r (Float3-reflect out n) mirror-weight)]
          [(fl= total 0.0) (put-nothing! r)]
          [else
           (cond
             [(fl< u highlight-end)
              (let-float3 ([axis (Float3-reflect out n)]
                           [local (warp-power-cosine
                                   (fl/ (fl- u choose-mirror) (fl- highlight-end choose-mirror))
                                   v inverse)])
                (let-frame (tangent bitangent) axis
                  (Float3-put! r in-direction (Frame-to-world tangent bitangent axis local))))]
             [else
              (let-float3 ([local (warp-cosine-hemisphere
                                   (fl/ (fl- u highlight-end) (fl- 1.0 highlight-end)) v)])
                (let-frame (tangent bitangent) n
                  (Float3-put! r in-direction (Frame-to-world tangent bitangent n local))))])
           (put-lobes! r n out)
           (let ([density (flvector-ref r bsdf-density)])
             (Float3-put! r bsdf-weight
                          (Float3-scale-by-scalar (Float3-in r bsdf-weight)
                                                  (if (fl> density 0.0) (fl/ 1.0 density) 0.0))))]))))

  (: evaluate (-> FlVector FxVector Void))
  (define (evaluate r i)
    (let-facing-normal r (n out cosine)
      (put-lobes! r n out)))

  (MaterialKernel sample evaluate
                  (and (fl= diffuse-part 0.0) (fl= highlight-part 0.0) (fl> mirror-part 0.0))
                  #f prepare))
