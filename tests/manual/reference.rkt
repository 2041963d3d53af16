#lang racket/base
;; Every name that raytrace provides has one entry in the reference, nothing else has, and the programs
;; of the reference run.
(module+ test
  (require racket/class racket/file racket/list racket/math racket/path racket/runtime-path racket/set
           rackunit scribble/base-render scribble/core (prefix-in text: scribble/text-render))

  (define-runtime-path reference-file "../../private/scribblings/reference.scrbl")
  (define-runtime-path view-file "../../private/scribblings/view.scrbl")
  (define-runtime-path reference-folder "../../private/scribblings/reference")

  ;; The names that pages define, for the module raytrace, and what is collected of them twice.
  (define (defined-names pages)
    (define renderer (new (text:render-mixin render%) [dest-dir (find-system-path 'temp-dir)]))
    (define documents (for/list ([page (in-list pages)]) (dynamic-require page 'doc)))
    (define names (for/list ([page (in-list pages)]) (path-replace-extension (file-name-from-path page) #"")))
    (define warnings (open-output-string))
    (define collected
      (parameterize ([current-error-port warnings])
        (send renderer collect documents names (send renderer traverse documents names))))
    (values (for/seteq ([key (in-hash-keys (collect-info-ht collected))]
                        #:when (and (pair? key) (eq? 'def (first key))
                                    (equal? '(lib "raytrace/main.rkt") (first (second key)))))
              (second (second key)))
            (get-output-string warnings)))

  ;; What (require raytrace) binds.
  (define (provided-names)
    (define-values (values syntaxes) (module->exports 'raytrace))
    (for*/seteq ([phase (in-list (append values syntaxes))] #:when (eqv? 0 (car phase))
                 [export (in-list (cdr phase))])
      (car export)))

  (test-case "every export has an entry, and nothing else has one"
    (define-values (defined warnings) (defined-names (list reference-file view-file)))
    (define provided (begin (dynamic-require 'raytrace #f) (provided-names)))
    (check-true (> (set-count provided) 300))
    (check-equal? (sort (set->list (set-subtract provided defined)) symbol<?) '())
    (check-equal? (sort (set->list (set-subtract defined provided)) symbol<?) '())
    (check-equal? (regexp-match* #rx"multiple times: '[(]def [^\n]*" warnings) '()))

  ;; ----------------------------------------------------------------------------------------------

  ;; The forms between @racketblock[ and its ], for every page.
  (define programs
    (for*/list ([file (in-list (directory-list reference-folder #:build? #t))]
                #:when (path-has-extension? file #".scrbl")
                [found (in-list (regexp-match* #px"@racketblock\\[\n(.*?)\n\\]\n" (file->string file)
                                               #:match-select cadr))])
      (cons (file-name-from-path file) found)))

  ;; Without comments, which such a block writes as forms, and what only a module may say.
  (define (bare form)
    (cond
      [(list? form)
       (for/list ([part (in-list form)] #:unless (and (pair? part) (memq (car part) '(code:comment provide))))
         (bare part))]
      [else form]))

  (test-case "programs"
    (check-true (>= (length programs) 11))
    (define loaded (current-namespace))
    (dynamic-require 'raytrace #f)
    (for ([program (in-list programs)])
      (define namespace (make-base-namespace))
      (namespace-attach-module loaded 'raytrace namespace)
      (parameterize ([current-namespace namespace])
        (namespace-require 'raytrace)
        (namespace-require 'racket/math)
        (with-check-info (['page (car program)])
          (check-not-exn
           (lambda ()
             (define in (open-input-string (cdr program)))
             (for ([form (in-list (bare (for/list ([form (in-port read in)]) form)))]) (eval form)))))))))
