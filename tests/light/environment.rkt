#lang racket/base
;; Environment maps: seen as they are, sampled as they shine.

(module+ test
  (require racket/flonum racket/math rackunit "../../main.rkt" "../../private/image/image.rkt"
           "../statistics.rkt" "light-samples.rkt")

  (define black (Float3 0 0 0))
  (define uniform (seeded 11))
  (define-values (width height) (values 16 8))
  ;; dark with some bright pixels, two of them at a pole and at the seam
  (define (picture bright)
    (define pixels (make-flvector (* 3 width height)))
    (for ([k (* 3 width height)]) (flvector-set! pixels k (uniform 0.0 0.2)))
    (for ([place bright])
      (for ([c 3]) (flvector-set! pixels (+ c (* 3 (+ (car place) (* width (cdr place))))) 50.0)))
    (make-Image width height pixels))
  (define image (picture '((5 . 2) (0 . 3) (9 . 0))))
  (define map (EnvironmentMap image))
  (define world (World '() '() map))

  (test-case "a panoramic camera that looks along -z sees the picture, to 1e-12"
    (define seen
      (render world (Camera-panoramic black (Float3 0 0 -1)) #:width width #:height height #:samples 1))
    (for ([a (in-flvector (Image-pixels seen))] [b (in-flvector (Image-pixels image))])
      (check-= a b (* 1e-12 (max 1.0 b)))))

  (test-case "turned by 90 degrees: what was at -z is at -x; scaled by 3"
    (define turned (World '() '() (EnvironmentMap image #:rotation-degrees 90 #:scale 3)))
    (for ([direction (list (Float3 0 0 -1) (Float3 0.3 0.5 -0.2) (Float3 1 -0.4 1))])
      (define left ; the same direction, turned about y
        (Float3 (Float3-z direction) (Float3-y direction) (- (Float3-x direction))))
      (check-true (<= (Float3-distance (World-ray-trace turned (Ray black left))
                                       (Float3-scale-by-scalar
                                        (World-ray-trace world (Ray black direction)) 3))
                      1e-10))))

  ;; --- sampling ---

  (define (samples count) ; of direction, radiance over density, density
    (for/list ([k count])
      (define-values (u v) (sample-point 'owen-sobol #:index k))
      (sample-light world black u v)))
  (define all (samples 16384))

  (test-case "the density a ray is told is the one it was sampled with, the radiance the one seen"
    (for ([s all] [k 2000])
      (define direction (Float3 (car s) (cadr s) (caddr s)))
      (define density (list-ref s 7))
      (check-= (Float3-length direction) 1.0 1e-15)
      (check-= (light-density-toward world black direction) density (* 1e-9 density))
      (check-= (* density (list-ref s 4)) (Float3-x (World-ray-trace world (Ray black direction)))
               1e-7)))

  (test-case "its inverse has the sphere's solid angle as mean: the density integrates to 1"
    ;; where every cell has light; the dark ones weigh most: 5 standard errors of the sample
    (define inverses (for/list ([s all]) (/ (list-ref s 7))))
    (check-= (mean inverses) (* 4 pi) (* 5 (standard-error inverses)))
    (check-true (< (standard-error inverses) 0.5)))

  (test-case "radiance over density: its mean is the mean radiance times 4 pi; it hardly varies"
    (define powers (for/list ([s all]) (/ (+ (list-ref s 4) (list-ref s 5) (list-ref s 6)) 3)))
    ;; interpolation keeps the integral over the pixels but for the change of a row's solid angle
    ;; across a cell: an independent sum over 400 x 200 directions
    (define expected
      (for*/fold ([sum 0.0]) ([y 200] [x 400])
        (define-values (latitude longitude)
          (values (* pi (- 0.5 (/ (+ y 0.5) 200))) (* 2 pi (- (/ (+ x 0.5) 400) 0.5))))
        (define seen
          (World-ray-trace world (Ray black (Float3 (* (cos latitude) (sin longitude)) (sin latitude)
                                                    (- (* (cos latitude) (cos longitude)))))))
        (+ sum (* (cos latitude) (/ pi 200) (/ (* 2 pi) 400)
                  (/ (+ (Float3-x seen) (Float3-y seen) (Float3-z seen)) 3)))))
    (check-= (mean powers) expected (* 0.002 expected))
    ;; uniform directions have a standard deviation of about 4 times the mean
    (check-true (< (standard-deviation powers) expected)))

  ;; --- in a path ---

  (test-case "irradiance on a plane: path tracing agrees with quadrature, 4 standard errors"
    (define floor (Disk (Float3 0 0 0) (Float3 0 1 0) 1 (Lambertian (Float3 0.5 0.5 0.5))))
    (define lit (World (list floor) '() map))
    (define camera (Camera-look-at (Float3 0 1 0) black #:up (Float3 0 0 1)
                                   #:vertical-field-of-view-degrees 1e-3))
    (define results
      (for/list ([seed 32])
        (define-values (red green blue)
          (Image-pixel (render lit camera #:width 1 #:height 1 #:samples 256 #:seed seed) 0 0))
        green))
    (define expected
      (for*/fold ([sum 0.0]) ([y 300] [x 600])
        (define latitude (* 0.5 pi (/ (+ y 0.5) 300)))
        (define longitude (* 2 pi (- (/ (+ x 0.5) 600) 0.5)))
        (define seen
          (World-ray-trace world (Ray black (Float3 (* (cos latitude) (sin longitude)) (sin latitude)
                                                    (- (* (cos latitude) (cos longitude)))))))
        (+ sum (* (sin latitude) (cos latitude) (/ (* 0.5 pi) 300) (/ (* 2 pi) 600)
                  (Float3-y seen)))))
    (check-mean "irradiance" results (* 0.5 (/ expected pi)) 0.012))

  (test-case "a constant picture is the constant background: a convex body of albedo a shows a L"
    (define ball (Sphere black 1 #:material (Lambertian (Float3 0.6 0.6 0.6))))
    (define constant
      (EnvironmentMap (make-Image 4 2 (make-flvector 24 0.5))))
    (define image
      (render (World (list ball) '() constant)
              (Camera-look-at (Float3 0 0 5) black #:vertical-field-of-view-degrees 10)
              #:width 8 #:height 8 #:samples 256))
    (define values (for/list ([x (in-flvector (Image-pixels image))]) x))
    (check-mean "convex body" values 0.3 0.005))

  (test-case "places are sent the picture"
    (define ball (Sphere black 1 #:material (Lambertian (Float3 0.6 0.6 0.6))))
    (define (pixels schedule)
      (Image-pixels
       (render (World (list ball) '() map) (Camera-look-at (Float3 0 0 5) black)
               #:width 8 #:height 4 #:samples 4 #:schedule schedule #:workers 2)))
    (check-equal? (pixels 'places) (pixels 'sequential)))

  (test-case "refused"
    (check-exn #rx"^EnvironmentMap[^\n]*image"
               (lambda () (EnvironmentMap (make-Image 1 1 (flvector 0.0 -1.0 0.0)))))
    (check-exn #rx"^EnvironmentMap[^\n]*scale" (lambda () (EnvironmentMap image #:scale -1)))))
