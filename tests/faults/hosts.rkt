#lang racket/base
;; Renders on hosts over ssh, to two nodes of an ssh server on 127.0.0.1 that lives as long as the test:
;; a host that is lost and one that comes late change no byte, for a number of samples and for an error.
(module+ test
  (require racket/file racket/port racket/string racket/system racket/tcp rackunit
           "support.rkt" "../command/support.rkt")

  ;; sshd wants to be called by its whole path
  (define sshd
    (for/first ([folder (in-list '("/usr/sbin" "/usr/local/sbin" "/sbin"))]
                #:when (file-exists? (build-path folder "sshd")))
      (build-path folder "sshd")))
  (check-true (path? sshd) "an ssh server is not installed")

  (define (free-port)
    (define listener (tcp-listen 0 1 #f "127.0.0.1"))
    (define-values (here port there other) (tcp-addresses listener #t))
    (tcp-close listener)
    port)

  (define (write-script file . lines)
    (display-lines-to-file (cons "#!/bin/sh" lines) file)
    (file-or-directory-permissions file #o755))

  ;; Keys, a server and a client that know each other, all in the folder; what stops the server.
  (define (start-server folder)
    (define (in-folder name) (path->string (build-path folder name)))
    (define port (free-port))
    (for ([key (in-list '("host" "user"))])
      (system* (find-executable-path "ssh-keygen") "-q" "-t" "ed25519" "-N" "" "-f" (in-folder key)))
    (copy-file (in-folder "user.pub") (in-folder "authorized"))
    (display-lines-to-file
     (list (format "Port ~a" port) "ListenAddress 127.0.0.1" (format "HostKey ~a" (in-folder "host"))
           (format "AuthorizedKeysFile ~a" (in-folder "authorized"))
           (format "PidFile ~a" (in-folder "pid")) "StrictModes no" "UsePAM no"
           "PermitRootLogin yes" "AllowTcpForwarding yes")
     (in-folder "server"))
    (display-lines-to-file
     (list "Host node-*" "HostName 127.0.0.1" (format "Port ~a" port)
           (format "IdentityFile ~a" (in-folder "user")) "IdentitiesOnly yes"
           "StrictHostKeyChecking no" (format "UserKnownHostsFile ~a" (in-folder "known")))
     (in-folder "client"))
    (make-directory (in-folder "bin"))
    (write-script (in-folder "bin/ssh")
                  (format "exec ~a -F ~a \"$@\"" (find-executable-path "ssh") (in-folder "client")))
    (putenv "PATH" (string-append (in-folder "bin") ":" (getenv "PATH")))
    (with-handlers ([exn:fail? void]) (make-directory "/run/sshd")) ; root's server asks for it
    (system* sshd "-f" (in-folder "server") "-E" (in-folder "log"))
    (lambda ()
      (system* "/bin/kill" (string-trim (file->string (in-folder "pid"))))))

  ;; A node's racket: notes its process, and is there only while the file `open` is.
  (define (write-racket folder node)
    (define file (build-path folder (string-append node "-racket")))
    (write-script file
                  (format "[ -e ~a ] || exit 1" (build-path folder (string-append node "-open")))
                  (format "echo $$ >> ~a" (build-path folder (string-append node "-started")))
                  (format "export PLTADDONDIR='~a'" (find-system-path 'addon-dir))
                  (format "exec ~a \"$@\"" (find-executable-path "racket")))
    (path->string file))

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
       (define stop-server (start-server folder))
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

       (dynamic-wind
        void
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
                         "balls.rkt" "--schedule" "hosts:hosts"))
        stop-server)))))
