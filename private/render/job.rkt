#lang typed/racket/base
;; What to render, as one immutable value; a schedule decides how. Any worker that has the job can
;; render any of its tiles, and gets the same pixels.
(require "../base/unsafe.rkt" "../world/world.rkt" "../world/camera.rkt"
         "../world/camera-kernel.rkt" "../shape/kernels.rkt" "../sample/filter.rkt"
         "../integrate/integrators.rkt" "../sample/sampler.rkt" "film.rkt" "pixel.rkt")

(provide (struct-out Job) Job-tile-count Job-target Job-bytes Job-worker)

;; scene: the file of a module that provides the world, where it is known. samples: how many a pixel gets, #f where the film says it pass by pass. sampler, filter and
;; integrator by name.
(struct Job ([world : World] [camera : Camera] [tiling : Tiling]
             [samples : (U #f Fixnum)] [seed : Fixnum] [sampler : Symbol] [filter : Symbol]
             [integrator : Symbol] [max-depth : (U #f Fixnum)]
             [scene : (U #f String)])
  #:transparent)

(: Job-tile-count (-> Job Fixnum))
(define (Job-tile-count job) (tile-count (Job-tiling job)))

;; Pixels of the rendered part.
(: Job-pixels (-> Job Fixnum))
(define (Job-pixels job)
  (define crop (Tiling-crop (Job-tiling job)))
  (fx* (caddr crop) (cadddr crop)))

;; What to write the job's pixels to, by a procedure that makes flvectors of a length and a value.
(: Job-target (-> Job (-> Fixnum Flonum FlVector) Target))
(define (Job-target job make)
  (define samples (Job-samples job))
  (define pixels (Job-pixels job))
  (define tallies (make (fx* (TALLY-PLACES) (Job-tile-count job)) 0.0))
  (cond
    [(not samples) (Target (make (fx* (PIXEL-PLACES) pixels) 0.0) #f tallies)]
    [else
     (Target (make (fx* 3 pixels) +nan.0)
             (make (if (eqv? samples 1) 0 (fx* 3 pixels)) +nan.0)
             tallies)]))

;; The memory that the target and the picture take together.
(: Job-bytes (-> Job Fixnum))
(define (Job-bytes job)
  (fx* (Job-pixels job)
       (cond
         [(not (Job-samples job)) (fx* 8 (fx+ (PIXEL-PLACES) 6))]
         [(eqv? 1 (Job-samples job)) 24]
         [else 48])))

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

;; A worker with a scratch of its own: a procedure that renders the tile it is given into the target,
;; or into one that holds a single tile (alone?); see pixel.rkt. observe: called with the integrator,
;; returns what takes its place.
(: Job-worker (->* (Job Target) (Boolean #:observe (-> Integrator Integrator))
                   (-> Fixnum (U #f Guard) Void)))
(define (Job-worker job target [alone? #f]
                    #:observe [observe (lambda ([integrator : Integrator]) integrator)])
  (define tiling (Job-tiling job))
  (define width (Tiling-width tiling))
  (define height (Tiling-height tiling))
  (define world (Job-world job))
  (make-tile-worker tiling (Job-samples job) (Filter-table (Job-filter job))
                    (sampler-number (Job-sampler job)) (Job-grid job) (Job-seed job)
                    (Camera-kernel (Camera-fitted (Job-camera job) (/ width height)) width height
                                   (ormap Shape-moves? (World-shapes world)))
                    (observe (World-integrator world (Job-integrator job) (Job-max-depth job)))
                    target alone?))
