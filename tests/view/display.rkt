#lang racket/base
;; A virtual display for tests: the X server Xvfb, keys and mouse by xdotool, and the screen's pixels,
;; which the server keeps in a file.
(provide call-with-display (struct-out display) type-keys mouse find-window screen-part)
(require racket/file racket/flonum racket/port racket/string "../../private/image/image.rkt"
         "../../private/image/tone.rkt")

;; name: what DISPLAY is set to. folder: where the server keeps the screen.
(struct display (name folder xdotool))

(define (program name)
  (or (find-executable-path name)
      (error 'display "no ~a: install the packages xvfb and xdotool" name)))

;; Calls use with a display of that size, on a number that is free, and ends it afterwards.
(define (call-with-display width height use)
  (define server (program "Xvfb"))
  (define xdotool (program "xdotool"))
  (define folder (make-temporary-file "display~a" 'directory))
  (define-values (process out in err)
    (subprocess #f #f (open-output-nowhere-file) server "-displayfd" "1" "-nolisten" "tcp"
                "-screen" "0" (format "~ax~ax24" width height) "-fbdir" folder))
  (close-output-port in)
  (dynamic-wind
   void
   (lambda ()
     (define number (sync/timeout 30 (read-line-evt out)))
     (unless (string? number) (error 'display "Xvfb did not start"))
     (use (display (string-append ":" number) folder xdotool)))
   (lambda ()
     (subprocess-kill process #t)
     (subprocess-wait process)
     (close-input-port out)
     (delete-directory/files folder))))

(define (open-output-nowhere-file)
  (open-output-file (if (eq? 'windows (system-type)) "nul" "/dev/null") #:exists 'append))

;; What xdotool prints with these words, a list of lines.
(define (xdotool on . words)
  (define variables (environment-variables-copy (current-environment-variables)))
  (environment-variables-set! variables #"DISPLAY" (string->bytes/utf-8 (display-name on)))
  (define-values (process out in err)
    (parameterize ([current-environment-variables variables])
      (apply subprocess #f #f (open-output-nowhere-file) (display-xdotool on)
             (map (lambda (word) (format "~a" word)) words))))
  (close-output-port in)
  (define lines (port->lines out))
  (subprocess-wait process)
  (close-input-port out)
  lines)

;; The number of the window that is shown with a title, #f where there is none.
(define (find-window on title)
  (define found (xdotool on "search" "--onlyvisible" "--name" title))
  (and (pair? found) (car found)))

;; Types keys by their X names, in a window that has been given the focus.
(define (type-keys on window . keys)
  (xdotool on "windowfocus" "--sync" window)
  (for ([key (in-list keys)]) (xdotool on "key" key)))

;; mouse: words of xdotool, as mousemove, mousedown; the pointer's places are those of the window.
(define (mouse on window . steps)
  (for ([step (in-list steps)])
    (if (number? (car step))
        (xdotool on "mousemove" "--window" window (car step) (cadr step))
        (apply xdotool on step))))

;; screen-part : the window's upper left part of width x height pixels, as an Image. The file is an X
;; window dump: a header of 32-bit numbers, colours of 12 bytes each, then rows of blue, green, red
;; and a byte.
(define (screen-part on window width height)
  (define geometry
    (for/hash ([line (in-list (xdotool on "getwindowgeometry" "--shell" window))])
      (apply values (string-split line "="))))
  (define-values (left top)
    (values (string->number (hash-ref geometry "X")) (string->number (hash-ref geometry "Y"))))
  (define bytes (file->bytes (build-path (display-folder on) "Xvfb_screen0")))
  (define (header k) (integer-bytes->integer bytes #f #t (* 4 k) (* 4 (+ k 1))))
  (define start (+ (header 0) (* 12 (header 19))))
  (define row-bytes (header 12))
  (define linear (sRGB-decoding-table 255))
  (define pixels (make-flvector (* 3 width height)))
  (for* ([y (in-range height)] [x (in-range width)] [channel (in-range 3)])
    (define from (+ start (* row-bytes (+ y top)) (* 4 (+ x left)) (- 2 channel)))
    (flvector-set! pixels (+ channel (* 3 (+ x (* y width))))
                   (flvector-ref linear (bytes-ref bytes from))))
  (make-Image width height pixels))
