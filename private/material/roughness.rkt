#lang typed/racket/base
;; Roughness that a texture drives: a material's kernel at each of many roughnesses, and the one that
;; is nearest to what the texture shows.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "kernel.rkt"
         "texture/texture.rkt" "texture/checker.rkt" "texture/kernels.rkt")

(provide NumberOrTexture check-number-or-texture texture-roughnesses roughness-kernel)

;; What a texture stands for is the luminance of its colour, from 0 to 1.
(define-type NumberOrTexture (U Flonum Texture))

(: check-number-or-texture (-> Symbol String (U Real Texture) NumberOrTexture))
(define (check-number-or-texture who argument value)
  (if (real? value) (check-between who argument value 0.0 1.0) value))

;; Levels (k / LEVELS)^2: neighbours differ by an eightieth at 0.1, by a 250th at 1.
(define-syntax-rule (LEVELS) 512)

;; texture-roughnesses : every roughness there is to a texture, where those are few, as for checkers
;; of colours; #f else.
(: texture-roughnesses (-> Texture (U #f (Listof Flonum))))
(define (texture-roughnesses texture)
  (define-values (even odd)
    (cond
      [(Checker? texture) (values (Checker-even texture) (Checker-odd texture))]
      [(CheckerUV? texture) (values (CheckerUV-even texture) (CheckerUV-odd texture))]
      [else (values texture texture)]))
  (cond
    [(eq? even texture) #f]
    [else
     (define first (roughnesses even))
     (define second (roughnesses odd))
     (and first second
          (let ([all (append first (remove* first second))])
            (and (< (length all) (LEVELS)) all)))]))

(: roughnesses (-> ColorOrTexture (U #f (Listof Flonum))))
(define (roughnesses source)
  (cond
    [(Float3? source)
     (define r (make-flonum-registers))
     ((weight-kernel source) r (make-fixnum-registers))
     (list (flvector-ref r surface-roughness))]
    [else (texture-roughnesses source)]))

;; roughness-kernel : at-roughness makes the kernel of one roughness, from 0 to 1. The number of the
;; chosen one is left in surface-roughness until the surface is done with.
(: roughness-kernel (-> Texture (-> Flonum MaterialKernel) MaterialKernel))
(define (roughness-kernel texture at-roughness)
  (define few (texture-roughnesses texture))
  (define weigh! (weight-kernel texture))
  (define levels : (Listof Flonum)
    (or few
        (build-list (+ 1 (LEVELS))
                    (lambda ([k : Index])
                      (let ([root (fl/ (fx->fl k) (fx->fl (LEVELS)))]) (fl* root root))))))
  (define kernels (map at-roughness levels))
  (define samples
    (list->vector (map MaterialKernel-sample kernels)))
  (define evaluates
    (list->vector (map MaterialKernel-evaluate kernels)))
  (define-syntax-rule (chosen all r) (vector-ref all (fl->fx (flvector-ref r surface-roughness))))
  (MaterialKernel
   (lambda ([r : FlVector] [i : FxVector]) ((chosen samples r) r i))
   (lambda ([r : FlVector] [i : FxVector]) ((chosen evaluates r) r i))
   (andmap MaterialKernel-specular? kernels)
   (ormap MaterialKernel-transmits? kernels)
   (if few
       (let ([values (apply flvector few)])
         (lambda ([r : FlVector] [i : FxVector])
           (weigh! r i)
           (flvector-set! r surface-roughness
                          (fx->fl (nearest values (flvector-ref r surface-roughness))))))
       (lambda ([r : FlVector] [i : FxVector])
         (weigh! r i)
         (flvector-set! r surface-roughness
                        (flfloor (fl+ 0.5 (fl* (fx->fl (LEVELS))
                                               (flsqrt (flvector-ref r surface-roughness))))))))))

;; The number of the value nearest to x.
(define-syntax-rule (nearest values x0)
  (let ([x x0] [first (flvector-ref values 0)])
    (let next : Fixnum ([k : Fixnum 1] [best : Fixnum 0] [distance : Flonum (flabs (fl- x first))])
      (if (fx= k (flvector-length values))
          best
          (let ([own (flabs (fl- x (flvector-ref values k)))])
            (if (fl< own distance)
                (next (fx+ k 1) k own)
                (next (fx+ k 1) best distance)))))))
