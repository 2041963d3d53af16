#lang racket/base
;; S24: sampled directions of every material against its density, by chi-square at level .01 for the
;; whole family (Sidak), independent samples. 10^5 samples in 20 x 40 bins; 10^6 in 80 x 160 when
;; RAYTRACE_STRESS is set. What the density lacks of 1 must be missing: mirrors and lost light.

(module+ test
  (require rackunit racket/flonum racket/math "support.rkt" "chi-square.rkt"
           "../../private/base/float3.rkt" "../../private/material/lambertian.rkt"
           "../../private/material/mirror.rkt" "../../private/material/metal.rkt"
           "../../private/material/dielectric.rkt" "../../private/material/plastic.rkt"
           "../../private/material/modified-phong.rkt" "../../private/material/phong.rkt"
           "../../private/material/mix.rkt")

  (define stress? (getenv "RAYTRACE_STRESS"))
  (define count (if stress? 1000000 100000))
  (define grey (make-Float3 0.5 0.4 0.3))
  (define white (make-Float3 1 1 1))
  (define plastic (make-Plastic grey))
  (define (highlight shininess) (make-ModifiedPhong grey grey shininess))

  ;; name, material, angle of incidence in degrees
  (define family
    (list (list "Lambertian" (make-Lambertian grey) 30.0)
          (list "ModifiedPhong 1" (highlight 1) 20.0)
          (list "ModifiedPhong 10" (highlight 10) 60.0)
          (list "ModifiedPhong 300" (highlight 300) 80.0)
          (list "ModifiedPhong, highlight" (make-ModifiedPhong (make-Float3 0 0 0) white 25) 45.0)
          (list "Plastic" plastic 10.0)
          (list "Plastic, grazing" plastic 80.0)
          (list "Plastic, white" (make-Plastic white #:ior 2.4) 50.0)
          (list "Phong" (make-Phong grey #:reflectivity 0.3) 45.0)
          (list "Mix" (make-Mix (make-Mix plastic (highlight 30) 0.5)
                                (make-Mix (make-Mirror) (make-Dielectric 1.5) 0.4) 0.3)
                40.0)
          (list "Metal .5" (make-Metal white 0.5) 20.0)
          (list "Metal .5, grazing" (make-Metal white 0.5) 80.0)
          (list "Metal 1" (make-Metal white 1) 50.0)))

  ;; Metal counts as specular, but its distribution is known: the part of the ball of radius fuzz
  ;; around the mirrored direction that is seen in a direction, where that is above the surface.
  (define (metal-density fuzz mirrored)
    (lambda (x y z)
      (define c (+ (* x (flvector-ref mirrored 0)) (* y (flvector-ref mirrored 1))
                   (* z (flvector-ref mirrored 2))))
      (define h-squared (- (* fuzz fuzz) (- 1.0 (* c c))))
      (cond
        [(and (> z 0.0) (> c 0.0) (> h-squared 0.0))
         (define h (sqrt h-squared))
         (define-values (near far) (values (max 0.0 (- c h)) (+ c h)))
         (/ (- (* far far far) (* near near near)) (* 4.0 pi fuzz fuzz fuzz))]
        [else 0.0])))

  (define level (sidak-level 0.01 (length family)))
  (for ([member (in-list family)])
    (define-values (name material degrees) (apply values member))
    (define b (make-bench material))
    (define out (direction-at NORMAL degrees 1.0))
    (face! b out)
    (define metal? (Metal? material))
    (define result
      (chi-square-test
       (lambda (k)
         (draw! b k)
         (define density (sampled-density b))
         (and (if metal? (= density +inf.0) (< 0.0 density +inf.0))
              (to-local NORMAL (sampled-direction b))))
       (if metal?
           (metal-density (Metal-fuzz material) (to-local NORMAL (reflected out NORMAL)))
           (lambda (x y z) (local-density b x y z)))
       count
       #:theta-bins (if stress? 80 20) #:phi-bins (if stress? 160 40)))
    (define p (chi-square-result-p result))
    (when stress? (printf "~a: p = ~a, density sums to ~a\n" name p (chi-square-result-integral result)))
    (check-true (> p level) (format "~a: p = ~a" name p))))
