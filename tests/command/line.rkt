#lang racket/base
;; Messages squeezed to one line.
(module+ test
  (require rackunit "../../private/command/line.rkt")
  (check-equal? (one-line "a: contract violation\n  expected: b\r\n  given: c\n")
                "a: contract violation expected: b given: c")
  (check-equal? (one-line "\e[2J\0\ttext  ") "[2J text")
  (check-equal? (one-line "") "")
  (check-equal? (one-line (make-string 400 #\a)) (make-string 400 #\a))
  (check-equal? (one-line (make-string 401 #\a)) (string-append (make-string 397 #\a) "...")))
