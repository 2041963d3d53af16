#lang typed/racket/base
;; The lobe that gives back what single scattering loses (Kulla and Conty, "Revisiting Physically
;; Based Shading at Imageworks", 2017): lost(o) lost(i) / (pi average), where lost is the share of
;; light single scattering loses by direction. It is symmetric, and returns lost(o) in all.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/frame.rkt"
         "../sample/circle.rkt" "scatter.rkt" "energy.rkt")

(provide (struct-out Compensation) make-compensation let-loss choose-by-loss! choose-below!
         sample-compensation! divide-by-density!)

;; rows: the losses ready for kernels, four numbers a cell. Loss at the cell's lower node; square of
;; the cosine there; the share of the lobe's light below it; density of the cell over the cosine:
;; within a cell, directions are sampled by cosine. Two rows more let a cosine of 1 be looked up as
;; any other. average: the mean of the losses over the hemisphere by cosine.
(struct Compensation ([rows : FlVector] [average : Flonum] [alpha : Flonum]))

;; From a column of losses (see energy.rkt).
(: make-compensation (-> FlVector Flonum Compensation))
(define (make-compensation losses alpha)
  (define table (make-flvector (* 4 (+ 2 (CELLS))) 0.0))
  (define rule (gauss-legendre 4))
  (define total
    (for/fold ([sum : Flonum 0.0]) ([cell (in-range (+ 2 (CELLS)))])
      (define node (min cell (CELLS)))
      (define cosine (node-cosine node alpha))
      (define row (* 4 cell))
      (flvector-set! table row (flvector-ref losses node))
      (flvector-set! table (+ row 1) (fl* cosine cosine))
      (flvector-set! table (+ row 2) sum)
      (cond
        [(< cell (CELLS))
         (define mass (cell-mass losses cell alpha rule))
         (define next (node-cosine (+ cell 1) alpha))
         (define area (fl* (fl- next cosine) (fl+ next cosine)))
         (flvector-set! table (+ row 3) (fl/ mass area))
         (fl+ sum mass)]
        [else
         (flvector-set! table (+ row 3) (flvector-ref table (- row 1)))
         sum])))
  ;; from light to shares of it, and to densities per solid angle
  (for ([cell (in-range (+ 2 (CELLS)))])
    (define row (* 4 cell))
    (flvector-set! table (+ row 2) (fl/ (flvector-ref table (+ row 2)) total))
    (flvector-set! table (+ row 3)
                   (fl/ (flvector-ref table (+ row 3)) (fl* 3.141592653589793 total))))
  (Compensation table total alpha))

;; The integral of 2 lost cosine over a cell.
(: cell-mass (-> FlVector Integer Flonum FlVector Flonum))
(define (cell-mass losses cell alpha rule)
  (define low (node-cosine cell alpha))
  (define width (fl- (node-cosine (+ cell 1) alpha) low))
  (for/fold ([sum : Flonum 0.0]) ([k (in-range 4)])
    (define cosine (fl+ low (fl* width (flvector-ref rule (* 2 k)))))
    (define t (fl- (fl* (fx->fl (CELLS)) (loss-coordinate cosine alpha))
                   (real->double-flonum cell)))
    (define lost (fl+ (fl* (fl- 1.0 t) (flvector-ref losses cell))
                      (fl* t (flvector-ref losses (+ cell 1)))))
    (fl+ sum (fl* (fl* 2.0 (fl* width (flvector-ref rule (+ 1 (* 2 k))))) (fl* cosine lost)))))

;; Binds loss to the loss at a cosine from 0 to 1, and density to the density with which
;; sample-compensation! chooses a direction of that cosine.
(define-syntax-rule (let-loss (loss density) (rows alpha cosine) body ...)
  (let* ([place (fl* (fx->fl (CELLS)) (loss-coordinate cosine alpha))]
         [cell (fl->fx place)]
         [row (fx* 4 cell)]
         [low (flvector-ref rows row)]
         [loss (fl+ low (fl* (fl- place (fx->fl cell))
                             (fl- (flvector-ref rows (fx+ row 4)) low)))]
         [density (fl* cosine (flvector-ref rows (fx+ row 3)))])
    body ...))

;; choose-below! : whether the number at a place of the scratch, in [0, 1), is below a limit. What is
;; left of the number, stretched to [0, 1), replaces it.
(define-syntax-rule (choose-below! r place limit)
  (let ([u (flvector-ref r place)])
    (if (fl< u limit)
        (begin (flvector-set! r place (below-one (fl/ u limit))) #t)
        (begin (flvector-set! r place (below-one (fl/ (fl- u limit) (fl- 1.0 limit)))) #f))))

;; Rounded quotients may reach 1.
(define-syntax-rule (below-one x) (flmin 0.9999999999999999 x))

;; choose-by-loss! : choose-below! with the loss towards the viewer as the limit.
(: choose-by-loss! (-> FlVector Flonum FlVector Fixnum Boolean))
(define (choose-by-loss! rows alpha r place)
  (let-facing-normal r (n out cosine)
    (let-loss (loss density) (rows alpha cosine)
      (choose-below! r place loss))))

(define-circle-operation (warp-ring [z-squared : Flonum] [v : Flonum])
  #:let () (flsqrt (fl- 1.0 z-squared)) v (flsqrt z-squared))

;; sample-compensation! : by sample-u and sample-v, an in-direction of the lobe around the normal, or
;; around its opposite where side is -1.
(: sample-compensation! (-> FlVector Flonum FlVector Void))
(define (sample-compensation! rows side r)
  (define cell
    (let search : Fixnum ([low : Fixnum 0] [high : Fixnum (CELLS)])
      (let ([middle (fxrshift (fx+ low high) 1)])
        (cond
          [(fx= middle low) low]
          [(fl< (flvector-ref r sample-u) (flvector-ref rows (fx+ 2 (fx* 4 middle))))
           (search low middle)]
          [else (search middle high)]))))
  (let-facing-normal r (n out cosine)
    (let* ([row (fx* 4 cell)]
           [below (flvector-ref rows (fx+ row 2))]
           [part (fl/ (fl- (flvector-ref r sample-u) below)
                      (fl- (flvector-ref rows (fx+ row 6)) below))]
           [low (flvector-ref rows (fx+ row 1))]
           [z-squared (fl+ low (fl* part (fl- (flvector-ref rows (fx+ row 5)) low)))])
      (let-float3 ([local (warp-ring z-squared (flvector-ref r sample-v))])
        (let-frame (tangent bitangent) n
          (Float3-put! r in-direction
                       (Frame-to-world tangent bitangent n
                                       (Float3 (Float3-x local) (Float3-y local)
                                               (fl* side (Float3-z local))))))))))

;; divide-by-density! : a value just evaluated becomes the weight of a sample.
(: divide-by-density! (-> FlVector Void))
(define (divide-by-density! r)
  (let ([density (flvector-ref r bsdf-density)])
    (if (fl> density 0.0)
        (Float3-put! r bsdf-weight
                     (Float3-scale-by-scalar (Float3-in r bsdf-weight) (fl/ 1.0 density)))
        (put-nothing! r))))
