#lang racket/base
;; Meshes given as bytes, read through a temporary file; checks of what is read and of errors.

(provide read-bytes-as
         call-with-folder
         check-one-line-error
         triangle-list
         position-list)

(require racket/file
         racket/fixnum
         racket/flonum
         rackunit
         "../../private/read/mesh.rkt")

;; Calls proc with a new folder that holds the files of a list of (cons name bytes), then deletes it.
(define (call-with-folder files proc)
  (define folder (make-temporary-file "mesh-test-~a" 'directory))
  (dynamic-wind
   void
   (λ ()
     (for ([file (in-list files)])
       (call-with-output-file (build-path folder (car file))
         (λ (out) (write-bytes (cdr file) out))))
     (proc folder))
   (λ () (delete-directory/files folder))))

;; The mesh-data of bytes (or a string) as a file with this extension; others stand beside it.
(define (read-bytes-as extension content #:beside [others '()] #:progress [progress #f])
  (define bytes (if (string? content) (string->bytes/utf-8 content) content))
  (define name (string-append "mesh" extension))
  (call-with-folder (cons (cons name bytes) others)
                    (λ (folder) (read-mesh (build-path folder name) #:progress progress))))

;; Reading must raise a user error of one line that contains place (":3: ", "byte 84: ") right after
;; the file's name, and expected.
(define-check (check-one-line-error extension content place expected)
  (define message
    (with-handlers ([exn:fail:user? exn-message])
      (read-bytes-as extension content)
      #f))
  (with-check-info (['message message])
    (unless message
      (fail-check "no user error"))
    (unless (regexp-match? (regexp-quote (string-append "/mesh" extension ":" place)) message)
      (fail-check "another place"))
    (unless (regexp-match? (regexp-quote expected) message)
      (fail-check "another text"))
    (when (regexp-match? #rx"[\r\n]" message)
      (fail-check "more than one line"))))

;; The triangles as lists of three vertex indices; the positions as lists of three flonums.
(define (triangle-list mesh)
  (define v (mesh-data-triangles mesh))
  (for/list ([i (in-range 0 (fxvector-length v) 3)])
    (for/list ([j (in-range 3)]) (fxvector-ref v (+ i j)))))

(define (position-list mesh)
  (define v (mesh-data-positions mesh))
  (for/list ([i (in-range 0 (flvector-length v) 3)])
    (for/list ([j (in-range 3)]) (flvector-ref v (+ i j)))))
