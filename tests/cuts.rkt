#lang racket/base
;; The benchmarks that cut a feature out of the library's source, or put another one in its place, find
;; the texts they are for. (That what is left compiles shows when they are run.)
(module+ test
  (require rackunit racket/list "bench/features.rkt" "bench/many-lights.rkt")

  (define (check-cuts name edits)
    (for ([file (remove-duplicates (map edit-file edits))])
      (define own (filter (lambda (e) (equal? (edit-file e) file)) edits))
      (check-not-equal? (edited-text file own) (edited-text file '()) name)))

  (for ([absence (in-list (cdr absences))]) (check-cuts (car absence) (cadr absence)))
  (check-cuts "uniform choice among lights" uniform-choice)

  (test-case "a text that is not there is one clear line"
    (check-exn (lambda (e)
                 (and (exn:fail:user? e)
                      (regexp-match? #rx"^features: expected \"no such text\" 1 times in [^\n]*, found it 0 times$"
                                     (exn-message e))))
               (lambda ()
                 (edited-text "private/integrate/path.rkt"
                              (list (edit "private/integrate/path.rkt" "no such text" 1 "")))))))
