#lang typed/racket/base
;; Rays as a camera's kernel makes them, for the tests.
(require racket/flonum "../../private/base/registers.rkt" "../../private/sample/sampler.rkt"
         "../../private/world/camera.rkt" "../../private/world/camera-kernel.rkt")

(provide kernel-ray kernel-time)

;; Origin and direction through (x, y), in pixels, of a picture of that size, with the lens sample
;; of that index: six numbers.
(: kernel-ray (-> Camera Fixnum Fixnum Flonum Flonum Fixnum (Listof Flonum)))
(define (kernel-ray camera width height x y index)
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (Sampler-start! i 0 0 index)
  (flvector-set! r film-x x)
  (flvector-set! r film-y y)
  ((Camera-kernel camera width height) r i)
  (append (for/list : (Listof Flonum) ([k (in-range 3)]) (flvector-ref r (+ ray-origin k)))
          (for/list : (Listof Flonum) ([k (in-range 3)]) (flvector-ref r (+ ray-direction k)))))

;; The time in the shutter of the sample of that index, in a world where something moves.
(: kernel-time (-> Camera Fixnum Flonum))
(define (kernel-time camera index)
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (Sampler-start! i 0 0 index)
  ((Camera-kernel camera 8 8 #t) r i)
  (flvector-ref r ray-time))
