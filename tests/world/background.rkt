#lang racket/base
;; Backgrounds: one colour, and the gradient sky, by direction alone.

(module+ test
  (require racket/match rackunit "../../main.rkt" "../statistics.rkt")

  (define uniform (seeded 1))
  (define (nums v) (list (Float3-x v) (Float3-y v) (Float3-z v)))
  (define (random-float3) (Float3 (uniform -5.0 5.0) (uniform -5.0 5.0) (uniform -5.0 5.0)))
  (define (seen world direction) (World-ray-trace world (Ray (random-float3) direction)))
  (define blue (Float3 0.45 0.65 1))
  (define sky (GradientSky (Float3 1 1 1) (Float3 0.5 0.7 1)))

  (test-case "a colour is the same everywhere, to the bit"
    (define world (World '() '() blue))
    (for ([k 200]) (check-equal? (seen world (random-float3)) blue))
    (check-equal? (World-background-color world) blue))

  (test-case "the gradient: linear in the height of the unit direction, whatever its length"
    (define world (World '() '() sky))
    (for ([k 500])
      (define d (random-float3))
      (define s (* 0.5 (+ 1.0 (/ (Float3-y d) (Float3-length d)))))
      (define expected (list (- 1.0 (* 0.5 s)) (- 1.0 (* 0.3 s)) 1.0))
      (for* ([scale '(1.0 1e-6 1e6)]
             [c+e (map cons (nums (seen world (Float3-scale-by-scalar d scale))) expected)])
        (check-= (car c+e) (cdr c+e) 1e-15)))
    (check-equal? (nums (seen world (Float3 0 -3 0))) '(1.0 1.0 1.0))
    (check-equal? (nums (seen world (Float3 0 7 0))) '(0.5 0.7 1.0)))

  (test-case "the one colour that stands for a gradient is its mean over all directions"
    (define world (World '() '() sky))
    (for ([c (nums (World-background-color world))] [e '(0.75 0.85 1.0)]) (check-= c e 1e-15)))

  (test-case "a picture of nothing is the background through the middle of each pixel"
    (define camera (Camera-look-at (Float3 1 2 3) (Float3 0 0 0)))
    (define image (render (World '() '() sky) camera #:width 16 #:height 9 #:samples 1))
    (for* ([x 16] [y 9])
      (define-values (red green blue) (Image-pixel image x y))
      (define d (Camera-get-ray-direction camera (/ (+ x 0.5) 16) (/ (+ y 0.5) 9)))
      (define s (* 0.5 (+ 1.0 (Float3-y d))))
      (check-= red (- 1.0 (* 0.5 s)) 1e-15)
      (check-= green (- 1.0 (* 0.3 s)) 1e-15)
      (check-equal? blue 1.0)))

  (test-case "refused: colours that are no light"
    (for ([bad (list (Float3 -0.1 0 0) (Float3 0 +nan.0 0) (Float3 0 0 +inf.0))])
      (define (refused? name)
        (lambda (e) (and (exn:fail:contract? e)
                         (regexp-match? (string-append "^[^\n]*" name "[^\n]*$") (exn-message e)))))
      (check-exn (refused? "background") (lambda () (World '() '() bad)))
      (check-exn (refused? "bottom") (lambda () (GradientSky bad blue)))
      (check-exn (refused? "top") (lambda () (GradientSky blue bad))))))
