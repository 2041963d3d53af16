#lang racket/base
;; A picture that needs more memory than there is says so before it starts, for a number of samples and
;; for an error.
(module+ test
  (require rackunit "support.rkt" "../command/support.rkt" "../../private/render/memory.rkt")

  (when (available-bytes)
    (check-true (< (expt 2 20) (available-bytes) (expt 2 50)))
    (check-exn #rx"^9x7 pixels need 1048576 MiB of memory, [0-9]+ MiB are available; --crop renders a part$"
               (lambda () (check-memory (expt 2 40) 9 7)))
    (check-not-exn (lambda () (check-memory (expt 2 20) 9 7)))
    ;; 2^28 pixels of 48 and of 128 bytes, where this machine has less
    (for ([goal (in-list '(("--samples" "4") ("--error" "1%")))] [need (in-list '(12288 32768))])
      (when (< (available-bytes) (* need (expt 2 20)))
        (call-with-folder
         (lambda (folder)
           (small-scene folder)
           (check-one-line-error (apply run-command folder "balls.rkt" "--size" "16384x16384" goal)
                                 (format "16384x16384 pixels need ~a MiB of memory" need))
           (check-equal? (files folder) '("balls.rkt"))))))))
