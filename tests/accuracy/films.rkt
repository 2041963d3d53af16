#lang typed/racket/base
;; The samples each pixel of an adaptive render took, read off its film.
(require racket/flonum
         "../../main.rkt" "../../private/base/unsafe-typed.rkt"
         "../../private/render/film.rkt" "../../private/render/job.rkt"
         "../../private/render/pixel.rkt" "../../private/render/passes.rkt")

(unsafe-require/typed "../../private/render/schedule/sequential.rkt"
  [run-sequential (-> Job Target Fixnum (-> Any) (-> Fixnum Any Void) Any)])

(provide film-samples)

;; film-samples : by rows, for a relative error.
(: film-samples (-> World Camera Positive-Fixnum Positive-Fixnum Positive-Flonum
                    (Vectorof Flonum)))
(define (film-samples world camera width height error)
  (define job
    (Job world camera (Tiling width height 16 (list 0 0 width height)) #f 0 'owen-sobol 'box 'auto #f #f))
  (define target (Job-target job (lambda ([size : Fixnum] [value : Flonum]) (make-flvector size value))))
  (define film (Target-film target))
  (define passes
    (make-passes film width (Job-tile-count job) (Goal MOST-SAMPLES error #f)))
  (run-sequential job target 1 (Passes-next passes) void)
  (for/vector : (Vectorof Flonum)
              ([at (in-range (taken-place) (flvector-length film) (PIXEL-PLACES))])
    (flvector-ref film at)))
