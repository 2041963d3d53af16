#lang racket/base
;; A picture in a terminal that shows 24-bit colours: every character is two pixels, an upper half block
;; in one colour on a ground of another.
(provide Image-print-blocks)
(require racket/flonum "image.rkt" "tone.rkt")

;; Image-print-blocks : prints the image, sRGB-encoded, at most so many characters wide, pixels averaged
;; in linear light where it has to be made smaller. Returns the number of lines printed. Raises
;; exn:fail:contract where columns is no positive whole number.
(define (Image-print-blocks image [out (current-output-port)] #:columns [columns 80])
  (unless (Image? image) (raise-argument-error 'Image-print-blocks "Image?" image))
  (unless (exact-positive-integer? columns)
    (raise-argument-error 'Image-print-blocks "exact-positive-integer?" columns))
  (define width (Image-width image))
  (define height (Image-height image))
  (define across (min columns width))
  ;; characters are twice as high as they are wide
  (define down (max 1 (round (/ (* across height) width))))
  (define lines (quotient (+ down 1) 2))
  (define (cell x y)
    (cell-color (Image-pixels image) width
                (quotient (* x width) across) (quotient (* (+ x 1) width) across)
                (quotient (* y height) down) (quotient (* (+ y 1) height) down)))
  (for ([line (in-range lines)])
    (for/fold ([above #f] [below #f] #:result (void)) ([x (in-range across)])
      (define top (cell x (* 2 line)))
      (define bottom (and (< (+ 1 (* 2 line)) down) (cell x (+ 1 (* 2 line)))))
      (unless (equal? top above) (write-color 38 top out))
      (unless (equal? bottom below) (write-color 48 bottom out)) ; none below an odd last row
      (write-string "▀" out)
      (values top bottom))
    (write-string "\e[0m\n" out))
  lines)

;; The sRGB bytes of the mean over a rectangle of pixels, which has one at least.
(define (cell-color pixels width x0 x1 y0 y1)
  (define right (max x1 (+ x0 1)))
  (define bottom (max y1 (+ y0 1)))
  (define count (->fl (* (- right x0) (- bottom y0))))
  (for/list ([channel (in-range 3)])
    (sRGB-byte
     (fl/ (for*/fold ([sum 0.0]) ([y (in-range y0 bottom)] [x (in-range x0 right)])
            (fl+ sum (flvector-ref pixels (+ channel (* 3 (+ x (* y width)))))))
          count))))

(define (write-color ground color out)
  (fprintf out "\e[~a;2;~a;~a;~am" ground (car color) (cadr color) (caddr color)))
