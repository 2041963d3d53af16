#lang racket/base
;; An interrupt while the command itself is still being loaded ends as any other: one line, and the
;; signal's code.
(module+ test
  (require racket/port rackunit)

  (define (outcome signal)
    (define errors (open-output-string))
    (define load (current-load/use-compiled))
    (define code
      (let/ec leave
        (parameterize ([current-namespace (make-base-empty-namespace)]
                       [current-command-line-arguments #("--help")]
                       [current-output-port (open-output-nowhere)]
                       [current-error-port errors]
                       [exit-handler leave]
                       [current-load/use-compiled
                        (lambda (path name)
                          (when (regexp-match? #rx"flags[.]rkt$" (format "~a" path))
                            (break-thread (current-thread) signal)
                            (sleep 0))
                          (load path name))])
          (with-handlers ([exn:break? (lambda (e) 'escaped)])
            (dynamic-require 'raytrace/private/command/main #f)
            'ran))))
    (list code (get-output-string errors)))

  (check-equal? (outcome #f) '(130 "raytrace: interrupted\n"))
  (check-equal? (outcome 'terminate) '(143 "raytrace: terminated\n")))
