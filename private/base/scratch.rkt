#lang typed/racket/base
;; A ray into a scratch from structs, for callers that ask one ray at a time.
(require "unsafe.rkt" "registers.rkt" "float3.rkt")

(provide put-scratch-ray!)

;; Point, direction (not checked) and no end nearer than infinity.
(: put-scratch-ray! (-> FlVector Float3 Float3 Void))
(define (put-scratch-ray! r point direction)
  (Float3-put! r ray-origin point)
  (Float3-put! r ray-direction direction)
  (flvector-set! r ray-limit +inf.0))
