#lang typed/racket/base
;; The film: what the samples of each pixel have added up to. Every pixel has two streams of samples
;; that are randomised independently; how far their means differ tells the error of both together.
(require "../base/unsafe.rkt" "../image/image.rkt")

(provide PIXEL-PLACES sums-place squares-place rays-place taken-place wanted-place
         Film-want! Film-image Film-squared-error Film-relative-error
         (struct-out Target) Target-image Target-finish!
         TALLY-PLACES tally-version tally-nearest tally-occlusion tally-rejected tally-pixel tally-sample
         tally-taken tally-failed ERROR-RAYS pixel-places tally-places error-rays tally-failed-place tally-nearest-place tally-occlusion-place
         tally-taken-place Target-version
         Target-relative-error Target-total Target-first-rejected)

;; A pixel's places: sums of the first and of the second stream, red green blue each; the sum of the
;; squared differences between paired samples, over all channels; rays traced; samples taken; and the
;; samples it shall have at the end of this pass.
(define-syntax-rule (PIXEL-PLACES) 10)
(define-syntax-rule (sums-place) 0)
(define-syntax-rule (squares-place) 6)
(define-syntax-rule (rays-place) 7)
(define-syntax-rule (taken-place) 8)
(define-syntax-rule (wanted-place) 9)

;; Asks for the same number of samples in every pixel.
(: Film-want! (-> FlVector Fixnum Void))
(define (Film-want! film samples)
  (let each ([at : Fixnum 0])
    (when (fx< at (flvector-length film))
      (flvector-set! film (fx+ at (wanted-place)) (fx->fl samples))
      (each (fx+ at (PIXEL-PLACES))))))

;; The first stream's share of n samples: it has one more where n is odd.
(define-syntax-rule (first-stream-count n) (flfloor (fl* 0.5 (fl+ n 1.0))))

;; The squared standard error of a channel of a pixel, from one difference: unbiased, with one degree
;; of freedom. 0 where there are fewer than two samples.
(define-syntax-rule (squared-error film at channel)
  (let* ([n (flvector-ref film (fx+ at (taken-place)))]
         [first (first-stream-count n)]
         [second (fl- n first)])
    (if (fl< second 1.0)
        0.0
        (let ([difference (fl- (fl/ (flvector-ref film (fx+ at channel)) first)
                               (fl/ (flvector-ref film (fx+ at (fx+ 3 channel))) second))])
          (fl/ (fl* (fl* difference difference) (fl* first second)) (fl* n n))))))

;; The same over all channels of the pixel whose places start at `at`.
(: Film-squared-error (-> FlVector Fixnum Flonum))
(define (Film-squared-error film at)
  (fl+ (squared-error film at 0) (fl+ (squared-error film at 1) (squared-error film at 2))))

;; The picture: means, and their standard errors where every pixel has two samples or more.
(: Film-image (-> FlVector Fixnum Fixnum Image))
(define (Film-image film width height)
  (define count (fx* width height))
  (define pixels (make-flvector (* 3 count)))
  (define errors (make-flvector (* 3 count)))
  (let each ([k : Fixnum 0] [least : Flonum +inf.0])
    (cond
      [(fx< k count)
       (let ([at (fx* k (PIXEL-PLACES))] [to (fx* 3 k)])
         (put-pixel! film at pixels errors to)
         (each (fx+ k 1) (flmin least (flvector-ref film (fx+ at (taken-place))))))]
      [else (make-Image width height pixels (if (fl< least 2.0) #f errors))])))

;; Means and standard errors of the pixel whose places start at `at`.
(define-syntax-rule (put-pixel! film at pixels errors to)
  (begin
    (put-mean! film at pixels to 0)
    (put-mean! film at pixels to 1)
    (put-mean! film at pixels to 2)
    (put-error! film at errors to 0)
    (put-error! film at errors to 1)
    (put-error! film at errors to 2)))
(define-syntax-rule (put-mean! film at pixels to channel)
  (flvector-set! pixels (fx+ to channel)
                 (fl/ (fl+ (flvector-ref film (fx+ at channel))
                           (flvector-ref film (fx+ at (fx+ 3 channel))))
                      (flvector-ref film (fx+ at (taken-place))))))
(define-syntax-rule (put-error! film at errors to channel)
  (flvector-set! errors (fx+ to channel) (flsqrt (squared-error film at channel))))

;; The estimated RMSE of the picture relative to its mean, over the pixels that have samples; #f where
;; one of them has fewer than two. What Image-relative-error tells of its picture, up to rounding.
(: Film-relative-error (-> FlVector (U #f Flonum)))
(define (Film-relative-error film)
  (let each : (U #f Flonum) ([at : Fixnum 0] [count : Flonum 0.0] [error : Flonum 0.0] [light : Flonum 0.0])
    (cond
      [(fx< at (flvector-length film))
       (let ([n (flvector-ref film (fx+ at (taken-place)))])
         (cond
           [(fl= n 0.0) (each (fx+ at (PIXEL-PLACES)) count error light)]
           [(fl< n 2.0) #f]
           [else
            (each (fx+ at (PIXEL-PLACES)) (fl+ count 3.0)
                  (fl+ error (Film-squared-error film at))
                  (fl+ light (fl/ (sum-of-six film at) n)))]))]
      [(fl= count 0.0) #f]
      [(fl= light 0.0) 0.0]
      [else (fl/ (flsqrt (fl* error count)) light)])))
(: sum-of-six (-> FlVector Fixnum Flonum))
(define (sum-of-six film at)
  (let add : Flonum ([k : Fixnum 0] [sum : Flonum 0.0])
    (if (fx< k 6) (add (fx+ k 1) (fl+ sum (flvector-ref film (fx+ at k)))) (fl+ sum 0.0))))

;; ----------------------------------------------------------------------------------------------

;; What a render writes to. Where passes follow each other, film holds PIXEL-PLACES a pixel and errors
;; is #f. Where one pass gives each pixel all of its samples, only what becomes the picture is kept:
;; film holds the means, three a pixel, and errors their standard errors (none where samples is 1);
;; a pixel without samples yet is no number. tallies: TALLY-PLACES a tile.
(struct Target ([film : FlVector] [errors : (U #f FlVector)] [tallies : FlVector]))

;; A tile's tally: a version, odd while the tile is being written and 0 before that; rays; samples that
;; were rejected, the number of the first pixel among them plus 1 and its sample; samples taken; and pixels of the error colour.
(define-syntax-rule (TALLY-PLACES) 8)
(define-syntax-rule (tally-version) 0)
(define-syntax-rule (tally-nearest) 1)
(define-syntax-rule (tally-occlusion) 2)
(define-syntax-rule (tally-rejected) 3)
(define-syntax-rule (tally-pixel) 4)
(define-syntax-rule (tally-sample) 5)
(define-syntax-rule (tally-taken) 6)
(define-syntax-rule (tally-failed) 7)

;; What stands for the rays of a pixel that could not be rendered and has the error colour for good:
;; fewer than any sample traces.
(define-syntax-rule (ERROR-RAYS) 1e-300)

;; The same for modules that cannot use a typed module's macros.
(: pixel-places Fixnum)
(define pixel-places (PIXEL-PLACES))
(: error-rays Flonum)
(define error-rays (ERROR-RAYS))
(: tally-failed-place Fixnum)
(define tally-failed-place (tally-failed))
(: tally-places Fixnum)
(define tally-places (TALLY-PLACES))
(: tally-nearest-place Fixnum)
(define tally-nearest-place (tally-nearest))
(: tally-occlusion-place Fixnum)
(define tally-occlusion-place (tally-occlusion))
(: tally-taken-place Fixnum)
(define tally-taken-place (tally-taken))

;; A tile's version.
(: Target-version (-> Target Fixnum Fixnum))
(define (Target-version target tile)
  (fl->fx (flvector-ref (Target-tallies target) (fx+ (tally-version) (fx* tile (TALLY-PLACES))))))

;; The sum of one place over all tallies.
(: Target-total (-> Target Fixnum Fixnum))
(define (Target-total target place)
  (define tallies (Target-tallies target))
  (let each ([at : Fixnum place] [sum : Fixnum 0])
    (if (fx< at (flvector-length tallies))
        (each (fx+ at (TALLY-PLACES)) (fx+ sum (fl->fx (flvector-ref tallies at))))
        sum)))

;; The number of the first pixel with a rejected sample, plus 1, and that sample; 0 where there is none.
(: Target-first-rejected (-> Target (Values Fixnum Fixnum)))
(define (Target-first-rejected target)
  (define tallies (Target-tallies target))
  (let each ([at : Fixnum 0] [pixel : Fixnum 0] [sample : Fixnum 0])
    (if (fx< at (flvector-length tallies))
        (let ([other (fl->fx (flvector-ref tallies (fx+ at (tally-pixel))))])
          (if (and (fx> other 0) (or (fx= pixel 0) (fx< other pixel)))
              (each (fx+ at (TALLY-PLACES)) other
                    (fl->fx (flvector-ref tallies (fx+ at (tally-sample)))))
              (each (fx+ at (TALLY-PLACES)) pixel sample)))
        (values pixel sample))))

;; Writes the finished pixel whose places in `film` start at `at` as the target's pixel k.
(: Target-finish! (-> Target Fixnum FlVector Fixnum Void))
(define (Target-finish! target k film at)
  (define pixels (Target-film target))
  (define errors (Target-errors target))
  (define to (fx* 3 k))
  (when errors
    (if (fx= 0 (flvector-length errors))
        (begin (put-mean! film at pixels to 0) (put-mean! film at pixels to 1)
               (put-mean! film at pixels to 2))
        (put-pixel! film at pixels errors to))))

;; The picture so far. Where the target holds it already, it is that, not a copy.
(: Target-image (-> Target Fixnum Fixnum Image))
(define (Target-image target width height)
  (define errors (Target-errors target))
  (cond
    [errors (make-Image width height (Target-film target)
                        (if (fx= 0 (flvector-length errors)) #f errors))]
    [else (Film-image (Target-film target) width height)]))

;; The estimated RMSE of the pixels so far relative to their mean, #f where it is not known.
(: Target-relative-error (-> Target (U #f Flonum)))
(define (Target-relative-error target)
  (define errors (Target-errors target))
  (define pixels (Target-film target))
  (cond
    [(not errors) (Film-relative-error pixels)]
    [(fx= 0 (flvector-length errors)) #f]
    [else
     (let each : (U #f Flonum) ([k : Fixnum 0] [count : Flonum 0.0] [error : Flonum 0.0] [light : Flonum 0.0])
       (cond
         [(fx< k (flvector-length pixels))
          (let ([mean (flvector-ref pixels k)] [own (flvector-ref errors k)])
            ;; one of them is no number before the pixel is there
            (if (and (fl= mean mean) (fl= own own))
                (each (fx+ k 1) (fl+ count 1.0) (fl+ error (fl* own own)) (fl+ light mean))
                (each (fx+ k 1) count error light)))]
         [(fl= count 0.0) #f]
         [(fl= light 0.0) 0.0]
         [else (fl/ (flsqrt (fl* error count)) light)]))]))
