#lang racket/base
;; Values print as expressions that make them again. Most structs do by themselves, for their
;; constructors take their fields; here are those whose constructors take something else.
(require (only-in racket/struct make-constructor-style-printer))

(provide print-struct print-call)

;; print-struct : writes a transparent struct to the port as its constructor's call; mode as
;; prop:custom-write has it. A procedure or a picture in it prints as what it is.
(define (print-struct value port mode)
  (define parts (struct->vector value))
  (define name
    (string->symbol (substring (symbol->string (vector-ref parts 0)) (string-length "struct:"))))
  (define fields (cdr (vector->list parts)))
  (define (field k) (list-ref fields k))
  (define (call positional . keywords+values)
    (print-call name positional keywords+values port mode))
  (case name
    [(Cylinder Cone)
     (call (list (field 0) (field 1) (field 2) (field 3)) '#:caps? (field 4) #t)]
    ;; a composite's first field is how deep it nests
    [(Group Moving) (call (cdr fields))]
    [(Instance SolidUnion SolidIntersection SolidDifference)
     (call (list (field 1) (field 2)) '#:material (field 3) #f)]
    [(DistanceShape)
     (call (list (field 0) (field 1) (field 2))
           '#:error (field 3) (void) '#:lipschitz (field 4) 1.0 '#:material (field 5) (void))]
    [(CustomShape)
     (call (list (field 0) (field 1) (field 2))
           '#:error (field 3) 0.0 '#:uv (field 4) #f '#:material (field 5) (void))]
    [(EnvironmentMap)
     (call (list (field 0))
           '#:rotation-degrees (radians->degrees (field 1)) 0.0 '#:scale (field 2) 1.0)]
    [else (call fields)]))

;; print-call : writes (name argument ... #:keyword argument ...). keywords+values: by threes a
;; keyword, its argument, and the default, at which it is left out.
(define (print-call name positional keywords+values port mode)
  (define keyword-arguments
    (let next ([left keywords+values])
      (cond
        [(null? left) '()]
        [(equal? (cadr left) (caddr left)) (next (cdddr left))]
        [else (list* (unquoted-printing-string (format "~s" (car left))) (cadr left)
                     (next (cdddr left)))])))
  ((make-constructor-style-printer (lambda (value) name)
                                   (lambda (value) (append positional keyword-arguments)))
   name port mode))

;; Degrees that become the same radians again, where there are such.
(define (radians->degrees radians)
  (define near (/ radians (/ 3.141592653589793 180.0)))
  (or (for*/first ([step (in-list '(0 1 -1 2 -2))]
                   [degrees (in-value (* near (+ 1.0 (* step 1.1102230246251565e-16 2.0))))]
                   #:when (= radians (* degrees (/ 3.141592653589793 180.0))))
        degrees)
      near))
