#lang racket/base
;; Every program and every command that README and manual show runs: programs as modules, commands in
;; a folder that holds the files they name, at a tiny size and with a fraction of the samples. (The
;; manual's examples run when it is built: see manual.rkt.)
(module+ test
  (require compiler/find-exe racket/file racket/list racket/path racket/runtime-path racket/string
           racket/system rackunit "../command/support.rkt"
           "../../private/image/image.rkt" "../../private/image/write.rkt" racket/flonum)

  (define-runtime-path package-folder "../..")
  (define readme (file->string (build-path package-folder "README.md")))
  (define pages
    (for/list ([file (in-list (directory-list (build-path package-folder "private/scribblings")
                                              #:build? #t))]
               #:when (path-has-extension? file #".scrbl"))
      (file->string file)))

  (define (matches pattern text) (regexp-match* pattern text #:match-select cadr))

  ;; The lines between ```language and ```, for each such block.
  (define (blocks language text)
    (let next ([lines (string-split text "\n" #:trim? #f)])
      (define start (memf (lambda (line) (string-prefix? line "```")) lines))
      (cond
        [start
         (define-values (inside after)
           (splitf-at (cdr start) (lambda (line) (not (equal? line "```")))))
         (define rest (next (cdr after)))
         (if (equal? (car start) (string-append "```" language)) (cons inside rest) rest)]
        [else '()])))

  ;; ----------------------------------------------------------------------------------------------
  ;; Programs: each must end well; what provides a world must render.

  (define programs
    (append (for/list ([lines (in-list (blocks "racket" readme))]) (string-join lines "\n"))
            (append-map (lambda (page) (matches #px"@codeblock[|][{]\n(.*?)[}][|]" page)) pages)))

  (test-case "programs"
    (check-true (>= (length programs) 2))
    (for ([program (in-list programs)])
      (call-with-folder
       (lambda (folder)
         (write-scene folder "program.rkt" program)
         (define errors (open-output-string))
         (check-true (parameterize ([current-directory folder] [current-error-port errors])
                       (system* (find-exe) "program.rkt"))
                     (get-output-string errors))
         (when (regexp-match? #rx"[(]provide world camera" program)
           (define result
             (run-command folder "program.rkt" "-o" "p.ppm" "--size" "16x9" "--samples" 1))
           (check-equal? (outcome-code result) 0 (outcome-errors result)))))))

  ;; ----------------------------------------------------------------------------------------------
  ;; Commands.

  ;; Lines of code in the README, whose remark begins after two spaces, and command lines of the manual.
  (define lines
    (append
     (for*/list ([block (in-list (blocks "" readme))] [line (in-list block)])
       (car (regexp-split #px"\\s{2,}" line)))
     (append-map (lambda (page) (matches #px"@commandline[{]([^\n]*)[}]\n" page)) pages)))

  ;; What a shell, GNU parallel, xargs or Slurm makes of a line: the words after `raco raytrace`.
  (define (command-words line)
    (define command (cadr (regexp-match #px"raco raytrace (.*?)(?: :::.*|')?$" line)))
    (string-split (regexp-replaces command '([#rx"{}" "1"] [#rx"[$]SLURM_ARRAY_TASK_ID" "1"]))))

  (define commands
    (remove-duplicates
     (for/list ([line (in-list lines)] #:when (regexp-match? #rx"raco raytrace " line))
       (command-words line))))

  ;; The same command for a tiny picture.
  (define (tiny words)
    (define smaller
      (let shrink ([words words])
        (cond
          [(or (null? words) (null? (cdr words))) words]
          [else
           (define value
             (case (car words)
               [("--size") "16x9"]
               [("--samples") "2"]
               [("--seconds") "0.1"]
               [("--error") "100%"]
               [("--pixel") "3,3"]
               [("--schedule") "sequential"] ; there are no hosts here
               [else #f]))
           (if value
               (list* (car words) value (shrink (cddr words)))
               (cons (car words) (shrink (cdr words))))])))
    (define (with flag value words) (if (member flag words) words (append words (list flag value))))
    (cond
      [(member (car words) '("new" "check" "compare" "list" "merge" "--help")) smaller]
      [(equal? (car words) "explain") (with "--samples" "2" (with "--size" "16x9" smaller))]
      [(ormap (lambda (goal) (member goal words)) '("--error" "--seconds"))
       (with "--size" "16x9" smaller)]
      [(member "raster" words) (with "--size" "16x9" smaller)]
      [else (with "--samples" "2" (with "--size" "16x9" smaller))]))

  (define ply
    (string-append "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                   "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                   "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"))
  (define obj "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")

  ;; The files that commands take as given.
  (define (provide-files folder)
    (write-scene folder "my-scene.rkt" (scene-text))
    (write-scene folder "dragon.ply" ply)
    (write-scene folder "roof.obj" obj)
    (define picture (make-Image 2 1 (flvector 0.0 0.1 0.2 0.3 0.4 0.5)))
    (for ([name '("a.pfm" "b.pfm" "my-scene.pfm" "reference.pfm")])
      (Image-write picture (build-path folder name))))

  ;; Where a shell would put the names of files.
  (define (expanded folder words)
    (append*
     (for/list ([word (in-list words)])
       (if (regexp-match? #rx"[*]" word)
           (for/list ([file (in-list (files folder))]
                      #:when (regexp-match? (regexp (regexp-replaces word '([#rx"[.]" "[.]"]
                                                                            [#rx"[*]" ".*"])))
                                            file))
             file)
           (list word)))))

  ;; Files that the command should leave.
  (define (outputs words)
    (for/list ([flag (in-list words)] [word (in-list (append (cdr words) '("")))]
               #:when (equal? flag "-o"))
      word))

  ;; A window would stay open: with its flags accepted, view finds no display. (tests/view opens one.)
  (define no-display (environment-variables-copy (current-environment-variables)))
  (for ([name '(#"DISPLAY" #"WAYLAND_DISPLAY")]) (environment-variables-set! no-display name #f))

  (test-case "commands"
    (check-true (> (length commands) 20))
    (for ([words (in-list commands)])
      (call-with-folder
       (lambda (folder)
         (provide-files folder)
         (case (car words)
           [("new") (delete-file (build-path folder "my-scene.rkt"))]
           [("merge")
            (for ([part '("1/2" "2/2")])
              (run-command folder "weekend" "--size" "16x9" "--samples" 2 "--part" part))]
           [else (void)])
         (define result
           (parameterize ([current-environment-variables no-display])
             (apply run-command folder (expanded folder (tiny words)))))
         (with-check-info (['command (string-join words)])
           (if (equal? (car words) "view")
               (check-regexp-match #rx"^raytrace: view needs a display: [^\n]*\n$"
                                   (outcome-errors result))
               (check-equal? (outcome-code result) 0 (outcome-errors result)))
           (for ([name (in-list (outputs words))])
             (check-true (file-exists? (build-path folder name)) name)))))))

  (test-case "the schedules and flags that cannot run here are known to the command"
    (call-with-folder
     (lambda (folder)
       (define help (outcome-output (run-command folder "--help")))
       (for* ([words (in-list commands)] [word (in-list words)]
              #:when (and (regexp-match? #rx"^--" word)
                          (not (member (car words) '("explain" "check" "compare" "merge" "new")))))
         (check-true (regexp-match? (regexp-quote (string->bytes/utf-8 word)) help) word))))))
