#lang typed/racket/base
;; Rays that leave a hit on a sphere, for the tests.
(require racket/flonum racket/fixnum
         "../../private/base/registers.rkt" "../../private/base/float3.rkt"
         "../../private/sample/sampler.rkt" "../../private/sample/warp.rkt"
         "../../private/base/frame.rkt" "../../private/integrate/seed.rkt"
         "../../private/world/world.rkt" "../../private/world/trace.rkt")

(provide spawned-hits)

;; Sends a ray from o along d at the first sphere of `seen`, and from its hit `count` rays with
;; cosine density, on the side the ray came from, into `world`. How many hit nothing, primitive 0,
;; primitive 1; and the smallest t, +inf.0 for none; #f where the first ray misses.
(: spawned-hits (-> World World Float3 Float3 Fixnum
                    (U #f (List Fixnum Fixnum Fixnum Flonum))))
(define (spawned-hits seen world o d count)
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (define scene (World-scene world))
  (Float3-put! r ray-origin o)
  (Float3-put! r ray-direction d)
  (flvector-set! r ray-limit +inf.0)
  (Sampler-start! i 0 0 0)
  (cond
    [(Scene-nearest! (World-scene seen) r i)
     (Scene-surface! (World-scene seen) r i)
     (face-viewer! r)
     (put-ray-from-surface! r)
     (let loop : (List Fixnum Fixnum Fixnum Flonum)
       ([k : Fixnum 0] [none : Fixnum 0] [first : Fixnum 0] [second : Fixnum 0]
        [smallest : Flonum +inf.0])
       (cond
         [(fx= k count) (list none first second smallest)]
         [else
          (sample-pair! r i 1 k)
          (let-float3 ([n (Float3-in r surface-normal)]
                       [local (warp-cosine-hemisphere (flvector-ref r sample-u)
                                                      (flvector-ref r sample-v))])
            (let-frame (tangent bitangent) n
              (Float3-put! r ray-direction (Frame-to-world tangent bitangent n local))))
          (flvector-set! r ray-limit +inf.0)
          (define hit? (Scene-nearest! scene r i))
          (define primitive (fxvector-ref i hit-primitive))
          (loop (fx+ k 1)
                (if hit? none (fx+ none 1))
                (if (eqv? primitive 0) (fx+ first 1) first)
                (if (eqv? primitive 1) (fx+ second 1) second)
                (if hit? (flmin smallest (flvector-ref r hit-t)) smallest))]))]
    [else #f]))
