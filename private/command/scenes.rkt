#lang racket/base
;; Where scenes are: the package's own by name, all others by path.
(provide find-scene package-scenes scene-name mesh-file?)

(define scenes-folder
  (let-values ([(folder name must-be-folder?)
                (split-path (variable-reference->module-source (#%variable-reference)))])
    (simplify-path (build-path folder 'up 'up "scenes"))))

;; package-scenes : the paths of the package's scenes, sorted.
(define (package-scenes)
  (if (directory-exists? scenes-folder)
      (sort (for/list ([file (in-list (directory-list scenes-folder #:build? #t))]
                       #:when (regexp-match? #rx"[.]rkt$" (path->bytes file)))
              file)
            string<? #:key scene-name)
      '()))

;; scene-name : a scene's path without folder and extension, as a string.
(define (scene-name path)
  (define-values (folder name must-be-folder?) (split-path path))
  (path->string (path-replace-extension name #"")))

;; mesh-file? : whether the path ends as the name of a mesh file does.
(define (mesh-file? path) (regexp-match? #rx"[.](?i:obj|ply|stl)$" path))

;; find-scene : the complete path of the scene's file: the word is a path to a .rkt or a mesh file,
;; or the name of one of the package's scenes. Raises exn:fail:user where there is none.
(define (find-scene word)
  (define path
    (and (path-string? word)
         (if (regexp-match? #px"^[\\w-]+$" word)
             (build-path scenes-folder (string-append word ".rkt"))
             (path->complete-path word))))
  (cond
    [(and path (file-exists? path)) (simplify-path path)]
    [else
     (raise-user-error
      (format (string-append "~a: expected a scene (a .rkt, .obj, .ply or .stl file, or a name that "
                             "raco raytrace list shows), found ~a")
              word
              (if (and path (directory-exists? path)) "a folder" "no such file")))]))
