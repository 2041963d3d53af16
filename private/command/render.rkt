#lang racket/base
;; Rendering a scene to a picture file: what can be wrong is checked before the first ray.
(require racket/lazy-require "values.rkt" "scenes.rkt" "load.rkt" "progress.rkt" "report.rkt"
         "../integrate/integrators.rkt" "../sample/sampler.rkt" "../sample/filter.rkt"
         "../render/render.rkt" "../render/statistics.rkt" "../image/image.rkt"
         "../image/write.rkt")

(lazy-require ["studio.rkt" (load-studio)]
              ["needs.rkt" (scene-needs)])

(provide render-scene)

;; render-scene : renders the scene that word names and writes the picture. options: a hash as
;; parse-render-flags makes it. Raises exn:fail:user on bad input; then there is no output file.
(define (render-scene options word)
  (define path (find-scene word))
  (define output (hash-ref options 'output (lambda () (string-append (scene-name path) ".ppm"))))
  (define json (hash-ref options 'stats-json #f))
  (check-output-path output)
  (when json (check-json-path json output))
  (define quiet? (hash-ref options 'quiet #f))
  (define show? (and (not quiet?) (terminal-port? (current-error-port))))
  (define-values (world camera settings)
    (if (mesh-file? path) (load-studio path show?) (load-scene word path)))
  (define (option key default)
    (hash-ref options key (lambda () (hash-ref settings key default))))
  (define (named-option key default names)
    (define what
      (if (hash-has-key? options key) (format "--~a" key) (format "~a: settings, '~a" word key)))
    (check-name what (option key default) names))
  (define size (option 'size '(640 360)))
  ;; a goal that is asked for goes before the scene's samples; samples beside it are the most
  (define goal? (or (hash-has-key? options 'error) (hash-has-key? options 'seconds)))
  (define integrator (named-option 'integrator 'auto INTEGRATORS))
  (define raster? (eq? integrator 'raster))
  (when (and raster? goal?)
    (define key (if (hash-has-key? options 'error) 'error 'seconds))
    (unexpected (format "--~a" key) (hash-ref options key)
                "another integrator than raster, which has no noise to lower"))
  (define shading
    (check-shading (if (hash-has-key? options 'shading)
                       "--shading"
                       (format "~a: settings, 'shading" word))
                   (option 'shading 'phong) SHADINGS))
  ;; what a scene asks of another integrator says nothing about rasterization
  (define samples
    (cond
      [(or goal? (and raster? (not (eq? 'raster (hash-ref settings 'integrator #f)))))
       (hash-ref options 'samples #f)]
      [else (option 'samples (if raster? 4 16))]))
  (define seed (option 'seed 0))
  (define crop (check-crop "--crop" (option 'crop #f) size))
  (define sampler (named-option 'sampler 'owen-sobol SAMPLERS))
  (define filter (named-option 'filter 'box FILTERS))
  (define schedule (named-option 'schedule 'futures SCHEDULES))
  (define workers (option 'workers (default-worker-count)))
  (define-values (image statistics)
    (call-with-progress
     show?
     (lambda (watch)
       (with-handlers ([exn:fail? (lambda (e) (raise-user-error
                                               (format "~a: ~a" word (exn-message e))))])
         (parameterize ([current-output-port (current-error-port)])
           (render/statistics world camera #:width (car size) #:height (cadr size)
                              #:samples samples #:error (hash-ref options 'error #f)
                              #:seconds (hash-ref options 'seconds #f)
                              #:seed seed #:crop crop #:sampler sampler #:filter filter
                              #:integrator integrator #:shading shading
                              #:max-depth (option 'max-depth #f)
                              #:schedule schedule #:workers workers #:tile (option 'tile 16)
                              #:watch watch))))))
  (Image-write image output)
  (define report
    (render-report (hasheq 'scene word 'file output
                           'width (Image-width image) 'height (Image-height image)
                           'seed seed 'sampler sampler 'filter filter 'integrator integrator
                           'schedule schedule 'workers workers
                           'stoppedBy (Statistics-stopped-by statistics))
                   statistics))
  (unless quiet? (report-line report))
  (when (option 'stats #f)
    (report-table report)
    (unless raster? (report-texts (scene-needs world camera integrator))))
  (when json (report-json report json)))
