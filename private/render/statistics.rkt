#lang typed/racket/base
;; What a render did: samples, rays, error, times.
(provide (struct-out Statistics))

;; samples: taken in all pixels together. nearest-rays and occlusion-rays: how many were traced.
;; rejected-samples: those that were no finite non-negative number; first-rejected: the pixel's
;; column and row and the number of the sample, of the first one in reading order. failed-pixels: those left in the error colour, for they could not be
;; rendered; faults: why, in this process: a text, column and row of the first, for each text. error: the
;; estimated RMSE of the picture relative to its mean, and error-uncertainty the standard error of
;; that estimate; #f where pixels have one sample only. passes: how often all tiles were gone over.
;; stopped-by: 'samples where every pixel has what was asked for, else 'error or 'seconds where that
;; goal is reached, and 'most-samples where all pixels that need more have the most they may get.
;; build-seconds: compiling the world, 0 when it was compiled before. seconds: wall-clock time of
;; the rendering; processor-seconds: of all its threads.
(struct Statistics
  ([pixels : Fixnum] [samples : Fixnum] [nearest-rays : Fixnum] [occlusion-rays : Fixnum]
   [rejected-samples : Fixnum] [first-rejected : (U #f (List Fixnum Fixnum Fixnum))]
   [failed-pixels : Fixnum] [faults : (Listof (List String Fixnum Fixnum))]
   [error : (U #f Flonum)] [error-uncertainty : (U #f Flonum)]
   [passes : Fixnum] [stopped-by : Symbol]
   [build-seconds : Flonum] [seconds : Flonum]
   [processor-seconds : Flonum])
  #:transparent)
