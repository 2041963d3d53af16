#lang racket/base
;; The first word of the command line names a subcommand, or the scene to render. Whatever goes wrong
;; ends in one line on standard error and exit code 1; an interrupt in 130, or 143 where it is SIGTERM.
;; Nothing heavy is loaded before the words have been understood.
(require raco/command-name racket/lazy-require "line.rkt" "flags.rkt")

(provide run-command-line)

(lazy-require ["render.rkt" (render-scene)]
              ["list.rkt" (list-scenes)]
              ["compare.rkt" (compare-pictures)]
              ["explain.rkt" (explain-pixel)]
              ["check.rkt" (check-scene)]
              ["new.rkt" (new-scene)]
              ["merge.rkt" (merge-parts)]
              ["view.rkt" (view-command)])

;; run-command-line : does what the words of the command line ask for; exits where it cannot.
(define (run-command-line)
  (with-handlers* ([exn:break:terminate? (lambda (e) (leave 143 (break-text e "terminated")))]
                   [exn:break? (lambda (e) (leave 130 (break-text e "interrupted")))]
                   [(lambda (e) #t) report])
    (run (vector->list (current-command-line-arguments)))
    (flush-output)))

(define (run words)
  (define program (short-program+command-name))
  (define (name word) (string-append program " " word))
  (case (and (pair? words) (car words))
    [("list") (list-scenes (name "list") (cdr words))]
    [("merge") (merge-parts (name "merge") (cdr words))]
    [("compare") (compare-pictures (name "compare") (cdr words))]
    [("explain") (explain-pixel (name "explain") (cdr words))]
    [("check") (check-scene (name "check") (cdr words))]
    [("view") (view-command (name "view") (cdr words))]
    [("new") (new-scene (name "new") (cdr words))]
    [else
     (define-values (options scene) (parse-render-flags program words))
     (render-scene options scene)]))

(define (leave code text)
  (eprintf "raytrace: ~a\n" (one-line text))
  (exit code))

(define (report failure)
  (leave 1 (if (exn? failure) (exn-message failure) (format "raised ~s" failure))))

;; A render that is interrupted has more to say than the system.
(define (break-text e otherwise)
  (define text (exn-message e))
  (if (regexp-match? (string-append "^" otherwise) text) text otherwise))
