#lang typed/racket/base
;; Bounds of lights, alone and together, and what they say about the light that arrives at a point.
(require "../base/unsafe.rkt" "../base/float3.rkt" "light.rkt")

(provide BOUND-STRIDE pack-bound! importance LightBound-union)

;; Packed: centre and half extents of the box, intensity, squared half diagonal (-1 without a
;; box), axis, cosine and sine of the spread, cosine of the reach.
(define-syntax-rule (BOUND-STRIDE) 14)
;; in place of the cosine of the spread where there is no axis
(define-syntax-rule (NO-AXIS) -2.0)

(: pack-bound! (-> FlVector Fixnum LightBound Void))
(define (pack-bound! v at bound)
  (define box (LightBound-box bound))
  (define axis (LightBound-axis bound))
  (flvector-set! v (fx+ at 6) (LightBound-intensity bound))
  (flvector-set! v (fx+ at 7) -1.0)
  (when box
    (let-float3 ([low (Float3-in box 0)] [high (Float3-in box 3)]
                 [half (Float3-scale-by-scalar (Float3-subtract high low) 0.5)])
      (Float3-put! v at (Float3-add low half))
      (Float3-put! v (fx+ at 3) half)
      (flvector-set! v (fx+ at 7) (Float3-length-squared half))))
  (flvector-set! v (fx+ at 11) (NO-AXIS))
  (when axis
    (Float3-put! v (fx+ at 8) axis)
    (flvector-set! v (fx+ at 11) (flcos (LightBound-spread bound)))
    (flvector-set! v (fx+ at 12) (flsin (LightBound-spread bound)))
    (flvector-set! v (fx+ at 13) (flcos (LightBound-reach bound)))))

(define-syntax-rule (lesser a b) (let ([x a] [y b]) (if (fl< x y) x y)))
(define-syntax-rule (greater a b) (let ([x a] [y b]) (if (fl> x y) x y)))

;; About how much irradiance the lights within a packed bound bring to a surface at x with normal n
;; if nothing is in between: 0 only where they bring none. The distance is the one to the middle of
;; the box, within the box no less than makes up for the lights nearer than the middle: over 1,000
;; lights in halls the variance is 1/15 to 1/35 of that with the distance to the nearest point.
(define-syntax-rule (importance v at0 transmits? x n)
  (let* ([at : Fixnum at0]
         [intensity (flvector-ref v (fx+ at 6))]
         [half-squared (flvector-ref v (fx+ at 7))])
    (if (fl< half-squared 0.0)
        (if (or transmits? (fl= (flvector-ref v (fx+ at 11)) (NO-AXIS)))
            intensity
            (fl* intensity (greater 0.0 (Float3-dot (Float3-in v (fx+ at 8)) n))))
        (let-float3 ([half (Float3-in v (fx+ at 3))]
                     [to-center (Float3-subtract (Float3-in v at) x)])
          (let* ([least (fl* (LEAST-PART) half-squared)]
                 ;; the small number only so that nothing is divided by 0
                 [squared (greater (greater (Float3-length-squared to-center) least) 1e-200)]
                 [facing (if transmits?
                             1.0
                             (greatest-cosine (flsqrt squared) to-center half n))]
                 [cos-spread (flvector-ref v (fx+ at 11))]
                 [shining (if (fl= cos-spread (NO-AXIS))
                              1.0
                              (emission-cosine v at cos-spread half-squared to-center))])
            (fl/ (fl* (fl* intensity facing) shining) squared))))))

;; The least squared distance, as a part of the squared half diagonal: from 1 to 1/10 the variance
;; falls.
(define-syntax-rule (LEAST-PART) 0.1)

;; About the greatest cosine between the normal and a direction to the box: the greatest height of
;; a corner over the surface, by the distance; 0 only where the whole box is behind the surface.
(define-syntax-rule (greatest-cosine distance to-center half n)
  (let ([height (fl+ (Float3-dot to-center n)
                     (fl+ (fl+ (fl* (Float3-x half) (flabs (Float3-x n)))
                               (fl* (Float3-y half) (flabs (Float3-y n))))
                          (fl* (Float3-z half) (flabs (Float3-z n)))))])
    (if (fl> height 0.0) (lesser 1.0 (fl/ height distance)) 0.0)))

;; At most the cosine of the angle between a direction of full intensity and one from the box to
;; the surface: of the angle at the centre less the spread and the angle the box is seen under.
(define-syntax-rule (emission-cosine v at cos-spread half-squared to-center)
  (let ([squared (Float3-length-squared to-center)])
    (if (fl<= squared half-squared)
        1.0
        (let* ([cos-center (fl/ (fl* -1.0 (Float3-dot to-center (Float3-in v (fx+ at 8))))
                                (flsqrt squared))]
               [sin-center (sine-of cos-center)]
               [sin-squared (fl/ half-squared squared)]
               [cos-size (flsqrt (fl- 1.0 sin-squared))]
               [sin-size (flsqrt sin-squared)]
               [sin-spread (flvector-ref v (fx+ at 12))])
          (let-difference (cos-axis sin-axis) (cos-center sin-center cos-spread sin-spread)
            (let-difference (cos-nearest sin-nearest) (cos-axis sin-axis cos-size sin-size)
              (if (fl>= cos-nearest (flvector-ref v (fx+ at 13)))
                  (greater 0.0 cos-nearest)
                  0.0)))))))

(define-syntax-rule (sine-of cosine)
  (let ([c cosine]) (flsqrt (greater 0.0 (fl- 1.0 (fl* c c))))))

;; Cosine and sine of a - b for two angles from 0 to pi, of 0 where b is greater.
(define-syntax-rule (let-difference (cosine sine) (cos-a sin-a cos-b sin-b) body)
  (let* ([cosine (if (fl> cos-a cos-b) 1.0 (fl+ (fl* cos-a cos-b) (fl* sin-a sin-b)))]
         [sine (if (fl> cos-a cos-b) 0.0 (fl- (fl* sin-a cos-b) (fl* cos-a sin-b)))])
    body))

;; The bound of two lights with boxes.
(: LightBound-union (-> LightBound LightBound LightBound))
(define (LightBound-union a b)
  (define box-a (LightBound-box a))
  (define box-b (LightBound-box b))
  (define box
    (and box-a box-b
         (flvector (lesser (flvector-ref box-a 0) (flvector-ref box-b 0))
                   (lesser (flvector-ref box-a 1) (flvector-ref box-b 1))
                   (lesser (flvector-ref box-a 2) (flvector-ref box-b 2))
                   (greater (flvector-ref box-a 3) (flvector-ref box-b 3))
                   (greater (flvector-ref box-a 4) (flvector-ref box-b 4))
                   (greater (flvector-ref box-a 5) (flvector-ref box-b 5)))))
  (define intensity (fl+ (LightBound-intensity a) (LightBound-intensity b)))
  (define reach (greater (LightBound-reach a) (LightBound-reach b)))
  (define axis-a (LightBound-axis a))
  (define axis-b (LightBound-axis b))
  (cond
    [(and axis-a axis-b)
     (if (fl< (LightBound-spread a) (LightBound-spread b))
         (with-cone box intensity reach axis-b (LightBound-spread b) axis-a (LightBound-spread a))
         (with-cone box intensity reach axis-a (LightBound-spread a) axis-b (LightBound-spread b)))]
    [else (LightBound box intensity #f 0.0 0.0)]))

(define-syntax-rule (PI) 3.141592653589793)

;; With the smallest cone around two, the wider one first.
(: with-cone (-> (U #f FlVector) Flonum Flonum Float3 Flonum Float3 Flonum LightBound))
(define (with-cone box intensity reach wide wide-spread narrow narrow-spread)
  (let-float3 ([across (Float3-subtract narrow wide)] [along (Float3-add narrow wide)])
    (let* ([between (fl* 2.0 (flatan (fl/ (Float3-length across) (Float3-length along))))]
           [spread (fl* 0.5 (fl+ wide-spread (fl+ between narrow-spread)))])
      (cond
        [(fl<= (fl+ between narrow-spread) wide-spread)
         (LightBound box intensity wide wide-spread reach)]
        [(or (fl>= spread (PI)) (fl>= between (fl* 0.999999 (PI))))
         (LightBound box intensity #f 0.0 0.0)]
        [else
         ;; turned from the wide axis towards the narrow one
         (let ([turn (fl- spread wide-spread)]
               [sine (flsin between)])
           (LightBound box intensity
                       (Float3-normalized
                        (Float3-add
                         (Float3-scale-by-scalar wide (fl/ (flsin (fl- between turn)) sine))
                         (Float3-scale-by-scalar narrow (fl/ (flsin turn) sine))))
                       spread reach))]))))
