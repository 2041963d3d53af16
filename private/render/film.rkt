#lang typed/racket/base
;; The film: what the samples of each pixel have added up to. Every pixel has two streams of samples
;; that are randomised independently; how far their means differ tells the error of both together.
(require "../base/unsafe.rkt" "../image/image.rkt")

(provide PIXEL-PLACES sums-place squares-place rays-place taken-place wanted-place
         Film-want! Film-image Film-cost-image Film-error-image Film-samples Film-squared-error)

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

;; How many samples were taken in all.
(: Film-samples (-> FlVector Flonum))
(define (Film-samples film)
  (let each ([at : Fixnum 0] [sum : Flonum 0.0])
    (if (fx< at (flvector-length film))
        (each (fx+ at (PIXEL-PLACES)) (fl+ sum (flvector-ref film (fx+ at (taken-place)))))
        (fl+ sum 0.0))))

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
  (define-syntax-rule (put-channel! at to channel)
    (begin
      (flvector-set! pixels (fx+ to channel)
                     (fl/ (fl+ (flvector-ref film (fx+ at channel))
                               (flvector-ref film (fx+ at (fx+ 3 channel))))
                          (flvector-ref film (fx+ at (taken-place)))))
      (flvector-set! errors (fx+ to channel) (flsqrt (squared-error film at channel)))))
  (let each ([k : Fixnum 0] [least : Flonum +inf.0])
    (cond
      [(fx< k count)
       (let ([at (fx* k (PIXEL-PLACES))] [to (fx* 3 k)])
         (put-channel! at to 0)
         (put-channel! at to 1)
         (put-channel! at to 2)
         (each (fx+ k 1) (flmin least (flvector-ref film (fx+ at (taken-place))))))]
      [else (make-Image width height pixels (if (fl< least 2.0) #f errors))])))

;; Greys that tell of a pixel: the rays a sample took, and the root of the mean squared standard error
;; of its channels.
(: Film-cost-image (-> FlVector Fixnum Fixnum Image))
(define (Film-cost-image film width height)
  (grey-image film width height
              (lambda ([at : Fixnum])
                (fl/ (flvector-ref film (fx+ at (rays-place)))
                     (flvector-ref film (fx+ at (taken-place)))))))

(: Film-error-image (-> FlVector Fixnum Fixnum Image))
(define (Film-error-image film width height)
  (grey-image film width height
              (lambda ([at : Fixnum]) (flsqrt (fl/ (Film-squared-error film at) 3.0)))))

(: grey-image (-> FlVector Fixnum Fixnum (-> Fixnum Flonum) Image))
(define (grey-image film width height grey)
  (define count (fx* width height))
  (define pixels (make-flvector (* 3 count)))
  (let each ([k : Fixnum 0])
    (when (fx< k count)
      (let ([value (grey (fx* k (PIXEL-PLACES)))] [to (fx* 3 k)])
        (flvector-set! pixels to value)
        (flvector-set! pixels (fx+ to 1) value)
        (flvector-set! pixels (fx+ to 2) value)
        (each (fx+ k 1)))))
  (make-Image width height pixels))
