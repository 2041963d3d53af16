#lang racket/base
;; Calls of public constructors by untyped code: what types have to say of a wrong argument is told in
;; one line that names the constructor, the argument and what was expected.
(require racket/lazy-require)

(provide call-checked checked)

(lazy-require ["arguments.rkt" (raise-wrong-argument)])

;; call-checked : (call-checked name make argument ...), with keywords too, is (make argument ...).
(define call-checked
  (make-keyword-procedure
   (lambda (keywords values name make . arguments)
     (with-handlers ([exn:fail:contract?
                      (retold name make arguments keywords values)])
       (keyword-apply make keywords values arguments)))
   (lambda (name make . arguments)
     (with-handlers ([exn:fail:contract? (retold name make arguments '() '())])
       (apply make arguments)))))

;; checked : the constructor as a value, under its public name.
(define (checked name make)
  (procedure-rename
   (make-keyword-procedure
    (lambda (keywords values . arguments)
      (keyword-apply call-checked keywords values name make arguments))
    (lambda arguments (apply call-checked name make arguments)))
   name))

;; What the constructor says itself of a number out of range is well told.
(define ((retold name make arguments keywords values) failure)
  (raise-wrong-argument name make arguments keywords values)
  (raise failure))
