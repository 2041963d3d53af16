#lang racket/base
;; An ssh server on 127.0.0.1 with names of hosts that all lead to it, for as long as a test needs it.
(require racket/file racket/string racket/system racket/tcp)

(provide sshd call-with-ssh-server write-script node-racket)

;; sshd wants to be called by its whole path; #f where there is none.
(define sshd
  (for/first ([folder (in-list '("/usr/sbin" "/usr/local/sbin" "/sbin"))]
              #:when (file-exists? (build-path folder "sshd")))
    (build-path folder "sshd")))

(define (free-port)
  (define listener (tcp-listen 0 1 #f "127.0.0.1"))
  (define-values (here port there other) (tcp-addresses listener #t))
  (tcp-close listener)
  port)

;; write-script : an executable file of lines for the shell.
(define (write-script file . lines)
  (display-lines-to-file (cons "#!/bin/sh" lines) file)
  (file-or-directory-permissions file #o755))

;; call-with-ssh-server : calls (use) while the command ssh, of this process and those it starts, knows
;; hosts named node-... that are this machine. Keys, settings and the server's log go to the folder.
(define (call-with-ssh-server folder use)
  (define (in-folder name) (path->string (build-path folder name)))
  (define port (free-port))
  (define path (getenv "PATH"))
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
  (putenv "PATH" (string-append (in-folder "bin") ":" path))
  (with-handlers ([exn:fail? void]) (make-directory "/run/sshd")) ; root's server asks for it
  (system* sshd "-f" (in-folder "server") "-E" (in-folder "log"))
  (dynamic-wind
   void use
   (lambda ()
     (putenv "PATH" path)
     (system* "/bin/kill" (string-trim (file->string (in-folder "pid")))))))

;; node-racket : a command for a file of hosts: racket as it is here, after lines for the shell. addon:
;; the folder of the user's links.
(define (node-racket folder name #:addon [addon (find-system-path 'addon-dir)]
                     #:last [last (format "exec ~a \"$@\"" (find-executable-path "racket"))] . lines)
  (define file (build-path folder name))
  (apply write-script file (append lines (list (format "export PLTADDONDIR='~a'" addon) last)))
  (path->string file))
