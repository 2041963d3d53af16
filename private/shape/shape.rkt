#lang typed/racket/base
;; The supertype of shapes. Each shape is a substruct in a file of its own, with its kernel.
(require "../material/material.rkt" "../material/phong.rkt" "../base/float3.rkt")

(provide (struct-out Shape) MaterialOrColor ->material)

(struct Shape () #:transparent)

;; Where a material is expected a colour means the article's surface in that colour.
(define-type MaterialOrColor (U Material Float3))
(: ->material (-> MaterialOrColor Material))
(define (->material material)
  (if (Float3? material) (make-Phong material) material))
