#lang racket/base
;; A picture in a terminal that shows 24-bit colours: every character is two pixels, an upper half block
;; in one colour on a ground of another.
(provide Image-print-blocks Image-shrink)
(require racket/flonum "image.rkt" "tone.rkt")

;; Image-print-blocks : prints the image, sRGB-encoded, at most so many characters wide, pixels averaged
;; in linear light where it has to be made smaller. Returns the number of lines printed. Raises
;; exn:fail:contract where columns is no positive whole number.
(define (Image-print-blocks image [out (current-output-port)] #:columns [columns 80])
  (unless (Image? image) (raise-argument-error 'Image-print-blocks "Image?" image))
  (unless (exact-positive-integer? columns)
    (raise-argument-error 'Image-print-blocks "exact-positive-integer?" columns))
  (define small (Image-shrink image columns))
  (define width (Image-width small))
  (define height (Image-height small))
  (define lines (quotient (+ height 1) 2))
  (define (color x y)
    (define-values (red green blue) (Image-pixel small x y))
    (list (sRGB-byte red) (sRGB-byte green) (sRGB-byte blue)))
  (for ([line (in-range lines)])
    (for/fold ([above #f] [below #f] #:result (void)) ([x (in-range width)])
      (define top (color x (* 2 line)))
      (define bottom (and (< (+ 1 (* 2 line)) height) (color x (+ 1 (* 2 line)))))
      (unless (equal? top above) (write-color 38 top out))
      (unless (equal? bottom below) (write-color 48 bottom out)) ; none below an odd last row
      (write-string "▀" out)
      (values top bottom))
    (write-string "\e[0m\n" out))
  lines)

(define (write-color ground color out)
  (fprintf out "\e[~a;2;~a;~a;~am" ground (car color) (cadr color) (caddr color)))

;; Image-shrink : the image at most so many pixels wide, its shape kept, by the means of rectangles.
;; Pixels that are no number are left out; where a rectangle has no others it is black, or what the
;; image `under` shows there.
(define (Image-shrink image columns #:under [under #f])
  (define width (Image-width image))
  (define height (Image-height image))
  (define pixels (Image-pixels image))
  (define-values (across down) (shrunk-size width height columns))
  (make-Image
   across down
   (for*/flvector #:length (* 3 across down)
                  ([y (in-range down)] [x (in-range across)] [channel (in-range 3)])
     (define mean
       (mean-in pixels width channel
                (quotient (* x width) across) (quotient (* (+ x 1) width) across)
                (quotient (* y height) down) (quotient (* (+ y 1) height) down)))
     (cond
       [mean mean]
       [under
        (define from-x (quotient (* x (Image-width under)) across))
        (define from-y (quotient (* y (Image-height under)) down))
        (flvector-ref (Image-pixels under)
                      (+ channel (* 3 (+ from-x (* from-y (Image-width under))))))]
       [else 0.0]))))

(define (shrunk-size width height columns)
  (define across (min columns width))
  (values across (max 1 (round (/ (* across height) width)))))

;; The mean over a rectangle, of one pixel at least, of what is a number; #f where there is none.
(define (mean-in pixels width channel x0 x1 y0 y1)
  (define-values (sum count)
    (for*/fold ([sum 0.0] [count 0.0])
               ([y (in-range y0 (max y1 (+ y0 1)))] [x (in-range x0 (max x1 (+ x0 1)))])
      (define value (flvector-ref pixels (+ channel (* 3 (+ x (* y width))))))
      (if (fl= value value)
          (values (fl+ sum value) (fl+ count 1.0))
          (values sum count))))
  (and (fl> count 0.0) (fl/ sum count)))
