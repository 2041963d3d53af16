#lang racket/base
;; Pictures in a terminal: the text to the letter, pictures made smaller, odd heights.
(module+ test
  (require racket/flonum racket/string rackunit
           "../../private/image/image.rkt" "../../private/image/terminal.rkt")

  (define (gray width height . values)
    (make-Image width height
                (for*/flvector ([value (in-list values)] [channel (in-range 3)]) (exact->inexact value))))
  (define (blocks image columns)
    (define out (open-output-string))
    (define lines (Image-print-blocks image out #:columns columns))
    (define text (get-output-string out))
    (check-equal? lines (length (string-split text "\n")))
    text)

  ;; red above blue
  (check-equal? (blocks (make-Image 1 2 (flvector 1.0 0.0 0.0 0.0 0.0 1.0)) 80)
                "\e[38;2;255;0;0m\e[48;2;0;0;255m▀\e[0m\n")
  ;; a colour that stays is not said again; beyond white is white, below black is black
  (check-equal? (blocks (gray 2 2 2 2 -1 -1) 80)
                "\e[38;2;255;255;255m\e[48;2;0;0;0m▀▀\e[0m\n")
  ;; an odd row has the terminal's own ground below
  (check-equal? (blocks (gray 1 1 0) 80) "\e[38;2;0;0;0m▀\e[0m\n")
  (check-equal? (blocks (gray 1 3 1 1 0) 80)
                "\e[38;2;255;255;255m\e[48;2;255;255;255m▀\e[0m\n\e[38;2;0;0;0m▀\e[0m\n")
  ;; half the light in a 2x2 square is sRGB 188
  (check-equal? (blocks (gray 2 2 1 0 0 1) 1) "\e[38;2;188;188;188m▀\e[0m\n")
  (check-equal? (blocks (gray 2 4 1 0 0 1 0 0 0 0) 1) "\e[38;2;188;188;188m\e[48;2;0;0;0m▀\e[0m\n")
  ;; as wide as asked for, half as many lines
  (define large (blocks (apply gray 64 36 (for/list ([k (in-range (* 64 36))]) (/ k 2304))) 32))
  (check-equal? (length (string-split large "\n")) 9)
  (check-equal? (length (regexp-match* #rx"▀" large)) (* 32 9))
  (check-exn exn:fail:contract? (lambda () (Image-print-blocks (gray 1 1 0) #:columns 0)))
  (check-exn exn:fail:contract? (lambda () (Image-print-blocks 1))))
