#lang typed/racket/base
;; Rays from a surface through what was gathered around it, for the tests.
(require racket/flonum racket/fixnum
         "../../private/base/registers.rkt" "../../private/base/float3.rkt"
         "../../private/sample/sampler.rkt" "../../private/sample/warp.rkt"
         "../../private/base/frame.rkt" "../../private/integrate/seed.rkt"
         "../../private/world/world.rkt" "../../private/world/scene.rkt"
         "../../private/world/trace.rkt" "../../private/world/gather.rkt")

(provide compare-gathered)

;; Sends a ray from o along d; where it hits, gathers what is nearer than the distance and sends
;; `count` rays over the hemisphere both ways. How many spheres were gathered (-1 too many, #f for
;; no hit), how many rays hit something, and how many differ in whether or in a bit of t.
(: compare-gathered (-> World Float3 Float3 Flonum Fixnum
                        (List (U #f Fixnum) Fixnum Fixnum)))
(define (compare-gathered world o d distance count)
  (define scene (World-scene world))
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (Float3-put! r ray-origin o)
  (Float3-put! r ray-direction d)
  (flvector-set! r ray-limit +inf.0)
  (Sampler-start! i 0 0 0)
  (cond
    [(Scene-nearest! scene r i)
     (Scene-surface! scene r i)
     (face-viewer! r)
     (put-ray-from-surface! r)
     (Scene-gather! scene distance r i)
     (define gathered (fxvector-ref i gathered-count))
     (if (fx< gathered 0)
         (list gathered 0 0)
         (compare scene distance count gathered r i))]
    [else (list #f 0 0)]))

(: compare (-> Scene Flonum Fixnum Fixnum FlVector FxVector (List Fixnum Fixnum Fixnum)))
(define (compare scene distance count gathered r i)
  (let loop : (List Fixnum Fixnum Fixnum)
    ([k : Fixnum 0] [hits : Fixnum 0] [different : Fixnum 0])
    (cond
      [(fx= k count) (list gathered hits different)]
      [else
       (sample-pair! r i 1 k)
       (let-float3 ([n (Float3-in r surface-normal)]
                    [local (warp-uniform-hemisphere (flvector-ref r sample-u)
                                                    (flvector-ref r sample-v))])
         (let-frame (tangent bitangent) n
           (Float3-put! r ray-direction (Frame-to-world tangent bitangent n local))))
       (flvector-set! r ray-limit distance)
       (define near? (Scene-nearest-gathered! scene r i))
       (define t (flvector-ref r hit-t))
       (flvector-set! r ray-limit distance)
       (define own (fxvector-ref i hit-primitive))
       (define hit? (Scene-nearest! scene r i))
       (fxvector-set! i hit-primitive own)
       (loop (fx+ k 1)
             (if hit? (fx+ hits 1) hits)
             (if (and (eq? near? hit?) (or (not hit?) (eqv? t (flvector-ref r hit-t))))
                 different
                 (fx+ different 1)))])))
