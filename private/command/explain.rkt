#lang racket/base
;; raco raytrace explain: why a pixel of a scene looks as it does.
(require "flags.rkt" "values.rkt" "scenes.rkt" "load.rkt" "../render/explain.rkt"
         "../render/explanation.rkt" "../integrate/integrators.rkt" "../sample/sampler.rkt"
         "../sample/filter.rkt")

(provide explain-pixel)

(define (whole key check)
  (lambda (flag text) (cons key (check flag text (text->natural text)))))
(define (name key names)
  (lambda (flag text) (cons key (check-name flag (string->symbol text) names))))

(define flags
  `((usage-help
     "Tells how a pixel of <scene> comes about: what its paths hit, which lights were sampled,"
     "where its light comes from, and its error. It is the pixel that a render with the same flags"
     "and no --error or --seconds has.")
    (once-each
     [("--pixel") ,(lambda (flag text) (cons 'pixel text))
                  ("The pixel's column and row, from 0, 0 at the upper left" "X,Y")]
     [("--size") ,(lambda (flag text)
                    (cons 'size (check-size flag text (text->naturals text #rx"x"))))
                 ("The picture's width and height; by default the scene's, else 640x360" "WxH")]
     [("--samples") ,(whole 'samples check-samples)
                    ("Camera rays for the pixel; by default the scene's, else 16" "n")]
     [("--paths") ,(whole 'paths check-samples)
                  ("How many of their paths are told, those that bring most; by default 4" "n")]
     [("--seed") ,(whole 'seed check-seed) ("By default the scene's, else 0" "n")]
     [("--sampler") ,(name 'sampler SAMPLERS) ("As for rendering" "name")]
     [("--filter") ,(name 'filter FILTERS) ("As for rendering" "name")]
     [("--integrator") ,(name 'integrator INTEGRATORS) ("As for rendering" "name")]
     [("--max-depth") ,(whole 'max-depth check-max-depth) ("As for rendering" "n")])))

(define (explain-pixel program words)
  (define-values (options word)
    (parse-words program words flags '("scene")
                 (lambda (settings scene) (values (make-immutable-hasheq settings) scene))))
  (define pixel-text
    (hash-ref options 'pixel
              (lambda ()
                (raise-user-error "--pixel: expected the pixel to explain, as in --pixel 200,100"))))
  (define-values (world camera settings) (load-world word (find-scene word)))
  (define (option key default)
    (hash-ref options key (lambda () (hash-ref settings key default))))
  (define size (option 'size '(640 360)))
  (define pixel (text->naturals pixel-text #rx","))
  (unless (and (= (length pixel) 2) (andmap values pixel)
               (< (car pixel) (car size)) (< (cadr pixel) (cadr size)))
    (unexpected "--pixel" pixel-text
                (format "X,Y, two whole numbers that tell a pixel of ~ax~a" (car size) (cadr size))))
  (define explanation
    (with-handlers ([exn:fail? (lambda (e)
                                 (raise-user-error (format "~a: ~a" word (exn-message e))))])
      (explain world camera (car pixel) (cadr pixel) #:width (car size) #:height (cadr size)
               #:samples (option 'samples 16) #:seed (option 'seed 0)
               #:sampler (option 'sampler 'owen-sobol) #:filter (option 'filter 'box)
               #:integrator (option 'integrator 'auto) #:max-depth (option 'max-depth #f))))
  (write-explanation explanation (current-output-port) #:paths (hash-ref options 'paths 4)))
