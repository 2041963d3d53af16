#lang racket/base
;; A picture that becomes better and better: drawn at once by rasterization, then traced with more and
;; more samples. One render continues the film of the one before, so no sample is lost.
(require racket/flonum "../render/render.rkt" "../render/film.rkt" "../render/job.rkt"
         "../render/passes.rkt" "../render/statistics.rkt" "../render/memory.rkt"
         "../integrate/integrators.rkt" "../raster/raster.rkt" "../image/image.rkt"
         "../image/edit.rkt")

(provide (struct-out scene) (struct-out shown) now make-ready refine fast-preview next-divisor
         stage-goal over status-text)

;; What is looked at. samples: the most a pixel gets, or #f; error: the relative RMSE at which it is
;; good enough, or #f; the rest as for render.
(struct scene (world camera width height integrator samples error seed max-depth shading)
  #:transparent)

;; A picture on its way. samples: how many a pixel has, the mean; error: its estimated relative RMSE,
;; #f where it is not known; seconds: since its camera was there; failed: pixels that could not be
;; rendered; done?: whether it stays as it is.
(struct shown (image samples error seconds failed done?))

(define (now) (/ (current-inexact-monotonic-milliseconds) 1000.0))

;; ----------------------------------------------------------------------------------------------
;; Rasterization, while the camera moves

;; A preview shall take about so long: where it does not, it becomes coarser or finer.
(define PREVIEW-SECONDS 0.1)
(define COARSEST 4)

;; next-divisor : by what to divide the picture's sides for the next preview, after one with that
;; divisor took so long.
(define (next-divisor divisor seconds)
  (cond
    [(and (> seconds (* 1.5 PREVIEW-SECONDS)) (< divisor COARSEST)) (+ divisor 1)]
    ;; what the finer one will take, at most
    [(and (> divisor 1) (< (* seconds (/ (* divisor divisor) (* (- divisor 1) (- divisor 1))))
                           PREVIEW-SECONDS))
     (- divisor 1)]
    [else divisor]))

;; fast-preview : the picture without rays, its sides divided, and the seconds that took.
(define (fast-preview given divisor #:samples [samples 1])
  (define start (now))
  (define image
    (preview (scene-world given) (scene-camera given)
             #:width (max 1 (quotient (scene-width given) divisor))
             #:height (max 1 (quotient (scene-height given) divisor))
             #:samples samples #:shading (scene-shading given)))
  (values image (- (now) start)))

;; ----------------------------------------------------------------------------------------------
;; Tracing

;; make-ready : brings the world into the form that is traced, once for all pictures of it.
(define (make-ready given)
  (World-integrator (scene-world given) (scene-integrator given) (scene-max-depth given)))

;; The samples of the first passes, the same in all pixels.
(define FIRST-SAMPLES '(2 8))

;; Small tiles: a break waits for those that are being rendered.
(define TILE 8)

;; Each later stage makes the error so much smaller: half the variance.
(define STAGE-FACTOR 0.7)

;; stage-goal : the most samples of a pixel and the error at which the stage ends, as two values; #f
;; and #f where there is none. stage: from 0. error: what the one before left, or #f.
(define (stage-goal stage error most wanted)
  (define least (or wanted 1e-9))
  (cond
    [(< stage (length FIRST-SAMPLES))
     (define samples (list-ref FIRST-SAMPLES stage))
     (define before (if (zero? stage) 0 (list-ref FIRST-SAMPLES (- stage 1))))
     (if (and (> stage 0) (<= most before)) (values #f #f) (values (min samples most) least))]
    [(or (not error) (<= error least) (<= most (car (reverse FIRST-SAMPLES)))) (values #f #f)]
    [else (values most (max least (* STAGE-FACTOR error)))]))

;; The part of the time that may go into showing, and how often at most.
(define SHOW-SHARE 0.2)
(define SHOW-SECONDS 0.25)

;; refine : renders what is given in stages and calls show with a shown again and again, from this
;; thread or another one, a last time with one that is done. under: a picture of the same size, for
;; pixels without samples. start: when the camera came there, as (now) tells. A break ends it.
(define (refine given under show [start (now)])
  (define most (max 2 (or (scene-samples given) MOST-SAMPLES)))
  (define (tell target failed done? #:error? [error? #t])
    (define seen
      (shown (over (picture-so-far given target) under)
             (/ (Target-total target tally-taken-place) (* (scene-width given) (scene-height given)))
             (and error? (Target-relative-error target)) (- (now) start) failed done?))
    (show seen)
    seen)
  (let next-stage ([stage 0] [target #f] [seen #f])
    (define-values (samples goal)
      (stage-goal stage (and seen (shown-error seen)) most (scene-error given)))
    (cond
      [samples
       (define-values (statistics found)
         (render-stage given samples goal target (lambda (target)
                        ;; of a part of the picture it says little
                        (tell target 0 #f #:error? (> stage 0)))))
       (define done?
         (and (>= stage (length FIRST-SAMPLES))
              (eq? 'most-samples (Statistics-stopped-by statistics))))
       (define seen (tell found (Statistics-failed-pixels statistics) done?))
       (unless done? (next-stage (+ stage 1) found seen))]
      [else (show (struct-copy shown seen [done? #t]))])))

;; One stage, which goes on from the target of another, or begins where that is #f: its Statistics and
;; target. tell is called with the target now and then while it goes on.
(define (render-stage given samples goal before tell)
  (define target #f)
  (define teller #f)
  (define (prepare progress)
    (set! target (Progress-target progress))
    (when before (continue! progress before samples))
    (set! teller (thread (lambda () (tell-on (lambda () (tell target)))))))
  (dynamic-wind
   void
   (lambda ()
     (define-values (image statistics)
       (render/statistics (scene-world given) (scene-camera given)
                          #:width (scene-width given) #:height (scene-height given)
                          #:samples samples #:error goal #:seed (scene-seed given)
                          #:integrator (scene-integrator given)
                          #:max-depth (scene-max-depth given) #:tile TILE #:prepare prepare))
     (values statistics target))
   (lambda ()
     (when teller (kill-thread teller))
     (when target
       (unpin (Target-film target))
       (unpin (Target-tallies target))))))

;; Puts what another target holds into that of a render that starts. What was wanted there is wanted
;; again, or more where all pixels get the same.
(define (continue! progress before samples)
  (define target (Progress-target progress))
  (flvector-copy! (Target-film target) (Target-film before))
  (flvector-copy! (Target-tallies target) (Target-tallies before))
  (when (memv samples FIRST-SAMPLES) (Film-want! (Target-film target) samples))
  ((Passes-resume! (Progress-passes progress)) (list 1 0.0 0.0 1.0 1.0)))

(define (flvector-copy! to from)
  (for ([k (in-range (flvector-length from))]) (flvector-set! to k (flvector-ref from k))))

(define (tell-on tell)
  (let loop ([pause SHOW-SECONDS])
    (sleep pause)
    (define before (now))
    (tell)
    (loop (max SHOW-SECONDS (/ (- (now) before) SHOW-SHARE)))))

;; What the integrator shows, in its numbers.
(define (picture-so-far given target)
  (define image (Target-image target (scene-width given) (scene-height given)))
  (if (and (eq? 'error (scene-integrator given)) (Image-standard-error image))
      (Image-error-map image)
      image))

;; over : the first picture where it has numbers, the other one elsewhere; both of one size.
(define (over image under)
  (define pixels (Image-pixels image))
  (define others (Image-pixels under))
  (define count (flvector-length pixels))
  (if (for/and ([value (in-flvector pixels)]) (fl= value value))
      image
      (let ([merged (make-flvector count)])
        (for ([k (in-range count)])
          (define value (flvector-ref pixels k))
          (flvector-set! merged k (if (fl= value value) value (flvector-ref others k))))
        (make-Image (Image-width image) (Image-height image) merged))))

;; ----------------------------------------------------------------------------------------------

;; status-text : one line on a picture on its way, shown at an exposure.
(define (status-text seen stops)
  (define samples (shown-samples seen))
  (string-append
   (cond
     [(zero? samples) "preview"]
     [else
      (define error (shown-error seen))
      (format "~a samples a pixel, error ~a, ~a s" (decimals samples (if (< samples 10) 1 0))
              (cond
                [error (format "~a%" (decimals (* 100 error) (if (< error 0.1) 2 1)))]
                [else "not known yet"])
              (decimals (shown-seconds seen) 1))])
   (if (zero? stops) "" (format ", ~a~a stops" (if (positive? stops) "+" "") stops))
   (case (shown-failed seen)
     [(0) ""]
     [(1) ", a pixel could not be rendered"]
     [else (format ", ~a pixels could not be rendered" (shown-failed seen))])
   (if (and (shown-done? seen) (positive? samples)) ", done" "")))

(define (decimals number places)
  (if (zero? places)
      (number->string (inexact->exact (round number)))
      (real->decimal-string number places)))
