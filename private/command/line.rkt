#lang racket/base
;; Text squeezed to one line, for messages.
(provide one-line)

(define LONGEST-LINE 400)

;; one-line : the text with every run of white space and control characters made one space, cut
;; where it is too long to be read.
(define (one-line text)
  (define line (regexp-replaces text '([#px"[\\s[:cntrl:]]+" " "] [#px"^ | $" ""])))
  (if (> (string-length line) LONGEST-LINE)
      (string-append (substring line 0 (- LONGEST-LINE 3)) "...")
      line))
