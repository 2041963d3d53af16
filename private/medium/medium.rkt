#lang typed/racket/base
;; Participating media: what fills a shape or the whole world and scatters light on its way, as fog,
;; smoke or milk.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/float3.rkt" "../base/check.rkt" "../base/public.rkt")

(provide (struct-out Medium) make-Medium Density)

;; How dense a medium is at a point, relative to its extinction.
(define-type Density (-> Float3 Real))

;; extinction: per unit of length, linear RGB: light fades as exp(-extinction distance), so its mean
;; free path is 1/extinction. albedo: the part of what is lost that is scattered and not absorbed.
;; anisotropy: the mean cosine of the scattering angle (Henyey and Greenstein 1941). density: #f for
;; the same everywhere. majorant: what density nowhere exceeds.
(struct Medium
  ([extinction : Float3] [albedo : Float3] [anisotropy : Flonum]
   [density : (U #f Density)] [majorant : Flonum])
  #:transparent)

;; (Medium extinction albedo [anisotropy density majorant]), the last three also by keyword.
;; extinction: a number, or linear RGB where colours fade differently. albedo: linear RGB, from 0
;; (smoke) to 1 (cloud). anisotropy: from -0.999 (back) over 0 (isotropic) to 0.999 (forward).
;; density: a pure function from a point to a number from 0 to majorant, which the extinction is
;; multiplied by there; what is more counts as majorant, NaN as 0. A medium with a density fills
;; shapes, not the world. The tighter the majorant, the faster.
;; Point and spot lights deep in a dense medium leave single bright pixels: light that is scattered
;; twice close to one goes as one over the squared distance at both, a finite mean of unbounded
;; samples. They are not clamped, which would darken the picture. More samples thin them out; a
;; shining sphere in place of the light bounds them.
(: make-Medium (->* ((U Real Float3) Float3)
                    (Real (U #f Density) Real
                     #:anisotropy Real #:density (U #f Density) #:majorant Real)
                    Medium))
(define (make-Medium extinction albedo
                     [anisotropy-by-place 0.0] [density-by-place #f] [majorant-by-place 1.0]
                     #:anisotropy [anisotropy anisotropy-by-place]
                     #:density [density density-by-place]
                     #:majorant [majorant majorant-by-place])
  (Medium (check-color 'Medium "extinction"
                       (if (Float3? extinction)
                           extinction
                           (make-Float3 extinction extinction extinction)))
          (check-albedo 'Medium "albedo" albedo)
          (check-between 'Medium "anisotropy" anisotropy -0.999 0.999)
          density
          (check-positive 'Medium "majorant" majorant)))

(define-constructor Medium make-Medium (extinction albedo anisotropy density majorant))
