#lang racket/base
;; Worlds and rays that are hard on a hierarchy, for the tests of trace and gather.

(provide random-spheres many-scales nested-duplicates mixed-shapes
         random-rays axis-parallel-rays grazing-rays on-face-rays)

(require racket/flonum racket/list "../../main.rkt" "rays.rkt")

(define (random-point uniform size)
  (Float3 (uniform (- size) size) (uniform (- size) size) (uniform (- size) size)))

(define (random-spheres uniform count [size 10.0] [radius 0.8])
  (for/list ([k count])
    (Sphere (random-point uniform size) (uniform (* 0.1 radius) radius))))

;; Radii and distances from the origin from 1e-9 to 1e9.
(define (many-scales uniform count)
  (for/list ([k count])
    (define size (expt 10.0 (uniform -9.0 9.0)))
    (Sphere (random-point uniform (* 3.0 size)) size)))

;; Every sphere of a few is there several times, in an order of its own.
(define (nested-duplicates uniform copies)
  (define few (random-spheres uniform 12 5.0 1.5))
  (sort (for*/list ([k copies] [s few]) (Sphere (Sphere-point s) (Sphere-radius s)))
        < #:key (let ([keys (make-hasheq)])
                  (lambda (s) (hash-ref! keys s (lambda () (uniform)))))))

;; Spheres between triangles, quads, disks and boxes on whole coordinates, so that faces coincide,
;; above a plane.
(define (mixed-shapes uniform count)
  (define (whole) (floor (uniform -6.0 6.0)))
  (define (corner) (Float3 (whole) (whole) (whole)))
  (append
   (random-spheres uniform count 6.0)
   (for/list ([k count])
     (Triangle (random-point uniform 6.0) (random-point uniform 6.0) (random-point uniform 6.0)))
   (for/list ([k count]) (Quad (corner) (Float3 2.0 0.0 0.0) (Float3 0.0 0.0 2.0)))
   (for/list ([k count])
     (define low (corner))
     (Box low (Float3-add low (Float3 1.0 2.0 1.0))))
   (for/list ([k count]) (Disk (corner) (Float3 0.0 1.0 0.0) 1.5))
   (list (Plane (Float3 0.0 -3.0 0.0) (Float3 0.0 1.0 0.0)))))

;; --- rays: seven numbers each ---

(define (rays lists) (apply flvector (append* lists)))
(define (nums v) (list (Float3-x v) (Float3-y v) (Float3-z v)))
(define (random-limit uniform size)
  (if (< (uniform) 0.7) +inf.0 (uniform 0.0 (* 2.0 size))))
(define (pick uniform l) (list-ref l (inexact->exact (floor (uniform 0.0 (length l))))))

(define (random-rays uniform count size)
  (rays (for/list ([k count])
          (append (nums (random-point uniform (* 1.5 size)))
                  (nums (random-point uniform 1.0))
                  (list (random-limit uniform size))))))

;; Directions with one or two components 0 of either sign; half of the origins on whole numbers.
(define (axis-parallel-rays uniform count size)
  (rays (for/list ([k count])
          (define (component) (pick uniform '(0.0 -0.0 1.0 -1.0 0.25)))
          (define d (list (component) (component) (component)))
          (define o (nums (random-point uniform (* 1.2 size))))
          (append (if (even? k) o (map floor o))
                  (if (andmap zero? d) '(0.0 -0.0 1.0) d)
                  (list (random-limit uniform size))))))

;; Aimed at the silhouette of some sphere, off it by up to a few roundings.
(define (grazing-rays uniform count world size)
  (define spheres (World-spheres world))
  (rays (for/list ([k count])
          (define s (pick uniform spheres))
          (define o (random-point uniform (* 1.5 size)))
          (define axis (Float3-subtract (Sphere-point s) o))
          (define side (Float3-cross axis (random-point uniform 1.0)))
          (define-values (distance radius) (values (Float3-length axis) (Sphere-radius s)))
          ;; the tangent point is at radius^2 / distance before the centre
          (define sine (/ radius distance))
          (define aim
            (if (and (< sine 1.0) (> (Float3-length side) 0.0))
                (Float3-add
                 (Float3-scale-by-scalar axis (- 1.0 (* sine sine)))
                 (Float3-scale-by-scalar
                  (Float3-normalized side)
                  (* radius (sqrt (- 1.0 (* sine sine)))
                     (+ 1.0 (* (floor (uniform -4.0 5.0)) 2.2e-16)))))
                axis))
          (append (nums o) (nums aim) (list (random-limit uniform size))))))

;; From faces, edges and corners of the hierarchy's boxes, along them and through them.
(define (on-face-rays uniform count world)
  (define boxes (node-boxes world))
  (rays (for/list ([k count])
          (define box (pick uniform boxes))
          (define o
            (for/list ([axis 3])
              (define-values (low high) (values (list-ref box axis) (list-ref box (+ 3 axis))))
              (pick uniform (list low high (+ low (* (uniform) (- high low)))))))
          (define (component) (pick uniform (list 0.0 -0.0 1.0 -1.0 (uniform -1.0 1.0))))
          (define d (list (component) (component) (component)))
          (append o (if (andmap zero? d) '(-0.0 1.0 0.0) d) (list +inf.0)))))
