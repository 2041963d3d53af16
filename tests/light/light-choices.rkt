#lang typed/racket/base
;; How a world's lights are chosen, for the tests: probabilities, choices, and what they estimate.
(require racket/flonum racket/fixnum
         "../../private/base/registers.rkt" "../../private/base/float3.rkt"
         "../../private/sample/sampler.rkt" "../../private/light/light.rkt"
         "../../private/light/choice.rkt"
         "../../private/world/world.rkt" "../../private/world/scene.rkt")

(provide light-count light-probabilities light-choices irradiance-samples bytes-per-choice)

(: scratch (-> Float3 Float3 (Values FlVector FxVector)))
(define (scratch point normal)
  (define-values (r i) (values (make-flonum-registers) (make-fixnum-registers)))
  (Float3-put! r surface-point point)
  (Float3-put! r surface-normal normal)
  (values r i))

(: light-count (-> World Index))
(define (light-count world) (vector-length (Scene-lights (World-scene world))))

;; The probability of every light.
(: light-probabilities (-> World Float3 Float3 Boolean (Listof Flonum)))
(define (light-probabilities world point normal transmits?)
  (define-values (r i) (scratch point normal))
  (define choice (Scene-light-choice (World-scene world)))
  (for/list ([k : Nonnegative-Fixnum (in-range (light-count world))])
    (put-light-probability! choice k transmits? r)
    (flvector-ref r (light-probability))))

;; How often each light is chosen, and the probability a choice reported for it (0 if never).
(: light-choices (-> World Float3 Float3 Boolean Index Fixnum
                     (Values (Listof Fixnum) (Listof Flonum))))
(define (light-choices world point normal transmits? count seed)
  (define-values (r i) (scratch point normal))
  (define choice (Scene-light-choice (World-scene world)))
  (define counts (make-fxvector (light-count world) 0))
  (define reported (make-flvector (light-count world) 0.0))
  (for ([k : Nonnegative-Fixnum (in-range count)])
    ;; a key for every choice, so that they are independent of each other
    (Sampler-start! i k seed 0)
    (sample-next-pair! r i)
    (let ([light (choose-light! choice transmits? r)])
      (fxvector-set! counts light (fx+ 1 (fxvector-ref counts light)))
      (flvector-set! reported light (flvector-ref r (light-probability)))))
  (values (for/list ([n (in-fxvector counts)]) n) (for/list ([p (in-flvector reported)]) p)))

;; Independent estimates of the red irradiance, nothing in between, from one light and one point
;; on it each; uniform?: the light is chosen uniformly.
(: irradiance-samples (-> World Float3 Float3 Index Fixnum Boolean (Listof Flonum)))
(define (irradiance-samples world point normal count seed uniform?)
  (define-values (r i) (scratch point normal))
  (define scene (World-scene world))
  (define lights (Scene-lights scene))
  (define choice (Scene-light-choice scene))
  (for/list ([k : Nonnegative-Fixnum (in-range count)])
    (Sampler-start! i k seed 0)
    (sample-next-pair! r i)
    (define light
      (if uniform?
          (fl->fx (floor (fl* (flvector-ref r sample-u) (fx->fl (vector-length lights)))))
          (choose-light! choice #f r)))
    (define probability
      (if uniform? (fl/ 1.0 (fx->fl (vector-length lights))) (flvector-ref r (light-probability))))
    (sample-next-pair! r i)
    ((LightKernel-sample (vector-ref lights light)) r i)
    (define cosine (Float3-dot (Float3-in r light-direction) normal))
    (if (fl> cosine 0.0)
        (fl/ (fl* cosine (flvector-ref r light-radiance)) probability)
        0.0)))

;; What a choice allocates, with the probability of the chosen light asked for again.
(: bytes-per-choice (-> World Float3 Float3 Fixnum Flonum))
(define (bytes-per-choice world point normal count)
  (define-values (r i) (scratch point normal))
  (define choice (Scene-light-choice (World-scene world)))
  (Sampler-start! i 0 0 0)
  (: run (-> Fixnum Void))
  (define (run count)
    (let next ([k : Fixnum 0])
      (when (fx< k count)
        (sample-pair! r i 0 k)
        (put-light-probability! choice (choose-light! choice #f r) #f r)
        (next (fx+ k 1)))))
  (run 100)
  (define before (current-memory-use 'cumulative))
  (run count)
  (fl/ (real->double-flonum (- (current-memory-use 'cumulative) before)) (fx->fl count)))
