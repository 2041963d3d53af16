#lang racket/base
;; Four plates from polished to rough under four spheres of equal power, after Veach's figure (Robust
;; Monte Carlo Methods for Light Transport Simulation, 1997, chapter 9): small lights are found by
;; sampling lights, large ones in polished plates by sampling the plate, and both weighed together.
;; raco raytrace scenes/veach-mis.rkt -o veach-mis.png
(require raytrace)

(provide world camera settings)

(define eye (Float3 0 2.2 15))

;; radii by threes; the radiance makes up for the area
(define lights
  (for/list ([radius '(0.033 0.1 0.3 0.9)] [x '(-3.75 -1.25 1.25 3.75)]
             [color (list (Float3 1.0 0.55 0.35) (Float3 1.0 0.9 0.45)
                          (Float3 0.45 1.0 0.6) (Float3 0.45 0.65 1.0))])
    (Sphere (Float3 x 0 0) radius
            #:material (Emitter (Float3-scale-by-scalar color (/ 1.8 (* radius radius)))))))

;; A plate is turned so that the eye sees the row of lights in its middle.
(define (plate y z roughness)
  (define middle (Float3 0 y z))
  (define (towards point) (Float3-normalized (Float3-subtract point middle)))
  (define normal (Float3-normalized (Float3-add (towards eye) (towards (Float3 0 0 0)))))
  (define along (Float3 8 0 0))
  (define across (Float3-cross normal (Float3 1 0 0)))
  (define corner
    (Float3-subtract middle (Float3-add (Float3-scale-by-scalar along 0.5)
                                        (Float3-scale-by-scalar across 0.5))))
  (Quad corner along across
        #:material (RoughConductor roughness #:color (Float3 0.75 0.75 0.77))))

(define plates
  (for/list ([y '(-2.4 -3.06 -3.58 -3.92)] [z '(-0.1 0.95 2.25 3.6)]
             [roughness '(0.07 0.14 0.22 0.32)])
    (plate y z roughness)))

(define grey (Lambertian (Float3 0.4 0.4 0.4)))
(define room
  (list (Quad (Float3 -30 -4.3 -3) (Float3 0 0 40) (Float3 60 0 0) #:material grey)
        (Quad (Float3 -30 -4.3 -3) (Float3 60 0 0) (Float3 0 40 0) #:material grey)))

(define world (World (append lights plates room) '() (Float3 0.02 0.02 0.02)))

(define camera
  (Camera-look-at eye (Float3 0 -1.8 1.5) #:vertical-field-of-view-degrees 29))

(define settings (hash 'size '(768 512) 'samples 64))
