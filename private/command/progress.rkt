#lang racket/base
;; What is told while a render goes on: one line on a terminal that is kept up to date, with the picture
;; above it as it forms where that is asked for; lines of a log elsewhere.
(require racket/lazy-require)

(lazy-require ["preview.rkt" (draw-preview)])

(provide call-with-progress (struct-out live) progress-text duration-text)

;; What a render tells of itself while it goes on, procedures without arguments: the rays traced, the
;; estimated relative error or #f, and the picture so far, no number where there is none.
(struct live (rays error picture))

(define REDRAW-SECONDS 0.2)

;; A log has no lines of renders that are done by then.
(define LOG-SECONDS 5.0)

;; The part of the time that may go into telling of it.
(define SHARE 0.03)

;; call-with-progress : the values of (use watch). watch is called with a procedure that tells the part
;; that is done, from 0 to 1, and optionally with a live; it returns a procedure to be called at the
;; end. style: 'line draws a line on a terminal, 'preview that and the picture above it, 'log writes a
;; line that starts with the label for every tenth of the whole, #f nothing. However use ends, what
;; was drawn is cleared. under: #f or a procedure from a width to a coarse picture.
(define (call-with-progress style use #:label [label ""] #:under [under #f])
  (define drawer #f)
  (define lines 0)
  (define (watch part [render #f])
    (define tell
      (case style
        [(log) (log-teller label)]
        [(preview) (if render
                       (let ([draw (draw-preview (live-picture render) under)])
                         (lambda (part text) (set! lines (draw text))))
                       draw-line)]
        [else draw-line]))
    (when style (set! drawer (thread (lambda () (tell-on part render tell)))))
    void)
  (dynamic-wind void
                (lambda () (use watch))
                (lambda ()
                  (when drawer
                    (kill-thread drawer)
                    (unless (eq? style 'log) (clear lines))))))

(define (now) (/ (current-inexact-monotonic-milliseconds) 1000.0))

;; Tells again and again. The rate is that of the last seconds; what takes long to find is found less
;; often.
(define (tell-on part render tell)
  (define start (now))
  (let loop ([then start] [rays-then 0.0] [rate #f])
    (define before (now))
    (define rays (and render ((live-rays render))))
    (define new-rate
      (if (and rays (> (- before then) 1.0)) (/ (- rays rays-then) (- before then)) rate))
    (define error (and render ((live-error render))))
    (define done (part))
    (tell done (progress-text done (- before start) #:rate new-rate #:error error))
    (define took (- (now) before))
    (sleep (max REDRAW-SECONDS (/ took SHARE)))
    (if (and rays (> (- before then) 1.0))
        (loop before rays new-rate)
        (loop then rays-then new-rate))))

;; To the start of the line, the text, and clear what stood behind it.
(define (draw-line part text)
  (eprintf "\r~a\e[K" text)
  (flush-output (current-error-port)))

;; What stands on this line, and on so many above it.
(define (clear lines)
  (eprintf "\r~a\e[J" (if (zero? lines) "" (format "\e[~aA" lines)))
  (flush-output (current-error-port)))

;; One line for each tenth that has been passed since the last.
(define (log-teller label)
  (define start (now))
  (define told 0)
  (lambda (part text)
    (define tenths (inexact->exact (floor (* 10 part))))
    (when (and (> tenths told) (< tenths 10) (> (- (now) start) LOG-SECONDS))
      (set! told tenths)
      (eprintf "~a: ~a\n" label text))))

;; progress-text : part: from 0 to 1; seconds since the start; rate: rays a second, and error, or #f.
(define (progress-text part seconds #:rate [rate #f] #:error [error #f])
  (string-append
   (format "~a%" (floor (inexact->exact (* 100 part))))
   (if rate (format ", ~a million rays/s" (significant (/ rate 1e6) 3)) "")
   (if error (format ", error ~a%" (significant (* 100 error) 2)) "")
   (if (and (positive? part) (>= seconds 1.0))
       (format ", ~a left" (duration-text (* seconds (/ (- 1 part) part))))
       "")))

;; A positive number with so many digits that are not leading zeros, and no more than it needs.
(define (significant number digits)
  (define power (if (positive? number) (inexact->exact (floor (/ (log number) (log 10)))) 0))
  (define places (- digits 1 power))
  (if (positive? places)
      (real->decimal-string number places)
      (number->string (inexact->exact (round number)))))

;; duration-text : seconds in words, rounded up.
(define (duration-text seconds)
  (define whole (inexact->exact (ceiling seconds)))
  (define-values (minutes rest) (quotient/remainder whole 60))
  (define-values (hours minutes-rest) (quotient/remainder minutes 60))
  (cond [(positive? hours) (format "~a h ~a min" hours minutes-rest)]
        [(positive? minutes) (format "~a min ~a s" minutes rest)]
        [else (format "~a s" rest)]))
