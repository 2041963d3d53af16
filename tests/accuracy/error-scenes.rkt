#lang racket/base
;; Scenes on which errors are measured, and statistics of pictures that differ by their seed alone.

(provide (struct-out scene) error-scenes scene-named shade-scene disk-light-scene glass-scene
         picture-mean mean-square-difference mean-picture light)

(require racket/flonum racket/list "../../main.rkt"
         (prefix-in seed: "../../scenes/seed.rkt")
         (prefix-in weekend: "../../scenes/weekend.rkt")
         (prefix-in cornell: "../../scenes/cornell-diffuse.rkt")
         (prefix-in plates: "../../scenes/veach-mis.rkt"))

(struct scene (name world camera))

(define (grey x) (Float3 x x x))

;; The article's spheres, with so many occlusion rays a sample.
(define (shade-scene rays)
  (scene "seed ambient occlusion"
         (World (World-spheres seed:world) (World-lights seed:world) (World-background seed:world)
                #:ambient-samples rays)
         seed:camera))

;; Balls on a floor below a disk that shines: most of the floor is in half shadow.
(define disk-light-scene
  (scene "soft shadows under a disk light"
         (World (list (Plane (Float3 0 0 0) (Float3 0 1 0) (Lambertian (grey 0.7)))
                      (Disk (Float3 0.5 5 0.5) (Float3 0 -1 0) 1.2 (Emitter (grey 12)))
                      (Sphere (Float3 -1.3 1.2 0) 1 (Lambertian (Float3 0.8 0.3 0.2)))
                      (Sphere (Float3 1.4 1.6 -0.3) 0.8 (Lambertian (Float3 0.2 0.4 0.8)))
                      (Sphere (Float3 0.3 0.9 1.6) 0.4 (Lambertian (Float3 0.3 0.7 0.3))))
                '() (grey 0.02))
         (Camera-look-at (Float3 0 3.2 9) (Float3 0 0.8 0) #:vertical-field-of-view-degrees 36)))

;; A glass ball, a mirror and a rough metal under the sky and a lamp.
(define glass-scene
  (scene "glass and mirrors"
         (World (list (Plane (Float3 0 0 0) (Float3 0 1 0) (Lambertian (Float3 0.6 0.55 0.5)))
                      (Sphere (Float3 -1.5 1 0) 1 (Dielectric 1.5))
                      (Sphere (Float3 0.9 1 -0.8) 1 (Mirror (grey 0.9)))
                      (Sphere (Float3 0.6 0.5 1.3) 0.5 (RoughConductor 0.25 (Float3 0.9 0.7 0.4)))
                      (Sphere (Float3 2.5 4.5 2) 1 (Emitter (grey 6))))
                '() (GradientSky (grey 0.9) (Float3 0.4 0.6 1)))
         (Camera-look-at (Float3 0 2 7) (Float3 0 0.8 0) #:vertical-field-of-view-degrees 40)))

;; Veach's plates, without the lights in view: of those so few samples see a small one that a picture
;; as small as a test's knows nothing of its error.
(define plates-scene
  (scene "veach-mis, its plates" plates:world
         (Camera-look-at (Float3 0 2.2 15) (Float3 0 -3.2 1.5) #:vertical-field-of-view-degrees 17)))

(define error-scenes
  (list (shade-scene 4) disk-light-scene glass-scene
        (scene "cornell-diffuse" cornell:world cornell:camera)
        plates-scene
        (scene "weekend" weekend:world weekend:camera)))

(define (scene-named name)
  (findf (lambda (s) (equal? (scene-name s) name)) error-scenes))

;; ----------------------------------------------------------------------------------------------
;; Pictures are flvectors of pixels.

(define (light v) (for/fold ([sum 0.0]) ([x (in-flvector v)]) (fl+ sum x)))
(define (picture-mean v) (/ (light v) (flvector-length v)))

(define (mean-square-difference a b)
  (/ (for/fold ([sum 0.0]) ([x (in-flvector a)] [y (in-flvector b)])
       (fl+ sum (fl* (fl- x y) (fl- x y))))
     (flvector-length a)))

(define (mean-picture pictures)
  (define count (->fl (length pictures)))
  (define sums (make-flvector (flvector-length (car pictures))))
  (for ([v (in-list pictures)])
    (for ([x (in-flvector v)] [k (in-naturals)])
      (flvector-set! sums k (fl+ (flvector-ref sums k) x))))
  (flvector-map (lambda (x) (fl/ x count)) sums))

(define (flvector-map f v)
  (for/flvector #:length (flvector-length v) ([x (in-flvector v)]) (f x)))
