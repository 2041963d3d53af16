#lang racket/base
;; What is told about a render: the line, the table and the JSON, exactly.
(module+ test
  (require json racket/list racket/string rackunit "support.rkt"
           "../../private/command/report.rkt" "../../private/render/statistics.rkt")

  (define about (hasheq 'scene "a.rkt" 'file "a.ppm" 'width 64 'height 36 'seed 0
                        'integrator 'auto 'schedule 'futures 'workers 2 'stoppedBy 'samples))
  (define (report-of #:samples [samples 4] #:rejected [rejected 0] #:seconds [seconds 0.5]
                     #:error [error #f] #:stopped-by [stopped-by 'samples])
    (render-report (hash-set about 'stoppedBy stopped-by)
                   (Statistics 2304 (* 2304 samples) 4608 2304
                               rejected (and (positive? rejected) (list 12 7 3))
                               0 '()
                               error (and error (/ error 100)) 1 stopped-by
                               0.25 seconds 0.75)))
  (define (errors-of use)
    (define out (open-output-string))
    (parameterize ([current-error-port out]) (use))
    (get-output-string out))

  (check-equal? (errors-of (lambda () (report-line (report-of))))
                "a.ppm: 64x36, 4 samples a pixel, 0.75 s\n")
  (check-equal? (errors-of (lambda () (report-line (report-of #:samples 1 #:rejected 2))))
                (string-append "a.ppm: 64x36, 1 sample a pixel, 0.75 s, 2 samples rejected: "
                               "no finite colour; see one with --crop 12,7,1,1 --seed 0\n"))

  (check-equal? (errors-of (lambda () (report-line (report-of #:samples 9/2 #:error 0.012345))))
                "a.ppm: 64x36, 4.5 samples a pixel, error 1.2%, 0.75 s\n")
  (check-equal? (errors-of (lambda () (report-line (report-of #:error 0.12345
                                                              #:stopped-by 'most-samples))))
                (string-append "a.ppm: 64x36, 4 samples a pixel, error 12% "
                               "(stopped by the most samples a pixel may have), 0.75 s\n"))

  (define table (string-split (errors-of (lambda () (report-table (report-of)))) "\n"))
  (check-equal? (list-ref table 0) "pixels                                     2304")
  (check-equal? (list-ref table 7) "rays per pixel                             3.00")
  (check-equal? (list-ref table 8) "million rays per second                    0.01")
  (check-equal? (length (remove-duplicates (map string-length table))) 1)

  (call-with-folder
   (lambda (folder)
     (define path (build-path folder "s.json"))
     (define (json-of report)
       (report-json report (path->string path))
       (call-with-input-file path read-json))
     (define object (json-of (report-of)))
     (check-equal? (hash-remove object 'peakMebibytes)
                   (hasheq 'scene "a.rkt" 'file "a.ppm" 'width 64 'height 36 'seed 0
                           'integrator "auto" 'schedule "futures" 'workers 2
                           'stoppedBy "samples" 'passes 1
                           'relativeError (json-null) 'relativeErrorUncertainty (json-null)
                           'pixels 2304 'samples 4 'nearestRays 4608 'occlusionRays 2304
                           'raysPerPixel 3.0 'millionRaysPerSecond 0.013824 'buildSeconds 0.25
                           'seconds 0.5 'processorSeconds 0.75 'rejectedSamples 0 'failedPixels 0))
     ;; no rate without time; an older file is replaced
     (check-equal? (hash-ref (json-of (report-of #:seconds 0.0)) 'millionRaysPerSecond) (json-null))
     (check-equal? (files folder) '("s.json"))
     (check-exn #rx"cannot be written" (lambda () (check-json-path "none/s.json" "a.ppm")))
     (check-exn #rx"^--stats-json -: expected a file" (lambda () (check-json-path "-" "-")))
     (check-not-exn (lambda () (check-json-path "-" "a.ppm")))
     (check-not-exn (lambda () (check-json-path path "-"))))))
