#lang racket/base
;; Runs the test files under this folder, as many at a time as there are processors, each in a
;; process of its own, and ends with the line `N passed, N failed`.
;;   racket tests/run.rkt              all of them
;;   racket tests/run.rkt tests/image  those in folders or files
(module+ main
  (require compiler/cm compiler/find-exe racket/cmdline racket/file racket/future racket/list racket/path
           racket/port rackunit/log)

  (define FILE-SECONDS 600)

  (define this-file (variable-reference->module-source (#%variable-reference)))
  (define tests-folder (path-only this-file))
  (define package-folder (simplify-path (build-path tests-folder 'up)))

  ;; ----------------------------------------------------------------------------------------------
  ;; One file, in this process.

  ;; Runs the test submodule of a file and prints `(passed . failed)` as the last line on standard
  ;; output. An exception counts as a failure, and so do tests that check nothing.
  (define (run-here file)
    (define raised?
      (with-handlers ([(lambda (e) #t)
                       (lambda (e)
                         ((error-display-handler) (if (exn? e) (exn-message e) (format "~s" e)) e)
                         #t)])
        (parameterize ([current-command-line-arguments #()])
          (dynamic-require `(submod ,file test) #f))
        #f))
    (define counts (test-log))
    (define nothing? (and (not raised?) (zero? (cdr counts))))
    (when nothing? (eprintf "no check was run\n"))
    (writeln (cons (- (cdr counts) (car counts))
                   (+ (car counts) (if (or raised? nothing?) 1 0)))))

  ;; ----------------------------------------------------------------------------------------------
  ;; All files, in processes of their own.

  ;; The .rkt files at a path or below it that have tests; compiled ones, and those
  ;; that measure time, are left out.
  (define (test-files path)
    (cond
      [(directory-exists? path)
       (append*
        (for/list ([entry (in-list (directory-list path))]
                   #:unless (member (path->string entry) '("compiled" "bench")))
          (test-files (build-path path entry))))]
      [(and (path-has-extension? path #".rkt") (has-tests? path)) (list path)]
      [else '()]))

  (define (has-tests? path)
    (call-with-input-file path (lambda (in) (regexp-match? #rx"[(]module[+] test[ \n]" in))))

  ;; Runs the file: prints its name and what it had to say, and returns its counts.
  (define (run-file file)
    (define start (current-inexact-milliseconds))
    (define said (open-output-bytes))
    (define-values (process out in err)
      (parameterize ([subprocess-group-enabled #t] ; to stop what a test has started along with it
                     [current-subprocess-custodian-mode 'kill])
        (subprocess #f #f #f (find-exe) this-file "--here" file)))
    (close-output-port in)
    (define pumps
      (for/list ([from (in-list (list out err))])
        (thread (lambda () (copy-port from said)))))
    (define ended? (sync/timeout FILE-SECONDS process))
    (unless ended? (subprocess-kill process #t))
    (for-each thread-wait pumps)
    (define text (get-output-bytes said))
    (define counts (regexp-match #px#"(?m:^\\(([0-9]+) [.] ([0-9]+)\\)$)" text))
    (define-values (passed failed)
      (if (and ended? counts)
          (values (bytes->number (cadr counts)) (bytes->number (caddr counts)))
          (values 0 1)))
    (printf "~a: ~a passed, ~a failed, ~a s\n"
            (find-relative-path package-folder file) passed failed
            (round (/ (- (current-inexact-milliseconds) start) 1000.0)))
    (unless (zero? failed)
      (write-bytes text)
      (unless ended? (printf "stopped after ~a s\n" FILE-SECONDS)))
    (flush-output)
    (cons passed failed))

  (define (bytes->number bytes) (string->number (bytes->string/latin-1 bytes)))

  ;; The results of function for each item, by so many threads that each take the next one.
  (define (map-with-threads function items thread-count)
    (define next (make-channel))
    (define results (make-channel))
    (for ([k (in-range thread-count)])
      (thread (lambda ()
                (let loop ()
                  (channel-put results (function (channel-get next)))
                  (loop)))))
    (thread (lambda () (for ([item (in-list items)]) (channel-put next item))))
    (for/list ([item (in-list items)]) (channel-get results)))

  ;; Compiles the package and then the tests, as many at a time as there are processors, so that not
  ;; every process does it again and none runs what was compiled before a change.
  (define (compile-all tests)
    (define package
      (cons (build-path package-folder "main.rkt")
            (append-map (lambda (folder)
                          (find-files (lambda (path) (path-has-extension? path #".rkt"))
                                      (build-path package-folder folder)))
                        '("private" "scenes"))))
    (define count (processor-count))
    (define shares
      (for/list ([k (in-range count)])
        (for/list ([test (in-list tests)] [n (in-naturals)] #:when (= k (remainder n count))) test)))
    (subprocess-wait (start-compiling package))
    (for-each subprocess-wait (map start-compiling (filter pair? shares))))

  (define (start-compiling files)
    (define-values (process out in err)
      (apply subprocess (current-output-port) #f (current-error-port)
             (find-exe) this-file "--compile" files))
    (close-output-port in)
    process)

  ;; In this process, with one compilation manager: raco make has one for every file, which costs half a
  ;; second each. What cannot be compiled is told, and again by the tests that need it.
  (define (compile-here files)
    (define compile! (make-caching-managed-compile-zo))
    (parameterize ([current-namespace (make-base-empty-namespace)])
      (for ([file (in-list files)])
        (with-handlers ([exn:fail? (lambda (e) (eprintf "~a\n" (exn-message e)))])
          (compile! (path->complete-path file))))))

  (define compile-only? #f)

  (command-line
   #:program "racket tests/run.rkt"
   #:once-each
   [("--here") file "Run one file in this process and print its counts"
               (run-here (path->complete-path file))
               (exit 0)]
   [("--compile") "Compile the files in this process, and run none"
                  (set! compile-only? #t)]
   #:args paths
   (when compile-only?
     (compile-here paths)
     (exit 0))
   (for ([path (in-list paths)])
     (unless (or (file-exists? path) (directory-exists? path))
       (raise-user-error (format "~a: expected a test file or a folder, found no such file" path))))
   (define files
     (append-map test-files
                 (if (null? paths) (list tests-folder) (map path->complete-path paths))))
   (compile-all files)
   (define counts (map-with-threads run-file files (processor-count)))
   (define failed (apply + (map cdr counts)))
   (printf "~a passed, ~a failed\n" (apply + (map car counts)) failed)
   (exit (if (zero? failed) 0 1))))
