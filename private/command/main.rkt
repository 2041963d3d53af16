;; raco raytrace: what runs it, subcommands.rkt, and racket/base with it, take a moment to load. An
;; interrupt meanwhile ends as one later does, so this module is written in the kernel language.
(module main '#%kernel
  (#%require '#%paramz)

  (define-values (leave)
    (lambda (code word)
      (begin
        (display (string-append "raytrace: " word "\n") (current-error-port))
        (exit code))))

  (define-values (handle)
    (lambda (e)
      (if (exn:break:terminate? e)
          (leave 143 "terminated")
          (if (exn:break? e)
              (leave 130 "interrupted")
              e))))

  (with-continuation-mark exception-handler-key handle
    ((dynamic-require
      (module-path-index-join "subcommands.rkt"
                              (variable-reference->module-path-index (#%variable-reference)))
      'run-command-line)))

  ;; For compilation: nothing else tells that this module needs the other.
  (module needs '#%kernel
    (#%require (for-label "subcommands.rkt")))

  ;; Without this, raco test would run the command.
  (module test '#%kernel))
