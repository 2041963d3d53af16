#lang typed/racket/base
;; The supertype of shapes. Each shape is a substruct in a file of its own, with its kernel.
(require "../material/material.rkt" "../material/phong.rkt" "../base/float3.rkt"
         "../base/unsafe-typed.rkt")

(provide (struct-out Shape) MaterialOrColor ->material)

(unsafe-require/typed "../base/print.rkt" [print-struct (-> Any Output-Port (U Boolean 0 1) Any)])

(struct Shape () #:transparent
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write
  (lambda ([shape : Shape] [port : Output-Port] [mode : (U Boolean 0 1)])
    (print-struct shape port mode)))

;; Where a material is expected a colour means the article's surface in that colour.
(define-type MaterialOrColor (U Material Float3))
(: ->material (-> MaterialOrColor Material))
(define (->material material)
  (if (Float3? material) (make-Phong material) material))
