#lang typed/racket/base
;; GGX distribution, masking and visible normals, against their definitions.

(module+ test
  (require typed/rackunit typed/racket/unsafe racket/math
           "../../private/base/unsafe.rkt" "../../private/base/float3.rkt"
           "../../private/material/microfacet.rkt")
  (unsafe-require/typed "chi-square.rkt"
    [#:struct chi-square-result ([p : Flonum] [integral : Flonum] [missing : Integer])]
    [chi-square-test (-> (-> Fixnum FlVector) (-> Flonum Flonum Flonum Flonum) Integer
                         chi-square-result)]
    [sidak-level (-> Flonum Integer Flonum)])
  (unsafe-require/typed "../../private/material/energy.rkt"
    [gauss-legendre (-> Positive-Integer FlVector)])

  (: check-relative (-> Flonum Flonum Flonum String Any))
  (define (check-relative found expected tolerance message)
    (check-true (fl<= (flabs (fl- found expected)) (fl* tolerance (flabs expected)))
                (format "~a: ~a, expected ~a" message found expected)))

  (define ALPHAS : (Listof Flonum) '(1e-4 1e-3 0.01 0.1 0.5 1.0))
  (define COSINES : (Listof Flonum) '(1e-12 1e-6 1e-3 0.03 0.5 0.999 1.0))
  (define (exact [x : Flonum]) : Exact-Rational (inexact->exact x))

  ;; The integral of a function over slopes tan(theta) = alpha t, from normal to grazing, by a rule
  ;; of 200 points in t / (1 + t).
  (define rule (gauss-legendre 200))
  (: over-slopes (-> Flonum (-> Flonum Flonum) Flonum))
  (define (over-slopes alpha f)
    (for/fold ([sum : Flonum 0.0]) ([k (in-range 200)])
      (define w (flvector-ref rule (* 2 k)))
      (define rest (fl- 1.0 w))
      (fl+ sum (fl* (fl/ (flvector-ref rule (+ 1 (* 2 k))) (fl* rest rest))
                    (fl* alpha (f (fl/ (fl* alpha w) rest)))))))

  (test-case "D: against exact rationals, to 1e-15, and 1 / (pi alpha^2) at the normal"
    (for* ([alpha ALPHAS] [sine : Flonum '(0.0 1e-9 1e-4 0.01 0.7 1.0)])
      (define s (fl* sine sine))
      (define c (fl- 1.0 s))
      (define a (* (exact alpha) (exact alpha)))
      (define length (+ (exact s) (* a (exact c))))
      (check-relative (GGX-distribution s c alpha)
                      (real->double-flonum (/ a (* (exact pi) length length))) 1e-15 "D"))
    (check-relative (GGX-distribution 0.0 1.0 0.01) (fl/ 1e4 pi) 1e-15 "D at the normal"))

  (test-case "projected areas of the microfacets sum to 1, to 1e-12"
    (for ([alpha ALPHAS])
      (check-relative
       (over-slopes alpha
                    (lambda ([slope : Flonum])
                      (let* ([c-squared (fl/ 1.0 (fl+ 1.0 (fl* slope slope)))]
                             [s-squared (fl* slope (fl* slope c-squared))])
                        ;; 2 pi sine cosine dtheta is 2 pi slope c^4 dslope
                        (fl* (fl* (fl* 2.0 pi) (GGX-distribution s-squared c-squared alpha))
                             (fl* slope (fl* c-squared c-squared))))))
       1.0 1e-12 "area")))

  (test-case "Lambda by its definition (60 digits) to 1e-15, and GGX-length = cosine (1 + 2 Lambda)"
    (: square-root (-> Exact-Rational Exact-Rational)) ; of a positive number, to about 60 digits
    (define (square-root x)
      (let improve ([y : Exact-Rational (exact (flsqrt (real->double-flonum x)))] [steps : Integer 2])
        (if (= steps 0) y (improve (/ (+ y (/ x y)) 2) (- steps 1)))))
    (for* ([alpha ALPHAS] [cosine COSINES])
      (define a (exact alpha))
      (define c (exact cosine))
      (define tangent-squared (* a a (/ (- 1 (* c c)) (* c c))))
      (define lambda-exact (/ (- (square-root (+ 1 tangent-squared)) 1) 2))
      (check-relative (GGX-lambda cosine alpha) (real->double-flonum lambda-exact) 1e-15 "Lambda")
      (check-relative (GGX-length cosine alpha)
                      (real->double-flonum (* c (+ 1 (* 2 lambda-exact)))) 1e-15 "length")))

  (test-case "masking and what is masked, from Lambda, to 1e-12"
    (for* ([alpha ALPHAS] [o COSINES] [i COSINES])
      (define-values (lo li) (values (GGX-lambda o alpha) (GGX-lambda i alpha)))
      (define g2 (fl/ 1.0 (fl+ 1.0 (fl+ lo li))))
      (define o-length (GGX-length o alpha))
      (check-relative (fl* o (GGX-masking o o-length i (GGX-length i alpha))) g2 1e-12 "G2")
      (check-relative (GGX-masked-share o o-length i alpha) (fl* li g2) 1e-12 "1 - G2 / G1")))

  (test-case "visible normals: unit, visible, finite, also at grazing and at corners of the square"
    (define last (fl- 1.0 2.3283064365386963e-10))
    (for* ([alpha ALPHAS] [cosine : Flonum (cons 0.0 COSINES)]
           [u : Flonum (list 0.0 1e-9 0.3 0.999 last)] [v : Flonum (list 0.0 0.25 0.5 0.8 last)])
      (let-float3 ([o (Float3 (flsqrt (fl- 1.0 (fl* cosine cosine))) 0.0 cosine)])
        (let-visible-normal h (o alpha u v)
          (let ([length (Float3-length h)] [facing (Float3-dot o h)] [z (Float3-z h)])
            (check-true (fl<= (flabs (fl- length 1.0)) 4e-16))
            (check-true (fl> z 0.0))
            ;; the last u leaves 2^-32 of the cap: what is left has 21 bits
            (check-true (fl>= facing (if (fl= u last) -1e-6 -1e-15))
                        (format "~a ~a ~a ~a: ~a" alpha cosine u v facing)))))))

  (test-case "chi-square of 10^5 visible normals, level .01 for all; their density sums to 1 (1e-5)"
    (define generator (vector->pseudo-random-generator (vector 1 2 3 4 5 6)))
    (define family : (Listof (List Flonum Flonum))
      '((0.05 1.0) (0.2 0.7) (0.2 0.1) (1.0 1.0) (1.0 0.5) (1.0 0.01)))
    (for ([member family])
      (define alpha (car member))
      (define cosine (cadr member))
      (define sine (flsqrt (fl- 1.0 (fl* cosine cosine))))
      (define result
        (chi-square-test
         (lambda ([k : Fixnum])
           (define-values (u v) (values (random generator) (random generator)))
           (let-float3 ([o (Float3 sine 0.0 cosine)])
             (let-visible-normal h (o alpha u v)
               (flvector (Float3-x h) (Float3-y h) (Float3-z h)))))
         (lambda ([x : Flonum] [y : Flonum] [z : Flonum])
           (define facing (fl+ (fl* sine x) (fl* cosine z)))
           (if (and (fl> facing 0.0) (fl> z 0.0))
               (GGX-visible-density
                cosine (GGX-length cosine alpha) facing
                (GGX-distribution (fl+ (fl* x x) (fl* y y)) (fl* z z) alpha))
               0.0))
         100000))
      (define p (chi-square-result-p result))
      (check-true (> p (sidak-level 0.01 (length family))) (format "~a: p = ~a" member p))
      (check-relative (chi-square-result-integral result) 1.0 1e-5 (format "~a" member)))))
