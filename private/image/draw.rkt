#lang racket/base
;; PNG and JPEG decoding by racket/draw. Loading it is slow, so only a lazy-require names this file.
(provide decode-picture)
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
