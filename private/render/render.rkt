#lang typed/racket/base
;; Rendering: a World seen by a Camera becomes an Image, by whatever schedule is asked for.
(require "../base/unsafe-typed.rkt"
         "../base/unsafe.rkt" "../base/check.rkt" "../base/float3.rkt" "../base/registers.rkt"
         "../world/world.rkt" "../world/camera.rkt" "../image/image.rkt" "../image/error.rkt"
         "../integrate/integrators.rkt" "../sample/sampler.rkt" "../sample/filter.rkt"
         "film.rkt" "passes.rkt" "pixel.rkt" "job.rkt" "statistics.rkt")

(provide render render/statistics (struct-out Progress) SCHEDULES default-worker-count MOST-SAMPLES)

(define-type Schedule (-> Job Target Fixnum (-> Any) (-> Fixnum Any Void) Any))
(unsafe-require/typed "schedule/sequential.rkt" [run-sequential Schedule])
(unsafe-require/typed "schedule/futures.rkt" [run-futures Schedule])
(unsafe-require/typed "schedule/lazy.rkt" [run-places Schedule]
  [run-hosts (-> Path-String Schedule)])
(unsafe-require/typed "../raster/lazy.rkt"
  [raster-image (-> World Camera Fixnum Fixnum Integer (U Symbol (Listof Symbol))
                    (U #f (List Integer Integer Integer Integer))
                    Image)])
(unsafe-require/typed racket/base
  [current-inexact-monotonic-milliseconds (-> Flonum)])
(unsafe-require/typed racket/future
  [processor-count (-> Positive-Fixnum)])
(unsafe-require/typed "schedule/tiles.rkt"
  [call-with-lock (-> Semaphore (-> Any) Any)])
(unsafe-require/typed "faults.rkt"
  [make-faults (-> Boolean Fixnum Fixnum (Values (-> Fixnum Any Void)
                                                 (-> (Listof (List String Fixnum Fixnum)))))])
(unsafe-require/typed "memory.rkt"
  [make-pinned-flvector (-> Fixnum Flonum FlVector)]
  [unpin (-> FlVector Void)]
  [check-memory (-> Fixnum Fixnum Fixnum Void)])

;; A render that goes on, for whoever watches it or keeps what is done. skip: a byte for each tile, not
;; 0 for those that are not rendered here. Between passes the film is planned anew: who reads a whole
;; one holds the lock.
(struct Progress ([job : Job] [target : Target] [passes : Passes] [skip : Bytes]
                  [lock : Semaphore]))

(define SCHEDULES : (Listof Symbol) '(sequential futures places hosts))

;; As many workers as the machine has processors.
(: default-worker-count (-> Positive-Fixnum))
(define (default-worker-count) (processor-count))

;; render : the picture of a world through a camera, with its standard error. #:width and #:height in
;; pixels. #:samples camera rays a pixel, 16 unless said otherwise. Or #:error: the RMSE relative to
;; the picture's mean at which to stop; samples go where they lower it most. Or #:seconds: the time
;; to use, wall-clock. With one of these #:samples is the most a pixel gets, MOST-SAMPLES by default.
;; #:sampler one of SAMPLERS. #:filter one of FILTERS: how a pixel weighs what falls near it.
;; #:integrator one of INTEGRATORS; 'cost shows the rays that a sample of each pixel took and 'error the
;; pixel's standard error, both as greys (see Image-false-color). #:seed any whole number of 32 bits; the
;; same seed gives the same picture, to the bit, whatever the schedule, workers and tile (but not with
;; #:seconds). #:max-depth bounces of a path, #f for no limit. #:schedule one of SCHEDULES. #:crop
;; (list x y width height) renders only that part.
;; The integrator 'raster draws without rays, as preview does (see there), with #:samples, 4 unless said
;; otherwise, and #:shading one of SHADINGS or a list of them; it has no #:error and takes no #:seconds.
;; A pixel where a function of the scene raises twice is left magenta, (1, 0, 1); with #:strict? the
;; render stops there instead. #:scene the file of a module that provides `world`: workers elsewhere
;; load it where the world holds functions. #:hosts the file of hosts for the schedule 'hosts.
;; Raises exn:fail:contract on numbers out of range.
(: render (->* (World Camera)
               (#:width Integer #:height Integer #:samples (U #f Integer)
                #:error (U #f Real) #:seconds (U #f Real) #:seed Integer
                #:sampler Symbol #:filter Symbol #:integrator Symbol #:max-depth (U #f Integer)
                #:schedule Symbol #:workers Integer #:tile Integer
                #:shading (U Symbol (Listof Symbol))
                #:crop (U #f (List Integer Integer Integer Integer))
                #:strict? Boolean #:scene (U #f Path-String) #:hosts (U #f Path-String))
               Image))
(define (render world camera #:width [width 640] #:height [height 360] #:samples [samples #f]
                #:error [error #f] #:seconds [seconds #f] #:seed [seed 0]
                #:sampler [sampler 'owen-sobol] #:filter [filter 'box]
                #:integrator [integrator 'auto]
                #:max-depth [max-depth #f] #:schedule [schedule 'futures]
                #:workers [workers (default-worker-count)] #:tile [tile 16]
                #:shading [shading 'phong] #:crop [crop #f]
                #:strict? [strict? #f] #:scene [scene #f] #:hosts [hosts #f])
  (define-values (image statistics)
    (render/statistics world camera #:width width #:height height #:samples samples
                       #:error error #:seconds seconds #:seed seed #:sampler sampler
                       #:filter filter #:integrator integrator #:max-depth max-depth
                       #:schedule schedule #:workers workers #:tile tile #:crop crop
                       #:shading shading #:strict? strict? #:scene scene #:hosts hosts))
  (define errors (Image-standard-error image))
  (unpin (Image-pixels image))
  (when errors (unpin errors))
  image)

;; The same with Statistics beside the picture, of which pixels that were not rendered are no numbers.
;; #:part (list I N): only the tiles whose number has the remainder I - 1 by N. #:prepare is called with
;; the Progress before the first tile: it may put what is known already into the target. #:watch is
;; called at the start with a procedure that tells the part that is done, from 0 to 1, and the Progress,
;; and returns a procedure called at the end. A large picture's flvectors stay where they are for good.
(: render/statistics
   (->* (World Camera)
        (#:width Integer #:height Integer #:samples (U #f Integer)
         #:error (U #f Real) #:seconds (U #f Real) #:seed Integer
         #:sampler Symbol #:filter Symbol #:integrator Symbol #:max-depth (U #f Integer)
         #:schedule Symbol #:workers Integer #:tile Integer
         #:shading (U Symbol (Listof Symbol))
         #:crop (U #f (List Integer Integer Integer Integer))
         #:strict? Boolean #:scene (U #f Path-String) #:hosts (U #f Path-String)
         #:part (U #f (List Integer Integer)) #:prepare (-> Progress Any)
         #:watch (-> (-> Real) Progress (-> Void)))
        (Values Image Statistics)))
(define (render/statistics world camera #:width [width 640] #:height [height 360]
                           #:samples [samples #f] #:error [error #f] #:seconds [seconds #f]
                           #:seed [seed 0] #:sampler [sampler 'owen-sobol] #:filter [filter 'box]
                           #:integrator [integrator 'auto] #:max-depth [max-depth #f]
                           #:schedule [schedule 'futures]
                           #:workers [workers (default-worker-count)] #:tile [tile 16]
                           #:shading [shading 'phong] #:crop [crop #f]
                           #:strict? [strict? #f] #:scene [scene #f] #:hosts [hosts #f]
                           #:part [part #f] #:prepare [prepare void]
                           #:watch [watch (lambda (done progress) void)])
  (define columns (check-count 'render "width" width 1 100000))
  (define rows (check-count 'render "height" height 1 100000))
  (if (eq? integrator 'raster)
      (raster/statistics world camera columns rows samples error seconds shading crop)
      (trace/statistics world camera columns rows samples error seconds seed sampler filter integrator
                        max-depth schedule workers tile crop strict? scene hosts part prepare watch)))

;; A picture without rays, and how long it took.
(: raster/statistics (-> World Camera Fixnum Fixnum (U #f Integer) (U #f Real) (U #f Real)
                         (U Symbol (Listof Symbol)) (U #f (List Integer Integer Integer Integer))
                         (Values Image Statistics)))
(define (raster/statistics world camera columns rows samples error seconds shading crop)
  (define (no-goal [name : String] [value : (U #f Real)])
    (when value
      (raise-expected 'render name "#f for the integrator raster, which has no noise to lower," value)))
  (no-goal "error" error)
  (no-goal "seconds" seconds)
  (define count (check-count 'render "samples" (or samples 4) 1 64))
  (define start (current-inexact-milliseconds))
  (define processor-start (current-process-milliseconds))
  (define image (raster-image world camera columns rows count shading crop))
  (define pixels (fx* (Image-width image) (Image-height image)))
  (values
   image
   (Statistics pixels (fx* count pixels) 0 0 0 #f 0 '() #f #f 1 'samples 0.0
               (fl/ (fl- (current-inexact-milliseconds) start) 1000.0)
               (fl/ (fx->fl (fx- (current-process-milliseconds) processor-start)) 1000.0))))

(: trace/statistics
   (-> World Camera Fixnum Fixnum (U #f Integer) (U #f Real) (U #f Real) Integer Symbol Symbol Symbol
       (U #f Integer) Symbol Integer Integer (U #f (List Integer Integer Integer Integer))
       Boolean (U #f Path-String) (U #f Path-String)
       (U #f (List Integer Integer)) (-> Progress Any) (-> (-> Real) Progress (-> Void))
       (Values Image Statistics)))
(define (trace/statistics world camera columns rows samples error seconds seed sampler filter
                          integrator max-depth schedule workers tile crop strict? scene hosts part prepare watch)
  (define goal
    (Goal (check-count 'render "samples" (or samples (if (or error seconds) MOST-SAMPLES 16))
                       1 1000000000)
          (and error (check-positive 'render "error" error))
          (and seconds (check-positive 'render "seconds" seconds))))
  (define tile-side (check-count 'render "tile" tile 1 100000))
  (define worker-count (check-count 'render "workers" workers 1 1024))
  (define seed32 (check-count 'render "seed" seed 0 #xFFFFFFFF))
  (define area : (List Fixnum Fixnum Fixnum Fixnum)
    (if crop (check-crop crop columns rows) (list 0 0 columns rows)))
  (define tiling (Tiling columns rows tile-side area))
  (define job (Job world camera tiling (if (or error seconds) #f (Goal-samples goal)) seed32 sampler
                   filter integrator
                   (and max-depth (check-count 'render "max-depth" max-depth 0 1000000000))
                   (and scene (path->string (path->complete-path scene)))))
  (define run
    (case schedule
      [(sequential) run-sequential]
      [(futures) run-futures]
      [(places) run-places]
      [(hosts) (if hosts (run-hosts hosts) (raise-expected 'render "hosts" "a file" hosts))]
      [else (raise-expected 'render "schedule" (format "one of ~a" SCHEDULES) schedule)]))
  (check-integrator integrator)
  (when (and (eq? integrator 'error) (< (Goal-samples goal) 2))
    (raise-expected 'render "samples" "at least 2 where the error is shown" samples))
  (sampler-number sampler)
  (check-filter filter)
  (check-memory (Job-bytes job) (caddr area) (cadddr area))
  (define start (current-inexact-monotonic-milliseconds))
  (unless (memq schedule '(places hosts)) (World-scene world))
  (define built (current-inexact-monotonic-milliseconds))
  (define processor-start (current-process-milliseconds))
  (define target
    (Job-target job make-pinned-flvector))
  (define count (Job-tile-count job))
  (define skip (make-bytes count 0))
  (when part
    (for ([tile (in-range count)])
      (unless (= (remainder tile (cadr part)) (- (car part) 1)) (bytes-set! skip tile 1))))
  (define passes
    (make-passes (if (Target-errors target) #f (Target-film target)) (caddr area) count goal skip))
  (define lock (make-semaphore 1))
  (define progress (Progress job target passes skip lock))
  (prepare progress)
  (define finish (watch (Passes-progress passes) progress))
  (define next (Passes-next passes))
  ;; a plan that a break cuts off would leave a film that cannot be gone on with
  (define-values (report-fault! faults) (make-faults strict? columns seed32))
  (run job target worker-count (lambda () (call-with-lock lock next)) report-fault!)
  (finish)
  (define image (Target-image target (caddr area) (cadddr area)))
  (define-values (rejected-pixel-number sample) (Target-first-rejected target))
  (values
   (if (eq? integrator 'error) (error-image image) image)
   (Statistics (if part
                   (for/fold ([sum : Fixnum 0]) ([tile (in-range count)])
                     (cond
                       [(= (remainder tile (cadr part)) (- (car part) 1))
                        (define-values (x0 y0 x1 y1) (Tiling-bounds tiling (assert tile fixnum?)))
                        (fx+ sum (fx* (fx- x1 x0) (fx- y1 y0)))]
                       [else sum]))
                   (fx* (caddr area) (cadddr area)))
               (Target-total target (tally-taken))
               (Target-total target (tally-nearest)) (Target-total target (tally-occlusion))
               (Target-total target (tally-rejected))
               (and (fx> rejected-pixel-number 0)
                    (list (fxremainder (fx- rejected-pixel-number 1) columns)
                          (fxquotient (fx- rejected-pixel-number 1) columns) sample))
               (Target-total target (tally-failed)) (faults)
               (if part #f (Image-relative-error image))
               (if part #f (Image-relative-error-uncertainty image))
               ((Passes-count passes)) ((Passes-stopped-by passes))
               (fl/ (fl- built start) 1000.0)
               (cadr ((Passes-state passes)))
               (fl/ (fx->fl (fx- (current-process-milliseconds) processor-start)) 1000.0))))

;; Greys that tell the root of the mean squared standard error of a pixel's channels.
(: error-image (-> Image Image))
(define (error-image image)
  (define errors (assert (Image-standard-error image)))
  (define pixels (make-flvector (flvector-length errors) 0.0))
  (let each ([at : Fixnum 0])
    (when (fx< at (flvector-length errors))
      (let-float3 ([e (Float3-in errors at)])
        (let ([grey (flsqrt (fl/ (Float3-length-squared e) 3.0))])
          (Float3-put! pixels at (Float3 grey grey grey))))
      (each (fx+ at 3))))
  (make-Image (Image-width image) (Image-height image) pixels))

(: check-crop (-> (List Integer Integer Integer Integer) Fixnum Fixnum
                  (List Fixnum Fixnum Fixnum Fixnum)))
(define (check-crop crop width height)
  (define x (check-count 'render "crop's x" (car crop) 0 (- width 1)))
  (define y (check-count 'render "crop's y" (cadr crop) 0 (- height 1)))
  (list x y
        (check-count 'render "crop's width" (caddr crop) 1 (- width x))
        (check-count 'render "crop's height" (cadddr crop) 1 (- height y))))
