#lang racket/base
;; What is told about a render that is done: a line, a table, and JSON.
(require racket/lazy-require "line.rkt" "../render/statistics.rkt" "../image/write.rkt" "../image/source.rkt")

(lazy-require [json (write-json)]
              [racket/file (call-with-atomic-output-file)])

(provide render-report report-line report-table report-texts report-faults report-json check-json-path)

;; about: what the statistics do not know. rows: (list key label value) with number values, or #f
;; for what is unknown. first-rejected: as in Statistics.
(struct report (about rows first-rejected))

;; render-report : about: a hasheq with at least 'file, 'width, 'height and 'seed.
(define (render-report about statistics)
  (define rays (+ (Statistics-nearest-rays statistics) (Statistics-occlusion-rays statistics)))
  (define seconds (Statistics-seconds statistics))
  (report
   about
   (list
    (list 'pixels "pixels" (Statistics-pixels statistics))
    (list 'samples "samples per pixel" (samples-per-pixel statistics))
    (list 'passes "passes" (Statistics-passes statistics))
    (list 'relativeError "relative error (estimated RMSE / mean)" (Statistics-error statistics))
    (list 'relativeErrorUncertainty "its standard error" (Statistics-error-uncertainty statistics))
    (list 'nearestRays "nearest-hit rays" (Statistics-nearest-rays statistics))
    (list 'occlusionRays "occlusion rays" (Statistics-occlusion-rays statistics))
    (list 'raysPerPixel "rays per pixel"
          (exact->inexact (/ rays (max 1 (Statistics-pixels statistics)))))
    (list 'millionRaysPerSecond "million rays per second"
          (and (positive? seconds) (/ rays seconds 1e6)))
    (list 'buildSeconds "build seconds" (Statistics-build-seconds statistics))
    (list 'seconds "seconds" seconds)
    (list 'processorSeconds "processor seconds" (Statistics-processor-seconds statistics))
    (list 'rejectedSamples "rejected samples" (Statistics-rejected-samples statistics))
    (list 'failedPixels "failed pixels" (Statistics-failed-pixels statistics))
    (list 'peakMebibytes "peak memory, MiB" (peak-mebibytes)))
   (Statistics-first-rejected statistics)))

;; A whole number where every pixel has as many.
(define (samples-per-pixel statistics)
  (define mean (/ (Statistics-samples statistics) (max 1 (Statistics-pixels statistics))))
  (if (integer? mean) mean (exact->inexact mean)))

(define (report-value report key)
  (caddr (assq key (report-rows report))))

;; One line on standard error.
(define (report-line report)
  (define about (report-about report))
  (define rejected (report-value report 'rejectedSamples))
  (define error (report-value report 'relativeError))
  (eprintf "~a: ~ax~a, ~a a pixel~a~a, ~a s~a\n"
           (hash-ref about 'file) (hash-ref about 'width) (hash-ref about 'height)
           (count-text (report-value report 'samples) "sample")
           (if error (format ", error ~a%" (significant-text (* 100 error) 2)) "")
           (if (eq? 'most-samples (hash-ref about 'stoppedBy))
               " (stopped by the most samples a pixel may have)"
               "")
           (number-text (+ (report-value report 'buildSeconds) (report-value report 'seconds)))
           (if (zero? rejected)
               ""
               (format ", ~a rejected: no finite colour; see one with ~a"
                       (count-text rejected "sample") (rejected-flags about report)))))

;; The flags of a render that has the first rejected sample in it.
(define (rejected-flags about report)
  (define at (report-first-rejected report))
  (format "--crop ~a,~a,1,1 --seed ~a" (car at) (cadr at) (hash-ref about 'seed)))

(define (count-text count noun)
  (format "~a ~a~a" (if (exact-integer? count) count (real->decimal-string count 1))
          noun (if (= count 1) "" "s")))

;; A positive number with so many digits that are not leading zeros.
(define (significant-text number digits)
  (define power (if (positive? number) (floor (/ (log number) (log 10))) 0))
  (define places (- digits 1 (inexact->exact power)))
  (if (positive? places)
      (real->decimal-string number places)
      (number->string (inexact->exact (round number)))))

;; report-faults : a line on standard error for each kind of what a scene's functions raised.
(define (report-faults scene seed statistics)
  (define pixels (Statistics-failed-pixels statistics))
  (define faults (Statistics-faults statistics))
  (for ([fault (in-list faults)])
    (eprintf "raytrace: ~a: ~a, at pixel ~a,~a with seed ~a\n" scene (one-line (car fault))
             (cadr fault) (caddr fault) seed))
  (when (positive? pixels)
    (eprintf "raytrace: ~a: ~a left magenta (1, 0, 1)\n" scene
             (if (= pixels 1) "1 pixel is" (format "~a pixels are" pixels)))))

;; A table on standard error.
(define (report-table report)
  (define rows
    (for/list ([row (in-list (report-rows report))])
      (cons (cadr row)
            (if (and (memq (car row) '(relativeError relativeErrorUncertainty)) (caddr row))
                (significant-text (caddr row) 3)
                (number-text (caddr row))))))
  (define (widest part) (apply max (map (lambda (row) (string-length (part row))) rows)))
  (define (spaces count) (make-string count #\space))
  (for ([row (in-list rows)])
    (eprintf "~a~a  ~a~a\n"
             (car row) (spaces (- (widest car) (string-length (car row))))
             (spaces (- (widest cdr) (string-length (cdr row)))) (cdr row))))

;; report-texts : pairs of a label and a text, a line each, on standard error.
(define (report-texts pairs)
  (define widest (apply max (map (lambda (pair) (string-length (car pair))) pairs)))
  (for ([pair (in-list pairs)])
    (eprintf "~a~a  ~a\n" (car pair)
             (make-string (- widest (string-length (car pair))) #\space) (cdr pair))))

(define (number-text number)
  (cond [(not number) "unknown"]
        [(exact-integer? number) (number->string number)]
        [else (real->decimal-string number 2)]))

;; ----------------------------------------------------------------------------------------------

;; report-json : writes the report to a file, whole or not at all, or to standard output for "-".
(define (report-json report path)
  (define object
    (for/fold ([object (for/hasheq ([(key value) (in-hash (report-about report))])
                         (values key (if (symbol? value) (symbol->string value) value)))])
              ([row (in-list (report-rows report))])
      (hash-set object (car row) (or (caddr row) 'null))))
  (define (write-to out)
    (write-json object out #:null 'null)
    (newline out))
  (with-handlers ([exn:fail? (lambda (e) (unwritable path (error-reason e)))])
    (if (equal? path "-")
        (write-to (current-output-port))
        (call-with-atomic-output-file path (lambda (out temporary) (write-to out))))))

;; check-json-path : raises exn:fail:user where report-json could not write; output is where the
;; picture goes.
(define (check-json-path path output)
  (cond
    [(not (equal? path "-")) (check-output-path path #:format 'ppm)]
    [(equal? output "-")
     (raise-user-error "--stats-json -: expected a file, standard output takes the picture")]))

(define (unwritable path why)
  (raise-user-error (format "~a: cannot be written (~a)" path why)))

;; The most memory this process has held, or #f where the system does not tell.
(define (peak-mebibytes)
  (define status "/proc/self/status")
  (define match
    (and (file-exists? status)
         (call-with-input-file status
           (lambda (in) (regexp-match #px#"VmHWM:\\s*([0-9]+) kB" in)))))
  (and match (quotient (string->number (bytes->string/latin-1 (cadr match))) 1024)))
