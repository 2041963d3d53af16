#lang racket/base
;; Only the window loads racket/gui, and without a display it says so in one line.
(module+ test
  (require compiler/find-exe racket/port racket/runtime-path rackunit "../command/support.rkt")

  (define-runtime-path package-folder "../..")
  (define heavy '(racket/gui/base racket/gui mred racket/draw raytrace/private/view/window
                                  raytrace/private/view/view))

  ;; Runs racket with words, without a display: its exit code and what it says on standard error.
  (define (run-racket . words)
    (define variables (environment-variables-copy (current-environment-variables)))
    (for ([name '(#"DISPLAY" #"WAYLAND_DISPLAY")]) (environment-variables-set! variables name #f))
    (define-values (process out in err)
      (parameterize ([current-environment-variables variables])
        (apply subprocess #f #f #f (find-exe) words)))
    (close-output-port in)
    (define told (port->string out #:close? #t))
    (define errors (port->string err #:close? #t))
    (subprocess-wait process)
    (list (subprocess-status process) told errors))

  (define (declared-after module)
    (run-racket "-l" "racket/base" "-l" module "-e"
                (format "(for ([name '~s]) (when (module-declared? name #f) (write name)))" heavy)))

  (test-case "neither the library nor the renderer of the command loads what a window takes"
    (for ([module '("raytrace" "raytrace/private/command/render" "raytrace/private/command/flags"
                               "raytrace/private/command/load")])
      (check-equal? (declared-after module) '(0 "" "") module))
    ;; the same question about a module that loads one of them
    (check-equal? (declared-after "racket/draw") '(0 "racket/draw" "")))

  (test-case "no display: one line and exit code 1"
    (when (eq? 'unix (system-type))
      (define line "view needs a display: neither DISPLAY nor WAYLAND_DISPLAY is set\n")
      (check-equal? (run-racket "-N" "raco" "-l-" "raytrace/private/command/main" "view" "seed")
                    (list 1 "" (string-append "raytrace: " line)))
      (define world "(World (list (Sphere (Float3 0 0 0) 1)))")
      (define camera "(Camera-look-at (Float3 0 0 5) (Float3 0 0 0))")
      (define result (run-racket "-l" "racket/base" "-l" "raytrace" "-e"
                                 (format "(view ~a ~a)" world camera)))
      (check-equal? (car result) 1)
      (check-equal? (caddr result) line)
      (define wrong (run-racket "-l" "racket/base" "-l" "raytrace" "-e"
                                (format "(view ~a ~a #:width 0)" world camera)))
      (check-regexp-match #rx"^view: expected a whole number from 1 to 100000\n *width: 0"
                          (caddr wrong))))

  (test-case "a display that is not there: one line"
    (when (eq? 'unix (system-type))
      (define variables (environment-variables-copy (current-environment-variables)))
      (environment-variables-set! variables #"DISPLAY" #":9999")
      (environment-variables-set! variables #"WAYLAND_DISPLAY" #f)
      (call-with-folder
       (lambda (folder)
         (check-one-line-error
          (parameterize ([current-environment-variables variables])
            (run-command folder "view" "seed"))
          "view needs a display: " ":9999")))))

  (test-case "bad input is told before any window"
    (call-with-folder
     (lambda (folder)
       (check-refused folder "--size 0x9: expected WIDTHxHEIGHT, two whole numbers from 1 to 100000"
                      "view" "seed" "--size" "0x9")
       (check-one-line-error (run-command folder "view" "no.rkt") "no.rkt: expected a scene")
       (check-one-line-error (run-command folder "view" "seed" "--integrator" "nothing")
                             "--integrator nothing: expected one of auto")
       (check-one-line-error (run-command folder "view") "scene")))))
