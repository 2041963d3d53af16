#lang typed/racket/base
;; Gradient noise (Perlin, "Improving Noise", 2002) with the gradients at whole points chosen by a
;; hash, so that it needs no table and has no period; and its sums over octaves.
(require "../../base/unsafe.rkt" "../../base/float3.rkt" "../../base/check.rkt"
         "../../sample/hash.rkt")

(provide make-noise perlin-noise perlin-turbulence check-octaves check-seed)

(: check-octaves (-> Symbol Integer Fixnum))
(define (check-octaves who octaves) (check-count who "octaves" octaves 1 32))

(: check-seed (-> Symbol Integer Fixnum))
(define (check-seed who seed) (check-count who "seed" seed 0 #xFFFFFFFF))

;; 6 x^5 - 15 x^4 + 10 x^3: from 0 to 1 with first and second derivatives 0 at both ends.
(define-syntax-rule (fade x)
  (fl* (fl* x (fl* x x)) (fl+ 10.0 (fl* x (fl- (fl* 6.0 x) 15.0)))))

(define-syntax-rule (blend s a b) (fl+ a (fl* s (fl- b a))))

;; The dot product with one of the twelve directions to the edges of a cube, four of them twice.
(define-syntax-rule (along-gradient hash x y z)
  (let* ([h (fxand hash 15)]
         [u (if (fx< h 8) x y)]
         [v (if (fx< h 4) y (if (fx= 12 (fxand h 13)) x z))])
    (fl+ (if (fx= 0 (fxand h 1)) u (fl* -1.0 u))
         (if (fx= 0 (fxand h 2)) v (fl* -1.0 v)))))

;; The hash of a whole number after those before it.
(define-syntax-rule (next-hash before number)
  (hash32 (fxand (fx+ before (fxand number (MASK32))) (MASK32))))

;; Noise at a point, from -1 to 1, 0 at whole points.
(define-syntax-rule (noise-at px py pz key)
  (let* ([x0 (flfloor px)] [y0 (flfloor py)] [z0 (flfloor pz)]
         [i (fl->fx x0)] [j (fl->fx y0)] [k (fl->fx z0)]
         [x (fl- px x0)] [y (fl- py y0)] [z (fl- pz z0)]
         [x-1 (fl- x 1.0)] [y-1 (fl- y 1.0)] [z-1 (fl- z 1.0)]
         [h0 (next-hash key i)] [h1 (next-hash key (fx+ i 1))]
         [h00 (next-hash h0 j)] [h01 (next-hash h0 (fx+ j 1))]
         [h10 (next-hash h1 j)] [h11 (next-hash h1 (fx+ j 1))]
         [u (fade x)] [v (fade y)] [w (fade z)]
         [k+1 (fx+ k 1)])
    (blend w
           (blend v
                  (blend u (along-gradient (next-hash h00 k) x y z)
                         (along-gradient (next-hash h10 k) x-1 y z))
                  (blend u (along-gradient (next-hash h01 k) x y-1 z)
                         (along-gradient (next-hash h11 k) x-1 y-1 z)))
           (blend v
                  (blend u (along-gradient (next-hash h00 k+1) x y z-1)
                         (along-gradient (next-hash h10 k+1) x-1 y z-1))
                  (blend u (along-gradient (next-hash h01 k+1) x y-1 z-1)
                         (along-gradient (next-hash h11 k+1) x-1 y-1 z-1))))))

;; make-noise : a procedure that reads the point at place `from` of a vector, which is multiplied by
;; scale, and writes at place `to` the sum of noise(point) + noise(2 point) / 2 + noise(4 point) / 4
;; and so on. Every octave has gradients of its own.
(: make-noise (-> Flonum Fixnum Fixnum (-> FlVector Fixnum Fixnum Void)))
(define (make-noise scale octaves seed)
  (define first-key (hash32 seed))
  (lambda ([v : FlVector] [from : Fixnum] [to : Fixnum])
    (flvector-set! v to 0.0)
    (let-float3 ([p (Float3-scale-by-scalar (Float3-in v from) scale)])
      (let octave ([k : Fixnum 0] [key : Fixnum first-key]
                   [x : Flonum (Float3-x p)] [y : Flonum (Float3-y p)] [z : Flonum (Float3-z p)]
                   [weight : Flonum 1.0])
        (when (fx< k octaves)
          (flvector-set! v to (fl+ (flvector-ref v to) (fl* weight (noise-at x y z key))))
          (octave (fx+ k 1) (hash32 key)
                  (fl* 2.0 x) (fl* 2.0 y) (fl* 2.0 z) (fl* 0.5 weight)))))))

;; perlin-noise : smooth noise at a point, for textures by a function: from -1 to 1 with mean 0 for
;; one octave; more octaves add detail, and at most double the range. octaves: 1 to 32. seed: 0 to
;; 2^32 - 1.
(: perlin-noise (->* (Float3) (Integer Integer #:octaves Integer #:seed Integer) Flonum))
(define (perlin-noise point [octaves-by-place 1] [seed-by-place 0]
                      #:octaves [octaves octaves-by-place] #:seed [seed seed-by-place])
  (noise-value point (check-octaves 'perlin-noise octaves) (check-seed 'perlin-noise seed)))

(: noise-value (-> Float3 Fixnum Fixnum Flonum))
(define (noise-value point octaves seed)
  (define noise! (make-noise 1.0 octaves seed))
  (define v (flvector (Float3-x point) (Float3-y point) (Float3-z point) 0.0))
  (noise! v 0 3)
  (flvector-ref v 3))

;; perlin-turbulence : the magnitude of the sum over octaves, as in "Ray Tracing: The Next Week".
(: perlin-turbulence (->* (Float3) (Integer Integer #:octaves Integer #:seed Integer) Flonum))
(define (perlin-turbulence point [octaves-by-place 7] [seed-by-place 0]
                           #:octaves [octaves octaves-by-place] #:seed [seed seed-by-place])
  (flabs (noise-value point (check-octaves 'perlin-turbulence octaves)
                   (check-seed 'perlin-turbulence seed))))
