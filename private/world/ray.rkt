#lang typed/racket/base
;; Rays and what they hit.
(require (for-syntax racket/base)
         "../base/float3.rkt" "../base/check.rkt" "../base/public.rkt")

(provide (struct-out Ray) make-Ray Ray-point-at
         (struct-out Intersection) make-Intersection Intersection-empty
         INTERSECTION-T-MAX EPSILON)

;; A ray of light backwards: a point and a direction of any length other than zero. `time` is the
;; moment in the shutter, from 0 to 1.
(struct Ray ([point : Float3] [direction : Float3] [time : Flonum]) #:transparent)

(: make-Ray (->* (Float3 Float3) (Real) Ray))
(define (make-Ray point direction [time 0.0])
  (Ray (check-point 'Ray "point" point)
       (check-direction 'Ray "direction" direction)
       (check-between 'Ray "time" time 0.0 1.0)))

(define-constructor Ray make-Ray (point direction time))

;; The point at parameter t, point + t direction; a distance where the direction is a unit vector.
(: Ray-point-at (-> Ray Real Float3))
(define (Ray-point-at ray t)
  (Float3-multiply-add (Ray-point ray) (real->double-flonum t) (Ray-direction ray)))

;; The nearest hit of a ray: its parameter, the point, the outward unit normal and the colour.
(struct Intersection ([t : Flonum] [point : Float3] [normal : Float3] [color : Float3])
  #:transparent)

(: make-Intersection (-> Real Float3 Float3 Float3 Intersection))
(define (make-Intersection t point normal color)
  (Intersection (real->double-flonum t) point normal color))

(define-constructor Intersection make-Intersection (t point normal color))

;; Beyond every scene; the t of an Intersection that is none.
(define INTERSECTION-T-MAX : Flonum 1.0e300)

(: Intersection-empty (-> Intersection))
(define (Intersection-empty)
  (define zero (make-Float3 0 0 0))
  (Intersection INTERSECTION-T-MAX zero zero zero))

;; The article's fixed offset from a surface, kept for its readers. The library itself offsets
;; rays by an error bound of the hit, because no fixed number is right at every scale.
(define EPSILON : Flonum 1.0e-6)
