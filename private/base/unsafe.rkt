#lang typed/racket/base
;; The one file with unsafe operations: kernels take flvector, fxvector and fixnum operations from here.
;; Set `safe?` to #t and recompile to get every bounds and type check back.
(require (for-syntax racket/base) racket/flonum racket/fixnum "unsafe-typed.rkt"
         (only-in racket/unsafe/ops unsafe-fxior unsafe-fxlshift))

(define-syntax (define-checked-or-unsafe stx)
  (define safe? #f)
  (define (private-name name) (string->symbol (format "chosen:~a" name)))
  (syntax-case stx ()
    [(_ [name checked unchecked] ...)
     (let ([names (syntax->datum #'(name ...))]
           [operations (syntax->datum (if safe? #'(checked ...) #'(unchecked ...)))])
       (datum->syntax
        stx
        `(begin
           (require (only-in ,(if safe?
                                  '(combine-in racket/flonum racket/fixnum racket/base)
                                  'racket/unsafe/ops)
                             ,@(for/list ([n names] [o operations]) `[,o ,(private-name n)])))
           (provide (rename-out ,@(for/list ([n names]) `[,(private-name n) ,n]))))))]))

(define-checked-or-unsafe
  [flvector-ref flvector-ref unsafe-flvector-ref]
  [flvector-set! flvector-set! unsafe-flvector-set!]
  [vector-ref vector-ref unsafe-vector-ref]
  [fx+ fx+ unsafe-fx+]
  [fx- fx- unsafe-fx-]
  [fx* fx* unsafe-fx*]
  [fx= fx= unsafe-fx=]
  [fx< fx< unsafe-fx<]
  [fx> fx> unsafe-fx>]
  [fx<= fx<= unsafe-fx<=]
  [fx>= fx>= unsafe-fx>=]
  [fxand fxand unsafe-fxand]
  [fxior fxior unsafe-fxior]
  [fxxor fxxor unsafe-fxxor]
  [fxlshift fxlshift unsafe-fxlshift]
  [fxrshift fxrshift unsafe-fxrshift]
  [fxquotient fxquotient unsafe-fxquotient]
  [fxremainder fxremainder unsafe-fxremainder]
  [fx->fl fx->fl unsafe-fx->fl]
  [fl->fx fl->fx unsafe-fl->fx])

;; Typed Racket takes only literals of 30 bits as Fixnum; the compiler folds this to a constant.
(define-syntax (fixnum-literal stx)
  (syntax-case stx ()
    [(_ n)
     (let ([value (syntax-e #'n)])
       #`(unsafe-fxior (unsafe-fxlshift #,(arithmetic-shift value -24) 24)
                       #,(bitwise-and value #xFFFFFF)))]))

;; Typed Racket 8.7 has no types for these; fixnum in, fixnum out is all they do.
(unsafe-require/typed racket/unsafe/ops
  [(unsafe-fxvector-ref fxvector-ref) (-> FxVector Fixnum Fixnum)]
  [(unsafe-fxvector-set! fxvector-set!) (-> FxVector Fixnum Fixnum Void)])
(unsafe-require/typed racket/fixnum
  [fx*/wraparound (-> Fixnum Fixnum Fixnum)]
  [fx+/wraparound (-> Fixnum Fixnum Fixnum)])

(provide fxvector-ref fxvector-set! fixnum-literal fx*/wraparound fx+/wraparound
         fl+ fl- fl* fl/ fl< fl> fl<= fl>= fl= flabs flsqrt flfloor flmin flmax
         flsin flcos fltan flexp fllog flatan flasin flacos flexpt fltruncate
         flvector make-flvector flvector-length flvector-copy
         fxvector make-fxvector fxvector-length fxvector-copy)
