#lang racket/base
;; raco raytrace check: what is probably wrong with a scene.
(require "flags.rkt" "scenes.rkt" "load.rkt" "../render/problems.rkt")

(provide check-scene)

(define flags
  '((usage-help "Looks for what is probably a mistake in <scene>: a light inside a shape, the camera"
                "inside one or looking away from everything, no lights, a picture all black or white."
                "Tells each in a line and ends with code 1, or with 0 where there is none.")))

(define (check-scene program words)
  (define word (parse-words program words flags '("scene") (lambda (settings scene) scene)))
  (define-values (world camera settings) (load-world word (find-scene word)))
  (define problems
    (with-handlers ([exn:fail? (lambda (e)
                                 (raise-user-error (format "~a: ~a" word (exn-message e))))])
      (World-problems world camera
                      #:integrator (hash-ref settings 'integrator 'auto)
                      #:max-depth (hash-ref settings 'max-depth #f)
                      #:aspect (let ([size (hash-ref settings 'size '(640 360))])
                                 (/ (car size) (cadr size))))))
  (for ([problem (in-list problems)]) (printf "~a: ~a\n" word problem))
  (cond
    [(null? problems) (printf "~a: nothing looks wrong\n" word)]
    [else (flush-output) (exit 1)]))
