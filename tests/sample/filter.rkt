#lang racket/base
;; Pixel filters: their tables invert the integral of their density, and pictures keep their mean.

(module+ test
  (require racket/flonum racket/math rackunit "../../main.rkt" "../../private/sample/filter.rkt")

  ;; Simpson's rule over the density
  (define (integral name low high)
    (define n 4000)
    (define h (/ (- high low) n))
    (* (/ h 3)
       (for/sum ([k (+ n 1)])
         (* (cond [(memv k (list 0 n)) 1] [(odd? k) 4] [else 2])
            (filter-density name (+ low (* k h)))))))

  (for ([name '(tent gaussian blackman-harris)])
    (define table (Filter-table name))
    (define cells (- (flvector-length table) 1))
    (define whole (integral name -2.0 2.0))
    (test-case (format "~a: the share of the density below an offset is its place in the table" name)
      (for ([k (in-range 1 cells 7)])
        (check-= (/ (integral name -2.0 (flvector-ref table k)) whole) (/ k cells 1.0) 1e-6)))
    (test-case (format "~a: in order, symmetric, within its width" name)
      (for ([k cells])
        (check-true (< (flvector-ref table k) (flvector-ref table (+ k 1))))
        (check-= (flvector-ref table k) (- (flvector-ref table (- cells k))) 1e-11))
      (check-true (<= (flvector-ref table cells) (if (eq? name 'tent) 1.0 2.0)))))

  (test-case "the box takes no table"
    (check-false (Filter-table 'box)))

  ;; an edge through the middle of a pixel column: filters integrate to one, so a picture of constant
  ;; light is constant and two halves have their mean
  (define camera (Camera-orthographic (Float3 0 0 5) (Float3 0 0 0) #:height 4))
  (define (picture world name)
    (render world camera #:width 4 #:height 4 #:samples 1024 #:filter name))
  (define (channels image) (for/list ([x (in-flvector (Image-pixels image))]) x))
  (test-case "constant light"
    (for ([name FILTERS])
      (for ([x (channels (picture (World '() '() (Float3 0.25 0.25 0.25)) name))])
        (check-= x 0.25 1e-15))))

  (test-case "an edge at x = 0: columns see the part of the filter on its bright side"
    (define half (Quad (Float3 0 -9 0) (Float3 9 0 0) (Float3 0 18 0) (Emitter (Float3 1 1 1))))
    (define world (World (list half) '() (Float3 0 0 0)))
    (for ([name FILTERS])
      (define image (picture world name))
      (define whole (integral name -2.0 2.0))
      (for ([column 4])
        (define-values (red green blue) (Image-pixel image column 2))
        ;; middles are at -1.5, -0.5, 0.5 and 1.5
        (define expected (/ (integral name (- 1.5 column) 2.0) whole))
        (check-= red expected (/ 4.0 1024) (format "~a, column ~a" name column)))))

  (test-case "other names are refused"
    (check-exn #rx"expected one of .* as filter" (lambda () (picture (World '() '() (Float3 0 0 0)) 'sinc)))))
