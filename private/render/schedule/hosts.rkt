#lang racket/base
;; Workers on other machines, over ssh, by racket/place/distributed. Its own launcher listens on every
;; interface; so host-node.rkt, which ssh starts there, gives its router a listener on 127.0.0.1, and
;; ssh forwards that port to one on 127.0.0.1 here. A worker is a process of its own with a connection
;; of its own. Host and here must have the same library, Racket and scene, which is checked first.
(require racket/class racket/fasl racket/list racket/port racket/flonum racket/place/distributed
         racket/tcp "../job.rkt" "crew.rkt" "desk.rkt" "host-check.rkt")

(provide run-hosts read-hosts)

;; workers: how many there. racket: the command there.
(struct host (name port workers racket))

;; read-hosts : the hosts of a file with lines `[user@]name[:port] [workers] [racket]`, where # starts a
;; comment; one worker and `racket` by default. Raises exn:fail:user on other lines.
(define (read-hosts file)
  (unless (file-exists? file)
    (raise-user-error (format "~a: expected a file with a host on each line, found no such file" file)))
  (define hosts
    (for*/list ([(line number) (in-indexed-lines file)]
                [words (in-value (string-words (car (regexp-match #rx"^[^#]*" line))))]
                #:unless (null? words))
      (define name (regexp-match #px"^((?:[\\w.-]+@)?\\w[\\w.-]*|\\[[0-9a-fA-F:]+\\])(?::([0-9]{1,5}))?$"
                                 (car words)))
      (define count (if (pair? (cdr words)) (string->number (cadr words)) 1))
      (unless (and name (exact-integer? count) (<= 1 count 1024) (<= (length words) 3))
        (raise-user-error
         (format "~a:~a: expected [user@]host[:port], workers from 1 to 1024, and racket's path, found ~a"
                 file number line)))
      (host (cadr name) (caddr name) count (if (= (length words) 3) (caddr words) "racket"))))
  (when (null? hosts)
    (raise-user-error (format "~a: expected a host on each line, found none" file)))
  hosts)

(define (in-indexed-lines file)
  (define lines (call-with-input-file file (lambda (in) (for/list ([line (in-lines in 'any)]) line))))
  (in-parallel lines (in-naturals 1)))

(define (string-words text) (filter (lambda (w) (positive? (string-length w)))
                                    (regexp-split #px"\\s+" text)))

;; run-hosts : as run-places, by the workers on the hosts of a file; `workers` does not count.
(define ((run-hosts file) job target workers next-pass report!)
  (define ssh (or (find-executable-path "ssh") (raise-user-error "--schedule hosts: expected ssh, found none")))
  (define order (s-exp->fasl (make-host-order job)))
  (define hosts (read-hosts file))
  (define refused (box 0))
  (define all (apply + (map host-workers hosts)))
  (define told (make-hash))
  (define (tell host text)
    (unless (hash-ref told (cons host text) #f)
      (hash-set! told (cons host text) #t)
      (eprintf "raytrace: ~a: ~a\n" (host-name host) text)))
  (run-crew job target
            (for*/list ([host (in-list hosts)] [k (in-range (host-workers host))])
              (make-host-worker ssh host order (make-desk job target make-flvector)
                                (lambda (text) (tell host text)) refused all))
            next-pass report!))

;; Between two tries to reach a host, and the longest that one may take to be ready.
(define RETRY-SECONDS 3.0)
(define READY-SECONDS 300.0)

;; A connected worker: the ssh process, and the channels to and from the worker there.
(struct link (process put! answers))

(define (make-host-worker ssh host order desk tell refused all)
  (define state #f)     ; a link, 'refused or #f
  (define custodian (make-custodian))
  (define starter #f)
  (define (drop!)
    (when (link? state) (close-link! state))
    (set! state #f))
  (define (begin-start!)
    (unless (and starter (not (thread-dead? starter)))
      (set! starter
            (parameterize ([current-custodian custodian])
              (thread
               (lambda ()
                 (let try ()
                   (define found (connect ssh host order))
                   (cond
                     [(link? found) (set! state found)]
                     [(pair? found)
                      (tell (cdr found))
                      (set! state 'refused)
                      (set-box! refused (+ 1 (unbox refused)))]
                     [else
                      (tell (format "~a; it is tried again every ~a s" found RETRY-SECONDS))
                      (sleep RETRY-SECONDS)
                      (try)]))))))))
  (define (start! finished?)
    (let wait ()
      (cond
        [(link? state) #t]
        [(eq? state 'refused)
         (when (= (unbox refused) all) (raise-user-error "no host can render this"))
         #f]
        [(finished?) #f]
        [else (begin-start!) (sleep 0.02) (wait)])))
  (define (render! tile seconds)
    (define now state)
    (define answer
      (with-handlers ([exn:fail? (lambda (e) 'dead)])
        ((link-put! now) (list tile (desk->bytes desk #t)))
        (sync/timeout seconds (link-answers now)
                      (handle-evt (link-process now) (lambda (e) 'dead)))))
    (cond
      [(and (pair? answer) (eq? (car answer) 'rendered) (eqv? (cadr answer) tile))
       (bytes->desk! desk (cadddr answer) #f)
       (caddr answer)]
      [else
       (tell (if answer "a worker there is lost" "a worker there stalls"))
       (drop!)
       (if answer 'dead 'stalled)]))
  (define (stop!)
    (drop!)
    (custodian-shutdown-all custodian))
  (crew-worker desk start! render! stop!))

(define (close-link! link)
  (define process (link-process link))
  (subprocess-kill process #t))

;; A port on 127.0.0.1 that is free now.
(define (free-port)
  (define listener (tcp-listen 0 1 #f "127.0.0.1"))
  (define-values (here port there other) (tcp-addresses listener #t))
  (tcp-close listener)
  port)

;; A link to a worker that is ready, a pair with why it may not render this, or why it is not reached.
(define (connect ssh host order)
  (define here (free-port))
  (define there (+ 20000 (random 12000)))
  (define-values (process out in err)
    (parameterize ([current-subprocess-custodian-mode 'kill])
      (apply subprocess #f #f #f ssh
             (append
              (list "-T" "-o" "BatchMode=yes" "-o" "ExitOnForwardFailure=yes" "-o" "ConnectTimeout=10"
                    "-o" "ServerAliveInterval=15" "-o" "ServerAliveCountMax=4"
                    "-L" (format "127.0.0.1:~a:127.0.0.1:~a" here there))
              (if (host-port host) (list "-p" (host-port host)) '())
              (list (host-name host) (host-racket host) "-l-"
                    "raytrace/private/render/schedule/host-node" (number->string there))))))
  (define said (make-channel))
  (define last-line #f)
  (thread (lambda () (for ([line (in-lines err)]) (set! last-line line))))
  (thread (lambda ()
            (for ([line (in-lines out)]) (when (equal? line "raytrace host ready") (channel-put said #t)))))
  (define (lost)
    (subprocess-kill process #t)
    (sync/timeout 0.2 never-evt)
    (format "no worker there (~a)" (or last-line "no answer")))
  (cond
    [(not (eq? #t (sync/timeout READY-SECONDS said process))) (lost)]
    [else
     (define answers (make-channel))
     (define put! #f)
     ;; what the library prints about connections is of no use here
     (parameterize ([current-output-port (open-output-nowhere)])
       (thread
        (lambda ()
          (with-handlers ([void (lambda (e) (channel-put answers 'dead))])
            (define node (new remote-node% [host-name "127.0.0.1"] [listen-port here]))
            (define worker
              (send node launch-place
                    (list 'dynamic-place '(lib "raytrace/private/render/schedule/host-worker.rkt")
                          'main)))
            (set! put! (lambda (message) (*channel-put worker message)))
            (put! order)
            (let loop ()
              (define answer (*channel-get worker))
              (channel-put answers (if (eof-object? answer) 'dead answer))
              (unless (eof-object? answer) (loop)))))))
     (define answer (sync/timeout READY-SECONDS answers (handle-evt process (lambda (e) 'dead))))
     (cond
       [(not (pair? answer)) (lost)]
       [(eq? (car answer) 'ready) (link process put! answers)]
       [else
        (subprocess-kill process #t)
        answer])]))
