#lang racket/base
;; What two machines must agree on before one renders for the other.
(require racket/fasl file/sha1 racket/path "desk.rkt" "../job.rkt" "../digest.rkt" "../transport.rkt"
         "../../world/world.rkt" "../../base/float3.rkt")

(provide make-host-order host-order->job)

(define scenes-folder (build-path (collection-path "raytrace") "scenes"))

;; make-host-order : the job, its scene's file (or #f where the world goes along), and what has to be
;; the same there. Scenes of the package are told by name.
(define (make-host-order job)
  (define scene (and (Job-scene job) (simple-form-path (Job-scene job))))
  (define-values (folder name directory?) (if scene (split-path scene) (values #f #f #f)))
  (define own?
    (and scene (equal? folder (path->directory-path (simple-form-path scenes-folder)))))
  (define bare
    (if scene (Job-with-world job (make-World '() '() (make-Float3 0 0 0))) job))
  (list (value->message bare)
        (and scene (if own? (list (path->string name)) (path->string scene)))
        (version) (library-digest)
        (and scene (scene-digest (Job-world job) scene))))

;; host-order->job : the job of an order, or a text that says what is not the same here.
(define (host-order->job order)
  (define scene
    (let ([named (cadr order)])
      (and named (if (pair? named) (build-path scenes-folder (car named)) (string->path named)))))
  (cond
    [(not (equal? (caddr order) (version)))
     (format "has Racket ~a, not ~a" (version) (caddr order))]
    [(not (equal? (cadddr order) (library-digest)))
     "has another version of raytrace"]
    [(not scene) (message->value (car order))]
    [(not (file-exists? scene)) (format "has no ~a" scene)]
    [else
     (define world (dynamic-require scene 'world))
     (if (equal? (list-ref order 4) (scene-digest world scene))
         (Job-with-world (message->value (car order)) world)
         (format "has another ~a" scene))]))

(define (scene-digest world file)
  (define bytes (call-with-input-file file sha1-bytes))
  (content-digest (list world bytes) (lambda () bytes)))

;; Of all modules of the library.
(define (library-digest)
  (define root (collection-path "raytrace"))
  (define files
    (cons (build-path root "main.rkt")
          (for/list ([file (in-directory (build-path root "private"))]
                     #:when (path-has-extension? file #".rkt"))
            file)))
  (sha1 (open-input-string
         (apply string-append
                (for/list ([file (in-list (sort files path<?))])
                  (format "~a ~a\n" (find-relative-path root file)
                          (call-with-input-file file sha1)))))))
