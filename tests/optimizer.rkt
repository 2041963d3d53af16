#lang racket/base
;; Typed Racket's optimizer says nothing was missed in the files that decide speed: all arithmetic on
;; flonums and fixnums there is unboxed or by unsafe operations.
(module+ test
  (require racket/runtime-path racket/string rackunit)

  (define-runtime-path private-folder "../private")

  (define kernel-files
    '("world/trace.rkt" "world/gather.rkt" "world/camera.rkt" "shape/sphere.rkt" "shape/triangle.rkt"
      "shape/quad.rkt" "shape/box.rkt" "shape/mesh.rkt" "sample/sampler.rkt" "sample/warp.rkt"
      "light/sphere.rkt" "light/quad.rkt" "material/lambertian.rkt" "material/dielectric.rkt"
      "material/texture/checker.rkt" "material/texture/image.rkt" "material/texture/noise.rkt"
      "material/texture/noises.rkt" "material/texture/gradient.rkt"
      "material/roughness.rkt" "material/bumped.rkt" "material/metal.rkt"
      "medium/scattering.rkt" "integrate/media.rkt" "integrate/bump.rkt"
      "integrate/path.rkt" "integrate/seed.rkt" "integrate/emission.rkt" "render/pixel.rkt"))

  ;; What the optimizer logs while a file is expanded from its source.
  (define (optimizer-log path)
    (define receiver (make-log-receiver (current-logger) 'debug 'TR-optimizer))
    (parameterize ([current-namespace (make-base-namespace)]
                   [read-accept-reader #t]
                   [current-load-relative-directory
                    (let-values ([(folder name dir?) (split-path path)]) folder)])
      (define syntax
        (call-with-input-file path
          (lambda (in) (port-count-lines! in) (read-syntax path in))))
      (parameterize ([current-module-declare-name (make-resolved-module-path path)])
        (expand syntax)))
    (let loop ([lines '()])
      (define event (sync/timeout 0 receiver))
      (if event (loop (cons (vector-ref event 1) lines)) (reverse lines))))

  (for ([file (in-list kernel-files)])
    (define log (optimizer-log (simplify-path (build-path private-folder file))))
    (check-true (pair? log) (format "~a: the optimizer says nothing at all" file))
    (check-equal? (filter (lambda (line) (string-contains? line "missed")) log) '() file)))
