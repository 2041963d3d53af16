#lang racket/base
;; How one public name serves as constructor, match pattern and type, from typed and untyped code
;; alike: a typed module says define-constructor, the surface module says define-surface.
(require racket/match typed/untyped-utils (for-syntax racket/base racket/syntax))

(provide define-constructor define-surface)

;; (define-constructor Name make-Name (field ...)), in the typed module that has the struct Name:
;; Name/public is a type, a match pattern over the fields, and as an expression make-Name.
;; #:struct says where the fields are among those of the struct, when it has more.
(define-syntax (define-constructor stx)
  (syntax-case stx ()
    [(_ name make (field ...)) #'(define-constructor name make (field ...) #:struct (field ...))]
    [(_ name make (field ...) #:struct (place ...))
     (with-syntax ([public (format-id #'name "~a/public" #'name)]
                   [public-id (format-id #'name "~a/public-id" #'name)]
                   [define-type (datum->syntax #'name 'define-type)])
       #'(begin
           (define-type public name #:omit-define-syntaxes)
           (define-match-expander public
             (lambda (pattern)
               (syntax-case pattern () [(_ field ...) #'(name place ...)]))
             (lambda (use)
               (syntax-case use ()
                 [(_ . arguments) (syntax/loc use (make . arguments))]
                 [_ #'make])))
           (begin-for-syntax (define public-id #'public) (provide public-id))))]))

;; (define-surface Name (field ...)), in the untyped surface module, which requires the typed ones
;; with the prefix struct: -- provides Name as typed code sees it, and the same for untyped code, which
;; calls the constructor through that module's call-checked and has it as a value from its checked.
;; With #:numbers a call with as many real numbers as fields goes the short way.
(define-syntax (define-surface stx)
  (syntax-case stx ()
    [(_ name (field ...)) #'(define-surface name (field ...) #:struct (field ...))]
    [(_ name (field ...) #:numbers) #'(define-surface name (field ...) #:struct (field ...) #:numbers)]
    [(_ name (field ...) #:struct (place ...) . numbers)
     (with-syntax ([public-id (format-id #'name "struct:~a/public-id" #'name)]
                   [make (format-id #'name "struct:make-~a" #'name)]
                   [call-checked (format-id #'name "call-checked")]
                   [checked (format-id #'name "checked")]
                   [struct-name (format-id #'name "struct:~a" #'name)]
                   [numbers? (pair? (syntax-e #'numbers))]
                   [(value ...) (generate-temporaries #'(field ...))])
       #'(begin
           (define-match-expander untyped-name
             (lambda (pattern)
               (syntax-case pattern () [(_ field ...) #'(struct-name place ...)]))
             (lambda (use)
               (syntax-case use ()
                 [(_ field ...)
                  numbers?
                  (syntax/loc use
                    (let ([value field] ...)
                      (if (and (real? value) ...)
                          (make value ...)
                          (call-checked 'name make value ...))))]
                 [(_ . arguments) (syntax/loc use (call-checked 'name make . arguments))]
                 [_ #'(checked 'name make)])))
           (define-syntax (define-it use)
             (syntax-case use ()
               [(_ id) #`(define-typed/untyped-identifier id #,public-id untyped-name)]))
           (define-it name)
           (provide name)))]))
