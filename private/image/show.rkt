#lang racket/base
;; A picture where one works: in a window that shows pictures among text, else as blocks of colour.
(provide show)
(require "image.rkt" "terminal.rkt")

;; show : prints the image to the port: itself where the port takes more than text, as DrRacket's
;; does; else in half blocks of 24-bit colour, at most #:columns wide, by default as wide as the
;; terminal says it is (COLUMNS), else 80.
(define (show image [out (current-output-port)] #:columns [columns (terminal-columns)])
  (unless (Image? image) (raise-argument-error 'show "an Image" image))
  (unless (output-port? out) (raise-argument-error 'show "an output port" out))
  (unless (exact-positive-integer? columns)
    (raise-argument-error 'show "a positive whole number of columns" columns))
  (cond
    [(port-writes-special? out)
     (write-special image out)
     (newline out)]
    [else (Image-print-blocks image out #:columns columns)])
  (void))

(define (terminal-columns)
  (define columns (string->number (or (getenv "COLUMNS") "")))
  (if (exact-positive-integer? columns) columns 80))
