#lang racket/base
;; The library's pictures against those of the article's tracer (tests/oracle.rkt).

(module+ test
  (require racket/flonum rackunit "../../main.rkt" "../statistics.rkt" "../oracle.rkt"
           (prefix-in seed: "../../scenes/seed.rkt"))

  (define-values (width height) (values 160 90))
  (define background (World-background-color seed:world))
  (define (oracle spheres sun samples)
    (oracle-render spheres sun background seed:camera width height samples))
  (define (library spheres sun samples)
    (define world (World spheres sun background #:ambient-samples samples))
    (Image-pixels (render world seed:camera #:width width #:height height #:samples 1)))

  (define (largest-difference a b)
    (for/fold ([largest 0.0]) ([x (in-flvector a)] [y (in-flvector b)])
      (max largest (abs (- x y)))))

  (test-case "the article's scene without occlusion samples: equal to 1e-12 in every channel"
    (define-values (spheres sun) (values (World-spheres seed:world) (World-sun seed:world)))
    (define found (library spheres sun 0))
    (check-true (<= (largest-difference found (oracle spheres sun 0)) 1e-12))
    ;; not a picture of the sky alone, nor without light or shadow
    (check-true (> (for/sum ([k (in-range 2 (flvector-length found) 3)])
                     (if (= 1.0 (flvector-ref found k)) 0 1))
                   1000)))

  (test-case "other scenes, spheres by chance and other suns: equal to 1e-11 in every channel"
    (for ([seed (stressed 3 50)])
      (define uniform (seeded seed))
      (define (point size) (Float3 (uniform (- size) size) (uniform (- size) size) (uniform (- size) 4)))
      (define spheres
        (for/list ([k 40])
          (Sphere (point 6.0) (uniform 0.2 1.5) (Float3 (uniform) (uniform) (uniform)))))
      (define sun (DistantLight (point 1.0) (Float3 (uniform) (uniform) (uniform))))
      (check-true (<= (largest-difference (library spheres sun 0) (oracle spheres sun 0)) 1e-11))))

  (test-case "with 64 occlusion samples: the same mean to 0.1%, noise of the size of its own"
    (define-values (spheres sun) (values (World-spheres seed:world) (World-sun seed:world)))
    (define found (library spheres sun 64))
    (define expected (oracle spheres sun 64))
    (check-= (/ (mean (in-flvector found)) (mean (in-flvector expected))) 1.0 1e-3)
    (define rms
      (sqrt (/ (for/sum ([x (in-flvector found)] [y (in-flvector expected)]) (* (- x y) (- x y)))
               (flvector-length found))))
    (check-true (< rms 0.02) (format "root mean square difference ~a" rms))))
