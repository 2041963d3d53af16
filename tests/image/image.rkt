#lang racket/base
;; The struct Image: what it checks, how it prints, compares and shows itself.
(module+ test
  (require file/convertible racket/flonum rackunit
           "../../private/image/image.rkt" "support.rkt")

  (define (pixel image x y)
    (call-with-values (lambda () (Image-pixel image x y)) list))

  ;; layout: row 0 on top, three channels a pixel
  (define image (make-Image 2 3 (for/flvector ([i (in-range 18)]) (exact->inexact i))))
  (check-equal? (pixel image 0 0) '(0.0 1.0 2.0))
  (check-equal? (pixel image 1 0) '(3.0 4.0 5.0))
  (check-equal? (pixel image 0 2) '(12.0 13.0 14.0))
  (check-equal? (pixel image 1 2) '(15.0 16.0 17.0))
  (for ([place (in-list '((2 0) (0 3) (-1 0) (0 -1)))])
    (check-exn exn:fail:contract? (lambda () (pixel image (car place) (cadr place)))))

  ;; sizes are checked against both flvectors
  (check-false (Image-standard-error image))
  (check-equal? (Image-standard-error (make-Image 1 1 (flvector 1.0 2.0 3.0) (flvector 0.1 0.2 0.3)))
                (flvector 0.1 0.2 0.3))
  (for ([arguments (in-list (list (list 2 2 (make-flvector 11))
                                  (list 2 2 (make-flvector 13))
                                  (list 0 2 (make-flvector 0))
                                  (list 2 -1 (make-flvector 6))
                                  (list (expt 10 30) 1 (make-flvector 3))
                                  (list 1 1 (make-flvector 3) (make-flvector 2))
                                  (list 1.0 1 (make-flvector 3))
                                  (list 1 1 (vector 1.0 1.0 1.0))))])
    (check-exn exn:fail:contract? (lambda () (apply make-Image arguments))))

  ;; printing
  (for ([mode (in-list '("~a" "~s" "~v"))])
    (check-equal? (format mode (make-Image 640 360 (make-flvector (* 3 640 360))))
                  "#<Image 640x360>"))

  ;; equality by content, standard error included
  (define (grey value [error #f]) (make-Image 1 1 (make-flvector 3 value) error))
  (check-equal? (grey 0.5) (grey 0.5))
  (check-equal? (equal-hash-code (grey 0.5)) (equal-hash-code (grey 0.5)))
  (check-not-equal? (grey 0.5) (grey 0.25))
  (check-not-equal? (grey 0.5) (grey 0.5 (make-flvector 3 0.1)))
  (check-not-equal? (make-Image 1 2 (make-flvector 6)) (make-Image 2 1 (make-flvector 6)))

  ;; a picture where values are asked for one; width and height stand at bytes 16 and 20
  (define (png-size bytes)
    (list (integer-bytes->integer bytes #f #t 16 20) (integer-bytes->integer bytes #f #t 20 24)))
  (check-true (convertible? small-image))
  (check-equal? (png-size (convert small-image 'png-bytes)) '(2 2))
  (check-equal? (png-size (convert small-image 'png@2x-bytes)) '(4 4))
  (check-false (convert small-image 'pdf-bytes))
  (check-equal? (convert small-image 'text "none") "none")
  ;; at double size every pixel is a square of four equal ones
  (define-values (doubled)
    (let ([read-bitmap (dynamic-require 'racket/draw 'read-bitmap)]
          [argb (make-bytes 64)])
      (define bitmap (read-bitmap (open-input-bytes (convert small-image 'png@2x-bytes))))
      ((dynamic-require 'racket/class 'dynamic-send) bitmap 'get-argb-pixels 0 0 4 4 argb)
      argb))
  (define (argb-row . pixels) (apply bytes-append (for*/list ([p pixels] [_ 2]) p)))
  (define red (bytes 255 255 0 0))
  (define green (bytes 255 0 255 0))
  (define blue (bytes 255 0 0 255))
  (define white (bytes 255 255 255 255))
  (check-equal? doubled
                (bytes-append (argb-row red green) (argb-row red green)
                              (argb-row blue white) (argb-row blue white))))
