#lang racket/base
;; What a texture shows at a point: seen on the unit square in z = 0, where u is x and v is y, whose
;; radiance it drives, along a ray that falls on it.
(require raytrace)
(provide unit-square shining looker seen components same-color?)

(define unit-square (list (Float3 0 0 0) (Float3 1 0 0) (Float3 0 1 0)))

(define (shining texture) (Emitter texture #:two-sided? #t))

;; A procedure from x and y, and perhaps a time, to the colour there of shapes met by rays along -z.
(define (looker . shapes)
  (define world (World shapes '() (Float3 0 0 0)))
  (lambda (x y [time 0])
    (World-ray-trace world (Ray (Float3 x y 9) (Float3 0 0 -1) time))))

;; The same for a texture on the unit square, as a list.
(define (seen texture)
  (define look
    (looker (Quad (car unit-square) (cadr unit-square) (caddr unit-square) (shining texture))))
  (lambda (x y) (components (look x y))))

(define (components color) (list (Float3-x color) (Float3-y color) (Float3-z color)))

(define (same-color? a b tolerance)
  (for/and ([x a] [y b]) (<= (abs (- x y)) tolerance)))
