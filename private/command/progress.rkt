#lang racket/base
;; One line on a terminal that tells how far a render is, and how long it will go on.
(provide call-with-progress progress-text)

(define REDRAW-SECONDS 0.2)

;; call-with-progress : the values of (use watch), where watch is what render/statistics takes. If
;; show? is true, a thread keeps the line up to date; however use ends, the line is cleared.
(define (call-with-progress show? use)
  (define drawer #f)
  (define (watch done)
    (when show? (set! drawer (thread (lambda () (draw-on done)))))
    void)
  (dynamic-wind void
                (lambda () (use watch))
                (lambda ()
                  (when drawer
                    (kill-thread drawer)
                    (draw "")))))

(define (draw-on done)
  (define start (current-inexact-milliseconds))
  (let loop ()
    (draw (progress-text (done) (/ (- (current-inexact-milliseconds) start) 1000.0)))
    (sleep REDRAW-SECONDS)
    (loop)))

;; To the start of the line, the text, and clear what stood behind it.
(define (draw text)
  (eprintf "\r~a\e[K" text)
  (flush-output (current-error-port)))

;; progress-text : part: from 0 to 1; seconds since the start.
(define (progress-text part seconds)
  (define percent (format "~a%" (floor (inexact->exact (* 100 part)))))
  (if (and (positive? part) (>= seconds 1.0))
      (format "~a, ~a left" percent (duration-text (* seconds (/ (- 1 part) part))))
      percent))

(define (duration-text seconds)
  (define whole (inexact->exact (ceiling seconds)))
  (define-values (minutes rest) (quotient/remainder whole 60))
  (define-values (hours minutes-rest) (quotient/remainder minutes 60))
  (cond [(positive? hours) (format "~a h ~a min" hours minutes-rest)]
        [(positive? minutes) (format "~a min ~a s" minutes rest)]
        [else (format "~a s" rest)]))
