#lang typed/racket/base
;; A point in a medium as a vertex of a path: the phase functions of the media there, as a material.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/frame.rkt"
         "../sample/sampler.rkt" "../sample/circle.rkt" "../material/kernel.rkt"
         "media.rkt" "phase.rkt")

(provide scattering-kernel put-medium-vertex!)

;; The point at segment-t of the segment becomes the surface in the scratch: it faces back along the
;; ray, is exact, and has no material.
(: put-medium-vertex! (-> FlVector FxVector Void))
(define (put-medium-vertex! r i)
  (let-float3 ([d (Float3-in r segment-direction)] [back (Float3-negate d)])
    (Float3-put! r surface-point
                 (Float3-multiply-add (Float3-in r segment-origin) (flvector-ref r segment-t) d))
    (Float3-put! r surface-normal back)
    (Float3-put! r surface-shading-normal back)
    (Float3-put! r out-direction back))
  (flvector-set! r surface-error 0.0)
  (fxvector-set! i surface-inside 0)
  (fxvector-set! i hit-material -1))

(define-circle-operation (around-z [cosine : Flonum] [v : Flonum])
  #:let () (flsqrt (flmax 0.0 (fl* (fl- 1.0 cosine) (fl+ 1.0 cosine)))) v cosine)

;; scattering-kernel : samples a medium of those around the ray in proportion to how much it scatters
;; at the point, then its phase function. Draws one pair.
(: scattering-kernel (-> Media MaterialKernel))
(define (scattering-kernel media)
  (define packed (Media-packed media))

  ;; By how much the k-th medium around the ray scatters, mean of the colours.
  (define-syntax-rule (weight r i k)
    (let ([at (fx+ 3 (medium-place (fxvector-ref i (fx+ media-count k))))])
      (fl* (flvector-ref r (fx+ medium-densities (fx- k 1)))
           (fl+ (flvector-ref packed at)
                (fl+ (flvector-ref packed (fx+ at 1)) (flvector-ref packed (fx+ at 2)))))))

  ;; For in-direction: what scatters there, of the whole that is scattered, and the density.
  (: evaluate (-> FlVector FxVector Void))
  (define (evaluate r i)
    (define count (fxvector-ref i media-count))
    (let ([cosine (fl* -1.0 (Float3-dot (Float3-in r in-direction) (Float3-in r out-direction)))])
      (let each ([k : Fixnum 1] [density : Flonum 0.0] [total : Flonum 0.0]
                 [red : Flonum 0.0] [green : Flonum 0.0] [blue : Flonum 0.0]
                 [all-red : Flonum 0.0] [all-green : Flonum 0.0] [all-blue : Flonum 0.0])
        (cond
          [(fx<= k count)
           (let* ([at (medium-place (fxvector-ref i (fx+ media-count k)))]
                  [phase (phase-density (flvector-ref packed (fx+ at 6)) cosine)]
                  [relative (flvector-ref r (fx+ medium-densities (fx- k 1)))]
                  [own (weight r i k)]
                  [s-red (fl* relative (flvector-ref packed (fx+ at 3)))]
                  [s-green (fl* relative (flvector-ref packed (fx+ at 4)))]
                  [s-blue (fl* relative (flvector-ref packed (fx+ at 5)))])
             (each (fx+ k 1) (fl+ density (fl* own phase)) (fl+ total own)
                   (fl+ red (fl* phase s-red)) (fl+ green (fl* phase s-green))
                   (fl+ blue (fl* phase s-blue))
                   (fl+ all-red s-red) (fl+ all-green s-green) (fl+ all-blue s-blue)))]
          [else
           (Float3-put! r bsdf-weight (Float3 (share red all-red) (share green all-green)
                                              (share blue all-blue)))
           (flvector-set! r bsdf-density (share density total))]))))

  ;; Leaves the number of a medium in the list, and in sample-u what the choice left of it.
  (: choose! (-> FlVector FxVector Fixnum))
  (define (choose! r i)
    (define count (fxvector-ref i media-count))
    (let add ([k : Fixnum 1] [total : Flonum 0.0])
      (if (fx<= k count)
          (add (fx+ k 1) (fl+ total (weight r i k)))
          (let find ([k : Fixnum 1] [left : Flonum (fl* total (flvector-ref r sample-u))])
            (let ([own (weight r i k)])
              (cond
                [(or (fl< left own) (fx= k count))
                 (flvector-set! r sample-u
                                (if (fl> own 0.0) (flmin 0.9999999999999999 (fl/ left own)) 0.0))
                 (fxvector-ref i (fx+ media-count k))]
                [else (find (fx+ k 1) (fl- left own))]))))))

  (: sample (-> FlVector FxVector Void))
  (define (sample r i)
    (sample-next-pair! r i)
    (define medium
      (if (fx= 1 (fxvector-ref i media-count)) (fxvector-ref i (fx+ 1 media-count)) (choose! r i)))
    (let* ([anisotropy (flvector-ref packed (fx+ 6 (medium-place medium)))]
           [cosine (phase-cosine anisotropy (flvector-ref r sample-u))])
      (let-float3 ([n (Float3-negate (Float3-in r out-direction))]
                   [local (around-z cosine (flvector-ref r sample-v))])
        (let-frame (tangent bitangent) n
          (Float3-put! r in-direction
                       (Float3-normalized (Frame-to-world tangent bitangent n local))))))
    (evaluate r i)
    (let ([density (flvector-ref r bsdf-density)])
      (when (fl> density 0.0)
        (Float3-put! r bsdf-weight
                     (Float3-scale-by-scalar (Float3-in r bsdf-weight) (fl/ 1.0 density))))))

  (MaterialKernel sample evaluate #f #t #f))

;; A part of a whole, 0 of nothing.
(define-syntax-rule (share part whole) (if (fl> whole 0.0) (fl/ part whole) 0.0))
