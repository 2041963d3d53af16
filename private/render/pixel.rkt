#lang typed/racket/base
;; A pixel as a fold over its samples: camera ray, integrator, mean.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt"
         "../sample/sampler.rkt")

(provide make-tile-worker (struct-out Tiling) tile-count)

;; How a picture is cut: its width and height, the tile's side, and the part that is rendered as
;; x, y, width, height. Tiles are numbered by rows; their order changes no pixel.
(struct Tiling ([width : Fixnum] [height : Fixnum] [tile : Fixnum]
                [crop : (List Fixnum Fixnum Fixnum Fixnum)])
  #:transparent)

(define-syntax-rule (ceiling-quotient a b) (fxquotient (fx+ a (fx- b 1)) b))

(: tile-count (-> Tiling Fixnum))
(define (tile-count tiling)
  (define crop (Tiling-crop tiling))
  (fx* (ceiling-quotient (caddr crop) (Tiling-tile tiling))
       (ceiling-quotient (cadddr crop) (Tiling-tile tiling))))

;; A worker: a procedure that renders the tile it is given into `film`, and the fixnum scratch that
;; holds its counts. It shares nothing it writes with other workers but places of the film that are
;; its tile's alone. One sample a pixel goes through the pixel's middle, more are spread over it.
(: make-tile-worker (-> Tiling Fixnum Fixnum (-> FlVector FxVector Void)
                        (-> FlVector FxVector Void) FlVector
                        (Values (-> Fixnum Void) FxVector)))
(define (make-tile-worker tiling samples seed camera-kernel integrator film)
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (define sums (make-flvector 6 0.0))
  (define width (Tiling-width tiling))
  (define tile (Tiling-tile tiling))
  (define crop (Tiling-crop tiling))
  (define left (car crop))
  (define top (cadr crop))
  (define right (fx+ left (caddr crop)))
  (define bottom (fx+ top (cadddr crop)))
  (define tiles-across (ceiling-quotient (caddr crop) tile))

  (: render-pixel! (-> Fixnum Fixnum Void))
  (define (render-pixel! x y)
    (define pixel (fx+ x (fx* y width)))
    (define place (fx* 3 (fx+ (fx- x left) (fx* (fx- y top) (fx- right left)))))
    (start-sum! sums)
    (let fold ([sample : Fixnum 0])
      (when (fx< sample samples)
        (Sampler-start! i pixel seed sample)
        (cond
          [(fx= samples 1)
           (fxvector-set! i sampler-dimension 1)
           (flvector-set! r film-x (fl+ (fx->fl x) 0.5))
           (flvector-set! r film-y (fl+ (fx->fl y) 0.5))]
          [else
           (sample-next-pair! r i)
           (flvector-set! r film-x (fl+ (fx->fl x) (flvector-ref r sample-u)))
           (flvector-set! r film-y (fl+ (fx->fl y) (flvector-ref r sample-v)))])
        (camera-kernel r i)
        (integrator r i)
        (unless (add-sample! r sums)
          (count-rejected! i pixel sample))
        (fold (fx+ sample 1))))
    (put-mean! film place sums (fx->fl samples)))

  (: render-tile! (-> Fixnum Void))
  (define (render-tile! number)
    (define x0 (fx+ left (fx* tile (fxremainder number tiles-across))))
    (define y0 (fx+ top (fx* tile (fxquotient number tiles-across))))
    (define x1 (if (fx< (fx+ x0 tile) right) (fx+ x0 tile) right))
    (define y1 (if (fx< (fx+ y0 tile) bottom) (fx+ y0 tile) bottom))
    (let rows ([y : Fixnum y0])
      (when (fx< y y1)
        (let columns ([x : Fixnum x0])
          (when (fx< x x1)
            (render-pixel! x y)
            (columns (fx+ x 1))))
        (rows (fx+ y 1)))))
  (values render-tile! i))

;; The sum of the samples in three places, and what was rounded off it in three more (Kahan 1965), so
;; that the mean of ten million is as exact as that of one.
(define-syntax-rule (start-sum! sums)
  (begin
    (Float3-put! sums 0 (Float3 0.0 0.0 0.0))
    (Float3-put! sums 3 (Float3 0.0 0.0 0.0))))

(define-syntax-rule (put-mean! film place sums count)
  (let-syntax ([put-component!
                (syntax-rules ()
                  [(_ k) (flvector-set! film (fx+ place k) (fl/ (flvector-ref sums k) count))])])
    (put-component! 0)
    (put-component! 1)
    (put-component! 2)))

;; Adds a sample and returns #t, unless it is no number a picture can hold.
(define-syntax-rule (add-sample! r sums)
  (let-float3 ([color (Float3-in r radiance)])
    (if (and (fl>= (Float3-x color) 0.0) (fl>= (Float3-y color) 0.0) (fl>= (Float3-z color) 0.0)
             (fl< (Float3-largest-component color) +inf.0))
        (begin
          (add-component! sums 0 (Float3-x color))
          (add-component! sums 1 (Float3-y color))
          (add-component! sums 2 (Float3-z color))
          #t)
        #f)))

(define-syntax-rule (add-component! sums k value)
  (let* ([sum (flvector-ref sums k)]
         [term (fl- value (flvector-ref sums (fx+ k 3)))]
         [next (fl+ sum term)])
    (flvector-set! sums (fx+ k 3) (fl- (fl- next sum) term))
    (flvector-set! sums k next)))

(: count-rejected! (-> FxVector Fixnum Fixnum Void))
(define (count-rejected! i pixel sample)
  (define first (fxvector-ref i rejected-pixel))
  (fxvector-set! i rejected-samples (fx+ 1 (fxvector-ref i rejected-samples)))
  (when (or (fx= first 0) (fx< pixel (fx- first 1)))
    (fxvector-set! i rejected-pixel (fx+ pixel 1))
    (fxvector-set! i rejected-sample sample)))
