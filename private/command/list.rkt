#lang racket/base
;; raco raytrace list: the package's scenes, each with the first sentence of its header.
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

;; The first sentence of the comment a file starts with.
(define (scene-header path)
  (define comment
    (call-with-input-file path
      (lambda (in)
        (for*/fold ([text ""] [ended? #f] #:result text)
                   ([line (in-lines in)] #:break ended?)
          (define words (regexp-match #rx"^;+ *(.*)$" line))
          (cond [words (values (string-append text (if (string=? text "") "" " ") (cadr words)) #f)]
                [else (values text (not (string=? text "")))])))))
  (car (regexp-match #px"^.*?[.](?= |$)|^.*$" comment)))
