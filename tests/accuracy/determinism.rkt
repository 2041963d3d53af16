#lang racket/base
;; S27: the same bits whatever the schedule, the number of workers, the tiles, the run; crops are
;; parts of the whole picture.

(module+ test
  (require racket/flonum rackunit "../../main.rkt" "../statistics.rkt")

  (define uniform (seeded 1))
  (define spheres
    (for/list ([k 30])
      (Sphere (Float3 (uniform -4.0 4.0) (uniform -2.0 2.0) (uniform -4.0 4.0))
              (uniform 0.2 0.9)
              (Phong (Float3 (uniform) (uniform) (uniform))
                     #:reflectivity (if (< (uniform) 0.3) 0.6 0)))))
  (define lamp (Sphere (Float3 3 5 2) 0.8 (Emitter (Float3 12 11 10))))
  (define world
    (World (cons lamp spheres)
           (list (DistantLight (Float3 1 2 1) (Float3 0.5 0.5 0.5))
                 (PointLight (Float3 -4 4 4) (Float3 5 5 5)))
           (GradientSky (Float3 1 1 1) (Float3 0.5 0.7 1))
           #:ambient-samples 4 #:shadow-samples 3))
  (define camera
    (Camera-look-at (Float3 0 2 10) (Float3 0 0 0) #:lens-radius 0.1 #:focus-distance 9))

  (define-values (width height) (values 67 38))
  (define (picture #:seed [seed 1] . settings)
    (define-values (schedule workers tile integrator) (apply values settings))
    (Image-pixels (render world camera #:width width #:height height #:samples 2 #:seed seed
                          #:schedule schedule #:workers workers #:tile tile
                          #:integrator integrator)))

  ;; equal? on flvectors tells 0.0 from -0.0 and finds NaN equal to itself: bits, but for NaN's.
  (for ([integrator '(seed ambient-occlusion path)])
    (test-case (format "~a: the bits of one worker, for 1, 2, 3, 7, 16 workers and tiles of 1 to 64"
                       integrator)
      (define reference (picture 'sequential 1 16 integrator))
      (check-true (for/or ([v (in-flvector reference)]) (not (= v (flvector-ref reference 0)))))
      (for ([workers '(1 2 3 7 16)])
        (check-equal? (picture 'futures workers 16 integrator) reference
                      (format "~a workers" workers)))
      (for ([tile '(1 2 3 5 8 31 64)])
        (check-equal? (picture 'sequential 1 tile integrator) reference (format "tile ~a" tile))
        (check-equal? (picture 'futures 3 tile integrator) reference
                      (format "tile ~a, 3 workers" tile)))))

  (test-case "places: the same bits as one worker, with an odd tile size"
    (check-equal? (picture 'places 2 7 'seed) (picture 'sequential 1 16 'seed)))

  (test-case "another seed, another picture"
    (check-not-equal? (picture 'sequential 1 16 'seed #:seed 2) (picture 'sequential 1 16 'seed)))

  (test-case "a crop is that part of the whole picture, to the bit"
    (define whole (picture 'sequential 1 16 'seed))
    (define part
      (Image-pixels (render world camera #:width width #:height height #:samples 2 #:seed 1
                            #:integrator 'seed #:crop '(20 7 31 18))))
    (for* ([y 18] [x 31] [c 3])
      (check-eqv? (flvector-ref part (+ c (* 3 (+ x (* 31 y)))))
                  (flvector-ref whole (+ c (* 3 (+ 20 x (* width (+ 7 y)))))))))

  (test-case "a ray asked for by itself is the ray of a render: pixel centres, no sampled effect"
    (define plain
      (World spheres (DistantLight (Float3 1 2 1) (Float3 1 1 1)) (Float3 0.3 0.4 0.5)
             #:ambient-samples 0))
    (define pinhole (Camera-look-at (Float3 0 2 10) (Float3 0 0 0) #:aspect (/ 40 20)))
    (define image (render plain pinhole #:width 40 #:height 20 #:samples 1))
    (for* ([x 40] [y 20])
      (define-values (red green blue) (Image-pixel image x y))
      (define alone (World-ray-trace plain (Camera-ray pinhole (/ (+ x 0.5) 40) (/ (+ y 0.5) 20))))
      (check-= (Float3-x alone) red 1e-12)
      (check-= (Float3-y alone) green 1e-12)
      (check-= (Float3-z alone) blue 1e-12))))
