#lang typed/racket/base
;; What to render, as one immutable value; a schedule decides how. Any worker that has the job can
;; render any of its tiles, and gets the same pixels.
(require "../base/unsafe.rkt" "../world/world.rkt" "../world/camera.rkt"
         "../integrate/integrators.rkt" "pixel.rkt")

(provide (struct-out Job) Job-tile-count Job-film-size Job-worker)

(struct Job ([world : World] [camera : Camera] [tiling : Tiling]
             [samples : Fixnum] [seed : Fixnum] [integrator : Symbol] [max-depth : (U #f Fixnum)])
  #:transparent)

(: Job-tile-count (-> Job Fixnum))
(define (Job-tile-count job) (tile-count (Job-tiling job)))

;; Flonums in the film: three a pixel of the rendered part.
(: Job-film-size (-> Job Fixnum))
(define (Job-film-size job)
  (define crop (Tiling-crop (Job-tiling job)))
  (fx* 3 (fx* (caddr crop) (cadddr crop))))

;; A worker with a scratch of its own: a procedure that renders the tile it is given into the film,
;; and the registers that count what it did.
(: Job-worker (-> Job FlVector (Values (-> Fixnum Void) FxVector)))
(define (Job-worker job film)
  (define tiling (Job-tiling job))
  (define width (Tiling-width tiling))
  (define height (Tiling-height tiling))
  (make-tile-worker tiling (Job-samples job) (Job-seed job)
                    (Camera-kernel (Camera-fitted (Job-camera job) (/ width height)) width height)
                    (World-integrator (Job-world job) (Job-integrator job) (Job-max-depth job))
                    film))
