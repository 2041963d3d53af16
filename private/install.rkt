#lang racket/base
;; Compiles the collection when it is installed, on all processors: raco setup alone gives one collection
;; to one of them. What cannot be compiled is left for raco setup to tell.
(require racket/future racket/list racket/path racket/port racket/set compiler/cm compiler/find-exe)

(provide pre-installer)

(define (pre-installer collections-folder folder . more)
  (define workers (min (processor-count) MOST-WORKERS))
  (when (> workers 1)
    (with-handlers ([exn:fail? void]) ; raco setup can do without
      (define files (sources (simple-form-path folder)))
      (define needs (for/hash ([file (in-list files)]) (values file (needed-by file files))))
      (compile-together (in-order-of-need files needs) needs workers))))

;; More would wait for each other: a quarter of the time is one chain of modules.
(define MOST-WORKERS 4)

;; Workers are processes, for places would stop each other to collect garbage. A file is given to one
;; when all that it needs is done, so no two compile the same. One that cannot be compiled is done too.
(define (compile-together files needs count)
  (let serve ([waiting files] [done (set)] [idle (build-list count start-worker)] [busy (hash)])
    (define file
      (and (pair? idle)
           (or (for/first ([file (in-list waiting)] #:when (subset? (hash-ref needs file) done)) file)
               ;; modules that load each other when they run
               (and (hash-empty? busy) (pair? waiting) (car waiting)))))
    (cond
      [file
       (ask (car idle) file)
       (serve (remove file waiting) done (cdr idle) (hash-set busy (car idle) file))]
      [(hash-empty? busy) (for-each stop idle)]
      [else
       (define worker (apply sync (map answer-event (hash-keys busy))))
       (define answer (read-line (worker-answers worker)))
       (define now-done (set-add done (hash-ref busy worker)))
       (define still-busy (hash-remove busy worker))
       (if (eof-object? answer)
           (serve waiting now-done idle still-busy)
           (serve waiting now-done (cons worker idle) still-busy))])))

;; A process that compiles the files whose names it reads.
(struct worker (process answers names))

(define (start-worker k)
  (define-values (process answers names errors)
    (subprocess #f #f #f (find-exe) (variable-reference->module-source (#%variable-reference))))
  (thread (lambda () (copy-port errors (open-output-nowhere))))
  (worker process answers names))

(define (answer-event worker) (wrap-evt (worker-answers worker) (lambda (port) worker)))

(define (ask worker file)
  (with-handlers ([exn:fail? void]) ; one that is gone gives no answer either
    (write-bytes (path->bytes file) (worker-names worker))
    (newline (worker-names worker))
    (flush-output (worker-names worker))))

(define (stop worker)
  (close-output-port (worker-names worker))
  (subprocess-wait (worker-process worker))
  (close-input-port (worker-answers worker)))

(module+ main
  (define compile! (make-caching-managed-compile-zo))
  (define answers (current-output-port))
  (parameterize ([current-namespace (make-base-empty-namespace)]
                 [current-output-port (open-output-nowhere)])
    (for ([name (in-bytes-lines)])
      (with-handlers ([exn:fail? void]) (compile! (bytes->path name)))
      (write-string "done\n" answers)
      (flush-output answers))))

;; The files that raco setup compiles too.
(define (sources folder)
  (for/list ([file (in-directory folder (lambda (below) (not (left-out? below))))]
             #:when (path-has-extension? file #".rkt"))
    file))

(define (left-out? folder)
  (regexp-match? #rx"^([.].*|compiled|tests)$" (path->string (file-name-from-path folder))))

;; First the files with the longest chain of modules above them.
(define (in-order-of-need files needs)
  (define above
    (for*/fold ([above (hash)]) ([(file needed) (in-hash needs)] [below (in-set needed)])
      (hash-update above below (lambda (others) (cons file others)) '())))
  (define heights (make-hash))
  (define (height file)
    (unless (hash-has-key? heights file)
      (hash-set! heights file 0) ; for modules that load each other when they run
      (hash-set! heights file (for/fold ([most 0]) ([other (in-list (hash-ref above file '()))])
                                (max most (+ 1 (height other))))))
    (hash-ref heights file))
  (sort files > #:key height))

;; Those of the files that a module's require forms name by their paths.
(define (needed-by file files)
  (for*/set ([name (in-list (required-names (module-form file)))]
             [path (in-value (simple-form-path (build-path (path-only file) name)))]
             #:when (member path files))
    path))

(define (module-form file)
  (parameterize ([read-accept-reader #t])
    (with-handlers ([exn:fail? (lambda (e) '())])
      (call-with-input-file file read))))

(define (required-names form)
  (cond
    [(not (list? form)) '()]
    [(and (pair? form) (memq (car form) '(require unsafe-require/typed lazy-require)))
     (filter (lambda (name) (and (string? name) (regexp-match? #rx"[.]rkt$" name)))
             (map (lambda (name) (if (eq? name 'raytrace) "../main.rkt" name)) (flatten (cdr form))))]
    [else (append-map required-names form)]))
