#lang racket/base
;; All cases of the stress suite, in order of their names, and how one is run.

(provide stress-cases run-case QUICK)

(require "case.rkt"
         (prefix-in spheres: "spheres.rkt") (prefix-in meshes: "meshes.rkt")
         (prefix-in boxes: "boxes.rkt") (prefix-in roots: "roots.rkt")
         (prefix-in vectors: "vectors.rkt") (prefix-in worlds: "worlds.rkt")
         (prefix-in pictures: "pictures.rkt") (prefix-in sums: "sums.rkt")
         (prefix-in cameras: "cameras.rkt") (prefix-in lights: "lights.rkt")
         (prefix-in files: "files.rkt") (prefix-in numbers: "numbers.rkt")
         (prefix-in large: "large.rkt") (prefix-in errors: "errors.rkt"))

;; The size at which all cases together take about a minute.
(define QUICK 1/200)

(define stress-cases
  (sort (append spheres:cases meshes:cases boxes:cases roots:cases vectors:cases worlds:cases
                pictures:cases sums:cases cameras:cases lights:cases files:cases numbers:cases
                large:cases errors:cases)
        string<? #:key stress-case-name))

;; What was measured, whether it passed and the seconds it took; an exception fails.
(define (run-case c size)
  (define start (current-inexact-milliseconds))
  (define-values (measured passed?)
    (with-handlers ([exn:fail? (lambda (e) (values (format "raised: ~a" (exn-message e)) #f))])
      ((stress-case-run c) size)))
  (values measured passed? (/ (- (current-inexact-milliseconds) start) 1000.0)))
