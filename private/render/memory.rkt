#lang racket/base
;; Memory for pictures that are large: whether there is enough, and arrays that the collector leaves
;; where they are instead of copying them.
(require racket/flonum ffi/unsafe/vm)

(provide make-pinned-flvector unpin available-bytes check-memory)

;; Smaller arrays may be copied.
(define LARGE (expt 2 22))

(define lock (with-handlers ([exn:fail? (lambda (e) void)]) (vm-primitive 'lock-object)))
(define unlock (with-handlers ([exn:fail? (lambda (e) void)]) (vm-primitive 'unlock-object)))

;; make-pinned-flvector : a flvector that stays where it is, if it is large, until it is unpinned.
(define (make-pinned-flvector length value)
  (define v (make-flvector length value))
  (when (>= length LARGE) (lock v))
  v)

(define (unpin v)
  (when (>= (flvector-length v) LARGE) (unlock v)))

;; available-bytes : the memory the system can give without swapping, or #f where it does not tell.
(define (available-bytes)
  (define file "/proc/meminfo")
  (define found
    (and (file-exists? file)
         (call-with-input-file file
           (lambda (in) (regexp-match #px#"MemAvailable:\\s*([0-9]+) kB" in)))))
  (and found (* 1024 (string->number (bytes->string/latin-1 (cadr found))))))

;; check-memory : raises exn:fail:user where a picture of that size needs more than there is.
(define (check-memory bytes width height)
  (define available (available-bytes))
  (define (mebibytes n) (quotient (+ n 1048575) 1048576))
  (when (and available (> bytes available))
    (raise-user-error
     (format "~ax~a pixels need ~a MiB of memory, ~a MiB are available; --crop renders a part"
             width height (mebibytes bytes) (mebibytes available)))))
