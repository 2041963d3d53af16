#lang racket/base
;; The README's program runs as it stands, and its commands name files that are there.
(module+ test
  (require compiler/find-exe racket/file racket/runtime-path racket/system rackunit
           "support.rkt" "../../private/image/image.rkt" "../../private/image/write.rkt")

  (define-runtime-path package-folder "../..")
  (define readme (file->string (build-path package-folder "README.md")))

  ;; the texts between ```language and ```
  (define (blocks language)
    (map cadr (regexp-match* (pregexp (format "(?m:^```~a\n((?:(?!```).*\n)*)```$)" language)) readme
                             #:match-select values)))

  (define programs (blocks "racket"))
  (check-equal? (length programs) 1)
  (call-with-folder
   (lambda (folder)
     (call-with-output-file (build-path folder "program.rkt")
       (lambda (out) (write-string (car programs) out)))
     (define errors (open-output-string))
     (check-true
      (parameterize ([current-directory folder] [current-error-port errors])
        (system* (find-exe) "program.rkt"))
      (get-output-string errors))
     (define image (Image-read (build-path folder "ball.png")))
     (check-equal? (list (Image-width image) (Image-height image)) '(320 180))))

  (define commands (blocks "sh"))
  (check-equal? (length commands) 2)
  (for* ([command (in-list commands)]
         [file (in-list (regexp-match* #px"(?:scenes|tests)/\\S+" command))])
    (check-true (file-exists? (build-path package-folder file)) file))
  (for ([file (in-list (regexp-match* #px"[(`](scenes/[^)`]+)[)`]" readme #:match-select cadr))])
    (check-true (file-exists? (build-path package-folder file)) file)))
