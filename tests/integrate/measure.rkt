#lang racket/base
;; One radiance of a world through the path integrator, with its standard error, and the check that
;; compares it with a closed form.
(require rackunit racket/math raytrace)

(provide measure check-radiance look-from black grey)

;; The mean over seeds of the red of the picture, and its standard error.
(define (measure world camera #:samples [samples 64] #:seeds [seeds 64] #:max-depth [max-depth #f]
                 #:size [size 1])
  (define values*
    (for/list ([seed (in-range seeds)])
      (define image
        (render world camera #:width size #:height size #:samples samples #:seed seed
                #:integrator 'path #:max-depth max-depth #:schedule 'sequential))
      (for*/fold ([sum 0.0] #:result (/ sum (* size size))) ([y size] [x size])
        (define-values (red green blue) (Image-pixel image x y))
        (+ sum red))))
  (define mean (/ (apply + values*) seeds))
  (define variance
    (/ (for/sum ([v (in-list values*)]) (sqr (- v mean))) (- seeds 1)))
  (values mean (sqrt (/ variance seeds))))

;; precision: the largest standard error that will do, as a part of what is expected.
(define (check-radiance world camera expected #:samples [samples 64] #:seeds [seeds 64]
                        #:max-depth [max-depth #f] #:size [size 1] #:precision [precision +inf.0])
  (define-values (mean error)
    (measure world camera #:samples samples #:seeds seeds #:max-depth max-depth #:size size))
  ;; rounding of a sum of a few thousand numbers where there is no variance at all
  (unless (<= (abs (- mean expected)) (+ (* 4.5 error) (* 1e-12 expected)))
    (fail (format "mean ~a, standard error ~a, expected ~a" mean error expected)))
  (when (> error (* precision expected)) (fail (format "standard error ~a of ~a" error expected))))

;; A camera so narrow that it sees one point.
(define (look-from eye at #:up [up (Float3 0 1 0)])
  (Camera-look-at eye at #:up up #:vertical-field-of-view-degrees 1e-6))

(define black (Float3 0 0 0))
(define (grey albedo) (Lambertian (Float3 albedo albedo albedo)))
