#lang racket/base
;; Parts of a picture, rendered by the manual's lines for GNU parallel, xargs and Slurm and merged, are
;; the undivided picture to the byte; what does not belong together or is missing is named.
(module+ test
  (require compiler/find-exe racket/file racket/list racket/port racket/runtime-path racket/string
           racket/system rackunit
           "support.rkt" "ssh-server.rkt" "../command/support.rkt")
  (define-runtime-path manual "../../private/scribblings/machines.scrbl")

  (define parallel (find-executable-path "parallel"))
  (check-true (path? parallel) "GNU parallel is not installed")

  (call-with-folder
   (lambda (folder)
     (small-scene folder)
     (define settings (append small-words '("--samples" "5" "--quiet")))
     (define (bytes-of file) (file->bytes (build-path folder file)))
     (define (run . words) (apply run-command folder words))
     (check-equal? (outcome-code (apply run (append settings '("-o" "whole.pfm")))) 0)

     ;; the manual's lines, of a smaller picture and in fewer parts; nobody has to have a cluster
     (define lines
       (filter (lambda (line) (regexp-match? #rx"^(parallel|seq|sbatch) |^raco raytrace merge " line))
               (file->lines manual)))
     (check-equal? (length lines) 4)
     (define (smaller line)
       (for/fold ([line line]) ([change (in-list '(("weekend --samples 1024"
                                                    "weekend --samples 1 --size 40x24 --quiet")
                                                   ("1 2 3 4 5 6 7 8" "1 2") ("seq 8" "seq 2")
                                                   ("/8" "/2") ("1-100" "1-2") ("/100" "/2")))])
         (string-replace line (first change) (second change))))
     (define bin (build-path folder "bin"))
     (make-directory bin)
     (write-script (build-path bin "raco")
                   "[ \"$1\" = raytrace ] && shift"
                   (format "exec ~a -N raco -l- raytrace/private/command/main \"$@\"" (find-exe)))
     (write-script (build-path bin "sbatch")
                   "[ \"$1 $2\" = \"--array=1-2 --wrap\" ] || exit 1"
                   "for k in 1 2; do SLURM_ARRAY_TASK_ID=$k sh -c \"$3\" || exit 1; done")
     (define (shell line)
       (define errors (open-output-string))
       (check-true (parameterize ([current-directory folder]
                                  [current-error-port errors]
                                  [current-environment-variables
                                   (environment-variables-copy (current-environment-variables))])
                     (putenv "PATH" (format "~a:~a" bin (getenv "PATH")))
                     (system line))
                   (string-append line (get-output-string errors))))
     (check-equal? (outcome-code (run "weekend" "--samples" "1" "--size" "40x24" "--quiet"
                                      "-o" "weekend-whole.png"))
                   0)
     (for ([line (in-list (take lines 3))] #:when (or parallel (not (regexp-match? #rx"^parallel" line))))
       (shell (smaller line))
       (check-equal? (filter (lambda (file) (regexp-match? #rx"^weekend[.].*[.]part$" file)) (files folder))
                     '("weekend.1-of-2.part" "weekend.2-of-2.part"))
       (shell (smaller (last lines)))
       (check-true (equal? (bytes-of "weekend.png") (bytes-of "weekend-whole.png")) line)
       (for ([file (in-list '("weekend.png" "weekend.1-of-2.part" "weekend.2-of-2.part"))])
         (delete-file (build-path folder file))))

     ;; more parts than tiles, cut another way: some are empty
     (for ([k (in-list '("1" "2" "3"))])
       (check-equal? (outcome-code
                      (apply run (append settings (list "--part" (string-append k "/3") "--tile" "100"
                                                        "-o" (string-append "t" k ".part")))))
                     0))
     (check-equal? (outcome-code (run "merge" "t3.part" "t1.part" "t2.part" "-o" "t.pfm")) 0)
     (check-true (equal? (bytes-of "t.pfm") (bytes-of "whole.pfm")))

     (check-refused folder "merge: missing parts 1, 3 of 3" "merge" "t2.part" "-o" "n.pfm")
     (check-equal? (outcome-code
                    (apply run (append settings '("--seed" "4" "--part" "2/3" "--tile" "100"
                                                  "-o" "s.part"))))
                   0)
     (check-refused folder
                    (string-append "s.part: expected a part of the same picture as t1.part, "
                                   "found another seed: 4, not 0")
                    "merge" "t1.part" "s.part" "t3.part" "-o" "n.pfm")
     (check-refused folder
                    "--part: expected --samples, for --error and --seconds look at the whole picture"
                    "balls.rkt" "--part" "1/2" "--error" "1%")
     (check-refused folder "balls.rkt: byte 0: expected a part of a picture, found another kind of file"
                    "merge" "balls.rkt" "-o" "n.pfm"))))
