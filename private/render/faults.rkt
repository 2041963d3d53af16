#lang racket/base
;; What went wrong in a scene's functions or in workers while rendering, each kind told once.
(provide make-faults fault-text)

;; make-faults : a procedure that is given the number of a pixel that was left in the error colour, and
;; the exception or a text that tells why, and one that returns the list of (text column row), with the
;; first such pixel in reading order for each text. If strict?, the first procedure raises one line.
(define (make-faults strict? width seed)
  (define first-pixels (make-hash))
  (define lock (make-semaphore 1))
  (define (report! pixel why)
    (define text (fault-text why))
    (when strict?
      (raise-user-error (format "~a, at pixel ~a,~a with seed ~a" text
                                (remainder pixel width) (quotient pixel width) seed)))
    (call-with-semaphore
     lock
     (lambda ()
       (hash-update! first-pixels text (lambda (other) (min other pixel)) pixel))))
  (define (all)
    (for/list ([fault (in-list (sort (hash->list first-pixels) < #:key cdr))])
      (list (car fault) (remainder (cdr fault) width) (quotient (cdr fault) width))))
  (values report! all))

;; What is said of an exception, a text, or anything else that was raised.
(define (fault-text why)
  (cond [(string? why) why]
        [(exn? why) (exn-message why)]
        [else (format "raised ~e" why)]))
