#lang typed/racket/base
;; What could be hit from a point within a distance, on one side of its tangent plane: gathered
;; once, many rays from that point try only those. Where nothing is gathered no ray is needed.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt"
         "../shape/sphere.rkt" "hierarchy.rkt" "scene.rkt")

(provide Scene-gather! gathered-reach? Scene-nearest-gathered! GATHER-LIMIT)

;; More than this many are cheaper to find by walking the hierarchy for every ray.
(define-syntax-rule (GATHER-LIMIT) 16)

;; Writes the places of the spheres whose box reaches nearer than `distance` to ray-origin and above
;; the plane through it across surface-normal, and their number into gathered-count; -1 when there
;; are too many or the world has other shapes. A box is kept when in doubt.
(: Scene-gather! (-> Scene Flonum FlVector FxVector Void))
(define (Scene-gather! scene distance r i)
  (define bounds (Scene-bounds scene))
  (define links (Scene-links scene))
  (define order (Scene-order scene))
  (define spheres (Scene-spheres scene))
  (define base (fxvector-ref i stack-base))
  ;; a sphere does not stand in the way of rays that leave it outwards
  (define own (fxvector-ref i hit-primitive))
  (fxvector-set! i gathered-count 0)
  (if (Scene-only-spheres? scene)
      (let-float3 ([o (Float3-in r ray-origin)]
                   [n (Float3-in r surface-normal)])
        (let* ([reach (fl* (fl* distance distance) 1.000000000001)]
               [slack (fl* -1e-12 (fl+ (Scene-extent scene) (Float3-largest-magnitude o)))])
          (let walk ([node : Fixnum 0] [top : Fixnum base])
            (define-syntax-rule (pop)
              (unless (fx= top base)
                (walk (fxvector-ref i (fx+ stack (fx- top 1))) (fx- top 1))))
            (let-float3 ([low (Float3-subtract (Float3-in bounds (fx* 6 node)) o)]
                         [high (Float3-subtract (Float3-in bounds (fx+ 3 (fx* 6 node))) o)])
              (if (and (fl<= (box-distance-squared low high) reach)
                       (fl> (highest-along low high n) slack))
                  (let* ([link (fxvector-ref links node)]
                         [count (link-count link)])
                    (cond
                      [(fx= count 0)
                       (fxvector-set! i (fx+ stack top) (link-payload link))
                       (walk (fx+ node 1) (fx+ top 1))]
                      [(fx> (fx+ count (fxvector-ref i gathered-count)) (GATHER-LIMIT))
                       (fxvector-set! i gathered-count -1)]
                      [else
                       (let* ([first (link-payload link)] [end (fx+ first count)])
                         (let add ([place : Fixnum first])
                           (when (fx< place end)
                             (let-float3 ([to-center (Float3-subtract
                                                      (Float3-in spheres (fx* 4 place)) o)])
                               (let* ([radius (flvector-ref spheres (fx+ 3 (fx* 4 place)))]
                                      [along (Float3-dot to-center n)]
                                      [far (fl+ radius distance)])
                                 (when (and (fl> (fl+ along radius) slack)
                                            (fl<= (Float3-length-squared to-center)
                                                  (fl* (fl* far far) 1.000000000001))
                                            (not (and (fl< along 0.0)
                                                      (fx= own (fxvector-ref order place)))))
                                   (let ([known (fxvector-ref i gathered-count)])
                                     (fxvector-set! i (fx+ gathered known) place)
                                     (put-band! r known along radius
                                                (Float3-length-squared to-center))
                                     (fxvector-set! i gathered-count (fx+ known 1))))))
                             (add (fx+ place 1)))))
                       (pop)]))
                  (pop))))))
      (fxvector-set! i gathered-count -1)))

;; A sphere seen within the angle a of its centre, that stands at the angle b to the normal, is met
;; at angles from b - a to b + a only. `along` is the centre's height over the tangent plane.
(define-syntax-rule (put-band! r k along radius distance-squared)
  (let* ([sine-squared (fl/ (fl* radius radius) distance-squared)]
         [cosine (fl/ along (flsqrt distance-squared))])
    (if (fl< sine-squared 0.999999)
        (let* ([level (fl* cosine (flsqrt (fl- 1.0 sine-squared)))]
               [swing (flsqrt (fl* sine-squared (flmax 0.0 (fl- 1.0 (fl* cosine cosine)))))]
               [zenith? (and (fl> cosine 0.0) (fl>= (fl* cosine cosine) (fl- 1.0 sine-squared)))])
          (flvector-set! r (band k) (fl- (fl- level swing) (BAND-MARGIN)))
          (flvector-set! r (fx+ 1 (band k))
                         (if zenith? 2.0 (fl+ (fl+ level swing) (BAND-MARGIN)))))
        (begin
          (flvector-set! r (band k) -2.0)
          (flvector-set! r (fx+ 1 (band k)) 2.0)))))
(define-syntax-rule (band k) (fx+ gathered-bands (fx* 2 k)))
;; roots of differences are exact to 2e-8
(define-syntax-rule (BAND-MARGIN) 1e-6)

(define-syntax-rule (in-band? r k cosine)
  (and (fl>= cosine (flvector-ref r (band k)))
       (fl<= cosine (flvector-ref r (fx+ 1 (band k))))))

;; Whether a direction of this cosine to the normal can meet anything that was gathered.
(: gathered-reach? (-> FlVector FxVector Flonum Boolean))
(define (gathered-reach? r i cosine)
  (define count (fxvector-ref i gathered-count))
  (let try ([k : Fixnum 0])
    (and (fx< k count)
         (or (in-band? r k cosine)
             (try (fx+ k 1))))))

;; The squared distance from the origin to a box, low and high relative to it.
(define-syntax-rule (box-distance-squared low high)
  (let ([x (outside (Float3-x low) (Float3-x high))]
        [y (outside (Float3-y low) (Float3-y high))]
        [z (outside (Float3-z low) (Float3-z high))])
    (fl+ (fl* x x) (fl+ (fl* y y) (fl* z z)))))
(define-syntax-rule (outside low high)
  (if (fl> low 0.0) low (if (fl< high 0.0) high 0.0)))

;; The largest n.p over a box.
(define-syntax-rule (highest-along low high n)
  (fl+ (fl* (Float3-x n) (if (fl> (Float3-x n) 0.0) (Float3-x high) (Float3-x low)))
       (fl+ (fl* (Float3-y n) (if (fl> (Float3-y n) 0.0) (Float3-y high) (Float3-y low)))
            (fl* (Float3-z n) (if (fl> (Float3-z n) 0.0) (Float3-z high) (Float3-z low))))))

;; Scene-nearest! among what was gathered, for rays of unit direction above the tangent plane, no
;; longer than the distance; only hit-t is written.
(: Scene-nearest-gathered! (-> Scene FlVector FxVector Boolean))
(define (Scene-nearest-gathered! scene r i)
  (define spheres (Scene-spheres scene))
  (define end (fx+ gathered (fxvector-ref i gathered-count)))
  (fxvector-set! i nearest-rays (fx+ 1 (fxvector-ref i nearest-rays)))
  (let-float3 ([o (Float3-in r ray-origin)]
               [d (Float3-in r ray-direction)])
    (let* ([dd (Float3-length-squared d)]
           [inverse-dd (fl/ 1.0 dd)]
           [start-limit (flvector-ref r ray-limit)]
           [cosine (Float3-dot d (Float3-in r surface-normal))])
      (let try ([k : Fixnum gathered] [limit : Flonum start-limit])
        (if (fx= k end)
            (and (fl< limit start-limit)
                 (begin (flvector-set! r hit-t limit) #t))
            (if (in-band? r (fx- k gathered) cosine)
                (let ([place (fxvector-ref i k)])
                  (let-float3 ([center (Float3-in spheres (fx* 4 place))])
                    (let ([t (Sphere-nearest-root o d dd inverse-dd center
                                                  (flvector-ref spheres (fx+ 3 (fx* 4 place))))])
                      (if (and (fl< t limit) (fl> t 0.0))
                          (try (fx+ k 1) t)
                          (try (fx+ k 1) limit)))))
                (try (fx+ k 1) limit)))))))
