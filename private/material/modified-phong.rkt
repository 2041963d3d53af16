#lang typed/racket/base
;; ModifiedPhong: matte with a soft highlight that reflects its surroundings, as satin paint or
;; waxed wood; Phong's model made energy-conserving and reciprocal (Lafortune and Willems 1994).
;; albedo and specular: linear RGB, the parts of the light that the matte body and the highlight
;; reflect; together at most 1 in each component. shininess: exponent of the highlight, from 0 to
;; 1e9, larger is smaller and sharper; its width is about sqrt(2 / shininess) radians.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/float3.rkt" "../base/check.rkt" "../base/public.rkt"
         "../sample/warp.rkt" "material.rkt" "kernel.rkt" "phong-lobes.rkt")

(provide (struct-out ModifiedPhong) make-ModifiedPhong ModifiedPhong-kernel)

(struct ModifiedPhong Material ([albedo : Float3] [specular : Float3] [shininess : Flonum])
  #:transparent)

;; (ModifiedPhong albedo specular shininess).
(: make-ModifiedPhong (-> Float3 Float3 Real ModifiedPhong))
(define (make-ModifiedPhong albedo specular shininess)
  (check-color 'ModifiedPhong "albedo" albedo)
  (check-color 'ModifiedPhong "specular" specular)
  (unless (fl<= (Float3-largest-component (Float3-add albedo specular)) 1.0)
    (raise-expected 'ModifiedPhong "specular"
                    "a colour that with albedo adds up to at most 1 in each component" specular))
  (ModifiedPhong albedo specular
                 (check-between 'ModifiedPhong "shininess" shininess 0.0 1e9)))

(define-constructor ModifiedPhong make-ModifiedPhong (albedo specular shininess))

;; The value is albedo / pi + specular (n + 2) / (2 pi) cos^n(alpha), alpha the angle to the
;; mirrored direction. Seen along the normal it reflects albedo + specular, seen aslant less.
(: ModifiedPhong-kernel (-> ModifiedPhong MaterialKernel))
(define (ModifiedPhong-kernel material)
  (define shininess (ModifiedPhong-shininess material))
  (phong-lobes-kernel (ModifiedPhong-albedo material) (make-Float3 1 1 1)
                      (Float3-scale-by-scalar (ModifiedPhong-specular material)
                                              (fl/ (fl+ shininess 2.0) (TWO-PI)))
                      shininess #t (make-Float3 0 0 0)))
