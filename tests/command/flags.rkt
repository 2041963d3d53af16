#lang racket/base
;; The flags of rendering: what they set, in any order, and that the help names what there is.
(module+ test
  (require racket/port racket/string rackunit "../../private/command/flags.rkt"
           "../../private/integrate/integrators.rkt" "../../private/render/render.rkt")

  (define (parse . words)
    (define-values (options scene) (parse-render-flags "raco raytrace" words))
    (cons scene (sort (hash->list options) symbol<? #:key car)))

  (check-equal? (parse "a.rkt") '("a.rkt"))
  (define all '("a.rkt" (crop . "0,0,8,8") (integrator . depth) (max-depth . 7)
                        (output . "b.ppm") (quiet . #t) (samples . 4) (schedule . sequential)
                        (seed . 0) (size . (64 36)) (stats . #t) (stats-json . "s.json")
                        (tile . 8) (workers . 3)))
  (define flags '("-o" "b.ppm" "--size" "64x36" "--samples" "4" "--seed" "0" "--workers" "3"
                       "--schedule" "sequential" "--tile" "8" "--crop" "0,0,8,8"
                       "--integrator" "depth" "--max-depth" "7" "--quiet" "--stats"
                       "--stats-json" "s.json"))
  (check-equal? (apply parse "a.rkt" flags) all)
  (check-equal? (apply parse (append flags '("a.rkt"))) all)
  (check-equal? (apply parse (append (list "--output") (list "b.ppm") '("a.rkt") (list-tail flags 2)))
                all)
  ;; a lone - is a value, what follows -- is no flag
  (check-equal? (parse "-o" "-" "a.rkt") '("a.rkt" (output . "-")))
  (check-equal? (parse "--quiet" "--" "--stats") '("--stats" (quiet . #t)))

  (define (refusal . words)
    (with-handlers ([exn:fail:user? exn-message])
      (apply parse words)
      "taken"))
  (check-equal? (refusal "a.rkt" "-x") "-x: expected one of the flags that --help tells")
  (check-equal? (refusal "a.rkt" "-o") "-o: expected a value after it, found none")
  (check-equal? (refusal "a.rkt" "b.rkt")
                "expects 1 <scene> on the command line, given 2 arguments: a.rkt b.rkt ")
  (check-equal? (refusal "a.rkt" "--seed" "1" "--seed" "2")
                "the --seed option can only be specified once")

  ;; the help names every integrator and every schedule
  (define help
    (with-output-to-string
      (lambda ()
        (let/ec leave
          (parameterize ([exit-handler leave]) (parse "--help"))))))
  (for ([name (in-list (append INTEGRATORS SCHEDULES))])
    (check-true (string-contains? help (symbol->string name)) (format "~a in the help" name))))
