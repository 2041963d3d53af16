#lang racket/base
;; raco raytrace view: a scene in a window, read again when its files change.
(require (only-in racket/list remove-duplicates) "flags.rkt" "values.rkt" "scenes.rkt"
         "load.rkt" "../view/view.rkt"
         "../view/refine.rkt" "../integrate/integrators.rkt" racket/lazy-require)

(lazy-require ["studio.rkt" (load-studio)])

(provide view-command)

(define (whole key check)
  (lambda (flag text) (cons key (check flag text (text->natural text)))))

(define flags
  `((usage-help
     "Shows <scene> in a window: drawn at once, then traced with more and more samples. The mouse"
     "moves the camera; h shows what else there is. The scene is read again when its file changes.")
    (once-each
     [("--size") ,(lambda (flag text)
                    (cons 'size (check-size flag text (text->naturals text #rx"x"))))
                 ("The picture's width and height; by default the scene's, else 640x360" "WxH")]
     [("--samples") ,(whole 'samples check-samples)
                    ("The most samples of a pixel; by default 65536" "n")]
     [("--error") ,(lambda (flag text) (cons 'error (check-error flag text (text->part text))))
                  ("The error that is good enough, such as 0.01 or 1%; by default none is" "e")]
     [("--seed") ,(whole 'seed check-seed) ("By default the scene's, else 0" "n")]
     [("--integrator") ,(lambda (flag text)
                          (cons 'integrator (check-name flag (string->symbol text) INTEGRATORS)))
                       ("As for rendering" "name")]
     [("--shading") ,(lambda (flag text)
                       (cons 'shading
                             (check-shading flag (map string->symbol (regexp-split #rx"," text))
                                            SHADINGS)))
                    ("How what is drawn at once is shaded; as for rendering" "name")]
     [("--max-depth") ,(whole 'max-depth check-max-depth) ("As for rendering" "n")])))

(define (view-command program words)
  (define-values (options word)
    (parse-words program words flags '("scene")
                 (lambda (settings scene) (values (make-immutable-hasheq settings) scene))))
  (define path (find-scene word))
  (check-display)
  (define sources (box (list path)))
  (define (read-scene) (load-viewed options word path sources))
  (void (view-scene (read-scene) #:name (scene-name path)
                    #:reload read-scene #:files (lambda () (unbox sources)))))

;; The scene, read from its file in a namespace of its own. sources: a box that is set to the files it
;; came from.
(define (load-viewed options word path sources)
  (define-values (world camera settings)
    (if (mesh-file? path) (load-studio path #f) (load-scene/sources word path sources)))
  (define (option key default)
    (hash-ref options key (lambda () (hash-ref settings key default))))
  (define size (option 'size '(640 360)))
  (check-crop "--crop" #f size)
  (scene world camera (car size) (cadr size)
         (check-name (format "~a: settings, 'integrator" word) (option 'integrator 'auto) INTEGRATORS)
         (hash-ref options 'samples #f) (hash-ref options 'error #f)
         (option 'seed 0) (option 'max-depth #f)
         (check-shading (format "~a: settings, 'shading" word) (option 'shading 'phong) SHADINGS)))

;; Modules in the scene's folder and below it are its sources, also those that are wrong.
(define (load-scene/sources word path sources)
  (define-values (folder name must-be-folder?) (split-path path))
  (define load (current-load/use-compiled))
  (define found (list path))
  (dynamic-wind
   void
   (lambda ()
     (parameterize ([current-load/use-compiled
                     (lambda (file expected)
                       (when (path-below folder file) (set! found (cons file found)))
                       (load file expected))])
       (load-scene word path #:namespace (fresh-namespace))))
   (lambda () (set-box! sources (remove-duplicates found)))))

;; A namespace in which nothing is loaded but raytrace and what it is made of.
(define (fresh-namespace)
  (define here (variable-reference->empty-namespace (#%variable-reference)))
  (define fresh (parameterize ([current-namespace here]) (make-empty-namespace)))
  (parameterize ([current-namespace here])
    (dynamic-require 'raytrace #f)
    (namespace-attach-module here 'raytrace fresh))
  fresh)
