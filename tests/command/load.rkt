#lang racket/base
;; Loading scenes: what is accepted, and the line for each way in which a module is no scene.
(module+ test
  (require racket/port racket/string rackunit raytrace "support.rkt"
           "../../private/command/load.rkt")

  (call-with-folder
   (lambda (folder)
     (define count 0)
     ;; each text gets a file of its own, for a module is loaded once
     (define (load text)
       (set! count (+ count 1))
       (load-scene "scene.rkt" (write-scene folder (format "scene~a.rkt" count) text)))
     (define (refusal text)
       (with-handlers ([exn:fail:user? exn-message])
         (load text)
         "taken"))

     ;; settings are optional
     (define-values (world camera no-settings) (load (scene-text)))
     (check-true (World? world))
     (check-true (Camera? camera))
     (check-equal? no-settings (hash))

     ;; what a scene prints is no output, and it sees no command line
     (define errors (open-output-string))
     (define settings #f)
     (define printed
       (with-output-to-string
         (lambda ()
           (parameterize ([current-command-line-arguments (vector "a")]
                          [current-error-port errors])
             (define-values (world camera loaded)
               (load (scene-text #:provide "world camera settings"
                                 "(define settings (hash 'size '(8 4) 'samples 2 'seed 7"
                                 "                       'integrator 'normals))"
                                 "(write (current-command-line-arguments))")))
             (set! settings loaded)))))
     (check-equal? printed "")
     (check-equal? (get-output-string errors) "#()")
     (check-equal? settings (hash 'size '(8 4) 'samples 2 'seed 7 'integrator 'normals))

     ;; typed scenes too
     (define-values (typed-world typed-camera typed-settings)
       (load (regexp-replace #rx"racket/base" (scene-text) "typed/racket/base")))
     (check-true (World? typed-world))
     (check-true (Camera? typed-camera))

     (define (check-refused text line) (check-equal? (refusal text) line))
     (check-refused (scene-text #:provide "world")
                    "scene.rkt: expected a module that provides `camera`, a Camera; it does not")
     (check-refused (scene-text #:camera "'(0 0 0)")
                    "scene.rkt: expected `camera` to be a Camera, found '(0 0 0)")
     (check-refused (scene-text "(exit 0)") "scene.rkt: left by (exit)")
     (check-refused (scene-text "(error \"first\\nsecond\")") "scene.rkt: first\nsecond")
     (check-refused (scene-text "(raise 'what)") "scene.rkt: raised 'what")
     (check-refused (scene-text "(define (f n) (if (zero? n) (car '()) (+ 1 (f (- n 1)))))" "(f 3)")
                    (string-append "scene.rkt:6: car: contract violation\n  expected: pair?\n"
                                   "  given: '()"))
     (check-refused (scene-text "(define)") "scene.rkt:6: define: bad syntax\n  in: (define)")
     (check-refused (scene-text "(car") "scene.rkt:6: read-syntax: expected a `)` to close `(`")
     (check-true (string-prefix? (refusal "no module") "scene.rkt: default-load-handler: "))
     (check-true (string-prefix? (refusal (scene-text "(require no/such/thing)"))
                                 "scene.rkt:6: "))

     (define (check-settings text line)
       (check-refused (scene-text #:provide "world camera settings"
                                  (format "(define settings ~a)" text))
                      (string-append "scene.rkt: " line)))
     (define keys "a hash with keys among 'size, 'samples, 'seed, 'integrator, 'max-depth and 'shading")
     (check-settings "4" (format "expected `settings` to be ~a, found 4" keys))
     (check-settings "(hash 'what 1)" (format "settings 'what: expected ~a" keys))
     (check-settings "(hash 'samples 0)"
                     "settings, 'samples 0: expected a whole number from 1 to 1000000000")
     (check-settings "(hash 'size '(0 4))"
                     (string-append "settings, 'size '(0 4): expected WIDTHxHEIGHT, two whole"
                                    " numbers from 1 to 100000"))
     (check-settings "(hash 'seed -1)"
                     "settings, 'seed -1: expected a whole number from 0 to 4294967295")
     (check-settings "(hash 'integrator \"x\")"
                     "settings, 'integrator \"x\": expected a symbol"))))
