#lang racket/base
;; What happens in a night: interrupts keep what they should, a full disk and a closed pipe end in one
;; line, checkpoints of other renders and damaged ones are refused and stay.
(module+ test
  (require racket/file racket/string rackunit "support.rkt" "../command/support.rkt"
           "../../private/image/write.rkt" "../../private/image/image.rkt")

  (call-with-folder
   (lambda (folder)
     (small-scene folder)
     (define long (append small-words '("--samples" "20000")))
     (define (wait-for file)
       (let loop ([tries 400])
         (unless (or (zero? tries) (file-exists? (build-path folder file)))
           (sleep 0.05)
           (loop (- tries 1)))))
     (define (interrupt signal code word . more)
       (when (file-exists? (build-path folder "a.pfm.checkpoint"))
         (delete-file (build-path folder "a.pfm.checkpoint")))
       (define command
         (apply start-command folder
                (append long '("-o" "a.pfm" "--resume" "--checkpoint-seconds" "0.1") more)))
       (wait-for "a.pfm.checkpoint")
       (sleep 1)
       (signal-command command signal)
       (define result (finish-command command))
       (check-equal? (outcome-code result) code (outcome-errors result))
       (check-regexp-match (string-append "raytrace: " word " at [0-9]+% after [0-9]+ .*"
                                          "the same command goes on from a.pfm.checkpoint[^\n]*\n$")
                           (outcome-errors result)))
     (interrupt 'INT 130 "interrupted" "--quiet")
     (check-equal? (files folder) '("a.pfm.checkpoint" "balls.rkt"))
     (interrupt 'TERM 143 "terminated" "--quiet" "--keep-partial")
     (check-equal? (files folder) '("a.pfm" "a.pfm.checkpoint" "balls.rkt"))
     (check-equal? (Image-width (Image-read (build-path folder "a.pfm"))) 120)

     ;; another render's checkpoint
     (define checkpoint (build-path folder "a.pfm.checkpoint"))
     (define whole (file->bytes checkpoint))
     (define (refused line . more)
       (apply check-refused folder line
              (append long '("-o" "a.pfm" "--resume" "--quiet") more))
       (check-true (equal? whole (file->bytes checkpoint))))
     (define start "a.pfm.checkpoint: expected a checkpoint of this render, found another ")
     (refused (string-append start "seed: 0, not 3") "--seed" "3")
     (refused (string-append start "sampler: owen-sobol, not r2") "--sampler" "r2")
     (define scene (file->string (build-path folder "balls.rkt")))
     (write-scene folder "balls.rkt" (string-replace scene "0.7 0.4 0.3" "0.7 0.4 0.2"))
     (refused (string-append "a.pfm.checkpoint: expected a checkpoint of this render, "
                             "found one with another scene's content"))
     (write-scene folder "balls.rkt" scene)
     ;; a damaged one
     (call-with-output-file checkpoint #:exists 'truncate
       (lambda (out) (write-bytes (subbytes whole 0 (- (bytes-length whole) 7)) out)))
     (define cut (apply run-command folder (append long '("-o" "a.pfm" "--resume" "--quiet"))))
     (check-one-line-error cut "a.pfm.checkpoint: byte" "found the end of the file")
     (check-equal? (file-size checkpoint) (- (bytes-length whole) 7))))

  (call-with-folder
   (lambda (folder)
     (small-scene folder)
     (define (run . more) (apply run-command folder (append small-words '("--samples" "2") more)))
     (when (file-exists? "/dev/full")
       (make-file-or-directory-link "/dev/full" (build-path folder "full.ppm"))
       (define result (run "-o" "full.ppm" "--resume" "--quiet"))
       (check-one-line-error result "full.ppm: cannot be written (No space left on device")
       (check-true (file-exists? (build-path folder "full.ppm.checkpoint"))))
     (check-one-line-error (run "-o" "none/a.ppm" "--resume") "none/a.ppm: cannot be written"))))
