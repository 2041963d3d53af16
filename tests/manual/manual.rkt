#lang racket/base
;; The manual is built by Scribble, with pictures of an eighth of their size: every example of every
;; page runs, every page and every picture is there, and no link leads nowhere.
(module+ test
  (require racket/file racket/path racket/runtime-path racket/string rackunit
           scribble/render (prefix-in html: scribble/html-render))

  (define-runtime-path manual-file "../../private/scribblings/raytrace.scrbl")

  ;; What Scribble warned of. An example that raises ends the building here.
  (define (build folder)
    (define warnings (open-output-string))
    (putenv "RAYTRACE_MANUAL" "small")
    (define manual (dynamic-require manual-file 'doc))
    (parameterize ([current-error-port warnings])
      (render (list manual) (list "raytrace")
              #:dest-dir folder
              #:render-mixin (lambda (class) (html:render-multi-mixin (html:render-mixin class)))
              #:quiet? #t #:warn-undefined? #t))
    (get-output-string warnings))

  (define folder (make-temporary-file "manual~a" 'directory))
  (define warnings (build folder))
  (define (page name) (file->string (build-path folder "raytrace" (string-append name ".html"))))
  (define (count pattern text) (length (regexp-match* pattern text)))

  (test-case "links within the manual lead somewhere"
    ;; names of functions, modules and pages of other manuals lead to Racket's own documentation,
    ;; which may not be installed
    (define elsewhere #px"^ [(](?:dep|mod-path|form|part [(]\"[(]lib) ?")
    (check-equal? (for/list ([line (in-list (string-split warnings "\n"))]
                             #:unless (regexp-match? #px"^Warning: some cross ref" line)
                             #:unless (regexp-match? elsewhere line))
                    line)
                  '()))

  (test-case "the pages and their pictures"
    ;; as many as there are examples that end with a picture
    (for ([(name pictures) (in-hash (hash "tutorial" 14 "how-to" 18 "seed-and-books" 1
                                          "spaces" 2 "pi" 2))])
      (check-equal? (count #rx"<img " (page name)) pictures name))
    (for ([name '("index" "accuracy" "inside")])
      (check-true (> (string-length (page name)) 2000) name)))

  (test-case "no example printed an error"
    (for ([file (in-list (directory-list (build-path folder "raytrace") #:build? #t))]
          #:when (path-has-extension? file #".html"))
      (check-false (regexp-match? #rx"class=\"RktErr\"" (file->string file)) (path->string file))))

  (delete-directory/files folder))
