#lang typed/racket/base
;; Mix: two materials at once, as dust on glass or a worn coat of paint; mixes may be mixed again.
;; weight: the part of the second, from 0 to 1, or a texture whose luminance is; the first has the
;; rest. Neither may be an emitter, nor bumped, nor bound a medium: the mix itself
;; may be bumped.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../base/public.rkt" "../sample/sampler.rkt"
         "material.rkt" "emitter.rkt" "bumped.rkt" "interior.rkt" "kernel.rkt" "scatter.rkt"
         "texture/texture.rkt" "texture/kernels.rkt")

(provide (struct-out Mix) make-Mix Mix-kernel)

(struct Mix Material ([first : Material] [second : Material] [weight : (U Flonum Texture)])
  #:transparent)

;; (Mix first second weight).
(: make-Mix (-> Material Material (U Real Texture) Mix))
(define (make-Mix first second weight)
  (for ([material (list first second)] [argument (list "first" "second")])
    (when (Emitter? material)
      (raise-expected 'Mix argument "a material that reflects" material))
    (when (Bumped? material)
      (raise-expected 'Mix argument "a material that is not bumped itself" material))
    (when (Interior? material)
      (raise-expected 'Mix argument "a material that bounds no medium" material)))
  (define mix
    (Mix first second (if (real? weight) (check-between 'Mix "weight" weight 0.0 1.0) weight)))
  (define-values (parts choices) (Mix-parts mix 1.0 0))
  (unless (or (null? choices) (<= (length parts) (MOST-TEXTURED-PARTS)))
    (raise-expected 'Mix "first and second"
                    (format "at most ~a materials where a texture weighs them" (MOST-TEXTURED-PARTS))
                    (length parts)))
  mix)

(define-constructor Mix make-Mix (first second weight))

(define-syntax (mixed-value stx) #'(fx+ workspace 20))
(define-syntax (mixed-density stx) #'(fx+ workspace 23))

;; As many as mix-weights has places.
(define-syntax-rule (MOST-TEXTURED-PARTS) 8)

;; A texture that gives its share to the parts from number middle to end, and the rest to those
;; from start to middle.
(struct Choice ([texture : Texture] [start : Fixnum] [middle : Fixnum] [end : Fixnum]))

;; Mixes of mixes are flattened into one list of parts, so that the sums below have one place. A
;; part is chosen by its weight; where its sample has a density, every part that could have chosen
;; the same direction is counted (the balance heuristic), and where it has none, no other part can.
;; Draws one pair, then those of the part. The last four places of `workspace` hold the sums while
;; the parts are asked. A part that absorbs leaves a density of 0, or a direction with its density.
(: Mix-kernel (-> Mix (-> Material MaterialKernel) MaterialKernel))
(define (Mix-kernel mix material-kernel)
  (define-values (parts choices) (Mix-parts mix 1.0 0))
  (define kernels
    (for/list : (Listof MaterialKernel) ([part (in-list parts)]) (material-kernel (cdr part))))
  (define last (- (length parts) 1))
  (define shares (apply flvector (map (inst car Flonum Material) parts)))
  (define weights (and (null? choices) shares))
  (define place (if weights 0 mix-weights))
  (define samples
    (list->vector (for/list : (Listof (-> FlVector FxVector Void)) ([kernel (in-list kernels)])
                    (after-prepare kernel (MaterialKernel-sample kernel)))))
  (define evaluates
    (list->vector (for/list : (Listof (-> FlVector FxVector Void)) ([kernel (in-list kernels)])
                    (after-prepare kernel (MaterialKernel-evaluate kernel)))))

  (: sample (-> FlVector FxVector Void))
  (define (sample r i)
    (sample-next-pair! r i)
    ((vector-ref samples (choose (or weights r) place last (flvector-ref r sample-u))) r i)
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
        (let ([weight (flvector-ref (or weights r) (fx+ place k))])
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
                     (and (or (pair? choices) (ormap MaterialKernel-prepare kernels))
                          (weigh-parts shares choices)))]))

;; Every part has its own texture, so it is asked again before the part is.
(: after-prepare (-> MaterialKernel (-> FlVector FxVector Void) (-> FlVector FxVector Void)))
(define (after-prepare kernel use!)
  (define prepare (MaterialKernel-prepare kernel))
  (if prepare
      (lambda ([r : FlVector] [i : FxVector])
        (prepare r i)
        (use! r i))
      use!))

;; Writes the weights of the parts where textures decide them.
(: weigh-parts (-> FlVector (Listof Choice) (-> FlVector FxVector Void)))
(define (weigh-parts shares choices)
  (define count (flvector-length shares))
  (define weigh-all : (Listof (-> FlVector FxVector Void))
    (for/list : (Listof (-> FlVector FxVector Void)) ([choice (in-list choices)])
      (define weigh! (weight-kernel (Choice-texture choice)))
      (define start (Choice-start choice))
      (define middle (Choice-middle choice))
      (define end (Choice-end choice))
      (lambda ([r : FlVector] [i : FxVector])
        (weigh! r i)
        (let each : Void ([k : Fixnum start])
          (when (fx< k end)
            (let ([weight (flvector-ref r surface-roughness)] [at (fx+ mix-weights k)])
              (flvector-set! r at (fl* (flvector-ref r at)
                                       (if (fx< k middle) (fl- 1.0 weight) weight))))
            (each (fx+ k 1)))))))
  (lambda ([r : FlVector] [i : FxVector])
    (unless (null? weigh-all)
      (let each : Void ([k : Fixnum 0])
        (when (fx< k count)
          (flvector-set! r (fx+ mix-weights k) (flvector-ref shares k))
          (each (fx+ k 1))))
      (for ([weigh! (in-list weigh-all)]) (weigh! r i)))))

;; The materials that are no mixes, each with its weight, which is above 0 and counts textures as
;; 1, and the textures that weigh them further. number: how many parts come before.
(: Mix-parts (-> Material Flonum Fixnum
                 (Values (Listof (Pairof Flonum Material)) (Listof Choice))))
(define (Mix-parts material share number)
  (cond
    [(fl= share 0.0) (values '() '())]
    [(Mix? material)
     (define weight (Mix-weight material))
     (define-values (first first-choices)
       (Mix-parts (Mix-first material) (if (flonum? weight) (fl* share (fl- 1.0 weight)) share)
                  number))
     (define middle (fx+ number (length first)))
     (define-values (second second-choices)
       (Mix-parts (Mix-second material) (if (flonum? weight) (fl* share weight) share) middle))
     (define choices (append first-choices second-choices))
     (values (append first second)
             (if (flonum? weight)
                 choices
                 (cons (Choice weight number middle (fx+ middle (length second))) choices)))]
    [else (values (list (cons share material)) '())]))

;; The first number at which the weights so far, which begin at a place, exceed u, or the last.
(define-syntax-rule (choose all place last number)
  (let* ([u number] [weights all] [first-weight (flvector-ref weights place)])
    (let next : Fixnum ([k : Fixnum 0] [above : Flonum first-weight])
      (if (or (fx= k last) (fl< u above))
          k
          (next (fx+ k 1) (fl+ above (flvector-ref weights (fx+ place (fx+ k 1)))))))))

(define-syntax-rule (finite-density? r)
  (let ([density (flvector-ref r bsdf-density)])
    (and (fl> density 0.0) (fl< density +inf.0))))
