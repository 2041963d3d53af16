#lang typed/racket/base
;; A material's kernel at a bench: a scratch with one surface in it, for the tests of materials.
;; Directions and weights are flvectors of three.
(require (only-in racket/flonum in-flvector)
         "../../private/base/unsafe.rkt" "../../private/base/registers.rkt"
         "../../private/sample/sampler.rkt" "../../private/material/material.rkt"
         "../../private/material/kernel.rkt" "../../private/material/kernels.rkt")

(provide make-bench bench-kernel face! draw! evaluate! sampled-direction sampled-weight
         sampled-density specular-sample? dot unit reflected direction-at to-local local-density
         local-value NORMAL INCIDENCES close?)

(: unit (-> Flonum Flonum Flonum FlVector))
(define (unit x y z)
  (define s (fl/ 1.0 (flsqrt (fl+ (fl* x x) (fl+ (fl* y y) (fl* z z))))))
  (flvector (fl* s x) (fl* s y) (fl* s z)))

;; A normal in general position, and the ten angles of incidence, in degrees, of every furnace.
(define NORMAL (unit 1.0 -2.0 3.0))
(define INCIDENCES '(0.0 10.0 20.0 30.0 40.0 50.0 60.0 70.0 80.0 89.0))

(struct bench ([r : FlVector] [i : FxVector] [kernel : MaterialKernel]))
(: make-bench (-> Material bench))
(define (make-bench material)
  (bench (make-flonum-registers) (make-fixnum-registers) (Material-kernel material)))

(: dot (-> FlVector FlVector Flonum))
(define (dot a b)
  (fl+ (fl* (flvector-ref a 0) (flvector-ref b 0))
       (fl+ (fl* (flvector-ref a 1) (flvector-ref b 1))
            (fl* (flvector-ref a 2) (flvector-ref b 2)))))

(: cross (-> FlVector FlVector FlVector))
(define (cross a b)
  (define (component [j : Fixnum] [k : Fixnum])
    (fl- (fl* (flvector-ref a j) (flvector-ref b k)) (fl* (flvector-ref a k) (flvector-ref b j))))
  (flvector (component 1 2) (component 2 0) (component 0 1)))

;; x a + y b + z c.
(: combine (-> Flonum FlVector Flonum FlVector Flonum FlVector FlVector))
(define (combine x a y b z c)
  (define (component [k : Fixnum])
    (fl+ (fl* x (flvector-ref a k)) (fl+ (fl* y (flvector-ref b k)) (fl* z (flvector-ref c k)))))
  (flvector (component 0) (component 1) (component 2)))

;; The mirror image of a direction that points away from the surface.
(: reflected (-> FlVector FlVector FlVector))
(define (reflected v n) (combine (fl* 2.0 (dot v n)) n -1.0 v 0.0 v))

;; A frame around a normal, unlike the one the kernels build.
(: frame-tangent-of (-> FlVector FlVector))
(define (frame-tangent-of n)
  (define c (cross (if (fl< (flabs (flvector-ref n 1)) 0.9) (flvector 0.0 1.0 0.0) (flvector 1.0 0.0 0.0))
                   n))
  (unit (flvector-ref c 0) (flvector-ref c 1) (flvector-ref c 2)))

(: from-local (-> FlVector Flonum Flonum Flonum FlVector))
(define (from-local n x y z)
  (define tangent (frame-tangent-of n))
  (combine x tangent y (cross n tangent) z n))

(: to-local (-> FlVector FlVector FlVector))
(define (to-local n d)
  (define tangent (frame-tangent-of n))
  (flvector (dot d tangent) (dot d (cross n tangent)) (dot d n)))

;; The unit direction at an angle to the normal, in degrees, and an azimuth around it, in radians.
(: direction-at (->* (FlVector Flonum) (Flonum) FlVector))
(define (direction-at n degrees [azimuth 0.0])
  (define theta (fl* degrees 0.017453292519943295))
  (from-local n (fl* (flsin theta) (flcos azimuth)) (fl* (flsin theta) (flsin azimuth))
              (flcos theta)))

(: put! (-> FlVector Fixnum FlVector Void))
(define (put! r place v)
  (for ([k (in-range 3)]) (flvector-set! r (fx+ place k) (flvector-ref v k))))

;; Puts a surface with these normals into the scratch, seen from the direction out by a ray that
;; came `distance` far; its direction is two units long.
(: face! (->* (bench FlVector)
              (#:normal FlVector #:shading-normal FlVector #:inside? Boolean #:distance Flonum)
              Void))
(define (face! b out #:normal [normal NORMAL] #:shading-normal [shading-normal normal]
               #:inside? [inside? #f] #:distance [distance 1.0])
  (define r (bench-r b))
  (put! r out-direction out)
  (put! r ray-direction (combine -2.0 out 0.0 out 0.0 out))
  (flvector-set! r hit-t (fl/ distance 2.0))
  (put! r surface-normal normal)
  (put! r surface-shading-normal shading-normal)
  (fxvector-set! (bench-i b) surface-inside (if inside? 1 0)))

;; Samples with the numbers of a pixel: those of different pixels are independent, those of one
;; pixel at ascending indices a low-discrepancy sequence.
(: draw! (->* (bench Fixnum) (Fixnum) Void))
(define (draw! b pixel [index 0])
  (Sampler-start! (bench-i b) pixel 1 index)
  ((MaterialKernel-sample (bench-kernel b)) (bench-r b) (bench-i b)))

(: evaluate! (-> bench FlVector Void))
(define (evaluate! b direction)
  (put! (bench-r b) in-direction direction)
  ((MaterialKernel-evaluate (bench-kernel b)) (bench-r b) (bench-i b)))

(: triple (-> bench Fixnum FlVector))
(define (triple b place)
  (define r (bench-r b))
  (flvector (flvector-ref r place) (flvector-ref r (fx+ place 1)) (flvector-ref r (fx+ place 2))))

(: sampled-direction (-> bench FlVector))
(define (sampled-direction b) (triple b in-direction))
(: sampled-weight (-> bench FlVector))
(define (sampled-weight b) (triple b bsdf-weight))
(: sampled-density (-> bench Flonum))
(define (sampled-density b) (flvector-ref (bench-r b) bsdf-density))
(: specular-sample? (-> bench Boolean))
(define (specular-sample? b) (fl= (sampled-density b) +inf.0))

;; Whether all three components are within an absolute tolerance.
(: close? (-> FlVector (Listof Real) Real Boolean))
(define (close? v expected tolerance)
  (for/and : Boolean ([x (in-flvector v)] [e (in-list expected)])
    (<= (abs (- x e)) tolerance)))

;; Density, and a component of value times cosine, for local coordinates around NORMAL.
(: local-density (-> bench Flonum Flonum Flonum Flonum))
(define (local-density b x y z)
  (evaluate! b (from-local NORMAL x y z))
  (sampled-density b))
(: local-value (-> bench Fixnum Flonum Flonum Flonum Flonum))
(define (local-value b component x y z)
  (evaluate! b (from-local NORMAL x y z))
  (flvector-ref (bench-r b) (fx+ bsdf-weight component)))
