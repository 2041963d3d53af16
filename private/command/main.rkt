#lang racket/base
;; raco raytrace: the first word names a subcommand, or the scene to render. Whatever goes wrong
;; ends in one line on standard error and exit code 1; an interrupt in 130. Nothing heavy is loaded
;; before the words have been understood.
(require raco/command-name racket/lazy-require "line.rkt" "flags.rkt")

(lazy-require ["render.rkt" (render-scene)]
              ["list.rkt" (list-scenes)]
              ["compare.rkt" (compare-pictures)]
              ["explain.rkt" (explain-pixel)]
              ["check.rkt" (check-scene)]
              ["new.rkt" (new-scene)]
              ["merge.rkt" (merge-parts)]
              ["view.rkt" (view-command)])

(define program (short-program+command-name))

(define (run words)
  (case (and (pair? words) (car words))
    [("list") (list-scenes (subcommand-name "list") (cdr words))]
    [("merge") (merge-parts (subcommand-name "merge") (cdr words))]
    [("compare") (compare-pictures (subcommand-name "compare") (cdr words))]
    [("explain") (explain-pixel (subcommand-name "explain") (cdr words))]
    [("check") (check-scene (subcommand-name "check") (cdr words))]
    [("view") (view-command (subcommand-name "view") (cdr words))]
    [("new") (new-scene (subcommand-name "new") (cdr words))]
    [else
     (define-values (options scene) (parse-render-flags program words))
     (render-scene options scene)]))

(define (subcommand-name word) (string-append program " " word))

(define (leave code text)
  (eprintf "raytrace: ~a\n" (one-line text))
  (exit code))

(define (report failure)
  (leave 1 (if (exn? failure) (exn-message failure) (format "raised ~s" failure))))

;; A render that is interrupted has more to say than the system.
(define (break-text e otherwise)
  (define text (exn-message e))
  (if (regexp-match? (string-append "^" otherwise) text) text otherwise))

(with-handlers* ([exn:break:terminate? (lambda (e) (leave 143 (break-text e "terminated")))]
                 [exn:break? (lambda (e) (leave 130 (break-text e "interrupted")))]
                 [(lambda (e) #t) report])
  (run (vector->list (current-command-line-arguments)))
  (flush-output))

;; Without this, raco test would run the command.
(module test racket/base)
