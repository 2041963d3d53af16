#lang racket/base
;; What is on a window's canvas: the picture as large as fits, and the keys over it.
(require racket/class (only-in racket/draw make-font) "refine.rkt" "look.rkt"
         "../image/edit.rkt" "../image/bridge.rkt")

(provide visible shown-bitmap place-picture draw-screen focus-text free-name)

;; visible : the picture as it is shown: what is no light in false colours, all at an exposure of so
;; many stops.
(define (visible seen integrator stops)
  (define image
    (if (and (memq integrator '(cost error)) (positive? (shown-samples seen)))
        (Image-false-color (shown-image seen))
        (shown-image seen)))
  (if (zero? stops) image (Image-exposed image stops)))

(define (shown-bitmap seen integrator stops) (Image->bitmap (visible seen integrator stops)))

;; place-picture : where a picture of that size is in a canvas, as large as it fits there, in its
;; middle: its left and upper edge, and how many pixels of the canvas one of its own takes.
(define (place-picture width height canvas-width canvas-height)
  (define scale (min (/ canvas-width width 1.0) (/ canvas-height height 1.0)))
  (values (/ (- canvas-width (* scale width)) 2.0)
          (/ (- canvas-height (* scale height)) 2.0)
          scale))

;; draw-screen : draws a bitmap, or #f, that stands for a picture of that size, and the keys if keys?.
(define (draw-screen dc canvas-width canvas-height bitmap width height keys?)
  (send dc set-background "black")
  (send dc clear)
  (when bitmap
    (define-values (left top scale) (place-picture width height canvas-width canvas-height))
    (define across (/ (* scale width) (send bitmap get-width)))
    (define down (/ (* scale height) (send bitmap get-height)))
    (send dc set-smoothing 'smoothed)
    (define-values (old-across old-down) (send dc get-scale))
    (define-values (old-left old-top) (send dc get-origin))
    (send dc set-origin left top)
    (send dc set-scale across down)
    (send dc draw-bitmap bitmap 0 0)
    (send dc set-scale old-across old-down)
    (send dc set-origin old-left old-top))
  (when keys? (draw-keys dc)))

(define MARGIN 12)
(define KEYS-FONT (make-font #:size 13 #:size-in-pixels? #t #:family 'swiss))

(define (draw-keys dc)
  (send dc set-font KEYS-FONT)
  (define-values (key-width text-width line)
    (for/fold ([key-width 0] [text-width 0] [line 0]) ([pair (in-list KEYS)])
      (define-values (w1 h1 descent1 above1) (send dc get-text-extent (car pair)))
      (define-values (w2 h2 descent2 above2) (send dc get-text-extent (cadr pair)))
      (values (max key-width w1) (max text-width w2) (max line h1 h2))))
  (define step (+ line 3))
  (send dc set-alpha 0.75)
  (send dc set-pen "black" 1 'transparent)
  (send dc set-brush "black" 'solid)
  (send dc draw-rectangle MARGIN MARGIN (+ key-width text-width (* 3 MARGIN))
        (+ (* step (length KEYS)) (* 2 MARGIN)))
  (send dc set-alpha 1.0)
  (for ([pair (in-list KEYS)] [k (in-naturals)])
    (define y (+ (* 2 MARGIN) (* k step)))
    (send dc set-text-foreground "gold")
    (send dc draw-text (car pair) (* 2 MARGIN) y)
    (send dc set-text-foreground "white")
    (send dc draw-text (cadr pair) (+ key-width (* 3 MARGIN)) y)))

;; focus-text : where a camera is focused, in words.
(define (focus-text distance lens-radius)
  (string-append (format "in focus: what is ~a away" (real->decimal-string distance 3))
                 (if (zero? lens-radius) " (the lens has radius 0, all is sharp)" "")))

;; free-name : the first of name-1.png, name-2.png ... that is no file yet.
(define (free-name name)
  (let try ([k 1])
    (define file (format "~a-~a.png" name k))
    (if (or (file-exists? file) (directory-exists? file) (link-exists? file)) (try (+ k 1)) file)))
