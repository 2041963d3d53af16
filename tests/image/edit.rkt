#lang racket/base
;; Pictures from pictures: parts, sizes, exposure, tone, false colours, rows of several.
(module+ test
  (require racket/flonum rackunit
           "../../private/image/image.rkt" "../../private/image/edit.rkt"
           "../../private/image/tone.rkt")

  (define (pixel image x y) (call-with-values (lambda () (Image-pixel image x y)) list))
  (define (ramp width height [errors? #f])
    (define pixels (for/flvector ([k (in-range (* 3 width height))]) (/ (exact->inexact k) 10.0)))
    (make-Image width height pixels (and errors? (for/flvector ([x (in-flvector pixels)]) (* 0.1 x)))))
  (define (mean image)
    (/ (for/sum ([x (in-flvector (Image-pixels image))]) x) (flvector-length (Image-pixels image))))
  (define (grey . values)
    (make-Image (length values) 1 (apply flvector (for*/list ([v values] [_ 3]) (exact->inexact v)))))

  (test-case "a crop has the pixels and errors of its part"
    (define image (ramp 5 4 #t))
    (define part (Image-crop image 1 2 3 2))
    (check-equal? (list (Image-width part) (Image-height part)) '(3 2))
    (for* ([x 3] [y 2]) (check-equal? (pixel part x y) (pixel image (+ x 1) (+ y 2))))
    (check-equal? (flvector-ref (Image-standard-error part) 0)
                  (flvector-ref (Image-standard-error image) (* 3 (+ 1 (* 2 5)))))
    (check-equal? (Image-crop image 0 0 5 4) image)
    (for ([bad (in-list '((5 0 1 1) (0 0 6 1) (-1 0 1 1) (0 0 0 1) (1.5 0 1 1)))])
      (check-exn exn:fail:contract? (lambda () (apply Image-crop image bad)))))

  (test-case "scaling keeps flat pictures flat, a size its factor, and light on average"
    (define flat (Image-scale (grey 0.3 0.3 0.3) #:width 7 #:height 5))
    (check-equal? (list (Image-width flat) (Image-height flat)) '(7 5))
    (for ([x (in-flvector (Image-pixels flat))]) (check-= x 0.3 1e-15))
    (define small (Image-scale (ramp 64 48) 1/4))
    (check-equal? (list (Image-width small) (Image-height small)) '(16 12))
    ;; borders weigh more than the middle: of a linear ramp the mean stays by symmetry
    (check-= (mean small) (mean (ramp 64 48)) 1e-9)
    (define large (Image-scale (ramp 5 4) #:width 10))
    (check-equal? (list (Image-width large) (Image-height large)) '(10 8))
    ;; between two middles a ramp stays a ramp: a quarter of the way from pixel 1 to pixel 2
    (check-= (car (pixel (Image-scale (grey 0 1 2 3) #:width 8 #:height 1) 3 0)) 1.25 1e-12)
    (check-equal? (Image-pixels (Image-scale (ramp 5 4) 1)) (Image-pixels (ramp 5 4)))
    (check-exn #rx"factor" (lambda () (Image-scale (ramp 2 2) 0)))
    (check-exn #rx"given both" (lambda () (Image-scale (ramp 2 2) 2 #:width 3)))
    (check-exn exn:fail:contract? (lambda () (Image-scale (ramp 2 2)))))

  (test-case "exposure in stops, errors too"
    (define image (Image-exposed (ramp 2 2 #t) 2))
    (check-equal? (pixel image 1 1) (map (lambda (x) (* 4.0 x)) (pixel (ramp 2 2) 1 1)))
    (check-equal? (flvector-ref (Image-standard-error image) 5)
                  (* 4.0 (flvector-ref (Image-standard-error (ramp 2 2 #t)) 5)))
    (check-exn #rx"stops" (lambda () (Image-exposed image +nan.0))))

  (test-case "tone curves"
    (define (toned value curve [stops 0])
      (car (pixel (Image-tone (grey value) #:curve curve #:exposure stops) 0 0)))
    (check-equal? (toned 0.25 'sRGB) 0.25)
    (check-equal? (toned 0.25 'sRGB 1) 0.5)
    (check-equal? (toned 7.0 'sRGB) 1.0)
    (check-= (sRGB-encode (toned 0.25 'linear)) 0.25 1e-12)
    ;; the fit's own values: 0 black, 0.8 at 1, rising, never above 1
    (check-= (toned 0 'filmic) 0.0 1e-15)
    (check-= (toned 1 'filmic) 0.8038 1e-4)
    (for ([k (in-range 1 200)])
      (check-true (<= (toned (/ (- k 1) 10.0) 'filmic) (toned (/ k 10.0) 'filmic) 1.0)))
    (check-equal? (toned +inf.0 'filmic) 1.0)
    (check-exn #rx"filmic" (lambda () (toned 1 'photo))))

  (test-case "false colours: black for 0, pale yellow for the largest or the scale"
    (define image (Image-false-color (grey 0 2 4)))
    (check-equal? (pixel image 0 0) '(0.0 0.0 0.0))
    (check-equal? (pixel image 2 0) '(1.0 1.0 0.8))
    (check-equal? (pixel (Image-false-color (grey 0 2 4) #:scale 8) 2 0) (pixel image 1 0))
    (check-equal? (pixel (Image-false-color (grey 0 0)) 1 0) '(0.0 0.0 0.0))
    (check-exn #rx"scale" (lambda () (Image-false-color (grey 0) #:scale 0))))

  (test-case "an error map is the root mean square of the channels' errors"
    (define image (make-Image 1 1 (flvector 1.0 1.0 1.0) (flvector 0.3 0.0 0.4)))
    (check-= (car (pixel (Image-error-map image) 0 0)) (sqrt (/ 0.25 3)) 1e-15)
    (check-exn #rx"known standard errors" (lambda () (Image-error-map (grey 1)))))

  (test-case "side by side, with labels below"
    (define row (Images-side-by-side (list (ramp 3 2) (ramp 2 4)) #:gap 1))
    (check-equal? (list (Image-width row) (Image-height row)) '(6 4))
    (check-equal? (pixel row 2 1) (pixel (ramp 3 2) 2 1))
    (check-equal? (pixel row 5 3) (pixel (ramp 2 4) 1 3))
    (check-equal? (pixel row 3 0) '(0.0 0.0 0.0))
    (check-equal? (pixel row 0 3) '(0.0 0.0 0.0))
    (define labelled (Images-side-by-side (list (ramp 60 3) (ramp 60 3)) #:labels '("here" "")))
    (define (ink from to)
      (for*/sum ([x (in-range from to)] [y (in-range 3 (Image-height labelled))])
        (car (pixel labelled x y))))
    (check-true (> (ink 0 60) 10.0))
    (check-equal? (ink 68 128) 0.0)
    (check-exn #rx"as many strings" (lambda () (Images-side-by-side (list (ramp 1 1)) #:labels '())))
    (check-exn #rx"at least one" (lambda () (Images-side-by-side '())))))
