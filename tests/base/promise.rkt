#lang racket/base
;; Promises of pure values: computed once, whatever befalls those who force them.
(module+ test
  (require racket/promise rackunit "../../private/base/promise.rkt")

  (define (counting act)
    (define count 0)
    (values (once (lambda () (set! count (+ count 1)) (act count))) (lambda () count)))

  (test-case "the value is computed when it is first asked for, and once"
    (define-values (promise count) (counting (lambda (n) (list 'value n))))
    (check-equal? (count) 0)
    (define value (force promise))
    (check-eq? (force promise) value)
    (check-equal? (count) 1))

  (test-case "an exception is not kept"
    (define-values (promise count) (counting (lambda (n) (if (= n 1) (error "not yet") n))))
    (check-exn #rx"not yet" (lambda () (force promise)))
    (check-equal? (force promise) 2))

  ;; Forces the promise in a thread that `stop` ends while the thunk runs.
  (define (check-stopped stop)
    (define started (make-semaphore 0))
    (define-values (promise count)
      (counting (lambda (n)
                  (when (= n 1)
                    (semaphore-post started)
                    (sync never-evt))
                  n)))
    (define worker
      (thread (lambda () (with-handlers ([exn:break? void]) (force promise)))))
    (semaphore-wait started)
    (stop worker)
    (thread-wait worker)
    (check-equal? (force promise) 2)
    (check-equal? (force promise) 2))

  (test-case "an interrupt leaves the promise as it was" (check-stopped break-thread))
  (test-case "a thread that is killed leaves the promise as it was" (check-stopped kill-thread))

  (test-case "threads that force it together get the same value"
    (define gate (make-semaphore 0))
    (define promise (once (lambda () (semaphore-wait gate) (list 'value))))
    (define values '())
    (define threads
      (for/list ([k 4]) (thread (lambda () (define value (force promise)) (set! values (cons value values))))))
    (sleep 0.05)
    (for ([k 4]) (semaphore-post gate))
    (for-each thread-wait threads)
    (check-equal? (length values) 4)
    (for ([value values]) (check-eq? value (car values)))))
