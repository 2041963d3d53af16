#lang racket/base
;; Renders that are killed at random moments, again and again, and go on with --resume: in the end the
;; picture is the one of a render that was never killed, to the byte. RAYTRACE_STRESS=full for 200 kills.
(module+ test
  (require racket/file rackunit "support.rkt" "../command/support.rkt")

  (define kills-wanted (if (equal? (getenv "RAYTRACE_STRESS") "full") 200 12))
  (define generator (make-pseudo-random-generator))
  (parameterize ([current-pseudo-random-generator generator]) (random-seed 8))

  (call-with-folder
   (lambda (folder)
     (small-scene folder)
     (define (bytes-of file) (file->bytes (build-path folder file)))
     (define (command goal file . more)
       (apply start-command folder (append small-words goal (list "-o" file "--quiet") more)))
     ;; each goal with the picture of an undisturbed render
     (define goals '(("--samples" "150") ("--error" "1.2%")))
     (define references
       (for/list ([goal (in-list goals)])
         (check-equal? (outcome-code (finish-command (command goal "whole.pfm"))) 0)
         (bytes-of "whole.pfm")))
     (define schedules
       '(("futures" "2") ("sequential" "1") ("places" "2") ("futures" "3")))
     (define checkpoint (build-path folder "a.pfm.checkpoint"))
     (define kept 0)
     (define (turn list k) (list-ref list (modulo k (length list))))

     ;; Until there is a checkpoint or the picture, and a moment more.
     (define (wait-for-checkpoint)
       (let wait ([tries 3000])
         (unless (or (zero? tries) (file-exists? checkpoint)
                     (file-exists? (build-path folder "a.pfm")))
           (sleep 0.01)
           (wait (- tries 1))))
       (sleep (* 0.5 (random generator))))

     ;; Kills a render several times and then lets it end; returns the kills that met it running, and
     ;; counts in `kept` those that left a checkpoint.
     (define (one-picture round)
       (define goal (turn goals round))
       (define (start attempt)
         (define schedule (turn schedules (+ round attempt)))
         (command goal "a.pfm" "--resume" "--checkpoint-seconds" "0.05"
                  "--schedule" (car schedule) "--workers" (cadr schedule)))
       (define kills
         (for/fold ([kills 0]) ([attempt (in-range 4)])
           (define running (start attempt))
           ;; at any moment, be it before the first ray; or when there is something to go on from
           (if (even? attempt)
               (sleep (+ 0.5 (* 2.0 (random generator))))
               (wait-for-checkpoint))
           (kill-command running)
           (define result (finish-command running))
           (when (file-exists? checkpoint) (set! kept (+ kept 1)))
           (if (eqv? (outcome-code result) 0) kills (+ kills 1))))
       (define result (finish-command (start 4) #:seconds 300))
       (check-equal? (outcome-code result) 0 (outcome-errors result))
       (check-true (equal? (bytes-of "a.pfm") (turn references round)))
       (check-false (file-exists? checkpoint))
       (check-false (file-exists? (build-path folder "a.pfm.checkpoint.new")))
       (delete-file (build-path folder "a.pfm"))
       kills)

     (define kills
       (let loop ([round 0] [kills 0])
         (if (or (>= kills kills-wanted) (> round (* 2 kills-wanted)))
             kills
             (loop (+ round 1) (+ kills (one-picture round))))))
     (check-true (>= kills kills-wanted))
     ;; what goes on from nothing proves little
     (check-true (>= kept (quotient kills 4)) (format "~a of ~a kills left a checkpoint" kept kills))
     (printf "~a kills, ~a with a checkpoint\n" kills kept))))
