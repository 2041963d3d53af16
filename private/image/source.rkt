#lang racket/base
;; What the readers of picture files share: a file's bytes, the header words of the Netpbm family,
;; and errors that say on one line which file, where in it, and what was expected.
(provide picture-error error-reason read-picture-file
         word-start word-end magic-word positive-word finite-decimal check-sample-bytes show-bytes)

;; picture-error : raises exn:fail:user with the file's name and a formatted message on one line.
(define (picture-error path template . arguments)
  (define name (regexp-replace* #rx"[\r\n]" (if (path? path) (path->string path) path) "?"))
  (raise-user-error (string-append name ": " (apply format template arguments))))

;; error-reason : the operating system's words for a failure, or else the message's first line.
(define (error-reason failure)
  (define message (exn-message failure))
  (cond [(regexp-match #rx"system error: ([^;\n]*)" message) => cadr]
        [else (car (regexp-match #rx"^[^\n]*" message))]))

;; read-picture-file : all bytes, or the first few, of a file that starts with one of the given byte
;; strings; expected is what they stand for, for the error. Memory follows what is there.
(define (read-picture-file path starts expected #:only-start? [only-start? #f])
  (define (read-bytes-of in)
    (define start (let ([bytes (peek-bytes (apply max (map bytes-length starts)) 0 in)])
                    (if (eof-object? bytes) #"" bytes)))
    (unless (for/or ([s (in-list starts)])
              (and (>= (bytes-length start) (bytes-length s))
                   (equal? s (subbytes start 0 (bytes-length s)))))
      (picture-error path "byte 0: expected ~a, found ~a" expected (show-bytes start)))
    (if only-start? start (read-all in)))
  (unless (and (path-string? path) (file-exists? path))
    (picture-error (if (path-string? path) path (format "~s" path))
                   "expected a picture file, found ~a"
                   (if (and (path-string? path) (directory-exists? path)) "a folder" "no such file")))
  (with-handlers ([exn:fail:filesystem?
                   (lambda (e) (picture-error path "cannot be read (~a)" (error-reason e)))])
    (call-with-input-file path read-bytes-of)))

(define (read-all in)
  (define chunk (make-bytes 65536))
  (define all (open-output-bytes))
  (let loop ()
    (define count (read-bytes! chunk in))
    (unless (eof-object? count)
      (write-bytes chunk all 0 count)
      (loop)))
  (get-output-bytes all #t))

;; show-bytes : at most 20 bytes as a string literal, for messages.
(define (show-bytes bytes)
  (cond [(equal? bytes #"") "the end of the file"]
        [(> (bytes-length bytes) 20)
         (format "~s..." (bytes->string/latin-1 (subbytes bytes 0 20)))]
        [else (format "~s" (bytes->string/latin-1 bytes))]))

;; ----------------------------------------------------------------------------------------------
;; Header words are separated by white space; # starts a comment that ends with the line.

(define (white-space? byte)
  (or (eqv? byte 32) (<= 9 byte 13)))

;; word-start : the offset where the first word at or after offset at begins, or the file's end.
(define (word-start bytes at)
  (define end (bytes-length bytes))
  (let skip ([i at] [comment? #f])
    (cond [(= i end) end]
          [comment? (skip (+ i 1) (not (memv (bytes-ref bytes i) '(10 13))))]
          [(white-space? (bytes-ref bytes i)) (skip (+ i 1) #f)]
          [(eqv? (bytes-ref bytes i) 35) (skip (+ i 1) #t)]
          [else i])))

;; word-end : the offset after the word that begins at start.
(define (word-end bytes start)
  (define end (bytes-length bytes))
  (let extend ([i start])
    (if (or (= i end) (white-space? (bytes-ref bytes i)) (eqv? (bytes-ref bytes i) 35))
        i
        (extend (+ i 1)))))

;; magic-word : the two characters that say what a Netpbm file holds, a word of their own.
(define (magic-word path bytes)
  (define word (subbytes bytes 0 (word-end bytes 0)))
  (unless (= (bytes-length word) 2)
    (picture-error path "byte 2: expected white space after ~a, found ~a"
                   (subbytes word 0 2) (show-bytes (subbytes word 2))))
  word)

;; positive-word : the next word as a positive integer of at most 18 digits, and the offset after it.
(define (positive-word path bytes start what)
  (define begin (word-start bytes start))
  (define stop (word-end bytes begin))
  (define word (subbytes bytes begin stop))
  (define number
    (and (<= 1 (bytes-length word) 18)
         (regexp-match? #px#"^[0-9]+$" word)
         (string->number (bytes->string/latin-1 word))))
  (unless (and number (positive? number))
    (picture-error path "byte ~a: expected a positive ~a, found ~a" begin what (show-bytes word)))
  (values number stop))

;; finite-decimal : the flonum that a word of at most 32 bytes writes as a decimal number, perhaps
;; with an exponent, or #f if it is none or beyond the range.
(define (finite-decimal word)
  (define number
    (and (<= (bytes-length word) 32)
         (regexp-match? #px#"^[+-]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][+-]?[0-9]{1,3})?$" word)
         (real->double-flonum (string->number (bytes->string/latin-1 word) 10))))
  (and number (< (abs number) +inf.0) number))

;; check-sample-bytes : one white space byte ends the header at offset stop, and width x height
;; pixels of the given size follow; the offset of the first.
(define (check-sample-bytes path bytes stop width height pixel-size)
  (define end (bytes-length bytes))
  (unless (and (< stop end) (white-space? (bytes-ref bytes stop)))
    (picture-error path "byte ~a: expected one white space byte and the samples, found ~a"
                   stop (show-bytes (subbytes bytes stop (min end (+ stop 1))))))
  (define first-sample (+ stop 1))
  (define needed (* width height pixel-size))
  (when (< (- end first-sample) needed)
    (picture-error path "byte ~a: expected ~a bytes of samples for ~ax~a pixels, found ~a"
                   first-sample needed width height (- end first-sample)))
  first-sample)
