#lang typed/racket/base
;; What a render did: rays, rejected samples, times.
(provide (struct-out Statistics))

;; nearest-rays and occlusion-rays: how many were traced. rejected-samples: those that were no
;; finite non-negative number; first-rejected: the pixel's column and row and the number of the
;; sample, of the first one in reading order. build-seconds: compiling the world, 0 when it was
;; compiled before.
;; seconds: wall-clock time of the rendering; processor-seconds: of all its threads.
(struct Statistics
  ([pixels : Fixnum] [samples : Fixnum] [nearest-rays : Fixnum] [occlusion-rays : Fixnum]
   [rejected-samples : Fixnum] [first-rejected : (U #f (List Fixnum Fixnum Fixnum))]
   [build-seconds : Flonum] [seconds : Flonum]
   [processor-seconds : Flonum])
  #:transparent)
