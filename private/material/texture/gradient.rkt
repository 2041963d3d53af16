#lang typed/racket/base
;; A colour that turns into another along v, or from one point to another.
(require (for-syntax racket/base)
         "../../base/unsafe.rkt" "../../base/registers.rkt" "../../base/float3.rkt"
         "../../base/check.rkt" "../../base/public.rkt" "texture.rkt")

(provide (struct-out GradientTexture) make-GradientTexture GradientTexture-kernel)

;; first, second: what is seen up to v = 0 and from v = 1 on, or, where start and end are given, in
;; the planes through them that are square to the line between them, in the space the shape is
;; made in.
(struct GradientTexture Texture
  ([first : Float3] [second : Float3] [start : (U #f Float3)] [end : (U #f Float3)])
  #:transparent)

;; (GradientTexture first second [start end]).
(: make-GradientTexture (->* (Float3 Float3)
                             ((U #f Float3) (U #f Float3)
                              #:start (U #f Float3) #:end (U #f Float3))
                             GradientTexture))
(define (make-GradientTexture first second [start-by-place #f] [end-by-place #f]
                              #:start [start start-by-place] #:end [end end-by-place])
  (check-color 'GradientTexture "first" first)
  (check-color 'GradientTexture "second" second)
  (cond
    [(and start end)
     (check-point 'GradientTexture "start" start)
     (check-point 'GradientTexture "end" end)
     (let ([squared (Float3-length-squared (Float3-subtract end start))])
       (unless (and (fl> squared 0.0) (fl< squared +inf.0))
         (raise-expected 'GradientTexture "end" "a point other than start" end)))]
    [(or start end)
     (raise-expected 'GradientTexture "start and end" "both of them or neither" (list start end))])
  (GradientTexture first second start end))

(define-constructor GradientTexture make-GradientTexture (first second start end))

(: GradientTexture-kernel (-> GradientTexture TextureKernel))
(define (GradientTexture-kernel texture)
  (define first (GradientTexture-first texture))
  (define second (GradientTexture-second texture))
  (define start (GradientTexture-start texture))
  (define end (GradientTexture-end texture))
  (define-syntax-rule (put-blend! r number)
    (let ([s (flmax 0.0 (flmin 1.0 number))])
      (Float3-put! r surface-color (Float3-linear-interpolate first second s))))
  (cond
    [(and start end)
     (define along
       (let-float3 ([line (Float3-subtract end start)])
         (Float3-scale-by-scalar line (fl/ 1.0 (Float3-length-squared line)))))
     (lambda ([r : FlVector] [i : FxVector])
       (put-blend! r (Float3-dot along (Float3-subtract (Float3-in r texture-point) start))))]
    [else
     (lambda ([r : FlVector] [i : FxVector])
       (put-blend! r (flvector-ref r (fx+ surface-uv 1))))]))
