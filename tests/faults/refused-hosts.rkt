#lang racket/base
;; Hosts that may not render, for their library, Racket or scene is another: each is told in one line
;; that names it and what differs. And one whose workers die before their first tile, again and again.
(module+ test
  (require racket/fasl racket/file racket/list racket/system rackunit raytrace
           "support.rkt" "ssh-server.rkt" "../command/support.rkt"
           "../../private/render/schedule/host-check.rkt" "../../private/render/job.rkt"
           "../../private/render/pixel.rkt")

  (check-true (path? sshd) "an ssh server is not installed")

  ;; what is compared, without hosts
  (define world (World (list (Sphere (Float3 0 0 0) 1 (Float3 1 0 0)))))
  (define camera (Camera-look-at (Float3 0 0 5) (Float3 0 0 0)))
  (define (order scene)
    (make-host-order
     (Job world camera (Tiling 8 8 8 '(0 0 8 8)) 1 0 'independent 'box 'auto #f scene)))
  (define (answer order) (host-order->job (fasl->s-exp (s-exp->fasl order))))
  (check-true (Job? (answer (order #f))))
  ;; a scene of the package is looked for in the host's own
  (check-equal? (cadr (order (path->string
                             (build-path (collection-path "raytrace") "scenes" "seed.rkt"))))
                '("seed.rkt"))
  (check-equal? (answer (list-set (order #f) 2 "8.0"))
                (format "has Racket ~a, not 8.0" (version)))
  (check-equal? (answer (list-set (order #f) 3 "another sum")) "has another version of raytrace")
  (call-with-folder
   (lambda (folder)
     (define scene (write-scene folder "ball.rkt" (scene-text)))
     (define asked (order (path->string scene)))
     (delete-file scene)
     (check-equal? (answer asked) (format "has no ~a" scene))))

  (define package (simplify-path (collection-path "raytrace")))

  ;; A folder of links for a copy of the library in which edit changes what it wants; its files are
  ;; symbolic links to those here.
  (define (other-library folder name edit)
    (define root (build-path folder name))
    (define addon (build-path folder (string-append name "-addon")))
    (make-directory* root)
    (for ([part (in-list '("info.rkt" "main.rkt" "private" "scenes" "compiled"))])
      (define from (build-path package part))
      (when (or (file-exists? from) (directory-exists? from))
        (system* "/bin/cp" "-as" (path->string from) (path->string root))))
    (edit root)
    (define links (build-path addon (version) "links.rktd"))
    (make-directory* (build-path addon (version)))
    (write-to-file (list (list "raytrace" (path->bytes root))) links)
    addon)

  (define (change-file file)
    (define text (file->string file))
    (delete-file file)
    (display-to-file (string-append text "\n;; another\n") file))

  (when sshd
    (call-with-folder
     (lambda (folder)
       (define newer
         (other-library folder "newer" (lambda (root) (change-file (build-path root "private/command/line.rkt")))))
       (define edited
         (other-library folder "edited" (lambda (root) (change-file (build-path root "scenes/seed.rkt")))))
       (define hosts (build-path folder "hosts"))
       ;; the first three workers are killed while they start, ever later
       (define count (build-path folder "count"))
       (define dying
         (node-racket folder "dying"
                      (format "echo >> ~a; n=$(wc -l < ~a)" count count)
                      "exec 3<&0"
                      #:last (format "~a \"$@\" <&3 & [ $n -gt 3 ] || { sleep 0.$((n * n - 1)); kill -9 $!; }; wait $!"
                                     (find-executable-path "racket"))))
       (display-lines-to-file
        (list (string-append "node-a 2 " (node-racket folder "newer-racket" #:addon newer))
              (string-append "node-b 1 " (node-racket folder "edited-racket" #:addon edited)))
        hosts)
       (define words '("seed" "--size" "32x18" "--samples" "1"))
       (define (run . more) (apply run-command folder (append words more)))
       (call-with-ssh-server
        folder
        (lambda ()
          (define result (run "--schedule" "hosts:hosts" "-o" "far.pfm" "--quiet"))
          (check-equal? (outcome-code result) 1)
          (check-equal? (sort (regexp-split #rx"\n" (outcome-errors result)) string<?)
                        (list ""
                              "raytrace: no host can render this"
                              "raytrace: node-a: has another version of raytrace"
                              (format "raytrace: node-b: has another ~a"
                                      (build-path folder "edited" "scenes" "seed.rkt"))))
          (check-false (file-exists? (build-path folder "far.pfm")))

          (display-lines-to-file (list (string-append "node-c 1 " dying)) hosts #:exists 'truncate)
          (define late (run "--schedule" "hosts:hosts" "-o" "far.pfm" "--quiet"))
          (check-equal? (outcome-code late) 0 (outcome-errors late))
          (check-regexp-match #rx"^raytrace: node-c: no worker there [^\n]*tried again every 3.0 s\n"
                              (outcome-errors late))
          (check-equal? (length (file->lines count)) 4)
          (check-equal? (outcome-code (run "--schedule" "sequential" "-o" "here.pfm" "--quiet")) 0)
          (check-true (equal? (file->bytes (build-path folder "far.pfm"))
                              (file->bytes (build-path folder "here.pfm"))))))))))
