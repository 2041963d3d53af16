#lang typed/racket/base
;; Shading normals that follow a bump texture (Blinn 1978). The surface is looked at in two points
;; close by, whatever its shape, by rays straight down on it; the differences of the texture there
;; give its slope along the surface (Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU",
;; 2010), by which the normal is tilted.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/frame.rkt"
         "../material/material.rkt" "../material/kernel.rkt" "../material/bumped.rkt"
         "../material/texture/kernels.rkt"
         "../world/scene.rkt" "../world/trace.rkt" "media.rkt")

(provide with-bumps)

;; with-bumps : the kernels of a scene's materials, those of bumped ones prepared by tilting the
;; normal. The same vector where nothing is bumped.
(: with-bumps (-> Scene (Vectorof MaterialKernel) (Vectorof MaterialKernel)))
(define (with-bumps scene kernels)
  (define materials (Scene-materials scene))
  (define (kernel-with-bumps [material : Material] [kernel : MaterialKernel]) : MaterialKernel
    (define bumps (Material-bumps material))
    (if (null? bumps)
        kernel
        (struct-copy MaterialKernel kernel
                     [prepare (tilting scene (map Bumped-tilt bumps)
                                       (if (MaterialKernel-transmits? kernel) 0 1)
                                       (MaterialKernel-prepare kernel))])))
  (if (for/or : Boolean ([material (in-vector materials)]) (pair? (Material-bumps material)))
      (for/vector : (Vectorof MaterialKernel)
                  ([material (in-vector materials)] [kernel (in-vector kernels)])
        (kernel-with-bumps material kernel))
      kernels))

(define-type Tilt (-> Scene FlVector FxVector Void))

;; one-sided: 1 where the material sends no light through.
(: tilting (-> Scene (Listof Tilt) Fixnum (U #f (-> FlVector FxVector Void))
               (-> FlVector FxVector Void)))
(define (tilting scene tilts one-sided prepare)
  (lambda ([r : FlVector] [i : FxVector])
    (fxvector-set! i bumped-here 0)
    (for ([tilt! (in-list tilts)]) (tilt! scene r i))
    (when (fx= 0 one-sided) (fxvector-set! i bumped-here 0))
    (when prepare (prepare r i))))

;; Room for a tilt in the workspace: what the texture shows at the hit; the step; the point it is
;; asked with; for both points close by their way from the hit, and what the texture shows there.
(define-syntax here (lambda (stx) #'workspace))
(define-syntax step (lambda (stx) #'(fx+ workspace 1)))
(define-syntax kept-texture-point (lambda (stx) #'(fx+ workspace 2)))
(define-syntax first-way (lambda (stx) #'(fx+ workspace 5)))
(define-syntax first-rise (lambda (stx) #'(fx+ workspace 8)))
(define-syntax second-way (lambda (stx) #'(fx+ workspace 9)))
(define-syntax second-rise (lambda (stx) #'(fx+ workspace 12)))

;; Where kept-for-shadow keeps the point and the normal of the hit.
(define-syntax kept-point (lambda (stx) #'(fx+ kept-for-shadow (fx- surface-point ray-origin))))
(define-syntax kept-normal (lambda (stx) #'(fx+ kept-for-shadow (fx- surface-normal ray-origin))))

;; The step is about half a pixel of a picture of a thousand across, seen at a right angle: the part of
;; the distance. Steps near the rounding of the point itself would show that, so there are none.
(define-syntax-rule (STEP-PART) 0.00048828125)
(define-syntax-rule (LEAST-STEP) 1024.0)

;; Reads the hit, its surface, uv and texture-point in the scratch while normals point outside, and
;; leaves all of them but the shading normal as they were.
(: Bumped-tilt (-> Bumped Tilt))
(define (Bumped-tilt bumped)
  (define height! (weight-kernel (Bumped-texture bumped)))
  (define height (Bumped-height bumped))
  (lambda ([scene : Scene] [r : FlVector] [i : FxVector])
    (flvector-set! r step (fl* (STEP-PART)
                               (fl* (flvector-ref r hit-t)
                                    (Float3-length (Float3-in r ray-direction)))))
    (when (fl> (flvector-ref r step) (fl* (LEAST-STEP) (flvector-ref r surface-error)))
      (height! r i)
      (flvector-set! r here (flvector-ref r surface-roughness))
      (Float3-put! r kept-texture-point (Float3-in r texture-point))
      (let-float3 ([n (Float3-in r surface-normal)])
        (let-frame (tangent bitangent) n
          (Float3-put! r frame-tangent tangent)
          (Float3-put! r frame-bitangent bitangent)))
      (keep-hit! r i)
      (look-around! scene height! frame-tangent first-way r i)
      (look-around! scene height! frame-bitangent second-way r i)
      (restore-hit! r i)
      (Float3-put! r texture-point (Float3-in r kept-texture-point))
      (flvector-set! r first-rise (fl* height (flvector-ref r first-rise)))
      (flvector-set! r second-rise (fl* height (flvector-ref r second-rise)))
      (unless (and (fl= (flvector-ref r first-rise) 0.0) (fl= (flvector-ref r second-rise) 0.0))
        (tilt-normal! r i)))))

;; Into the four places at `way`: from the hit to a point a step along that direction, or against it
;; where the shape has none there, and by how much the texture shows more than here. Where there is
;; neither, the texture is taken for level.
(: look-around! (-> Scene (-> FlVector FxVector Void) Fixnum Fixnum FlVector FxVector Void))
(define (look-around! scene height! along way r i)
  (cond
    [(or (look! scene along 1.0 way r i) (look! scene along -1.0 way r i))
     (Scene-surface! scene r i)
     (Scene-uv! scene r i)
     (height! r i)
     (Float3-put! r way (Float3-subtract (Float3-in r surface-point) (Float3-in r kept-point)))
     (flvector-set! r (fx+ way 3) (fl- (flvector-ref r surface-roughness) (flvector-ref r here)))]
    [else
     (Float3-put! r way (Float3-in r along))
     (flvector-set! r (fx+ way 3) 0.0)]))

;; Whether a ray from a step above the tangent plane down to a step below meets the same shape.
(: look! (-> Scene Fixnum Flonum Fixnum FlVector FxVector Boolean))
(define (look! scene along side way r i)
  (let-float3 ([n (Float3-in r kept-normal)])
    (let ([far (flvector-ref r step)])
      (Float3-put! r ray-origin
                   (Float3-multiply-add
                    (Float3-multiply-add (Float3-in r kept-point) far n)
                    (fl* side far) (Float3-in r along)))
      (Float3-put! r ray-direction (Float3-negate n))
      (flvector-set! r ray-limit (fl* 2.0 far))))
  (and (Scene-nearest! scene r i)
       (fx= (fxvector-ref i hit-primitive) (fxvector-ref i kept-hit-for-shadow))))

;; The part of the way to the viewer that a bump shows at least: steeper slopes are not seen.
(define-syntax-rule (LEAST-COSINE) 0.015625)

;; From the ways to the two points and how much higher the surface is there: the normal less the slope
;; of the surface is what the normal would be; where that is turned away from the viewer it is turned
;; back to the limit.
(: tilt-normal! (-> FlVector FxVector Void))
(define (tilt-normal! r i)
  (let-float3 ([n (Float3-in r surface-normal)]
               [first (Float3-cross (Float3-in r second-way) n)]
               [second (Float3-cross n (Float3-in r first-way))]
               [out (Float3-negate (Float3-normalized (Float3-in r ray-direction)))])
    (let* ([a (flvector-ref r first-rise)]
           [b (flvector-ref r second-rise)]
           [determinant (Float3-dot (Float3-in r first-way) first)]
           [seen (Float3-dot n out)]
           [side (if (fl< seen 0.0) -1.0 1.0)]
           [least (flmin (LEAST-COSINE) (fl* side seen))])
      (let-float3 ([slope (Float3-add (Float3-scale-by-scalar first (fl/ a determinant))
                                      (Float3-scale-by-scalar second (fl/ b determinant)))]
                   [tilted (Float3-normalized
                            (Float3-subtract (Float3-in r surface-shading-normal) slope))])
        (let* ([missing (flmax 0.0 (fl- least (fl* side (Float3-dot tilted out))))])
          (let-float3 ([turned (Float3-normalized
                                (Float3-multiply-add tilted (fl* side missing) out))])
            (when (fl< (Float3-length-squared turned) +inf.0)
              (Float3-put! r surface-shading-normal turned)
              (fxvector-set! i bumped-here 1))))))))
