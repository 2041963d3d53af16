#lang typed/racket/base
;; What to render, as one immutable value; a schedule decides how. Any worker that has the job can
;; render any of its tiles, and gets the same pixels.
(require "../base/unsafe.rkt" "../world/world.rkt" "../world/camera.rkt"
         "../world/camera-kernel.rkt" "../shape/kernels.rkt" "../sample/filter.rkt"
         "../integrate/integrators.rkt" "../sample/sampler.rkt" "film.rkt" "pixel.rkt")

(provide (struct-out Job) Job-tile-count Job-film-size Job-worker)

;; samples: how many a pixel gets, #f where the film says it pass by pass. sampler, filter and
;; integrator by name.
(struct Job ([world : World] [camera : Camera] [tiling : Tiling]
             [samples : (U #f Fixnum)] [seed : Fixnum] [sampler : Symbol] [filter : Symbol]
             [integrator : Symbol] [max-depth : (U #f Fixnum)])
  #:transparent)

(: Job-tile-count (-> Job Fixnum))
(define (Job-tile-count job) (tile-count (Job-tiling job)))

;; Flonums in the film of the rendered part.
(: Job-film-size (-> Job Fixnum))
(define (Job-film-size job)
  (define crop (Tiling-crop (Job-tiling job)))
  (fx* (PIXEL-PLACES) (fx* (caddr crop) (cadddr crop))))

;; The samples of one grid of the stratified sampler: one stream's of all samples, where they are few
;; enough and known.
(define-syntax-rule (MOST-CELLS) 4096)
(define-syntax-rule (ADAPTIVE-CELLS) 16)
(: Job-grid (-> Job Fixnum))
(define (Job-grid job)
  (define samples (Job-samples job))
  (cond
    [(not samples) (ADAPTIVE-CELLS)]
    [(< samples (fx* 2 (MOST-CELLS))) (fxrshift (fx+ samples 1) 1)]
    [else (MOST-CELLS)]))

;; A worker with a scratch of its own: a procedure that renders the tile it is given into the film,
;; and the registers that count what it did. observe: called with the integrator, returns what takes
;; its place.
(: Job-worker (->* (Job FlVector) ((-> Integrator Integrator))
                   (Values (-> Fixnum Void) FxVector)))
(define (Job-worker job film [observe (lambda ([integrator : Integrator]) integrator)])
  (define tiling (Job-tiling job))
  (define width (Tiling-width tiling))
  (define height (Tiling-height tiling))
  (define world (Job-world job))
  (make-tile-worker tiling (eqv? 1 (Job-samples job)) (Filter-table (Job-filter job))
                    (sampler-number (Job-sampler job)) (Job-grid job) (Job-seed job)
                    (Camera-kernel (Camera-fitted (Job-camera job) (/ width height)) width height
                                   (ormap Shape-moves? (World-shapes world)))
                    (observe (World-integrator world (Job-integrator job) (Job-max-depth job)))
                    film))
