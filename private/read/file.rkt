#lang racket/base
;; What the readers share about files: their bytes, the one-line errors, the progress report.

(provide load-file
         path-label
         fail-at-line
         fail-at-byte
         quote-bytes
         make-progress-meter)

(require racket/fixnum)

;; The bytes of a regular file; a user error for anything else.
(define (load-file path)
  (define (fail problem)
    (raise-user-error (format "~a: ~a" (path-label path) problem)))
  (when (directory-exists? path)
    (fail "expected a file, found a directory"))
  (unless (file-exists? path)
    (fail "no such file"))
  (with-handlers ([exn:fail:filesystem? (λ (_) (fail "the file cannot be read"))])
    (unless (regular-file? path)
      (fail "expected a regular file"))
    (define size (file-size path))
    (define bytes (make-bytes size))
    (define read (call-with-input-file* path (λ (in) (read-bytes! bytes in))))
    (cond [(eof-object? read) #""]
          [(= read size) bytes]
          [else (subbytes bytes 0 read)])))

;; A pipe or a device could keep the reader waiting for ever.
(define (regular-file? path)
  (define mode (hash-ref (file-or-directory-stat path) 'mode))
  (= #o100000 (bitwise-and #o170000 mode)))

;; The path as shown in messages, on one line.
(define (path-label path)
  (one-line (if (path? path) (path->string path) path)))

;; Raise a user error that names the file and the line, or the byte, and what was expected there.
(define (fail-at-line path line . message)
  (raise-user-error (format "~a:~a: ~a" (path-label path) line (apply format message))))

(define (fail-at-byte path offset . message)
  (raise-user-error (format "~a: byte ~a: ~a" (path-label path) offset (apply format message))))

;; Bytes [start, end) for a message: in quotes, printable, cut at 40.
(define (quote-bytes bytes start end)
  (define stop (min end (+ start 40)))
  (format "\"~a~a\""
          (one-line (bytes->string/utf-8 (subbytes bytes start stop) #\?))
          (if (< stop end) "..." "")))

(define (one-line text)
  (list->string
   (for/list ([c (in-string text)])
     (if (or (char-graphic? c) (char=? c #\space)) c #\?))))

;; A procedure to call with a position from 0 to total: it passes on the fraction, about a hundred
;; times in all, and at the end. progress is a procedure of a fraction in [0, 1], or #f.
(define (make-progress-meter progress total)
  (cond
    [progress
     (define step (fxmax 1 (fxquotient total 100)))
     (define next 0)
     (λ (position)
       (when (or (fx>= position next) (fx= position total))
         (set! next (fx+ position step))
         (progress (if (fx= total 0) 1.0 (exact->inexact (/ position total))))))]
    [else void]))
