#lang racket/base
;; Parts of a picture, rendered by GNU parallel and merged, are the undivided picture to the
;; byte; what does not belong together or is missing is named.
(module+ test
  (require compiler/find-exe racket/file racket/port racket/system rackunit
           "support.rkt" "../command/support.rkt")

  (define parallel (find-executable-path "parallel"))
  (check-true (path? parallel) "GNU parallel is not installed")

  (call-with-folder
   (lambda (folder)
     (small-scene folder)
     (define settings (append small-words '("--samples" "5" "--quiet")))
     (define (bytes-of file) (file->bytes (build-path folder file)))
     (define (run . words) (apply run-command folder words))
     (check-equal? (outcome-code (apply run (append settings '("-o" "whole.pfm")))) 0)

     (define (shell . words)
       (parameterize ([current-directory folder]
                      [current-error-port (open-output-nowhere)])
         (apply system* words)))
     (define command
       (append (list (path->string (find-exe)) "-N" "raco" "-l-" "raytrace/private/command/main")
               settings))
     (when parallel
       (check-true (apply shell parallel "-j" "2"
                          (append command '("--part" "{}/4" "-o" "p{}.part" ":::" "1" "2" "3" "4"))))
       (check-equal? (outcome-code (run "merge" "p3.part" "p1.part" "p4.part" "p2.part" "-o" "m.pfm")) 0)
       (check-true (equal? (bytes-of "m.pfm") (bytes-of "whole.pfm"))))

     ;; more parts than tiles, cut another way: some are empty
     (for ([k (in-list '("1" "2" "3"))])
       (check-equal? (outcome-code
                      (apply run (append settings (list "--part" (string-append k "/3") "--tile" "100"
                                                        "-o" (string-append "t" k ".part")))))
                     0))
     (check-equal? (outcome-code (run "merge" "t1.part" "t2.part" "t3.part" "-o" "t.pfm")) 0)
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
