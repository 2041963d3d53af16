#lang typed/racket/base
;; Operations on Float3: each is defined once, fuses in kernels (see fuse.rkt), and is the ordinary
;; function `name/function` that the public surface exports under the plain name.
(require (for-syntax racket/base) "fuse.rkt" "unsafe.rkt" "public.rkt" "check.rkt")

(provide (rename-out [Float3/kernel Float3]
                     [Float3-x/kernel Float3-x] [Float3-y/kernel Float3-y]
                     [Float3-z/kernel Float3-z])
         Float3? let-float3 define-float3-operation
         make-Float3 Float3-normalized/checked Float3-in Float3-put!
         Float3-add Float3-subtract Float3-negate Float3-scale-by-scalar Float3-scale-by-vector
         Float3-dot Float3-cross Float3-length-squared Float3-length Float3-normalized
         Float3-reflect Float3-clamped Float3-linear-interpolate Float3-distance
         Float3-largest-component Float3-largest-magnitude Float3-multiply-add
         Float3-x/function Float3-y/function Float3-z/function
         Float3-add/function Float3-subtract/function Float3-negate/function
         Float3-scale-by-scalar/function Float3-scale-by-vector/function
         Float3-dot/function Float3-cross/function Float3-length-squared/function
         Float3-length/function Float3-reflect/function Float3-clamped/function
         Float3-linear-interpolate/function Float3-distance/function)

;; The constructor as an operation, and the type of the same name.
(define-type Float3/kernel Float3 #:omit-define-syntaxes)
(define-float3-operation (Float3/kernel [x : Flonum] [y : Flonum] [z : Flonum]) : Float3 (x y z))

;; make-Float3 : a point, direction or linear RGB colour from any three real numbers.
(: make-Float3 (-> Real Real Real Float3))
(define (make-Float3 x y z)
  (Float3 (real->double-flonum x) (real->double-flonum y) (real->double-flonum z)))

(define-constructor Float3 make-Float3 (x y z))

;; Component-wise sum.
(define-float3-operation (Float3-add [(ax ay az) : Float3] [(bx by bz) : Float3])
  : Float3 ((fl+ ax bx) (fl+ ay by) (fl+ az bz)))

;; Component-wise difference a - b.
(define-float3-operation (Float3-subtract [(ax ay az) : Float3] [(bx by bz) : Float3])
  : Float3 ((fl- ax bx) (fl- ay by) (fl- az bz)))

;; The opposite vector.
(define-float3-operation (Float3-negate [(x y z) : Float3])
  : Float3 ((fl* -1.0 x) (fl* -1.0 y) (fl* -1.0 z)))

;; Every component times s.
(define-float3-operation (Float3-scale-by-scalar [(x y z) : Float3] [s : Flonum])
  : Float3 ((fl* x s) (fl* y s) (fl* z s)))

;; Component-wise product, as for a light's colour on a surface's colour.
(define-float3-operation (Float3-scale-by-vector [(ax ay az) : Float3] [(bx by bz) : Float3])
  : Float3 ((fl* ax bx) (fl* ay by) (fl* az bz)))

;; a + s b: the point at parameter s along b from a.
(define-float3-operation
  (Float3-multiply-add [(ax ay az) : Float3] [s : Flonum] [(bx by bz) : Float3])
  : Float3 ((fl+ ax (fl* s bx)) (fl+ ay (fl* s by)) (fl+ az (fl* s bz))))

;; Dot product.
(define-float3-operation (Float3-dot [(ax ay az) : Float3] [(bx by bz) : Float3])
  : Flonum (fl+ (fl+ (fl* ax bx) (fl* ay by)) (fl* az bz)))

;; Right-handed cross product: x cross y is z. (The published program flips the sign of y.)
(define-float3-operation (Float3-cross [(ax ay az) : Float3] [(bx by bz) : Float3])
  : Float3 ((fl- (fl* ay bz) (fl* az by))
            (fl- (fl* az bx) (fl* ax bz))
            (fl- (fl* ax by) (fl* ay bx))))

;; Squared Euclidean length.
(define-float3-operation (Float3-length-squared [(x y z) : Float3])
  : Flonum (fl+ (fl+ (fl* x x) (fl* y y)) (fl* z z)))

;; Euclidean length.
(define-float3-operation (Float3-length [(x y z) : Float3])
  : Flonum (flsqrt (fl+ (fl+ (fl* x x) (fl* y y)) (fl* z z))))

;; Euclidean distance between two points.
(define-float3-operation (Float3-distance [(ax ay az) : Float3] [(bx by bz) : Float3])
  #:let ([x (fl- ax bx)] [y (fl- ay by)] [z (fl- az bz)])
  : Flonum (flsqrt (fl+ (fl+ (fl* x x) (fl* y y)) (fl* z z))))

;; The unit vector of the same direction; in kernels NaN for the zero vector.
(define-float3-operation (Float3-normalized [(x y z) : Float3])
  #:let ([s (fl/ 1.0 (flsqrt (fl+ (fl+ (fl* x x) (fl* y y)) (fl* z z))))])
  : Float3 ((fl* x s) (fl* y s) (fl* z s)))

;; Mirror image of a vector that points away from the surface: 2 (v.n) n - v for a unit normal of
;; either side. (The published program reflects wrongly where v.n is negative.)
(define-float3-operation (Float3-reflect [(vx vy vz) : Float3] [(nx ny nz) : Float3])
  #:let ([s (fl* 2.0 (fl+ (fl+ (fl* vx nx) (fl* vy ny)) (fl* vz nz)))])
  : Float3 ((fl- (fl* s nx) vx) (fl- (fl* s ny) vy) (fl- (fl* s nz) vz)))

;; Every component brought into [low, high].
(define-float3-operation (Float3-clamped [(x y z) : Float3] [low : Flonum] [high : Flonum])
  : Float3 ((flmin high (flmax low x)) (flmin high (flmax low y)) (flmin high (flmax low z))))

;; (1 - s) a + s b.
(define-float3-operation
  (Float3-linear-interpolate [(ax ay az) : Float3] [(bx by bz) : Float3] [s : Flonum])
  : Float3 ((fl+ (fl* (fl- 1.0 s) ax) (fl* s bx))
            (fl+ (fl* (fl- 1.0 s) ay) (fl* s by))
            (fl+ (fl* (fl- 1.0 s) az) (fl* s bz))))

;; The largest component, and the largest absolute value of a component.
(define-float3-operation (Float3-largest-component [(x y z) : Float3])
  : Flonum (flmax x (flmax y z)))
(define-float3-operation (Float3-largest-magnitude [(x y z) : Float3])
  : Flonum (flmax (flabs x) (flmax (flabs y) (flabs z))))

;; The vector kept in three consecutive places of an flvector.
(define-float3-operation (Float3-in [v : FlVector] [i : Fixnum])
  : Float3 ((flvector-ref v i) (flvector-ref v (fx+ i 1)) (flvector-ref v (fx+ i 2))))

;; One component; of a fused vector it costs nothing.
(define-float3-operation (Float3-x/kernel [(x y z) : Float3]) : Flonum x)
(define-float3-operation (Float3-y/kernel [(x y z) : Float3]) : Flonum y)
(define-float3-operation (Float3-z/kernel [(x y z) : Float3]) : Flonum z)
(define Float3-x/function Float3-x)
(define Float3-y/function Float3-y)
(define Float3-z/function Float3-z)

;; Writes a vector into three consecutive places of a worker's scratch.
(define-syntax-rule (Float3-put! v i expression)
  (let-float3 ([whole expression])
    (flvector-set! v i (Float3-x/kernel whole))
    (flvector-set! v (fx+ i 1) (Float3-y/kernel whole))
    (flvector-set! v (fx+ i 2) (Float3-z/kernel whole))))

;; Float3-normalized as a function: the unit vector; raises for a zero, infinite or NaN vector. Repeated
;; until nothing changes, so that normalizing twice is normalizing once.
(: Float3-normalized/checked (-> Float3 Float3))
(define (Float3-normalized/checked v)
  (define largest (Float3-largest-magnitude v))
  (unless (and (fl> largest 0.0) (fl< largest +inf.0))
    (raise-expected 'Float3-normalized "vector" "a finite vector other than zero" v))
  (let again ([n : Float3 (normalized-once v)] [tries : Fixnum 8])
    (define next (normalized-once n))
    (cond
      [(equal? next n) n]
      [(fx> tries 0) (again next (fx- tries 1))]
      [else (if (fl< (coordinate-sum n) (coordinate-sum next)) n next)]))) ; two take turns

(: coordinate-sum (-> Float3 Flonum))
(define (coordinate-sum v) (fl+ (fl+ (Float3-x v) (fl* 3.0 (Float3-y v))) (fl* 7.0 (Float3-z v))))

;; Divided by the largest component first, so that squares neither overflow nor vanish.
(: normalized-once (-> Float3 Float3))
(define (normalized-once v)
  (define largest (Float3-largest-magnitude v))
  (let-float3 ([scaled (Float3 (fl/ (Float3-x v) largest)
                               (fl/ (Float3-y v) largest)
                               (fl/ (Float3-z v) largest))])
    (Float3-normalized scaled)))
