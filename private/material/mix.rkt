#lang typed/racket/base
;; Mix: two materials at once, as dust on glass or a worn coat of paint; mixes may be mixed again.
;; weight: the part of the second, from 0 to 1; the first has the rest. Neither may be an emitter.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../base/public.rkt" "../sample/sampler.rkt"
         "material.rkt" "emitter.rkt" "kernel.rkt" "scatter.rkt")

(provide (struct-out Mix) make-Mix Mix-kernel)

(struct Mix Material ([first : Material] [second : Material] [weight : Flonum]) #:transparent)

;; (Mix first second weight).
(: make-Mix (-> Material Material Real Mix))
(define (make-Mix first second weight)
  (for ([material (list first second)] [argument (list "first" "second")])
    (when (Emitter? material)
      (raise-expected 'Mix argument "a material that reflects" material)))
  (Mix first second (check-between 'Mix "weight" weight 0.0 1.0)))

(define-constructor Mix make-Mix (first second weight))

(define-syntax (mixed-value stx) #'(fx+ workspace 20))
(define-syntax (mixed-density stx) #'(fx+ workspace 23))

;; Mixes of mixes are flattened into one list of parts, so that the sums below have one place. A
;; part is chosen by its weight; where its sample has a density, every part that could have chosen
;; the same direction is counted (the balance heuristic), and where it has none, no other part can.
;; Draws one pair, then those of the part. The last four places of `workspace` hold the sums while
;; the parts are asked. A part that absorbs leaves a density of 0, or a direction with its density.
(: Mix-kernel (-> Mix (-> Material MaterialKernel) MaterialKernel))
(define (Mix-kernel mix material-kernel)
  (define parts (Mix-parts mix 1.0))
  (define kernels
    (for/list : (Listof MaterialKernel) ([part (in-list parts)]) (material-kernel (cdr part))))
  (define last (- (length parts) 1))
  (define weights (apply flvector (map (inst car Flonum Material) parts)))
  (define samples (list->vector (map MaterialKernel-sample kernels)))
  (define evaluates (list->vector (map MaterialKernel-evaluate kernels)))

  (: sample (-> FlVector FxVector Void))
  (define (sample r i)
    (sample-next-pair! r i)
    ((vector-ref samples (choose weights last (flvector-ref r sample-u))) r i)
    (when (finite-density? r)
      (evaluate r i)
      (Float3-put! r bsdf-weight
                   (Float3-scale-by-scalar (Float3-in r bsdf-weight)
                                           (fl/ 1.0 (flvector-ref r bsdf-density))))))

  (: evaluate (-> FlVector FxVector Void))
  (define (evaluate r i)
    (Float3-put! r mixed-value (Float3 0.0 0.0 0.0))
    (flvector-set! r mixed-density 0.0)
    (let sum ([k : Fixnum 0])
      (when (fx<= k last)
        ((vector-ref evaluates k) r i)
        (let ([weight (flvector-ref weights k)])
          (Float3-put! r mixed-value
                       (Float3-multiply-add (Float3-in r mixed-value) weight
                                            (Float3-in r bsdf-weight)))
          (flvector-set! r mixed-density
                         (fl+ (flvector-ref r mixed-density)
                              (fl* weight (flvector-ref r bsdf-density)))))
        (sum (fx+ k 1))))
    (Float3-put! r bsdf-weight (Float3-in r mixed-value))
    (flvector-set! r bsdf-density (flvector-ref r mixed-density)))

  (cond
    [(fx= last 0) (list-ref kernels 0)]
    [else
     (MaterialKernel sample evaluate
                     (andmap MaterialKernel-specular? kernels)
                     (ormap MaterialKernel-transmits? kernels)
                     (ormap MaterialKernel-needs-uv? kernels))]))

;; The materials that are no mixes, each with its weight, which is above 0.
(: Mix-parts (-> Material Flonum (Listof (Pairof Flonum Material))))
(define (Mix-parts material share)
  (cond
    [(fl= share 0.0) '()]
    [(Mix? material)
     (define weight (Mix-weight material))
     (append (Mix-parts (Mix-first material) (fl* share (fl- 1.0 weight)))
             (Mix-parts (Mix-second material) (fl* share weight)))]
    [else (list (cons share material))]))

;; The first place at which the weights so far exceed u, or the last.
(define-syntax-rule (choose weights last number)
  (let ([u number])
    (let next : Fixnum ([k : Fixnum 0] [above : Flonum (flvector-ref weights 0)])
      (if (or (fx= k last) (fl< u above))
          k
          (next (fx+ k 1) (fl+ above (flvector-ref weights (fx+ k 1))))))))

(define-syntax-rule (finite-density? r)
  (let ([density (flvector-ref r bsdf-density)])
    (and (fl> density 0.0) (fl< density +inf.0))))
