#lang racket/base
;; What a scene was found to need of the renderer, and what of it is skipped.
(require racket/fixnum
         (only-in "../base/float3.rkt" make-Float3)
         "../world/world.rkt" "../world/scene.rkt" "../world/camera.rkt" "../material/kernel.rkt"
         "../material/kernels.rkt" "../material/emitter.rkt" "../material/interior.rkt"
         "../material/phong.rkt")

(provide scene-needs)

;; scene-needs : pairs of a label and a text, for --stats.
(define (scene-needs world camera integrator)
  (define scene (World-scene world))
  (define materials (for/list ([material (in-vector (Scene-materials scene))]) material))
  (define article?
    (or (eq? integrator 'seed)
        (and (eq? integrator 'auto)
             (not (World-medium world))
             (andmap (lambda (m) (or (Phong? m) (Emitter? m))) materials))))
  (append
   (list (cons "hierarchy" (hierarchy-text scene))
         (cons "lights sampled" (number->string (vector-length (Scene-lights scene))))
         (cons "lens" (if (zero? (Camera-lens-radius camera)) "skipped: a pinhole" "needed")))
   (if article?
       (article-needs (World-shading world))
       (append
        (path-needs scene (filter (lambda (m) (not (Emitter? m))) materials))
        (list (cons "media" (if (or (World-medium world) (ormap Interior? materials))
                                "needed"
                                "skipped: nothing but surfaces")))))))

(define (hierarchy-text scene)
  (define bounded (fxvector-length (Scene-order scene)))
  (define unbounded (fxvector-length (Scene-unbounded scene)))
  (format "over ~a shapes~a~a" bounded
          (if (Scene-only-spheres? scene) ", all spheres: no calls of kernels" "")
          (if (zero? unbounded) "" (format ", ~a without bounds beside it" unbounded))))

(define (article-needs shading)
  (define (rays count)
    (if (zero? count) "skipped" (format "~a rays at a point" count)))
  (define black? (equal? (Shading-ambient-color shading) (make-Float3 0 0 0)))
  (list (cons "ambient occlusion"
              (if black? "skipped: no ambient light" (rays (Shading-ambient-samples shading))))
        (cons "shadows" (rays (Shading-shadow-samples shading)))))

(define (path-needs scene materials)
  (define kernels (map Material-kernel materials))
  (define sampled? (positive? (vector-length (Scene-lights scene))))
  (define rough (filter (lambda (kernel) (not (MaterialKernel-specular? kernel))) kernels))
  (list (cons "shadow rays"
              (cond
                [(not sampled?) "skipped: no light that can be sampled"]
                [(null? rough) "skipped: all surfaces are smooth mirrors or glass"]
                [else (format "at ~a of ~a materials" (length rough) (length kernels))]))
        (cons "transmission"
              (if (ormap MaterialKernel-transmits? kernels) "needed" "skipped: nothing transmits"))
        (cons "choice among lights"
              (if (> (vector-length (Scene-lights scene)) 1) "needed" "skipped"))))
