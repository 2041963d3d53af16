#lang racket/base
;; What the tests of the command share: the real command as a process, and scratch folders with
;; scene files.
(provide (struct-out outcome) run-command run-raco start-command finish-command
         wait-for-error-text signal-command
         check-refused check-one-line-error call-with-folder write-scene scene-text files)
(require compiler/find-exe racket/file racket/port racket/string racket/system rackunit)

;; code: the exit code. output: bytes. errors: what came on standard error, a string.
(struct outcome (code output errors) #:transparent)

(struct running (process threads output errors))

;; Starts `raco raytrace` with words in a folder.
(define (start-command folder #:module [module "raytrace/private/command/main"] . words)
  (define output (open-output-bytes))
  (define errors (open-output-bytes))
  (define-values (process out in err)
    (parameterize ([current-directory folder])
      (apply subprocess #f #f #f (find-exe) "-N" "raco" "-l-" module (map value->word words))))
  (close-output-port in)
  (define (pump from to)
    (thread (lambda () (copy-port from to) (close-input-port from))))
  (running process (list (pump out output) (pump err errors)) output errors))

(define (value->word value) (if (path? value) value (format "~a" value)))

;; Waits for the end; a command that takes more than so many seconds is killed and has the code #f.
(define (finish-command command #:seconds [seconds 60])
  (define process (running-process command))
  (define ended? (sync/timeout seconds process))
  (unless ended? (subprocess-kill process #t))
  (for-each thread-wait (running-threads command))
  (outcome (and ended? (subprocess-status process))
           (get-output-bytes (running-output command))
           (bytes->string/utf-8 (get-output-bytes (running-errors command)) #\?)))

;; Waits at most half a minute for a text on standard error.
(define (wait-for-error-text command pattern)
  (let wait ([tries 600])
    (unless (or (zero? tries) (regexp-match? pattern (get-output-bytes (running-errors command))))
      (sleep 0.05)
      (wait (- tries 1)))))

;; signal: 'INT or 'TERM.
(define (signal-command command signal)
  (system* "/bin/sh" "-c"
           (format "kill -~a ~a" signal (subprocess-pid (running-process command)))))

(define (run-command folder . words)
  (finish-command (apply start-command folder words)))

;; The same by the name that users type, through raco.
(define (run-raco folder . words)
  (finish-command (apply start-command folder #:module "raco" "raytrace" words)))

;; Exit code 1, no output, and one line on standard error that starts with `raytrace:` and holds
;; each of the parts.
(define (check-one-line-error result . parts)
  (define errors (outcome-errors result))
  (check-equal? (outcome-code result) 1 errors)
  (check-equal? (outcome-output result) #"")
  (check-true (regexp-match? #px"^raytrace: [^\r\n]+\n$" errors) errors)
  (for ([part (in-list parts)])
    (check-true (string-contains? errors part) (format "~s should contain ~s" errors part))))

;; The command refuses words with exactly this line, and leaves the folder's files as they are.
(define (check-refused folder line . words)
  (define before (files folder))
  (define result (apply run-command folder words))
  (with-check-info (['words words])
    (check-equal? (outcome-errors result) (string-append "raytrace: " line "\n"))
    (check-equal? (outcome-code result) 1)
    (check-equal? (outcome-output result) #"")
    (check-equal? (files folder) before)))

(define (files folder)
  (map path->string (directory-list folder)))

;; Calls use with a fresh folder that is deleted afterwards.
(define (call-with-folder use)
  (define folder (make-temporary-file "command~a" 'directory))
  (dynamic-wind void
                (lambda () (use folder))
                (lambda () (delete-directory/files folder))))

;; Writes a scene file into the folder: its path.
(define (write-scene folder name text)
  (define path (build-path folder name))
  (call-with-output-file path #:exists 'truncate (lambda (out) (write-string text out)))
  path)

;; A scene module whose world and camera are good, or as given in place of them.
(define (scene-text #:world [world good-world] #:camera [camera good-camera]
                    #:provide [provided "world camera"] . forms)
  (string-join
   `("#lang racket/base" "(require raytrace)" ,(format "(provide ~a)" provided)
     ,(format "(define world ~a)" world) ,(format "(define camera ~a)" camera) ,@forms)
   "\n" #:after-last "\n"))

(define good-world
  (string-append "(World (list (Sphere (Float3 0 0 0) 1 (Float3 1 0 0)))"
                 " (DistantLight (Float3 1 1 1) (Float3 1 1 1)))"))
(define good-camera "(Camera-look-at (Float3 0 0 5) (Float3 0 0 0))")
