#lang racket/base
;; Renders on hosts over ssh, to two nodes of an ssh server on 127.0.0.1 that lives as long as the test:
;; a host that is lost and one that comes late change no byte, for a number of samples and for an error.
(module+ test
  (require racket/file racket/system rackunit
           "support.rkt" "ssh-server.rkt" "../command/support.rkt")

  (check-true (path? sshd) "an ssh server is not installed")

  ;; A node's racket: notes its process, and is there only while the file `open` is.
  (define (write-racket folder node)
    (node-racket folder (string-append node "-racket")
                 (format "[ -e ~a ] || exit 1" (build-path folder (string-append node "-open")))
                 (format "echo $$ >> ~a" (build-path folder (string-append node "-started")))))

  (define (started folder node)
    (define file (build-path folder (string-append node "-started")))
    (if (file-exists? file) (file->lines file) '()))

  (define (wait-until ready?)
    (let loop ([tries 600])
      (unless (or (zero? tries) (ready?))
        (sleep 0.1)
        (loop (- tries 1)))))

  (when sshd
    (call-with-folder
     (lambda (folder)
       (small-scene folder)
       (define (open! node) (display-to-file "" (build-path folder (string-append node "-open"))))
       (display-lines-to-file
        (list "# two nodes of one machine"
              (string-append "node-a 1 " (write-racket folder "node-a"))
              (string-append "node-b 1 " (write-racket folder "node-b")))
        (build-path folder "hosts"))
       (define (bytes-of file) (file->bytes (build-path folder file)))
       (define (alone . words)
         (check-equal? (outcome-code
                        (apply run-command folder
                               (append small-words words '("--schedule" "sequential" "--quiet"))))
                       0))

       (call-with-ssh-server
        folder
        (lambda ()
          ;; node-b comes when node-a has worked for a while, and then node-a is lost
          (open! "node-a")
          (define goal '("--samples" "1280"))
          (define command
            (apply start-command folder
                   (append small-words goal '("--schedule" "hosts:hosts" "-o" "far.pfm"))))
          (wait-for-error-text command #rx"far.pfm: ")
          (open! "node-b")
          (wait-until (lambda () (pair? (started folder "node-b"))))
          (sleep 1)
          (system* "/bin/kill" "-9" (car (started folder "node-a")))
          (define result (finish-command command))
          (check-equal? (outcome-code result) 0 (outcome-errors result))
          (check-regexp-match #rx"node-b: no worker there" (outcome-errors result))
          (check-regexp-match #rx"node-a: a worker there is lost" (outcome-errors result))
          (apply alone (append goal '("-o" "here.pfm")))
          (check-true (equal? (bytes-of "far.pfm") (bytes-of "here.pfm")))

          ;; the tiles of many passes
          (define error-goal '("--error" "3%"))
          (check-equal? (outcome-code
                         (apply run-command folder
                                (append small-words error-goal
                                        '("--schedule" "hosts:hosts" "-o" "far.pfm" "--quiet"))))
                        0)
          (apply alone (append error-goal '("-o" "here.pfm")))
          (check-true (equal? (bytes-of "far.pfm") (bytes-of "here.pfm")))

          (write-scene folder "hosts" "node-a 1\nnode-b none\n")
          (check-refused folder
                         (string-append "hosts:2: expected [user@]host[:port], workers from 1 to 1024, "
                                        "and racket's path, found node-b none")
                         "balls.rkt" "--schedule" "hosts:hosts")))))))
