#lang racket/base
;; Finding scenes, by name and by path.
(module+ test
  (require rackunit "support.rkt" "../../private/command/scenes.rkt")

  (define names (map scene-name (package-scenes)))
  (check-not-false (member "seed" names))
  (check-equal? names (sort names string<?))
  (check-equal? (scene-name "a/b/soft-shadows.rkt") "soft-shadows")
  (check-true (file-exists? (find-scene "seed")))
  (check-equal? (scene-name (find-scene "seed")) "seed")

  (call-with-folder
   (lambda (folder)
     (define path (write-scene folder "seed.rkt" (scene-text)))
     (parameterize ([current-directory folder])
       (check-equal? (find-scene "seed.rkt") path)
       (check-equal? (find-scene "./seed.rkt") path)
       (check-equal? (find-scene (path->string path)) path)
       (check-not-equal? (find-scene "seed") path)
       (for ([wrong (in-list '("none" "none.rkt" "none/seed.rkt" "" "." "a\0b" "../"))])
         (check-exn (lambda (e)
                      (and (exn:fail:user? e)
                           (regexp-match? #rx": expected a scene [(]a .rkt, .*raco raytrace list shows"
                                          (exn-message e))))
                    (lambda () (find-scene wrong))))))))
