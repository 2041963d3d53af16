#lang racket/base
;; Worlds as messages: a value made of the library's structs becomes vectors a place channel carries,
;; and the same value again on the other side, field by field, with no constructor's arithmetic in
;; between.
(require racket/flonum
         (only-in "../base/float3.rkt" make-Float3)
         (only-in "../world/world.rkt" make-World World? World-shapes World-lights
                  World-background World-shading World-from-parts)
         (only-in "../world/camera.rkt" Camera-look-at)
         (only-in "../world/background.rkt" make-GradientSky)
         (only-in "../shape/sphere.rkt" make-Sphere)
         (only-in "../light/distant.rkt" make-DistantLight)
         (only-in "../light/point.rkt" make-PointLight)
         (only-in "../material/phong.rkt" make-Phong)
         (only-in "../material/emitter.rkt" make-Emitter)
         (only-in "../material/lambertian.rkt" make-Lambertian)
         (only-in "pixel.rkt" Tiling)
         (only-in "job.rkt" Job))

(provide value->message message->value)

;; One value of every struct a Job may hold; World is apart, for it holds a promise. What a value
;; says of its own struct type is enough to build others of it.
(define examples
  (let* ([zero (make-Float3 0 0 0)]
         [up (make-Float3 0 1 0)]
         [world (make-World '() '() zero)]
         [camera (Camera-look-at up zero (make-Float3 1 0 0))]
         [tiling (Tiling 1 1 1 '(0 0 1 1))])
    (list zero (World-shading world) camera tiling (Job world camera tiling 1 0 'auto #f)
          (make-GradientSky zero zero) (make-Sphere zero 1)
          (make-DistantLight up zero) (make-PointLight zero zero)
          (make-Phong zero) (make-Emitter zero) (make-Lambertian zero))))

(define (value-type value)
  (define-values (type skipped?) (struct-info value))
  type)

(define (struct-type-name type)
  (define-values (name own auto ref set immutables super skipped?) (struct-type-info type))
  name)

(define constructors
  (for/hasheq ([example (in-list examples)])
    (define type (value-type example))
    (values (struct-type-name type) (struct-type-make-constructor type))))

;; value->message : raises where the value holds a procedure or a struct that is not listed.
(define (value->message value)
  (cond
    [(or (number? value) (boolean? value) (symbol? value) (string? value) (null? value)) value]
    [(pair? value) (cons (value->message (car value)) (value->message (cdr value)))]
    [(World? value)
     (vector 'World (value->message (World-shapes value)) (value->message (World-lights value))
             (value->message (World-background value)) (value->message (World-shading value)))]
    [(flvector? value) (vector 'flvector (shared-copy value))]
    [(struct? value)
     (define fields (struct->vector value))
     (define type (value-type value))
     (define name (and type (struct-type-name type)))
     (unless (hash-has-key? constructors name)
       (raise-user-error (format "a ~a cannot be sent to another place" (or name "struct"))))
     (for/vector #:length (vector-length fields)
       ([field (in-vector fields)] [k (in-naturals)])
       (if (zero? k) name (value->message field)))]
    [else (raise-user-error (format "a world that holds ~e cannot be sent to another place"
                                    value))]))

(define (shared-copy v)
  (define copy (make-shared-flvector (flvector-length v)))
  (for ([x (in-flvector v)] [k (in-naturals)]) (flvector-set! copy k x))
  copy)

(define (message->value message)
  (cond
    [(pair? message) (cons (message->value (car message)) (message->value (cdr message)))]
    [(vector? message)
     (define fields (for/list ([field (in-vector message 1)]) (message->value field)))
     (case (vector-ref message 0)
       [(World) (apply World-from-parts fields)]
       [(flvector) (vector-ref message 1)]
       [else (apply (hash-ref constructors (vector-ref message 0)) fields)])]
    [else message]))
