#lang racket/base
;; Many instances of a large mesh in little memory; large mesh files in time linear in their bytes.

(provide cases)

(require compiler/find-exe racket/file racket/flonum racket/port racket/runtime-path racket/string
         (for-syntax racket/base)
         "case.rkt" "../../main.rkt" "../read/sphere-files.rkt")

(define-runtime-path instances-program "instances.rkt")

;; --- instances ---

;; Another process builds the world and renders it, so that its peak is its own.
(define (instances size)
  (define-values (count stacks) (if (< size 1) (values 1000 51) (values 10000 318)))
  (define-values (process out in err)
    (subprocess #f #f (current-error-port) (find-exe) instances-program
                (number->string count) (number->string stacks) "158"))
  (close-output-port in)
  (define lines (port->lines out))
  (subprocess-wait process)
  (define numbers (if (pair? lines) (map string->number (string-split (car lines))) '()))
  (define-values (triangles peak lit)
    (if (= (length numbers) 3) (apply values numbers) (values 0 +inf.0 0)))
  (values (format "~a instances of ~a triangles: ~a MiB at most" count triangles
                  (if (rational? peak) (round (/ peak 1048576)) peak))
          (and (= 0 (subprocess-status process)) (= triangles (* 2 158 (- stacks 1)))
               (> lit 0) (< peak (expt 2.0 31)))))

;; --- files ---

;; Least CPU seconds of a reading in three rounds of `times`, and the parts that progress was told
;; in the first one.
(define (reading-seconds path times)
  (define told '())
  (define seconds
    (for/fold ([least +inf.0]) ([round (in-range 3)])
      (collect-garbage)
      (define start (current-process-milliseconds))
      (for ([k (in-range times)])
        (define mesh
          (Mesh-read path #:progress (lambda (part)
                                       (when (= 0 round k) (set! told (cons part told))))))
        (unless (Mesh? mesh) (error 'Mesh-read "expected a Mesh, found ~e" mesh)))
      (min least (/ (- (current-process-milliseconds) start) 1000.0 times))))
  (values seconds (reverse told)))

(define ((reading kind) size)
  ;; about a million triangles and a tenth of that; a tenth of both when quick
  (define-values (few many) (if (< size 1) (values 72 224) (values 224 708)))
  (define folder (make-temporary-file "large-~a" 'directory))
  (define (file rings)
    (define path
      (build-path folder (format "~a.~a" rings (substring (symbol->string kind) 0 3))))
    (write-sphere kind rings path)
    path)
  (dynamic-wind
   void
   (lambda ()
     (define-values (small large) (values (file few) (file many)))
     (define-values (small-seconds small-told) (reading-seconds small 10))
     (define-values (large-seconds told) (reading-seconds large 1))
     (define growth
       (/ (/ large-seconds (file-size large)) (/ small-seconds (file-size small))))
     (values (format (string-append "~a triangles in ~a s, ~a in ~a s: ~a of the time a byte; "
                                    "progress told ~a times")
                     (sphere-triangle-count few) (rounded small-seconds)
                     (sphere-triangle-count many) (rounded large-seconds) (rounded growth)
                     (length told))
             (and (<= growth 2.0) (>= (length told) 50) (apply <= told) (= 1.0 (apply max told)))))
   (lambda () (delete-directory/files folder))))

(define cases
  (cons (stress-case "large instances" "under 2048 MiB" instances)
        (for/list ([kind (in-list '(obj-plain ply-little))])
          (stress-case (format "large ~a" kind) "at most twice the time a byte, progress told"
                       (reading kind)))))
