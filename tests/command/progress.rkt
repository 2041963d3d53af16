#lang racket/base
;; The progress line: its words, that it is cleared however the render ends, and that it appears on
;; a terminal only.
(module+ test
  (require rackunit "../../private/command/progress.rkt")

  (check-equal? (progress-text 0 0.0) "0%")
  (check-equal? (progress-text 0 100.0) "0%")
  (check-equal? (progress-text 1/2 0.5) "50%")
  (check-equal? (progress-text 1/4 1.0) "25%, 3 s left")
  (check-equal? (progress-text 1/3 60.0) "33%, 2 min 0 s left")
  (check-equal? (progress-text 999/1000 1.0) "99%, 1 s left")
  (check-equal? (progress-text 1/100 100.0) "1%, 2 h 45 min left")
  (check-equal? (progress-text 1 10.0) "100%, 0 s left")
  (check-equal? (progress-text 1/2 10.0 #:rate 1234567.0 #:error 0.01234)
                "50%, 1.23 million rays/s, error 1.2%, 10 s left")
  (check-equal? (progress-text 0 10.0 #:rate 0.0) "0%, 0.00 million rays/s")

  ;; what is drawn while use runs
  (define (drawn show? use)
    (define out (open-output-string))
    (parameterize ([current-error-port out])
      (with-handlers ([symbol? void])
        (call-with-progress (and show? 'line) use)))
    (get-output-string out))
  (define (half-done watch)
    (define finish (watch (lambda () 1/2)))
    (sleep 0.3)
    (finish))
  (check-regexp-match #px"^(\r50%\e\\[K)+\r\e\\[J$" (drawn #t half-done))
  (check-equal? (drawn #f half-done) "")
  (check-regexp-match #px"\r50%\e\\[K\r\e\\[J$"
                      (drawn #t (lambda (watch) (half-done watch) (raise 'stop))))
  (check-equal? (drawn #t (lambda (watch) 1)) "")
  (check-equal? (call-with-values (lambda () (call-with-progress #f (lambda (watch) (values 1 2))))
                                  list)
                '(1 2)))
