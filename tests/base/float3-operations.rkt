#lang typed/racket/base
;; Every operation on Float3 twice: as the ordinary function, and fused under let-float3. Vectors
;; and results are lists of flonums.
(require (for-syntax racket/base) "../../private/base/float3.rkt" racket/flonum)

(provide operations float3-list)

(define-type Numbers (Listof Flonum))

(: float3-list (-> Float3 Numbers))
(define (float3-list v) (list (Float3-x/function v) (Float3-y/function v) (Float3-z/function v)))

(: vector-from (-> Numbers Float3))
(define (vector-from l) (make-Float3 (car l) (cadr l) (caddr l)))

(define-type Versions (List Symbol (Listof Symbol) (-> (Listof Numbers) Numbers)
                            (-> (Listof Numbers) Numbers)))

;; (versions name (kind ...) result): kind is v for a vector, s for a scalar.
(define-syntax (versions stx)
  (syntax-case stx ()
    [(_ name (kind ...) result)
     (with-syntax ([(a ...) (generate-temporaries #'(kind ...))]
                   [(place ...) (for/list ([k (in-range (length (syntax->list #'(kind ...))))]) k)])
       #'(list 'name '(kind ...)
               (lambda ([l : (Listof Numbers)])
                 (let ([function name])
                   (as-numbers result (function (argument kind (list-ref l place)) ...))))
               (lambda ([l : (Listof Numbers)])
                 (bind-arguments ([a kind (argument kind (list-ref l place))] ...)
                   (fused-numbers result (name a ...))))))]))

(define-syntax (argument stx)
  (syntax-case stx ()
    [(_ kind e) (if (eq? 'v (syntax-e #'kind)) #'(vector-from e) #'(car e))]))

(define-syntax (bind-arguments stx)
  (syntax-case stx ()
    [(_ () body) #'body]
    [(_ ([a kind e] more ...) body)
     (if (eq? 'v (syntax-e #'kind))
         #'(let-float3 ([a e]) (bind-arguments (more ...) body))
         #'(let ([a e]) (bind-arguments (more ...) body)))]))

(define-syntax (as-numbers stx)
  (syntax-case stx ()
    [(_ result e) (if (eq? 'v (syntax-e #'result)) #'(float3-list e) #'(list e))]))

;; A fused vector's components, as kernels read them.
(define-syntax (fused-numbers stx)
  (syntax-case stx ()
    [(_ result e)
     (if (eq? 'v (syntax-e #'result))
         #'(let ([place (make-flvector 5 7.0)])
             (Float3-put! place 1 e)
             (unless (and (fl= 7.0 (flvector-ref place 0)) (fl= 7.0 (flvector-ref place 4)))
               (error "Float3-put! wrote beside its places"))
             (float3-list (Float3-in place 1)))
         #'(list e))]))

(: operations (Listof Versions))
(define operations
  (list (versions Float3 (s s s) v)
        (versions Float3-x (v) s) (versions Float3-y (v) s) (versions Float3-z (v) s)
        (versions Float3-add (v v) v)
        (versions Float3-subtract (v v) v)
        (versions Float3-negate (v) v)
        (versions Float3-scale-by-scalar (v s) v)
        (versions Float3-scale-by-vector (v v) v)
        (versions Float3-multiply-add (v s v) v)
        (versions Float3-dot (v v) s)
        (versions Float3-cross (v v) v)
        (versions Float3-length-squared (v) s)
        (versions Float3-length (v) s)
        (versions Float3-distance (v v) s)
        (versions Float3-normalized (v) v)
        (versions Float3-reflect (v v) v)
        (versions Float3-clamped (v s s) v)
        (versions Float3-linear-interpolate (v v s) v)
        (versions Float3-largest-component (v) s)
        (versions Float3-largest-magnitude (v) s)
        (list 'nested '(v v s)
              (lambda ([l : (Listof Numbers)])
                (define-values (a b s)
                  (values (vector-from (car l)) (vector-from (cadr l)) (car (caddr l))))
                (float3-list
                 (Float3-normalized/function
                  (Float3-multiply-add/function
                   (Float3-cross/function a (Float3-subtract/function b a))
                   s (Float3-reflect/function b a)))))
              (lambda ([l : (Listof Numbers)])
                (let-float3 ([a (vector-from (car l))] [b (vector-from (cadr l))])
                  (let ([s (car (caddr l))])
                    (fused-numbers v (Float3-normalized
                                      (Float3-multiply-add
                                       (Float3-cross a (Float3-subtract b a))
                                       s (Float3-reflect b a))))))))))

;; The two that the module keeps to itself, by the operation's name used as a value.
(define Float3-normalized/function : (-> Float3 Float3) Float3-normalized)
(define Float3-multiply-add/function : (-> Float3 Real Float3 Float3) Float3-multiply-add)
