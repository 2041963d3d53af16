#lang racket/base
;; The command as a process: exit codes, one line for whatever is wrong, interrupts, and what is
;; loaded before it is needed.
(module+ test
  (require racket/port racket/string rackunit "support.rkt"
           "../../private/integrate/integrators.rkt" "../../private/render/render.rkt")

  (define count-expected "expected a whole number from 1 to 1000000000")
  (define (listed names) (string-join (map symbol->string names) ", "))
  (define size-expected "expected WIDTHxHEIGHT, two whole numbers from 1 to 100000")

  ;; flags
  (call-with-folder
   (lambda (folder)
     (define (refused line . words) (apply check-refused folder line words))
     (refused (string-append "--size 0x36: " size-expected) "seed" "--size" "0x36")
     (refused (string-append "--size 1e9x1e9: " size-expected) "seed" "--size" "1e9x1e9")
     (refused (string-append "--size 1000000000x1: " size-expected)
              "seed" "--size" "1000000000x1")
     (refused (string-append "--samples NaN: " count-expected) "--samples" "NaN" "seed")
     (refused (string-append "--samples -4: " count-expected) "seed" "--samples" "-4")
     (refused "--what: expected one of the flags that --help tells" "seed" "--what")
     (refused "--seed: expected a value after it, found none" "seed" "--seed")
     (refused "expects 1 <scene> on the command line, given 0 arguments" "-o" "a.ppm")))

  ;; names
  (call-with-folder
   (lambda (folder)
     (write-scene folder "good.rkt" (scene-text))
     (define (refused line . words) (apply check-refused folder line words))
     (check-one-line-error (run-command folder "none.rkt")
                           "none.rkt: expected a scene" "found no such file")
     (check-one-line-error (run-command folder folder) "found a folder")
     (refused "a.gif: expected a file name that ends with .ppm, .pfm, .hdr or .png"
              "good.rkt" "-o" "a.gif")
     (refused (format "none/a.ppm: cannot be written (there is no folder ~anone/)"
                      (path->directory-path folder))
              "good.rkt" "-o" "none/a.ppm")
     (refused (string-append "--integrator what: expected one of " (listed INTEGRATORS))
              "good.rkt" "--integrator" "what")
     (refused (string-append "--schedule what: expected one of "
                             (listed (append (remq 'hosts SCHEDULES) '(hosts:FILE))))
              "good.rkt" "--schedule" "what")
     (refused (string-append "--crop 0,0,65,1: expected X,Y,WIDTH,HEIGHT, four whole numbers that"
                             " tell a part of 64x36")
              "good.rkt" "--size" "64x36" "--crop" "0,0,65,1")))

  ;; scenes
  (call-with-folder
   (lambda (folder)
     (define (refused line text)
       (write-scene folder "bad.rkt" text)
       (check-refused folder (string-append "bad.rkt" line) "bad.rkt" "-o" "a.ppm"))
     (refused ": expected a module that provides `world`, a World; it does not"
              (scene-text #:provide "camera"))
     (refused ": expected `world` to be a World, found 42" (scene-text #:world "42"))
     (refused ": Sphere: expected three finite coordinates as point, given (Float3 +nan.0 0.0 0.0)"
              (scene-text #:world "(World (list (Sphere (Float3 +nan.0 0 0) 1 (Float3 1 0 0))))"))
     (refused (string-append ": DistantLight: expected a direction other than zero as direction,"
                             " given (Float3 0.0 0.0 0.0)")
              (scene-text #:world "(World '() (DistantLight (Float3 0 0 0) (Float3 1 1 1)))"))
     (refused ": Sphere: expected a positive finite number as radius, given -1"
              (scene-text #:world "(World (list (Sphere (Float3 0 0 0) -1 (Float3 1 0 0))))"))
     (refused ":6: what: unbound identifier in: what" (scene-text "(what)"))))

  ;; interrupts: one line, the code of the signal, nothing left behind
  (call-with-folder
   (lambda (folder)
     (write-scene folder "endless.rkt" (scene-text "(display \"loaded\\n\")"))
     (define before (files folder))
     (define (check-signal signal code line)
       (define command
         (start-command folder "endless.rkt" "-o" "a.ppm" "--size" "2000x2000"
                        "--samples" "200"))
       (wait-for-error-text command #rx"loaded\n")
       (sleep 1)
       (signal-command command signal)
       (define result (finish-command command))
       (check-regexp-match (string-append "^loaded\n" line " at [0-9]+% after [0-9]+ s\n$")
                           (outcome-errors result))
       (check-equal? (outcome-code result) code)
       (check-equal? (files folder) before))
     (check-signal 'INT 130 "raytrace: interrupted")
     (check-signal 'TERM 143 "raytrace: terminated")))

  ;; by the name that users type
  (call-with-folder
   (lambda (folder)
     (define help (run-raco folder "--help"))
     (check-equal? (outcome-code help) 0)
     (check-equal? (outcome-errors help) "")
     (check-true (string-prefix? (bytes->string/utf-8 (outcome-output help))
                                 "usage: raco raytrace [ <option> ... ] <scene>\n"))
     (check-one-line-error (run-raco folder "none.rkt") "none.rkt: expected a scene")))

  ;; the help is told before anything of the renderer or of Typed Racket is loaded
  (define loaded
    (let/ec leave
      (parameterize ([current-namespace (make-base-empty-namespace)]
                     [current-command-line-arguments #("--help")]
                     [current-output-port (open-output-nowhere)]
                     [exit-handler
                      (lambda (code)
                        (leave (filter (lambda (module) (module-declared? module #f))
                                       (list 'typed/racket/base 'racket/contract/base 'raytrace
                                             'raytrace/private/command/flags))))])
        (dynamic-require 'raytrace/private/command/main #f)
        (leave '()))))
  (check-equal? loaded '(raytrace/private/command/flags)))
