#lang racket/base
;; The article's Phong surface as the path integrator has it. Its distribution is tested in
;; sampling.rkt.

(module+ test
  (require rackunit racket/flonum racket/math "support.rkt" "properties.rkt"
           "../../private/base/float3.rkt" "../../private/material/phong.rkt"
           "../../private/material/kernel.rkt")

  ;; D17: the lighting of "The Ray Tracer Challenge": times pi, the value is kd cos + ks (r.v)^n;
  ;; its ambient part .1 is no matter of the surface
  (test-case "D17: to 1e-12"
    (define b (make-bench (make-Phong (make-Float3 0.9 0.9 0.9) 0.9 200)))
    (define n (flvector 0.0 0.0 -1.0))
    (define s (sqrt 0.5))
    (define up (flvector 0.0 s (- s)))
    (define down (flvector 0.0 (- s) (- s)))
    (for ([out (list n n down up n)]
          [in (list n up up n (flvector 0.0 0.0 1.0))]
          [expected '(1.9 0.7363961030678928 1.6363961030678928 1.0 0.1)])
      (face! b out #:normal n)
      (evaluate! b in)
      (check-= (+ 0.1 (* pi (flvector-ref (sampled-weight b) 0))) expected 1e-12)))

  (define b (make-bench (make-Phong (make-Float3 0.6 0.3 0.1) 0.3 16
                                    (make-Float3 0.5 0.2 0.0))))

  (test-case "furnace at ten angles: mirror's share, and what quadrature says of the rest"
    (for ([degrees INCIDENCES])
      (face! b (direction-at NORMAL degrees))
      (check-furnace b 16384 (list (+ 0.5 (value-integral b 0))) degrees)))

  (test-case "along the normal, color + 2 specularity / (shininess + 1), to 1e-6"
    (define plain (make-bench (make-Phong (make-Float3 0.6 0.3 0.1) 0.3 16)))
    (face! plain NORMAL)
    (for ([color '(0.6 0.3 0.1)] [k 3])
      (check-= (value-integral plain k) (+ color (/ 0.6 17.0)) 1e-6)))

  (test-case "sample and evaluate agree"
    (for ([degrees INCIDENCES])
      (face! b (direction-at NORMAL degrees))
      (check-consistency b 300)))

  (test-case "reflectivity 1 is a mirror"
    (define mirror (make-bench (make-Phong (make-Float3 0.6 0.3 0.1) #:reflectivity 1)))
    (check-true (MaterialKernel-specular? (bench-kernel mirror)))
    (face! mirror (direction-at NORMAL 40.0))
    (draw! mirror 1)
    (check-equal? (sampled-weight mirror) (flvector 1.0 1.0 1.0))
    (check-true (specular-sample? mirror))))
