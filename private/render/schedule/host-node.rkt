#lang racket/base
;; The process on a host that ssh starts: a router of distributed places that listens on 127.0.0.1 at
;; the port it is told, and ends with its standard input.
(require racket/tcp racket/place/distributed)

(module+ main
  (define port (string->number (vector-ref (current-command-line-arguments) 0)))
  (define listener (tcp-listen port 4 #t "127.0.0.1"))
  (void (thread (lambda ()
                  (let loop () (unless (eof-object? (read-bytes 4096)) (loop)))
                  (exit 0))))
  (displayln "raytrace host ready")
  (flush-output)
  (start-spawned-node-router listener))
