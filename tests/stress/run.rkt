#lang racket/base
;; The stress suite: each case prints its name, what it measured beside its pass number, PASS or
;; FAIL and its seconds. Sizes are those of the truth table, or quick; the seeds are the same.
;;   racket tests/stress/run.rkt [--size quick|full] [S01 ...]
(module+ main
  (require racket/cmdline racket/list "case.rkt" "all.rkt")

  (define size 1)

  (define names
    (command-line
     #:program "racket tests/stress/run.rkt"
     #:once-each
     [("--size") word "quick (a minute for all) or full (hours); full unless given"
                 (set! size
                       (case word
                         [("quick") QUICK]
                         [("full") 1]
                         [else (raise-user-error
                                (format "--size: expected quick or full, given ~a" word))]))]
     #:args names
     names))

  (define (named? c name) (regexp-match? (string-append "^" (regexp-quote name) "( |$)")
                                         (stress-case-name c)))
  (for ([name (in-list names)])
    (unless (ormap (lambda (c) (named? c name)) stress-cases)
      (raise-user-error (format "~a: expected the name of a case, such as S01" name))))
  (define chosen
    (if (null? names)
        stress-cases
        (filter (lambda (c) (ormap (lambda (name) (named? c name)) names)) stress-cases)))

  (define failed
    (for/sum ([c (in-list chosen)])
      (define-values (measured passed? seconds) (run-case c size))
      (printf "~a: ~a; pass: ~a; ~a, ~a s\n" (stress-case-name c) measured (stress-case-pass c)
              (if passed? "PASS" "FAIL") (/ (round (* 10.0 seconds)) 10.0))
      (flush-output)
      (if passed? 0 1)))
  (printf "~a passed, ~a failed\n" (- (length chosen) failed) failed)
  (exit (if (zero? failed) 0 1)))
