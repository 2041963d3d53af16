#lang typed/racket/base
;; Where more samples pay: from what the film holds, the samples that every pixel should have next, so
;; that the picture's squared error falls fastest for the rays it costs.
;;   A pixel with variance v a sample, of which one costs c rays, gets samples in proportion to
;;   sqrt(v / c) (Neyman 1934). A pixel never loses samples, and gets at most GROWTH times what it has
;;   in one pass, for its variance is known only as well as its samples tell.
(require "../base/unsafe.rkt" "film.rkt")

(provide Film-plan-error! Film-plan-cost! PILOT-SAMPLES)

;; What every pixel gets before anything is known of it.
(define PILOT-SAMPLES 8)
(define-syntax-rule (GROWTH) 4.0)

(: channels (-> FlVector Flonum))
(define (channels film)
  (fx->fl (fx* 3 (fxquotient (flvector-length film) (PIXEL-PLACES)))))

;; The sum of a pixel's channels.
(: Film-light (-> FlVector Fixnum Flonum))
(define (Film-light film at)
  (fl/ (let add : Flonum ([k : Fixnum 0] [sum : Flonum 0.0])
         (if (fx< k 6) (add (fx+ k 1) (fl+ sum (flvector-ref film (fx+ at k)))) (fl+ sum 0.0)))
       (flvector-ref film (fx+ at (taken-place)))))

;; ----------------------------------------------------------------------------------------------

;; Film-plan-error! : asks for the samples with which the relative RMSE should become `target`, at most
;; `most` in a pixel. Returns the rays this pass should cost, and those of all passes that remain.
(: Film-plan-error! (-> FlVector Fixnum Flonum Fixnum (Values Flonum Flonum)))
(define (Film-plan-error! film width target most)
  (define pixels (pixel-variances film width))
  (define light
    (let each : Flonum ([at : Fixnum 0] [sum : Flonum 0.0])
      (if (fx< at (flvector-length film))
          (each (fx+ at (PIXEL-PLACES)) (fl+ sum (Film-light film at)))
          (fl+ sum 0.0))))
  (define goal (let ([root (fl* target light)]) (fl/ (fl* root root) (channels film))))
  (define factor
    (least-factor (lambda ([factor : Flonum])
                    (fl<= (predicted-error film pixels factor most) goal))))
  (define cost (predicted-cost film pixels factor (fx->fl most) +inf.0))
  (want! film pixels factor (fx->fl most))
  (values (predicted-cost film pixels factor (fx->fl most) (GROWTH)) cost))

;; Film-plan-cost! : asks for the best use of that many rays. Returns the rays it should cost.
(: Film-plan-cost! (-> FlVector Fixnum Flonum Fixnum Flonum))
(define (Film-plan-cost! film width rays most)
  (define pixels (pixel-variances film width))
  (define factor
    (least-factor (lambda ([factor : Flonum])
                    (fl>= (predicted-cost film pixels factor (fx->fl most) (GROWTH)) rays))))
  (want! film pixels factor (fx->fl most))
  (predicted-cost film pixels factor (fx->fl most) (GROWTH)))

;; The least power of a fine geometric sequence that is enough; the last one where none is.
(: least-factor (-> (-> Flonum Boolean) Flonum))
(define (least-factor enough?)
  (define (power [k : Fixnum]) (flexpt 2.0 (fl* 0.125 (fx->fl k))))
  (let halve : Flonum ([low : Fixnum -480] [high : Fixnum 480])
    (if (fx= (fx- high low) 1)
        (power high)
        (let ([middle (fxrshift (fx+ low high) 1)])
          (if (enough? (power middle)) (halve low middle) (halve middle high))))))

;; What is known of the pixels: for each the variance of a sample, all channels together, the rays a
;; sample costs, and the root of their quotient.
(define-syntax-rule (VARIANCE-PLACES) 3)

;; The samples a pixel has after a pass in which the factor is allowed that growth.
(define-syntax-rule (samples-after film pixels k factor most growth)
  (let* ([taken (flvector-ref film (fx+ (fx* k (PIXEL-PLACES)) (taken-place)))]
         [ideal (fl* factor (flvector-ref pixels (fx+ 2 (fx* k (VARIANCE-PLACES)))))])
    (flmax taken (flmin most (flmin ideal (fl* growth taken))))))

(define-syntax-rule (sum-over-pixels pixels (k) term)
  (let ([count (fxquotient (flvector-length pixels) (VARIANCE-PLACES))])
    (let each : Flonum ([k : Fixnum 0] [sum : Flonum 0.0])
      (if (fx< k count) (each (fx+ k 1) (fl+ sum term)) (fl+ sum 0.0)))))

(: predicted-error (-> FlVector FlVector Flonum Fixnum Flonum))
(define (predicted-error film pixels factor most0)
  (define most (fx->fl most0))
  (sum-over-pixels pixels (k)
    (fl/ (flvector-ref pixels (fx* k (VARIANCE-PLACES)))
         (samples-after film pixels k factor most +inf.0))))

(: predicted-cost (-> FlVector FlVector Flonum Flonum Flonum Flonum))
(define (predicted-cost film pixels factor most growth)
  (sum-over-pixels pixels (k)
    (fl* (flvector-ref pixels (fx+ 1 (fx* k (VARIANCE-PLACES))))
         (fl- (samples-after film pixels k factor most growth)
              (flvector-ref film (fx+ (fx* k (PIXEL-PLACES)) (taken-place)))))))

;; Writes down the samples wanted: pairs, one of each stream.
(: want! (-> FlVector FlVector Flonum Flonum Void))
(define (want! film pixels factor most)
  (define count (fxquotient (flvector-length pixels) (VARIANCE-PLACES)))
  (let each ([k : Fixnum 0])
    (when (fx< k count)
      (let ([at (fx* k (PIXEL-PLACES))]
            [samples (samples-after film pixels k factor most (GROWTH))])
        (flvector-set! film (fx+ at (wanted-place))
                       (flmax (flvector-ref film (fx+ at (taken-place)))
                              (fl* 2.0 (flfloor (fl+ 0.5 (fl* 0.5 samples)))))))
      (each (fx+ k 1)))))

;; Two things are known of a pixel. How its samples differ among each other tells the variance of one
;; well, but samples that are spread evenly have a mean that is nearer to the truth than so many
;; independent ones would be. By how much is known only roughly for a pixel, from the difference of
;; its two streams: so that factor is taken from the neighbourhood. And where few samples agree by
;; chance the neighbours tell better: a pixel's variance counts for no less than their mean. (Without
;; that, the weekend scene for an error of 5% came out 0.3% too bright and 20% above its estimate.)
(define-syntax-rule (EFFICIENCY-RADIUS) 4)
(define-syntax-rule (VARIANCE-RADIUS) 2)

(: pixel-variances (-> FlVector Fixnum FlVector))
(define (pixel-variances film width)
  (define count (fxquotient (flvector-length film) (PIXEL-PLACES)))
  (define height (fxquotient count width))
  (define-syntax-rule (per-pixel (at) value)
    (let ([values (make-flvector count)])
      (let each ([k : Fixnum 0])
        (when (fx< k count)
          (let ([at (fx* k (PIXEL-PLACES))])
            (flvector-set! values k value))
          (each (fx+ k 1))))
      values))
  (define-syntax-rule (taken at) (flvector-ref film (fx+ at (taken-place))))
  (define-syntax-rule (sample-variance at)
    (fl/ (flvector-ref film (fx+ at (squares-place))) (taken at)))
  (define own (per-pixel (at) (sample-variance at)))
  (define around (box-mean own width height (VARIANCE-RADIUS)))
  (define independent
    (box-mean (per-pixel (at) (fl/ (sample-variance at) (taken at)))
              width height (EFFICIENCY-RADIUS)))
  (define found
    (box-mean (per-pixel (at) (Film-squared-error film at)) width height (EFFICIENCY-RADIUS)))
  (define pixels (make-flvector (fx* count (VARIANCE-PLACES))))
  (let each ([k : Fixnum 0])
    (when (fx< k count)
      (let* ([at (fx* k (PIXEL-PLACES))]
             [to (fx* k (VARIANCE-PLACES))]
             [spread (flmax (flvector-ref own k) (flvector-ref around k))]
             [base (flvector-ref independent k)]
             [variance (if (fl> base 0.0)
                           (fl/ (fl* spread (flvector-ref found k)) base)
                           0.0)]
             [cost (flmax 1.0 (fl/ (flvector-ref film (fx+ at (rays-place))) (taken at)))])
        (flvector-set! pixels to variance)
        (flvector-set! pixels (fx+ to 1) cost)
        (flvector-set! pixels (fx+ to 2) (flsqrt (fl/ variance cost))))
      (each (fx+ k 1))))
  pixels)

;; The mean over a square of pixels around each, cut at the borders.
(: box-mean (-> FlVector Fixnum Fixnum Fixnum FlVector))
(define (box-mean values width height radius)
  (line-means (line-means values width height width 1 radius) height width 1 width radius))

;; The mean over 2 radius + 1 neighbours along lines: `lines` of them, `across` apart, of `length`
;; pixels, `along` apart.
(: line-means (-> FlVector Fixnum Fixnum Fixnum Fixnum Fixnum FlVector))
(define (line-means values length lines across along radius)
  (define means (make-flvector (flvector-length values)))
  (let each-line ([line : Fixnum 0])
    (when (fx< line lines)
      (let each ([x : Fixnum 0])
        (when (fx< x length)
          (let* ([first (if (fx< x radius) 0 (fx- x radius))]
                 [last (if (fx< (fx+ x radius) length) (fx+ x radius) (fx- length 1))]
                 [start (fx* line across)]
                 [sum (let add : Flonum ([k : Fixnum first] [sum : Flonum 0.0])
                        (if (fx<= k last)
                            (add (fx+ k 1)
                                 (fl+ sum (flvector-ref values (fx+ start (fx* k along)))))
                            (fl+ sum 0.0)))])
            (flvector-set! means (fx+ start (fx* x along))
                           (fl/ sum (fx->fl (fx+ 1 (fx- last first))))))
          (each (fx+ x 1))))
      (each-line (fx+ line 1))))
  means)
