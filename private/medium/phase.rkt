#lang typed/racket/base
;; The phase function of Henyey and Greenstein ("Diffuse radiation in the Galaxy", 1941): where light
;; goes that a medium scatters. anisotropy g is the mean cosine of the angle it is turned by.
(require "../base/unsafe.rkt" "../sample/warp.rkt")

(provide phase-density phase-cosine)

;; Per solid angle, at that cosine between the directions before and after.
(define-syntax-rule (phase-density anisotropy cosine)
  (let* ([g anisotropy]
         [b (flmax 0.0 (fl- (fl+ 1.0 (fl* g g)) (fl* 2.0 (fl* g cosine))))])
    (fl/ (fl* (fl* 0.25 (INVERSE-PI)) (fl* (fl- 1.0 g) (fl+ 1.0 g)))
         (fl* b (flsqrt b)))))

;; The cosine that has a share u of the light at less: the inverse of the distribution, without the
;; usual division by g, so that it holds for every g.
(define-syntax-rule (phase-cosine anisotropy u)
  (let* ([g anisotropy]
         [x (fl- (fl* 2.0 u) 1.0)]
         [s (fl+ 1.0 (fl* g x))]
         [xx (fl* x x)]
         [half (fl* 0.5 g)]
         [top (fl+ (fl* x (fl+ 1.0 (fl* g g)))
                   (fl+ (fl* half (fl+ xx 3.0))
                        (fl* (fl* half (fl* g g)) (fl- xx 1.0))))])
    (flmax -1.0 (flmin 1.0 (fl/ top (fl* s s))))))
