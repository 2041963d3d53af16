#lang typed/racket/base
;; The supertype of lights that are not shapes, and what the inside needs of any light.
(provide (struct-out Light) (struct-out LightKernel))

(struct Light () #:transparent)

;; sample: seen from surface-point with the pair in sample-u and sample-v, writes light-direction
;; (unit), light-distance, light-radiance (already divided by the density) and light-density (per
;; solid angle, infinite for a light no scattered ray can hit); radiance 0 where nothing arrives.
;; density: the density with which sample would choose in-direction, into light-density.
;; primitive: the primitive that is this light and does not shadow itself, or -1.
(struct LightKernel
  ([sample : (-> FlVector FxVector Void)]
   [density : (-> FlVector FxVector Void)]
   [area? : Boolean]
   [primitive : Fixnum]))
