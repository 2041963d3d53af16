#lang racket/base
;; Transforms: known images, inverses, composition, normals, and what the constructors refuse.

(module+ test
  (require racket/flonum racket/list rackunit
           (except-in "../../private/base/float3.rkt" Float3)
           "../../private/base/transform.rkt")

  (define (coordinates p)
    (list (Float3-x/function p) (Float3-y/function p) (Float3-z/function p)))
  ;; Within `tolerance` of the size of the numbers.
  (define (check-near actual expected [tolerance 1e-15])
    (define size (apply max 1.0 (map abs expected)))
    (for ([a (in-list actual)] [e (in-list expected)])
      (check-= a e (* tolerance size))))
  (define (check-point transform p expected [tolerance 1e-15])
    (check-near (coordinates (Transform-point transform p)) expected tolerance))

  (define p (make-Float3 2 -3 5))

  (test-case "each map moves a point where it should, exactly"
    (define-check (check-exact transform expected)
      (check-equal? (coordinates (Transform-point transform p)) expected))
    (check-exact (Transform-identity) '(2.0 -3.0 5.0))
    (check-exact (Transform-translate 1 2 3) '(3.0 -1.0 8.0))
    (check-exact (Transform-translate (make-Float3 1 2 3)) '(3.0 -1.0 8.0))
    (check-exact (Transform-scale 2) '(4.0 -6.0 10.0))
    (check-exact (Transform-scale 2 1 -1) '(4.0 -3.0 -5.0))
    (check-exact (Transform-shear #:x-by-y 1 #:z-by-x 2) '(-1.0 -3.0 9.0))
    (check-exact (Transform-rotate (make-Float3 0 0 1) #:degrees 90) '(3.0 2.0 5.0))
    (check-exact (Transform-rotate (make-Float3 0 0 1) #:degrees 180) '(-2.0 3.0 5.0))
    (check-exact (Transform-rotate (make-Float3 0 1 0) #:degrees -270) '(5.0 -3.0 -2.0)))

  (test-case "rotations, to 1e-15"
    (define angle (/ 3.141592653589793 4))
    (define turned (Transform-rotate (make-Float3 1 0 0) angle))
    (check-point turned (make-Float3 0 1 0) (list 0.0 (sqrt 0.5) (sqrt 0.5)))
    (check-point (Transform-inverse turned) (make-Float3 0 1 0) (list 0.0 (sqrt 0.5) (- (sqrt 0.5))))
    ;; about the space diagonal by a third of a turn: the axes change places
    (check-point (Transform-rotate (make-Float3 7 7 7) #:degrees 120) p '(5.0 2.0 -3.0) 4e-16)
    (check-point (Transform-rotate (make-Float3 0 0 1) #:degrees 36000030) (make-Float3 1 0 0)
                 (list (/ (sqrt 3.0) 2.0) 0.5 0.0) 2e-16))

  (test-case "directions do not move, normals stay across the surface"
    (define m (Transform-compose (Transform-translate 100 200 300) (Transform-scale 1 2 4)
                                 (Transform-rotate (make-Float3 1 2 3) 0.7)))
    (define along (make-Float3 1 -1 2))
    (define across (make-Float3 1 1 0))
    (check-near (coordinates (Transform-vector m along))
                (map - (coordinates (Transform-point m along))
                     (coordinates (Transform-point m (make-Float3 0 0 0))))
                1e-12)
    (define normal (Transform-normal m across))
    (check-= (Float3-dot/function normal (Transform-vector m along)) 0.0 1e-14)
    (check-= (Float3-length/function normal) 1.0 1e-15))

  (test-case "H20: normal of a squeezed, turned sphere"
    (define m (Transform-compose (Transform-scale 1 0.5 1)
                                 (Transform-rotate (make-Float3 0 0 1) (/ 3.141592653589793 5))))
    (define s (sqrt 0.5))
    (define normal
      (Transform-normal m (Transform-point (Transform-inverse m) (make-Float3 0 s (- s)))))
    (check-near (coordinates normal) '(0.0 0.9701425001453319 -0.24253562503633297) 1e-12))

  (test-case "the view from a point: a textbook's matrix, whose rows are not unit, to its digits"
    (define view
      (Transform-inverse (Transform-look-at (make-Float3 1 3 2) (make-Float3 4 -2 8)
                                            (make-Float3 1 1 0))))
    (for ([row (Transform-matrix-rows view)]
          [textbook '((-0.50709 0.50709 0.67612 -2.36643)
                      (0.76772 0.60609 0.12122 -2.82843)
                      (-0.35857 0.59761 -0.71714 0.0))])
      (define length (sqrt (for/sum ([e (take textbook 3)]) (* e e))))
      (for ([a row] [e textbook]) (check-= a (/ e length) 2e-5)))
    ;; an object at the eye looks at the focus
    (define placed (Transform-look-at (make-Float3 1 2 3) (make-Float3 1 2 -7)))
    (check-point placed (make-Float3 0 0 -10) '(1.0 2.0 -7.0))
    (check-point placed (make-Float3 0 1 0) '(1.0 3.0 3.0)))

  (test-case "inverses undo and composition is application in turn, to 1e-13, 1000 maps"
    (define generator (vector->pseudo-random-generator (vector 1 2 3 4 5 6)))
    (define (uniform) (- (* 2.0 (random generator)) 1.0))
    (define (vector3) (make-Float3 (uniform) (uniform) (uniform)))
    (define (stretch) (exp (* 2.0 (uniform))))
    (define (any)
      (case (random 4 generator)
        [(0) (Transform-translate (vector3))]
        [(1) (Transform-scale (stretch) (- (stretch)) (stretch))]
        [(2) (Transform-rotate (vector3) (* 7.0 (uniform)))]
        [else (Transform-shear #:x-by-y (* 0.3 (uniform)) #:y-by-z (* 0.3 (uniform))
                               #:z-by-x (* 0.3 (uniform)))]))
    (for ([_ 1000])
      (define-values (a b c) (values (any) (any) (any)))
      (define all (Transform-compose a b c))
      (define q (vector3))
      (define image (Transform-point all q))
      (check-near (coordinates image)
                  (coordinates (Transform-point a (Transform-point b (Transform-point c q))))
                  1e-13)
      (check-near (coordinates (Transform-point (Transform-inverse all) image)) (coordinates q)
                  1e-12)))

  (test-case "a matrix by its entries: the inverse is the exact one, rounded"
    (define m (make-Transform 2 1 0 5 0 3 1 6 1 0 4 7))
    ;; determinant 25; cofactors by hand
    (for ([row (Transform-matrix-rows (Transform-inverse m))]
          [expected '((12/25 -4/25 1/25) (1/25 8/25 -2/25) (-3/25 1/25 6/25))])
      (check-equal? (take row 3) (map real->double-flonum expected)))
    (check-equal? (Transform-compose) (Transform-identity))
    (check-equal? (Transform-scale 1e-150) (Transform-scale 1e-150 1e-150 1e-150))
    (check-not-exn (lambda () (make-Transform 1 0 0 0 0 1e-40 0 0 0 0 1e-40 0))))

  (test-case "it prints as one would write it"
    (check-equal? (format "~s" (Transform-translate 1 2 3))
                  "(Transform 1.0 0.0 0.0 1.0 0.0 1.0 0.0 2.0 0.0 0.0 1.0 3.0)"))

  (test-case "one line for what is not a map that can be undone"
    (define (check-refused pattern thunk)
      (check-exn (lambda (e)
                   (and (exn:fail:contract? e)
                        (regexp-match? pattern (exn-message e))
                        (not (regexp-match? #rx"\n" (exn-message e)))))
                 thunk))
    (check-refused #rx"^Transform-scale: expected a number other than zero"
                   (lambda () (Transform-scale 1 0 1)))
    (check-refused #rx"^Transform-scale: expected a finite" (lambda () (Transform-scale +nan.0)))
    (check-refused #rx"^Transform-translate: expected three finite"
                   (lambda () (Transform-translate 1 +inf.0 1)))
    (check-refused #rx"^Transform-rotate: expected a direction"
                   (lambda () (Transform-rotate (make-Float3 0 0 0) 1)))
    (check-refused #rx"^Transform-rotate: expected radians or #:degrees"
                   (lambda () (Transform-rotate (make-Float3 0 0 1))))
    (check-refused #rx"^Transform-shear: expected a map that can be undone"
                   (lambda () (Transform-shear #:x-by-y 1 #:y-by-x 1)))
    (check-refused #rx"^Transform: expected a map that can be undone"
                   (lambda () (make-Transform 0.1 0.2 0.3 0 0.3 0.6 0.9 0 0 0 1 0)))
    (check-refused #rx"^Transform: expected a finite"
                   (lambda () (make-Transform 1 0 0 +nan.0 0 1 0 0 0 0 1 0)))
    (check-refused #rx"^Transform-look-at: expected a direction across"
                   (lambda () (Transform-look-at (make-Float3 0 0 0) (make-Float3 0 5 0))))
    (check-refused #rx"^Transform-look-at: expected a direction other"
                   (lambda () (Transform-look-at (make-Float3 0 1 0) (make-Float3 0 1 0))))
    (check-refused #rx"^Transform-compose: expected a map"
                   (lambda ()
                     (Transform-compose (Transform-scale 1e-200) (Transform-scale 1e-200))))))
