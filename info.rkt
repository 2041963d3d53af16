#lang info
(define collection "raytrace")
(define version "0.1")
(define license '(Apache-2.0 OR MIT))
(define pkg-desc "A functional ray tracer: pure immutable worlds in, pictures with known error out")
(define deps
  '("base" "typed-racket-lib" "typed-racket-more" "draw-lib" "gui-lib" "images-lib" "pict-lib"))
(define build-deps
  '("rackunit-lib" "math-lib" "scribble-lib" "plot-lib" "racket-doc" "sandbox-lib"))
(define scribblings '(("private/scribblings/raytrace.scrbl" (multi-page) (library))))
(define raco-commands
  '(("raytrace" raytrace/private/command/main "render a scene to a picture" #f)))
(define test-include-paths '("tests"))
(define pre-install-collection "private/install.rkt")
(define compile-omit-paths '("tests"))
