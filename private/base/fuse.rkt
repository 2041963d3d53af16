#lang typed/racket/base
;; Float3 and the macros that make operations on it fuse: inside let-float3, and inside each
;; other, operations stay three flonum locals and allocate nothing; elsewhere they are functions.
(require racket/flonum
         (only-in racket/base let let*) ; typed ones take longer to expand
         (for-syntax racket/base racket/syntax syntax/parse (for-syntax racket/base)))

(provide (struct-out Float3) let-float3 define-float3-operation
         (for-syntax float3-operation-function))

;; A point, a direction or a linear RGB colour.
(struct Float3 ([x : Flonum] [y : Flonum] [z : Flonum]) #:transparent)

(begin-for-syntax
  ;; a name bound by let-float3: the identifiers of its three components
  (struct float3-local (x y z)
    #:property prop:procedure
    (lambda (self stx)
      (syntax-case stx ()
        [_ (identifier? stx)
           #`(Float3 #,(float3-local-x self) #,(float3-local-y self) #,(float3-local-z self))])))

  ;; an operation: the kinds of its arguments ('float3 or a type) and of its result, the procedure
  ;; from argument atoms to result expressions, and the identifier of the ordinary function
  (struct float3-operation (argument-kinds result-kind expand function)
    #:property prop:procedure
    (lambda (self stx)
      (syntax-case stx ()
        [name (identifier? #'name) (float3-operation-function self)]
        [(_ argument ...)
         (let-values ([(bindings result) (lower-application self stx)])
           (if (eq? (float3-operation-result-kind self) 'float3)
               #`(let* #,bindings (Float3 #,@result))
               #`(let* #,bindings #,result)))])))

  (define (static-value id)
    (and (identifier? id) (syntax-local-value id (lambda () #f))))

  ;; a Float3 expression as let* bindings and three atoms
  (define (lower expression)
    (define (bind-components bindings components)
      (define names (generate-temporaries '(x y z)))
      (values (append bindings
                      (for/list ([name names] [c components]) #`[#,name #,c]))
              names))
    (syntax-case expression ()
      [v (float3-local? (static-value #'v))
         (let ([local (static-value #'v)])
           (values '() (list (float3-local-x local) (float3-local-y local) (float3-local-z local))))]
      [(operation . _)
       (let ([static (static-value #'operation)])
         (and (float3-operation? static) (eq? 'float3 (float3-operation-result-kind static))))
       (call-with-values
        (lambda () (lower-application (static-value #'operation) expression))
        bind-components)]
      [_
       (let ([whole (car (generate-temporaries '(v)))])
         (bind-components (list #`[#,whole #,expression])
                          (list #`(Float3-x #,whole) #`(Float3-y #,whole) #`(Float3-z #,whole))))]))

  (define (lower-application operation stx)
    (define arguments (cdr (syntax->list stx)))
    (define kinds (float3-operation-argument-kinds operation))
    (unless (= (length arguments) (length kinds))
      (raise-syntax-error #f (format "expects ~a arguments" (length kinds)) stx))
    (define-values (bindings atoms)
      (for/fold ([bindings '()] [atoms '()]) ([argument arguments] [kind kinds])
        (cond
          [(eq? kind 'float3)
           (define-values (more components) (lower argument))
           (values (append bindings more) (append atoms (list components)))]
          [else
           (define name (car (generate-temporaries '(s))))
           (values (append bindings (list #`[#,name #,argument]))
                   (append atoms (list name)))])))
    (define-values (shared result) (apply (float3-operation-expand operation) atoms))
    (values (append bindings shared) result)))

;; (let-float3 ([v float3-expression] ...) body ...+) binds like let*, each v as three flonums.
(define-syntax (let-float3 stx)
  (syntax-parse stx
    [(_ () body ...+) #'(let () body ...)]
    [(_ ([v:id expression] more ...) body ...+)
     (define-values (bindings components) (lower #'expression))
     (with-syntax ([(binding ...) bindings] [(x y z) components])
       (syntax/loc stx
         (let* (binding ...)
           (let-syntax ([v (float3-local #'x #'y #'z)])
             (let-float3 (more ...) body ...)))))]))

;; (define-float3-operation (name [(ax ay az) : Float3] [s : Flonum] ...) : Float3 (ex ey ez))
;; or ... : Flonum e): one definition gives the fusing operation and name/function, which takes
;; any real for a Flonum argument. Arguments of other types are passed through. #:let ([s e] ...)
;; before the colon binds flonums that the result shares.
(define-syntax (define-float3-operation stx)
  (define-syntax-class argument
    #:attributes (kind type pattern name value)
    (pattern [(x:id y:id z:id) : (~datum Float3)]
      #:with kind #''float3 #:with type #'Float3 #:with pattern #'(list x y z)
      #:with name (generate-temporary #'x) #:with value #'name)
    (pattern [s:id : (~datum Flonum)]
      #:with kind #'(syntax Flonum) #:with type #'Real #:with pattern #'s
      #:with name (generate-temporary #'s) #:with value #'(real->double-flonum name))
    (pattern [s:id : other-type]
      #:with kind #'(syntax other-type) #:with type #'other-type #:with pattern #'s
      #:with name (generate-temporary #'s) #:with value #'name))
  (syntax-parse stx
    [(_ (operation:id a:argument ...) (~optional (~seq #:let ([shared:id shared-value] ...)))
        (~datum :) result-type:id result)
     #:with function (format-id #'operation "~a/function" #'operation)
     #:with kind (if (eq? (syntax-e #'result-type) 'Float3) #'float3 #'flonum)
     #:with template (if (eq? (syntax-e #'result-type) 'Float3)
                         (with-syntax ([(x y z) #'result]) #'(list #'x #'y #'z))
                         #'#'result)
     #:with (s ...) #'(~? (shared ...) ())
     #:with (s-value ...) #'(~? (shared-value ...) ())
     #'(begin
         (define-syntax operation
           (float3-operation
            (list a.kind ...) 'kind
            (lambda (a.name ...)
              (bind-pattern ([a.pattern a.name] ...)
                (with-syntax ([(s ...) (generate-temporaries #'(s ...))])
                  (values (list #'[s s-value] ...) template))))
            #'function))
         (: function (-> a.type ... result-type))
         (define (function a.name ...) (operation a.value ...)))]))

(begin-for-syntax
  (define-syntax (bind-pattern stx)
    (syntax-case stx (list)
      [(_ () template) #'template]
      [(_ ([(list x y z) name] more ...) template)
       #'(with-syntax ([(x y z) name]) (bind-pattern (more ...) template))]
      [(_ ([s name] more ...) template)
       #'(with-syntax ([s name]) (bind-pattern (more ...) template))])))
