#lang racket/base
;; A mesh file as a scene: the mesh stands in the middle of a studio floor, under three lights.
(require racket/flonum racket/math "line.rkt" "progress.rkt"
         "../../main.rkt" "../shape/kernel.rkt" (only-in "../shape/kernels.rkt" Shape-kernel))

(provide load-studio)

;; load-studio : the world, the camera and the settings in which the mesh file is shown. The mesh becomes 2 units large. OBJ and PLY files have y upwards, STL
;; files z. A file without normals is shown with smooth ones. Warnings of the reader go to standard
;; error, a line each. show?: whether to draw progress there. Raises exn:fail:user with one line where
;; the file cannot be read or is empty.
(define (load-studio path show?)
  (define upright
    (if (regexp-match? #rx"[.](?i:stl)$" path)
        (Transform-rotate (Float3 1 0 0) #:degrees -90)
        (Transform-identity)))
  (define part 0)
  (define warnings '())
  (define mesh
    (call-with-progress
     show?
     (lambda (watch)
       (watch (lambda () part))
       (Mesh-read path #:smooth? #t #:progress (lambda (now) (set! part now))
                  #:warn (lambda (line) (set! warnings (cons line warnings)))))))
  (for ([line (in-list (reverse warnings))])
    (eprintf "raytrace: ~a\n" (one-line line)))
  (define standing (Instance mesh upright))
  (define bounds (ShapeKernel-bounds (Shape-kernel standing)))
  (define-values (low high) (values (corner bounds 0) (corner bounds 3)))
  (define size (apply max (map - high low)))
  (define scale (/ 2.0 size))
  (define centred
    (Transform-compose
     (Transform-scale scale)
     (Transform-translate (- (/ (+ (car low) (car high)) 2)) (- (cadr low))
                          (- (/ (+ (caddr low) (caddr high)) 2)))))
  (define height (* scale (- (cadr high) (cadr low))))
  (values (World (list* (Instance standing centred)
                        (Disk (Float3 0 0 0) (Float3 0 1 0) 40 (Lambertian (Float3 0.55 0.55 0.55)))
                        (lights height))
                 '() (Float3 0.25 0.27 0.3))
          (studio-camera height)
          (hash 'size '(640 480) 'samples 64 'integrator 'path)))

(define (corner bounds at) (for/list ([k (in-range 3)]) (flvector-ref bounds (+ at k))))

;; Key, fill and rim: warm from the left, cool from the right, bright from behind.
(define (lights height)
  (define middle (Float3 0 (/ height 2) 0))
  (list (softbox (Float3 -4 6 5) middle 1.6 (Float3 17 15.5 13))
        (softbox (Float3 6 3 4) middle 1.6 (Float3 3 3.6 4.5))
        (softbox (Float3 2 5 -6) middle 1.2 (Float3 14 14 15))))

;; A disk that shines towards a point.
(define (softbox place towards radius radiance)
  (Disk place (Float3-subtract towards place) radius (Emitter radiance)))

;; Far enough to see a ball around the mesh whole.
(define (studio-camera height)
  (define middle (Float3 0 (* 0.5 height) 0))
  (define radius (* 0.5 (sqrt (+ 8.0 (* height height)))))
  (define from (Float3-normalized (Float3 0.55 0.35 1)))
  (define distance (/ radius (sin (degrees->radians 15))))
  (Camera-look-at (Float3-add middle (Float3-scale-by-scalar from distance)) middle
                  #:vertical-field-of-view-degrees 30))
