#lang racket/base
;; Loading a scene: a Racket module anywhere on disk, compiled in memory where it has to be.
(require racket/lazy-require
         "line.rkt" "values.rkt" "scenes.rkt" "../world/world.rkt" "../world/camera.rkt")

(provide load-world load-scene path-below)

(lazy-require ["studio.rkt" (load-studio)])

;; load-world : the world, the camera and the settings of a scene or a mesh file. show?: whether the
;; reading of a mesh shows its progress.
(define (load-world word path [show? #f])
  (if (mesh-file? path) (load-studio path show?) (load-scene word path)))

;; load-scene : the world, the camera and the settings (an empty hash where there are none) that a
;; module provides. word: the scene as the user named it. What the scene prints goes to standard
;; error. namespace: where modules are that are loaded already. Every failure is one line
;; (exn:fail:user) that starts with word.
(define (load-scene word path
                    #:namespace
                    [namespace (variable-reference->empty-namespace (#%variable-reference))])
  (define (failed e) (raise-user-error (format "~a: ~a" (place word path e) (reason e))))
  (define (get name otherwise)
    (dynamic-require path name otherwise))
  (define-values (world camera settings)
    (parameterize ([current-namespace namespace]
                   [current-output-port (current-error-port)]
                   [current-command-line-arguments #()]
                   [exit-handler (lambda (code) (raise-user-error "left by (exit)"))])
      (with-handlers ([(lambda (e) (not (exn:break? e))) failed])
        (dynamic-require path #f)
        (values (get 'world (lambda () missing)) (get 'camera (lambda () missing))
                (get 'settings (lambda () (hash)))))))
  (check-provided word 'world "a World" World? world)
  (check-provided word 'camera "a Camera" Camera? camera)
  (values world camera (check-settings word settings)))

(define missing (string->uninterned-symbol "missing"))

(define (check-provided word name expected right? value)
  (cond
    [(eq? value missing)
     (raise-user-error (format "~a: expected a module that provides `~a`, ~a; it does not"
                               word name expected))]
    [(not (right? value))
     (raise-user-error (format "~a: expected `~a` to be ~a, found ~e"
                               word name expected value))]))

;; settings: a hash with any of the keys 'size (list width height), 'samples, 'seed, 'integrator,
;; 'max-depth, 'shading.
(define (check-settings word settings)
  (define expected "a hash with keys among 'size, 'samples, 'seed, 'integrator, 'max-depth and 'shading")
  (unless (hash? settings)
    (raise-user-error (format "~a: expected `settings` to be ~a, found ~e" word expected settings)))
  (for ([(key value) (in-hash settings)])
    (define what (format "~a: settings, ~e" word key))
    (define given (format "~e" value))
    (case key
      [(size) (check-size what given value)]
      [(samples) (check-samples what given value)]
      [(seed) (check-seed what given value)]
      [(max-depth) (check-max-depth what given value)]
      [(shading) (void)] ; checked where it is used
      [(integrator) (unless (symbol? value) (unexpected what given "a symbol"))]
      [else (unexpected (format "~a: settings" word) (format "~e" key) expected)]))
  settings)

;; ----------------------------------------------------------------------------------------------

(define (reason e)
  (cond
    [(not (exn? e)) (format "raised ~e" e)]
    [(exn:srclocs? e) (regexp-replace #px"^\\S+?:\\d+:\\d+: " (exn-message e) "")]
    [else (exn-message e)]))

;; The scene's name, with the line where it went wrong if that is known, or the place in a module
;; beside or below it.
(define (place word path e)
  (define locations
    (filter values
            (append (if (exn:srclocs? e) ((exn:srclocs-accessor e) e) '())
                    (if (exn? e)
                        (map cdr (continuation-mark-set->context (exn-continuation-marks e)))
                        '()))))
  (define (line-in right?)
    (for/first ([location (in-list locations)] #:when (right? (srcloc-source location)))
      location))
  (define here (line-in (lambda (source) (equal? source path))))
  (define-values (folder name must-be-folder?) (split-path path))
  (define (below source) (and (path? source) (path-below folder source)))
  (define there (and (not here) (line-in below)))
  (cond
    [here (format "~a:~a" word (srcloc-line here))]
    [there (format "~a: ~a:~a" word (below (srcloc-source there))
                   (srcloc-line there))]
    [else word]))

;; path-below : what leads to a file from a folder that it is in, or is below; #f for other files.
(define (path-below folder file)
  (let next ([folders (explode-path folder)] [parts (explode-path file)])
    (cond
      [(null? folders) (and (pair? parts) (apply build-path parts))]
      [(and (pair? parts) (equal? (car folders) (car parts))) (next (cdr folders) (cdr parts))]
      [else #f])))
