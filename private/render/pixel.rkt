#lang typed/racket/base
;; A pixel as a fold over its samples: camera ray, integrator, sums on the film.
(require "../base/unsafe-typed.rkt" "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt"
         "../sample/hash.rkt" "../sample/sampler.rkt" "../sample/filter.rkt" "film.rkt")

(unsafe-require/typed racket/base
  [memory-order-release (-> Void)])

(provide make-tile-worker Guard (struct-out Tiling) tile-count Tiling-bounds)

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

;; The left, top, right and bottom of a tile in the rendered part.
(: Tiling-bounds (-> Tiling Fixnum (Values Fixnum Fixnum Fixnum Fixnum)))
(define (Tiling-bounds tiling number)
  (define tile (Tiling-tile tiling))
  (define width (caddr (Tiling-crop tiling)))
  (define height (cadddr (Tiling-crop tiling)))
  (define tiles-across (ceiling-quotient width tile))
  (define x (fx* tile (fxremainder number tiles-across)))
  (define y (fx* tile (fxquotient number tiles-across)))
  (values x y (min width (fx+ x tile)) (min height (fx+ y tile))))

;; Decides what becomes of a pixel, given its number in the picture, what renders it from a clean
;; start, and what leaves it in the error colour.
(define-type Guard (-> Fixnum (-> Void) (-> Void) Any))

;; A worker: a procedure that brings the pixels of the tile it is given to the samples the film wants,
;; and may be given a Guard, which is slower. A tile is rendered in scratch and then written to the
;; target as a whole, with its tally. It shares nothing it writes with other workers but places of the
;; target that are its tile's alone. Samples belong by turns to two streams, which are
;; randomised independently. samples: how many a pixel gets, #f where the
;; film says it pass by pass. alone?: whether the target holds one tile only, the one that is rendered.
;; Where one sample is all a pixel will have it goes through the pixel's middle, otherwise samples are spread as the filter's table says, over the pixel without one.
(: make-tile-worker (-> Tiling (U #f Fixnum) (U #f FlVector) Fixnum Fixnum Fixnum (-> FlVector FxVector Void)
                        (-> FlVector FxVector Void) Target Boolean
                        (-> Fixnum (U #f Guard) Void)))
(define (make-tile-worker tiling samples filter sampler grid seed camera-kernel integrator target
                          alone?)
  (define single? (eqv? samples 1))
  (define r (make-flonum-registers))
  (define i (make-fixnum-registers))
  (define sums (make-flvector SUMS-SIZE 0.0))
  (define second-seed (hash-pair (hash32 seed) 1))
  (define width (Tiling-width tiling))
  (define tile (Tiling-tile tiling))
  (define crop (Tiling-crop tiling))
  (define left (car crop))
  (define top (cadr crop))
  (define crop-width (caddr crop))
  (define tallies (Target-tallies target))
  (define finished? (and (Target-errors target) #t))
  ;; the tile's own film
  (define film
    (make-flvector (fx* (PIXEL-PLACES) (fx* (min tile crop-width) (min tile (cadddr crop)))) 0.0))
  (Sampler-choose! i sampler grid)

  (: render-pixel! (-> Fixnum Fixnum Fixnum Void))
  (define (render-pixel! x y place)
    (define pixel (fx+ x (fx* y width)))
    (define taken (fl->fx (flvector-ref film (fx+ place (taken-place)))))
    (define wanted (fl->fx (flvector-ref film (fx+ place (wanted-place)))))
    (define rays-before (rays-traced i))
    (if (failed? film place)
        (fail-pixel! place)
        (begin
          (start-sums! sums)
          (let fold ([sample : Fixnum taken])
            (when (fx< sample wanted)
              (Sampler-start! i pixel (if (first-stream? sample) seed second-seed) (fxrshift sample 1))
              (cond
                [single?
                 (fxvector-set! i sampler-dimension 1)
                 (flvector-set! r film-x (fl+ (fx->fl x) 0.5))
                 (flvector-set! r film-y (fl+ (fx->fl y) 0.5))]
                [filter
                 (sample-next-pair! r i)
                 (flvector-set! r film-x (fl+ (fl+ 0.5 (fx->fl x))
                                              (Filter-offset filter (flvector-ref r sample-u))))
                 (flvector-set! r film-y (fl+ (fl+ 0.5 (fx->fl y))
                                              (Filter-offset filter (flvector-ref r sample-v))))]
                [else
                 (sample-next-pair! r i)
                 (flvector-set! r film-x (fl+ (fx->fl x) (flvector-ref r sample-u)))
                 (flvector-set! r film-y (fl+ (fx->fl y) (flvector-ref r sample-v)))])
              (camera-kernel r i)
              (integrator r i)
              (unless (acceptable? r)
                (Float3-put! r radiance (Float3 0.0 0.0 0.0))
                (count-rejected! i pixel sample))
              (if (first-stream? sample)
                  (add-first! r sums)
                  (add-second! r sums))
              (fold (fx+ sample 1))))
          (put-sums! film place sums wanted (fx- (rays-traced i) rays-before)))))

  ;; The error colour, magenta, in all samples.
  (: fail-pixel! (-> Fixnum Void))
  (define (fail-pixel! place)
    (define wanted (flvector-ref film (fx+ place (wanted-place))))
    (define first (flfloor (fl* 0.5 (fl+ wanted 1.0))))
    (define second (fl- wanted first))
    (define-syntax-rule (put! k value) (flvector-set! film (fx+ place k) value))
    (put! 0 first) (put! 1 0.0) (put! 2 first)
    (put! 3 second) (put! 4 0.0) (put! 5 second)
    (put! (squares-place) 0.0)
    (put! (rays-place) (ERROR-RAYS))
    (put! (taken-place) wanted))

  ;; The scratch as at the start, but for what was counted up to now.
  (: clean-scratch! (-> Fixnum Fixnum Fixnum Fixnum Fixnum Void))
  (define (clean-scratch! nearest occlusion rejected pixel sample)
    (define fresh-r (make-flonum-registers))
    (define fresh-i (make-fixnum-registers))
    (let each ([k : Fixnum 0])
      (when (fx< k (flvector-length fresh-r))
        (flvector-set! r k (flvector-ref fresh-r k))
        (each (fx+ k 1))))
    (let each ([k : Fixnum 0])
      (when (fx< k (fxvector-length fresh-i))
        (fxvector-set! i k (fxvector-ref fresh-i k))
        (each (fx+ k 1))))
    (fxvector-set! i nearest-rays nearest)
    (fxvector-set! i occlusion-rays occlusion)
    (fxvector-set! i rejected-samples rejected)
    (fxvector-set! i rejected-pixel pixel)
    (fxvector-set! i rejected-sample sample)
    (Sampler-choose! i sampler grid))

  (: render-pixel-guarded! (-> Fixnum Fixnum Fixnum Guard Void))
  (define (render-pixel-guarded! x y place guard)
    (define nearest (fxvector-ref i nearest-rays))
    (define occlusion (fxvector-ref i occlusion-rays))
    (define rejected (fxvector-ref i rejected-samples))
    (define pixel (fxvector-ref i rejected-pixel))
    (define sample (fxvector-ref i rejected-sample))
    (define (clean!) (clean-scratch! nearest occlusion rejected pixel sample))
    (guard (fx+ x (fx* y width))
           (lambda () (clean!) (render-pixel! x y place))
           (lambda () (clean!) (fail-pixel! place)))
    (void))

  ;; What is done for a pixel of the tile: k is its number in the crop, place where it is in the
  ;; tile's film.
  (define-syntax-rule (each-pixel (x0 y0 x1 y1) (x y k place) body)
    (let rows ([y : Fixnum y0] [start : Fixnum 0])
      (when (fx< y y1)
        (let columns ([x : Fixnum x0] [place : Fixnum start])
          (if (fx< x x1)
              (let ([k (if alone? (fxquotient place (PIXEL-PLACES)) (fx+ x (fx* y crop-width)))])
                body
                (columns (fx+ x 1) (fx+ place (PIXEL-PLACES))))
              (rows (fx+ y 1) place))))))

  (: load! (-> Fixnum Fixnum Fixnum Fixnum Void))
  (define (load! x0 y0 x1 y1)
    (define from (Target-film target))
    (each-pixel (x0 y0 x1 y1) (x y k place)
      (if finished?
          (start-pixel! film place (if samples (fx->fl samples) 0.0))
          (copy-pixel! film place from (fx* (PIXEL-PLACES) k)))))

  (: store! (-> Fixnum Fixnum Fixnum Fixnum Void))
  (define (store! x0 y0 x1 y1)
    (define to (Target-film target))
    (each-pixel (x0 y0 x1 y1) (x y k place)
      (if finished?
          (Target-finish! target k film place)
          (copy-pixel! to (fx* (PIXEL-PLACES) k) film place))))

  (: taken-in (-> Fixnum Fixnum Flonum))
  (define (taken-in columns rows)
    (define end (fx* (PIXEL-PLACES) (fx* columns rows)))
    (let each : Flonum ([at : Fixnum (taken-place)] [sum : Flonum 0.0])
      (if (fx< at end)
          (each (fx+ at (PIXEL-PLACES)) (fl+ sum (flvector-ref film at)))
          (fl+ sum 0.0))))

  (: failed-in (-> Fixnum Fixnum Flonum))
  (define (failed-in columns rows)
    (define end (fx* (PIXEL-PLACES) (fx* columns rows)))
    (let each : Flonum ([place : Fixnum 0] [sum : Flonum 0.0])
      (if (fx< place end)
          (each (fx+ place (PIXEL-PLACES)) (if (failed? film place) (fl+ sum 1.0) sum))
          (fl+ sum 0.0))))

  (: render-tile! (-> Fixnum (U #f Guard) Void))
  (define (render-tile! number guard)
    (define-values (x0 y0 x1 y1) (Tiling-bounds tiling number))
    (define tally (if alone? 0 (fx* number (TALLY-PLACES))))
    (define nearest-before (fxvector-ref i nearest-rays))
    (define occlusion-before (fxvector-ref i occlusion-rays))
    (define rejected-before (fxvector-ref i rejected-samples))
    (fxvector-set! i rejected-pixel 0)
    (load! x0 y0 x1 y1)
    (each-pixel (x0 y0 x1 y1) (x y k place)
      (if guard
          (render-pixel-guarded! (fx+ left x) (fx+ top y) place guard)
          (render-pixel! (fx+ left x) (fx+ top y) place)))
    (define-syntax-rule (add! place amount)
      (flvector-set! tallies (fx+ tally place) (fl+ (flvector-ref tallies (fx+ tally place)) amount)))
    (define first (fxvector-ref i rejected-pixel))
    (define known (flvector-ref tallies (fx+ tally (tally-pixel))))
    (add! (tally-version) 1.0)
    (memory-order-release)
    (store! x0 y0 x1 y1)
    (add! (tally-nearest) (fx->fl (fx- (fxvector-ref i nearest-rays) nearest-before)))
    (add! (tally-occlusion) (fx->fl (fx- (fxvector-ref i occlusion-rays) occlusion-before)))
    (add! (tally-rejected) (fx->fl (fx- (fxvector-ref i rejected-samples) rejected-before)))
    (when (and (fx> first 0) (or (fl= known 0.0) (fl< (fx->fl first) known)))
      (flvector-set! tallies (fx+ tally (tally-pixel)) (fx->fl first))
      (flvector-set! tallies (fx+ tally (tally-sample)) (fx->fl (fxvector-ref i rejected-sample))))
    (flvector-set! tallies (fx+ tally (tally-taken)) (taken-in (fx- x1 x0) (fx- y1 y0)))
    (flvector-set! tallies (fx+ tally (tally-failed)) (failed-in (fx- x1 x0) (fx- y1 y0)))
    (memory-order-release)
    (add! (tally-version) 1.0))
  render-tile!)

(define-syntax-rule (failed? film place)
  (fl= (flvector-ref film (fx+ place (rays-place))) (ERROR-RAYS)))

(define-syntax-rule (copy-pixel! to at from place)
  (let copy ([p : Fixnum 0])
    (when (fx< p (PIXEL-PLACES))
      (flvector-set! to (fx+ at p) (flvector-ref from (fx+ place p)))
      (copy (fx+ p 1)))))

(define-syntax-rule (start-pixel! film place samples)
  (begin
    (let clear ([p : Fixnum 0])
      (when (fx< p (wanted-place))
        (flvector-set! film (fx+ place p) 0.0)
        (clear (fx+ p 1))))
    (flvector-set! film (fx+ place (wanted-place)) samples)))

(define-syntax-rule (first-stream? sample) (fx= 0 (fxand sample 1)))

(define-syntax-rule (rays-traced i)
  (fx+ (fxvector-ref i nearest-rays) (fxvector-ref i occlusion-rays)))

;; While a pixel is rendered: the sums of both streams; what was rounded off each (Kahan 1965), so
;; that the mean of ten million is as exact as that of one; the last sample of the first stream; and
;; the sum of squared differences.
(define SUMS-SIZE 16)
(define-syntax-rule (lost-place) 6)
(define-syntax-rule (last-place) 12)
(define-syntax-rule (difference-place) 15)

(define-syntax-rule (start-sums! sums)
  (let clear ([k : Fixnum 0])
    (when (fx< k SUMS-SIZE)
      (flvector-set! sums k 0.0)
      (clear (fx+ k 1)))))

;; Whether a sample is something a picture can hold.
(define-syntax-rule (acceptable? r)
  (let-float3 ([color (Float3-in r radiance)])
    (and (fl>= (Float3-x color) 0.0) (fl>= (Float3-y color) 0.0) (fl>= (Float3-z color) 0.0)
         (fl< (Float3-largest-component color) +inf.0))))

(define-syntax-rule (add-sample! r sums stream-place)
  (let-float3 ([color (Float3-in r radiance)])
    (add-component! sums stream-place (Float3-x color))
    (add-component! sums (fx+ stream-place 1) (Float3-y color))
    (add-component! sums (fx+ stream-place 2) (Float3-z color))))

(define-syntax-rule (add-component! sums k value)
  (let* ([sum (flvector-ref sums k)]
         [term (fl- value (flvector-ref sums (fx+ k (lost-place))))]
         [next (fl+ sum term)])
    (flvector-set! sums (fx+ k (lost-place)) (fl- (fl- next sum) term))
    (flvector-set! sums k next)))

(define-syntax-rule (add-first! r sums)
  (begin
    (add-sample! r sums 0)
    (Float3-put! sums (last-place) (Float3-in r radiance))))

(define-syntax-rule (add-second! r sums)
  (begin
    (add-sample! r sums 3)
    (let-float3 ([difference (Float3-subtract (Float3-in r radiance)
                                              (Float3-in sums (last-place)))])
      (flvector-set! sums (difference-place)
                     (fl+ (flvector-ref sums (difference-place))
                          (Float3-length-squared difference))))))

;; Adds what this pass found to the film.
(: put-sums! (-> FlVector Fixnum FlVector Fixnum Fixnum Void))
(define (put-sums! film place sums wanted rays)
  (define-syntax-rule (add-to! k amount)
    (flvector-set! film (fx+ place k) (fl+ (flvector-ref film (fx+ place k)) amount)))
  (let each ([k : Fixnum 0])
    (when (fx< k 6)
      (add-to! k (flvector-ref sums k))
      (each (fx+ k 1))))
  (add-to! (squares-place) (flvector-ref sums (difference-place)))
  (add-to! (rays-place) (fx->fl rays))
  (flvector-set! film (fx+ place (taken-place)) (fx->fl wanted)))

(: count-rejected! (-> FxVector Fixnum Fixnum Void))
(define (count-rejected! i pixel sample)
  (define first (fxvector-ref i rejected-pixel))
  (fxvector-set! i rejected-samples (fx+ 1 (fxvector-ref i rejected-samples)))
  (when (or (fx= first 0) (fx< pixel (fx- first 1)))
    (fxvector-set! i rejected-pixel (fx+ pixel 1))
    (fxvector-set! i rejected-sample sample)))
