#lang racket/base
;; Rendering a scene to a picture file: what can be wrong is checked before the first ray.
(require racket/lazy-require "values.rkt" "scenes.rkt" "load.rkt" "progress.rkt" "report.rkt"
         "unfinished.rkt"
         "../integrate/integrators.rkt" "../sample/sampler.rkt" "../sample/filter.rkt"
         "../render/render.rkt" "../render/statistics.rkt" "../image/image.rkt"
         "../image/write.rkt")

(lazy-require ["needs.rkt" (scene-needs)]
              ["../image/edit.rkt" (Image-false-color)]
              ["../render/schedule/hosts.rkt" (read-hosts)]
              ["keeper.rkt" (render-settings make-keeper write-part)])

(provide render-scene)

;; render-scene : renders the scene that word names and writes the picture, or the part of one. options:
;; a hash as parse-render-flags makes it. Raises exn:fail:user on bad input; then there is no output file.
(define (render-scene options word)
  (define path (find-scene word))
  (define part (hash-ref options 'part #f))
  (define output
    (hash-ref options 'output
              (lambda ()
                (if part
                    (format "~a.~a-of-~a.part" (scene-name path) (car part) (cadr part))
                    (string-append (scene-name path) ".ppm")))))
  (define json (hash-ref options 'stats-json #f))
  (check-output-path output #:format (and part 'ppm))
  (when json (check-json-path json output))
  (define resume? (hash-ref options 'resume #f))
  (define keep-partial? (hash-ref options 'keep-partial #f))
  (when (equal? output "-")
    (for ([flag (in-list '(resume part))] #:when (hash-ref options flag #f))
      (raise-user-error (format "--~a: expected -o with the name of a file" flag))))
  ;; a goal that is asked for goes before the scene's samples; samples beside it are the most
  (define error (hash-ref options 'error #f))
  (define seconds (hash-ref options 'seconds #f))
  (define goal? (and (or error seconds) #t))
  (when (and part goal?)
    (raise-user-error
     "--part: expected --samples, for --error and --seconds look at the whole picture"))
  (define quiet? (hash-ref options 'quiet #f))
  (define terminal? (terminal-port? (current-error-port)))
  (define show? (and (not quiet?) terminal?))
  (define preview? (and (hash-ref options 'preview #f) terminal?))
  (when (and (hash-ref options 'preview #f) (not terminal?) (not quiet?))
    (eprintf "raytrace: --preview: standard error is no terminal, there is no preview\n"))
  (define-values (world camera settings)
    (load-world word path show?))
  (define (option key default)
    (hash-ref options key (lambda () (hash-ref settings key default))))
  (define (named-option key default names)
    (define what
      (if (hash-has-key? options key) (format "--~a" key) (format "~a: settings, '~a" word key)))
    (check-name what (option key default) names))
  (define size (option 'size '(640 360)))
  (define integrator (named-option 'integrator 'auto INTEGRATORS))
  (define raster? (eq? integrator 'raster))
  (when (and raster? goal?)
    (define key (if (hash-has-key? options 'error) 'error 'seconds))
    (unexpected (format "--~a" key) (hash-ref options key)
                "another integrator than raster, which has no noise to lower"))
  (for ([flag (in-list '(resume part))] #:when (and raster? (hash-ref options flag #f)))
    (raise-user-error (format "--~a: expected another integrator than raster" flag)))
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
  (define hosts
    (let ([found (regexp-match #rx"^hosts:(.+)$" (symbol->string (option 'schedule 'futures)))])
      (and found (cadr found))))
  (define schedule
    (if hosts 'hosts (named-option 'schedule 'futures
                                (append (remq 'hosts SCHEDULES) '(hosts:FILE)))))
  (when hosts (read-hosts hosts))
  (define workers (option 'workers (default-worker-count)))
  (define tile (option 'tile 16))
  (define max-depth (option 'max-depth #f))
  ;; what has to be the same for two renders to be of one picture
  (define same
    (and (or resume? part)
         (render-settings
          (scene-name path) path world camera
          (list (cons "size" size) (cons "crop" crop) (cons "seed" seed)
                (cons "number of samples" samples) (cons "error" error) (cons "seconds" seconds)
                (cons "sampler" sampler) (cons "filter" filter) (cons "integrator" integrator)
                (cons "max-depth" max-depth) (cons "tile" tile)))))
  (define keep
    (and resume? (make-keeper output same part (hash-ref options 'checkpoint-seconds 10.0))))
  (define progress #f)
  (define (save) (and keep progress ((keeper-save keep) progress)))
  (define (prepare started)
    (set! progress started)
    (when keep ((keeper-load! keep) progress)))
  (define (coarse columns)
    (and (not crop)
         (render world camera #:width columns
                 #:height (max 1 (round (/ (* columns (cadr size)) (car size))))
                 #:samples 1 #:integrator integrator #:max-depth max-depth #:schedule 'sequential)))
  (define (render-it watch)
    (with-handlers ([exn:fail? (lambda (e) (raise-user-error
                                            (if (and (exn:fail:user? e)
                                                     (not (hash-ref options 'strict #f)))
                                                (exn-message e)
                                                (format "~a: ~a" word (exn-message e)))))])
      (parameterize ([current-output-port (current-error-port)])
        (render/statistics world camera #:width (car size) #:height (cadr size)
                           #:samples samples #:error error #:seconds seconds
                           #:seed seed #:crop crop #:sampler sampler #:filter filter
                           #:integrator integrator #:shading shading #:max-depth max-depth
                           #:schedule schedule #:workers workers #:tile tile
                           #:hosts hosts #:strict? (hash-ref options 'strict #f)
                           #:scene (and (not (mesh-file? path)) path)
                           #:part part #:prepare prepare
                           #:watch (lambda (done progress)
                                     (watch done (progress->live progress)))))))
  (define-values (image statistics)
    (with-handlers ([(lambda (e) (and (exn:break? e) progress))
                     (lambda (e)
                       (define kept
                         (append
                          (if (save) (list (kept-checkpoint (keeper-path keep))) '())
                          (if (and keep-partial? (not part))
                              (list (kept-picture progress output))
                              '())))
                       (raise (interrupted e progress kept)))])
      (call-with-progress
       (cond [preview? 'preview] [quiet? #f] [terminal? 'line] [else 'log])
       #:label output #:under coarse
       (lambda (watch)
         (if keep
             ((keeper-during keep) (lambda () progress) (lambda () (render-it watch)))
             (render-it watch))))))
  ;; what is no light is shown in false colours, but kept as it is where a file is for numbers
  (define false-color?
    (and (memq integrator '(cost error)) (not (regexp-match? #rx"[.](?i:pfm|hdr)$" output))))
  (with-handlers ([exn:fail? (lambda (e)
                               (save)
                               (raise e))])
    (if part
        (write-part output same part progress)
        (Image-write (if false-color? (Image-false-color image) image) output)))
  (when keep ((keeper-delete! keep)))
  (define report
    (render-report (hasheq 'scene word 'file output 'part part
                           'width (Image-width image) 'height (Image-height image)
                           'seed seed 'sampler sampler 'filter filter 'integrator integrator
                           'schedule schedule 'workers workers 'tile tile 'maxDepth max-depth
                           'errorWanted error 'secondsWanted seconds 'crop crop
                           'stoppedBy (Statistics-stopped-by statistics))
                   statistics))
  (report-faults word seed statistics)
  (unless quiet? (report-line report))
  (when (option 'stats #f)
    (report-table report)
    (unless raster? (report-texts (scene-needs world camera integrator))))
  (when json (report-json report json)))
