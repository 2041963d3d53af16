#lang racket/base
;; raco raytrace list: a line for each scene of the package, with what it shows.
(module+ test
  (require racket/port racket/string rackunit "../../private/command/list.rkt"
           "../../private/command/scenes.rkt")

  (define (listed . words)
    (with-output-to-string (lambda () (list-scenes "raco raytrace list" words))))
  (define lines (string-split (listed) "\n"))
  (check-equal? (for/list ([line (in-list lines)]) (car (string-split line)))
                (map scene-name (package-scenes)))
  ;; every scene says what it shows
  (for ([line (in-list lines)])
    (check-regexp-match #px"^[\\w-]+  +[A-Z].*[.]$" line))
  (check-exn #rx"expects no arguments" (lambda () (listed "more"))))
