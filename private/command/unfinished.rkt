#lang racket/base
;; What is known of a render before it is done, and what is said and kept when it is interrupted.
(require racket/flonum "progress.rkt" "../render/render.rkt" "../render/film.rkt" "../render/job.rkt"
         "../render/passes.rkt" "../render/pixel.rkt" "../image/image.rkt" "../image/write.rkt")

(provide (struct-out keeper) progress->live kept-picture kept-checkpoint interrupted)

;; What keeps the checkpoint of a render in the file path: load! goes on from it in a render that starts,
;; save writes it now, during calls (use) while a thread saves the progress that a procedure returns,
;; delete! is for a render that is done.
(struct keeper (path load! save during delete!))

;; progress->live : as call-with-progress takes it.
(define (progress->live progress)
  (define target (Progress-target progress))
  (live (lambda ()
          (exact->inexact (+ (Target-total target tally-nearest-place)
                             (Target-total target tally-occlusion-place))))
        (lambda () (Target-relative-error target))
        (lambda () (picture-so-far progress))))

(define (picture-so-far progress)
  (define crop (Tiling-crop (Job-tiling (Progress-job progress))))
  (Target-image (Progress-target progress) (caddr crop) (cadddr crop)))

;; Writes the picture so far, pixels without samples black; returns what is said of it.
(define (kept-picture progress output)
  (define image (picture-so-far progress))
  (define pixels (Image-pixels image))
  (for ([k (in-range (flvector-length pixels))])
    (unless (fl= (flvector-ref pixels k) (flvector-ref pixels k)) (flvector-set! pixels k 0.0)))
  (Image-write image output)
  (format "~a is the picture so far" output))

(define (kept-checkpoint checkpoint)
  (format "the same command goes on from ~a" checkpoint))

;; interrupted : the break e with words that tell how far the render got and what was kept.
(define (interrupted e progress kept)
  (define passes (Progress-passes progress))
  (define seconds (cadr ((Passes-state passes))))
  (define text
    (apply string-append
           (if (exn:break:terminate? e) "terminated" "interrupted")
           (format " at ~a% after ~a" (inexact->exact (floor (* 100 ((Passes-progress passes)))))
                   (duration-text seconds))
           (for/list ([words (in-list kept)]) (string-append "; " words))))
  ((if (exn:break:terminate? e) exn:break:terminate exn:break)
   text (exn-continuation-marks e) (exn:break-continuation e)))
