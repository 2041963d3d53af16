#lang racket/base
;; Rays that leave a flat surface or a box, by which the tests of those count self-intersections.

(provide float3 float3->list unit placed count-spawned (struct-out counts))

(require "probe.rkt" "axial-checks.rkt" "../../private/base/float3.rkt")

;; Points between the tests' lists of three flonums and the library's.
(define (float3 p) (apply make-Float3 p))
(define (float3->list p) (list (Float3-x/function p) (Float3-y/function p) (Float3-z/function p)))

(define (unit v) (scale (/ 1.0 (norm v)) v))

;; The points moved by the offset along every axis, then scaled.
(define (placed points size offset)
  (for/list ([p points]) (for/list ([x p]) (* size (+ x offset)))))

;; Rays that left the shape, those that met it again, those that passed through a second surface.
(struct counts (rays again leaked) #:transparent)

;; From each hit of `count` rays that `aim` makes (a procedure that returns origin and direction)
;; one cosine-distributed ray leaves on each of the `sides`: 1.0 for the side the ray came from,
;; -1.0 for the other. `again?` tells from the surface left and the surface met whether that is a
;; self-intersection. The ray must also meet the probe that `beyond` makes of the sign of the
;; normal on its side, where that is given.
(define (count-spawned probe count uniform aim
                       #:sides [sides '(1.0 -1.0)]
                       #:again? [again? (lambda (left met) #t)]
                       #:beyond [beyond #f])
  (for*/fold ([total (counts 0 0 0)]) ([k (in-range count)] [side (in-list sides)])
    (define-values (origin direction) (aim))
    (cond
      [(shoot probe origin direction)
       (define left (surface-at probe))
       (define facing (if (< (dot (Surface-normal left) direction) 0.0) side (- side)))
       (define normal (scale facing (Surface-normal left)))
       (define from (add (Surface-point left) (scale (Surface-error left) normal)))
       (define onward (cosine-direction uniform normal))
       (define again (and (shoot probe from onward) (again? left (surface-at probe))))
       (define leaked (and beyond (not (shoot (beyond facing) from onward))))
       (counts (+ 1 (counts-rays total))
               (+ (if again 1 0) (counts-again total))
               (+ (if leaked 1 0) (counts-leaked total)))]
      [else total])))
