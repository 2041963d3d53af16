#lang racket/base
;; S18: the article's scene at other scales. By powers of two the picture is the same to the bit;
;; by powers of ten every channel is within 1e-10, but for at most 3 of the 2304 pixels, whose
;; rays decide on an edge.

(module+ test
  (require racket/flonum rackunit "../../main.rkt"
           (only-in "../../private/world/world.rkt" World-shading Shading-max-occlusion-distance)
           (prefix-in seed: "../../scenes/seed.rkt"))

  (define (scaled v s) (Float3-scale-by-scalar v s))
  (define reach (Shading-max-occlusion-distance (World-shading seed:world)))

  (define (picture scale)
    (define world
      (World (for/list ([s (World-spheres seed:world)])
               (Sphere (scaled (Sphere-point s) scale) (* scale (Sphere-radius s)) (Sphere-material s)))
             (World-lights seed:world) (World-background seed:world)
             #:max-occlusion-distance (* scale reach) #:ambient-samples 8))
    (define c seed:camera)
    (define camera
      (Camera (scaled (Camera-eye c) scale) (Camera-forward c) (Camera-right c) (Camera-up c)))
    (Image-pixels (render world camera #:width 64 #:height 36 #:samples 1)))

  (define reference (picture 1.0))

  (test-case "there is something to see: at least 40 spheres' pixels and as many sky's"
    (define sky (for/sum ([k 2304]) (if (= 0.45 (flvector-ref reference (* 3 k))) 1 0)))
    (check-true (< 40 sky 2264)))

  (for ([exponent '(-300 -60 -30 -1 1 30 60 300)])
    (test-case (format "by 2^~a: identical to the bit" exponent)
      (check-equal? (picture (expt 2.0 exponent)) reference)))

  (for ([scale '(1e-9 1e-6 1e6 1e9)])
    (test-case (format "by ~a: within 1e-10 but for 3 pixels" scale)
      (define other (picture scale))
      (define different
        (for/sum ([k 2304])
          (if (for/and ([c 3])
                (define-values (a b)
                  (values (flvector-ref reference (+ c (* 3 k))) (flvector-ref other (+ c (* 3 k)))))
                (<= (abs (- a b)) (* 1e-10 (max (abs a) (abs b)))))
              0
              1)))
      (check-true (<= different 3) (format "~a pixels differ" different)))))
