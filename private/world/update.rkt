#lang typed/racket/base
;; Worlds and cameras that differ a little from others: functional updates.
(require "../base/float3.rkt" "../base/check.rkt" "../base/transform.rkt"
         "../shape/shape.rkt" "../light/light.rkt"
         "background.rkt" "camera.rkt" "world.rkt")

(provide World-add World-with-shapes World-with-lights World-with-background
         Camera-orbit Camera-dolly Camera-pan)

;; World-add : the world with these shapes and lights too, after those it has.
(: World-add (-> World (U Shape Light) * World))
(define (World-add world . things)
  (World-from-parts (append (World-shapes world) (filter Shape? things))
                    (append (World-lights world) (filter Light? things))
                    (World-background world) (World-shading world)
                    (World-medium world)))

;; World-with-shapes, World-with-lights : the world with these in place of its shapes, or lights;
;; shapes that shine are shapes.
(: World-with-shapes (-> World (Listof Shape) World))
(define (World-with-shapes world shapes)
  (World-from-parts shapes (World-lights world) (World-background world) (World-shading world)
                    (World-medium world)))

(: World-with-lights (-> World (U Light (Listof Light)) World))
(define (World-with-lights world lights)
  (World-from-parts (World-shapes world) (if (Light? lights) (list lights) lights)
                    (World-background world) (World-shading world)
                    (World-medium world)))

;; World-with-background : the world before another background. Its ambient colour stays, unless it
;; was the old background's: then it is the new one's.
(: World-with-background (-> World Background World))
(define (World-with-background world background)
  (when (Float3? background) (check-color 'World-with-background "background" background))
  (define shading (World-shading world))
  (define follows? (equal? (Shading-ambient-color shading)
                           (Background-color (World-background world))))
  (World-from-parts (World-shapes world) (World-lights world) background
                    (if follows?
                        (struct-copy Shading shading [ambient-color (Background-color background)])
                        shading)
                    (World-medium world)))

;; ----------------------------------------------------------------------------------------------

;; Camera-orbit : the camera carried around a point, which keeps its place in the picture: by
;; right-degrees to its own right on a circle about the vertical through the point, then by
;; up-degrees over it; past the pole it hangs upside down. #:around: the point, by default the one
;; in the middle of the picture at the focus distance. #:up: the direction of the vertical.
(: Camera-orbit (->* (Camera Real) (Real #:around (U #f Float3) #:up Float3) Camera))
(define (Camera-orbit camera right-degrees [up-degrees 0.0]
                      #:around [around #f] #:up [up (Camera-global-up)])
  (check-finite 'Camera-orbit "right-degrees" right-degrees)
  (check-finite 'Camera-orbit "up-degrees" up-degrees)
  (check-direction 'Camera-orbit "up" up)
  (define pivot (if around (check-point 'Camera-orbit "around" around) (Camera-focus camera)))
  (define turn
    (Transform-compose (Transform-rotate up #:degrees right-degrees)
                       (Transform-rotate (Camera-right camera) #:degrees (- up-degrees))))
  (define (turned [v : Float3]) (Transform-vector turn v))
  (let moved : Camera ([camera camera])
    (define end (Camera-end camera))
    (Camera-placed camera
                   (Float3-add pivot (turned (Float3-subtract (Camera-eye camera) pivot)))
                   (turned (Camera-forward camera)) (turned (Camera-right camera))
                   (turned (Camera-up camera)) (Camera-focus-distance camera)
                   (and end (moved end)))))

;; Camera-dolly : the camera moved forward by so many world units, or back. What it is focused on
;; stays sharp while it is ahead.
(: Camera-dolly (-> Camera Real Camera))
(define (Camera-dolly camera distance)
  (check-finite 'Camera-dolly "distance" distance)
  (define step (Float3-scale-by-scalar (Float3-normalized/checked (Camera-forward camera))
                                       (real->double-flonum distance)))
  (let moved : Camera ([camera camera])
    (define end (Camera-end camera))
    (define focus (- (Camera-focus-distance camera) distance))
    (Camera-placed camera (Float3-add (Camera-eye camera) step)
                   (Camera-forward camera) (Camera-right camera) (Camera-up camera)
                   (if (> focus 0.0) focus (Camera-focus-distance camera))
                   (and end (moved end)))))

;; Camera-pan : the camera moved sideways by so many world units to its right and up; it looks in
;; the same direction.
(: Camera-pan (->* (Camera Real) (Real) Camera))
(define (Camera-pan camera right [up 0.0])
  (check-finite 'Camera-pan "right" right)
  (check-finite 'Camera-pan "up" up)
  (define step
    (Float3-add (Float3-scale-by-scalar (Float3-normalized/checked (Camera-right camera))
                                        (real->double-flonum right))
                (Float3-scale-by-scalar (Float3-normalized/checked (Camera-up camera))
                                        (real->double-flonum up))))
  (let moved : Camera ([camera camera])
    (define end (Camera-end camera))
    (Camera-placed camera (Float3-add (Camera-eye camera) step)
                   (Camera-forward camera) (Camera-right camera) (Camera-up camera)
                   (Camera-focus-distance camera) (and end (moved end)))))

;; The point in the middle of the picture that is sharp.
(: Camera-focus (-> Camera Float3))
(define (Camera-focus camera)
  (Float3-multiply-add (Camera-eye camera) (Camera-focus-distance camera)
                       (Float3-normalized/checked (Camera-forward camera))))

;; The same camera at another place.
(: Camera-placed (-> Camera Float3 Float3 Float3 Float3 Real (U #f Camera) Camera))
(define (Camera-placed camera eye forward right up focus-distance end)
  (make-Camera eye forward right up
               #:lens-radius (Camera-lens-radius camera) #:focus-distance focus-distance
               #:blades (Camera-blades camera)
               #:projection (Camera-projection camera) #:angle (Camera-angle camera)
               #:shutter-open (Camera-shutter-open camera)
               #:shutter-close (Camera-shutter-close camera) #:end end))
