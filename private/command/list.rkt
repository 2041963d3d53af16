#lang racket/base
;; raco raytrace list: the package's scenes, each with the first line of its header.
(require "flags.rkt" "scenes.rkt")

(provide list-scenes)

(define (list-scenes program words)
  (parse-words program words '((usage-help "Tells the scenes of this package.")) '()
               (lambda (no-flags) (void)))
  (define rows
    (for/list ([path (in-list (package-scenes))]) (cons (scene-name path) (scene-header path))))
  (define widest (apply max 0 (map (lambda (row) (string-length (car row))) rows)))
  (for ([row (in-list rows)])
    (printf "~a~a~a\n" (car row) (make-string (- (+ widest 2) (string-length (car row))) #\space)
            (cdr row))))

;; The file's first comment line without its semicolons.
(define (scene-header path)
  (call-with-input-file path
    (lambda (in)
      (or (for/first ([line (in-lines in)] #:when (regexp-match? #rx"^;+ *[^; ]" line))
            (regexp-replace #rx"^;+ *" line ""))
          ""))))
