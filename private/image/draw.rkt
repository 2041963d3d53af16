#lang racket/base
;; What takes racket/draw: decoding PNG and JPEG, bitmaps, and writing. Loading it is slow, so only a
;; lazy-require names this file.
(provide decode-picture bytes->bitmap draw-label)
(require racket/class racket/draw)

;; decode-picture : the red, green and blue bytes, top row first, of a PNG or JPEG file's bytes
;; that must hold width x height pixels; #f when they do not.
(define (decode-picture bytes width height)
  (define bitmap
    (with-handlers ([exn:fail? (lambda (e) #f)])
      (read-bitmap (open-input-bytes bytes) 'unknown/alpha)))
  (and bitmap
       (send bitmap ok?)
       (= (send bitmap get-width) width)
       (= (send bitmap get-height) height)
       (let ([argb (make-bytes (* 4 width height))]
             [rgb (make-bytes (* 3 width height))])
         (send bitmap get-argb-pixels 0 0 width height argb)
         (for ([i (in-range (* width height))])
           (bytes-copy! rgb (* 3 i) argb (+ (* 4 i) 1) (+ (* 4 i) 4)))
         rgb)))

;; bytes->bitmap : an opaque bitmap% of red, green and blue bytes, top row first.
(define (bytes->bitmap width height rgb)
  (define argb (make-bytes (* 4 width height) 255))
  ;; three single bytes are copied faster than a range of them
  (for ([to (in-range 1 (* 4 width height) 4)] [from (in-range 0 (* 3 width height) 3)])
    (bytes-set! argb to (bytes-ref rgb from))
    (bytes-set! argb (+ to 1) (bytes-ref rgb (+ from 1)))
    (bytes-set! argb (+ to 2) (bytes-ref rgb (+ from 2))))
  (define bitmap (make-bitmap width height #f))
  (send bitmap set-argb-pixels 0 0 width height argb)
  bitmap)

;; draw-label : width x height grey bytes with the text in their middle, white on black.
(define (draw-label text width height)
  (define bitmap (make-bitmap width height #f))
  (define dc (new bitmap-dc% [bitmap bitmap]))
  (send dc set-background "black")
  (send dc clear)
  (send dc set-text-foreground "white")
  (send dc set-font (make-font #:size (quotient (* 3 height) 5) #:family 'swiss #:size-in-pixels? #t))
  (define-values (text-width text-height descent above) (send dc get-text-extent text))
  (send dc draw-text text (max 0 (/ (- width text-width) 2)) (/ (- height text-height) 2))
  (define argb (make-bytes (* 4 width height)))
  (send bitmap get-argb-pixels 0 0 width height argb)
  (define grey (make-bytes (* width height)))
  (for ([k (in-range (* width height))])
    (bytes-set! grey k (bytes-ref argb (+ 2 (* 4 k)))))
  grey)
