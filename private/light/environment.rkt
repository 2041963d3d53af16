#lang typed/racket/base
;; Light from all directions out of a picture: longitude across it, latitude down it (equirectangular).
;; Directions are sampled by the picture's luminance and the solid angle of its rows.
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../base/public.rkt" "../base/unsafe-typed.rkt" "../image/image.rkt" "light.rkt")

(provide (struct-out EnvironmentMap) make-EnvironmentMap EnvironmentMap-color
         EnvironmentMap-background EnvironmentMap-light-kernel)

;; image: radiance, linear RGB; between the middles of its pixels it is interpolated, across the seam
;; too. The middle of the picture is seen along -z, its right half towards +x, its top row straight up
;; (as Camera-panoramic sees it from a camera that looks along -z). rotation: radians by which the
;; picture is turned about y, counterclockwise seen from above. scale: multiplies the radiance.
(struct EnvironmentMap ([image : Image] [rotation : Flonum] [scale : Flonum]) #:transparent
  #:property prop:custom-print-quotable 'never
  #:property prop:custom-write
  (lambda ([map : EnvironmentMap] [port : Output-Port] [mode : (U Boolean 0 1)])
    (print-struct map port mode)))

(unsafe-require/typed "../base/print.rkt" [print-struct (-> Any Output-Port (U Boolean 0 1) Any)])

(: make-EnvironmentMap (->* (Image) (#:rotation-degrees Real #:scale Real) EnvironmentMap))
(define (make-EnvironmentMap image #:rotation-degrees [degrees 0.0] #:scale [scale 1.0])
  (define pixels (Image-pixels image))
  (each-below (k (flvector-length pixels))
    (unless (and (fl<= 0.0 (flvector-ref pixels k)) (fl<= (flvector-ref pixels k) 1e30))
      (raise-expected 'EnvironmentMap "image" "a picture of finite numbers, none negative"
                      (flvector-ref pixels k))))
  (EnvironmentMap image
                  (fl* (check-between 'EnvironmentMap "rotation-degrees" degrees -1e6 1e6)
                       (fl/ (PI) 180.0))
                  (check-between 'EnvironmentMap "scale" scale 0.0 1e30)))

(define-constructor EnvironmentMap make-EnvironmentMap (image) #:struct (image _ _))

(define-syntax-rule (PI) 3.141592653589793)
(define-syntax-rule (TWO-PI) 6.283185307179586)

;; The body for k = 0 .. count - 1.
(define-syntax-rule (each-below (k count) body ...)
  (let ([end : Fixnum count])
    (let loop ([k : Fixnum 0])
      (when (fx< k end)
        (let () body ...)
        (loop (fx+ k 1))))))

;; The mean radiance over the sphere of directions.
(: EnvironmentMap-color (-> EnvironmentMap Float3))
(define (EnvironmentMap-color map)
  (define image (EnvironmentMap-image map))
  (define pixels (Image-pixels image))
  (define width (Image-width image))
  (define height (Image-height image))
  (define sum (make-flvector 3 0.0))
  (each-below (y height)
    (define share (fl/ (row-height y height) (fl* 2.0 (fx->fl width))))
    (each-below (x width)
      (Float3-put! sum 0
                   (Float3-multiply-add (Float3-in sum 0) share
                                        (Float3-in pixels (fx* 3 (fx+ x (fx* y width))))))))
  (Float3-scale-by-scalar (Float3-in sum 0) (EnvironmentMap-scale map)))

;; The difference of the sines of the latitudes of a row's edges: its share of the sphere, times 2.
(: row-height (-> Fixnum Fixnum Flonum))
(define (row-height y height)
  (define step (fl/ (PI) (fx->fl height)))
  ;; 2 cos(middle) sin(half a step), which keeps its digits near the poles
  (fl* 2.0 (fl* (flsin (fl* step (fl+ 0.5 (fx->fl y)))) (flsin (fl* 0.5 step)))))

;; The sine of the latitude of a row's upper edge.
(define-syntax-rule (edge-sine y height)
  (flcos (fl/ (fl* (PI) (fx->fl y)) (fx->fl height))))

;; ----------------------------------------------------------------------------------------------

;; A procedure that writes the radiance seen along ray-direction into surface-color.
(: EnvironmentMap-background (-> EnvironmentMap (-> FlVector FxVector Void)))
(define (EnvironmentMap-background map)
  (define pixels (Image-pixels (EnvironmentMap-image map)))
  (define width (Image-width (EnvironmentMap-image map)))
  (define height (Image-height (EnvironmentMap-image map)))
  (define rotation (EnvironmentMap-rotation map))
  (define scale (EnvironmentMap-scale map))
  (lambda ([r : FlVector] [i : FxVector])
    (let-float3 ([d (Float3-normalized (Float3-in r ray-direction))])
      (let ([x (fl* (longitude-part (Float3-x d) (Float3-z d) rotation) (fx->fl width))]
            [y (fl* (latitude-part (Float3-y d)) (fx->fl height))])
        (put-interpolated! r surface-color pixels width height (fl- x 0.5) (fl- y 0.5) scale)))))

;; How far across the picture a direction is, from 0 at the left to 1.
(define-syntax-rule (longitude-part x z rotation)
  (let ([turns (fl/ (fl+ (arc-tangent x (fl- 0.0 z)) rotation) (TWO-PI))])
    (let ([part (fl+ turns 0.5)])
      (fl- part (flfloor part)))))

;; How far down, from 0 at the top to 1.
(define-syntax-rule (latitude-part y)
  (fl- 0.5 (fl/ (flasin (flmax -1.0 (flmin 1.0 y))) (PI))))

;; The angle of the point (c, s) from the first axis, from -pi to pi; 0 for the origin.
(define-syntax-rule (arc-tangent s0 c0)
  (let ([s s0] [c c0])
    (cond
      [(fl> (flabs c) (flabs s))
       (let ([angle (flatan (fl/ s c))])
         (if (fl> c 0.0)
             (fl+ angle 0.0)
             (if (fl< s 0.0) (fl- angle (PI)) (fl+ angle (PI)))))]
      [(fl= s 0.0) 0.0]
      [else
       (let ([angle (flatan (fl/ c s))])
         (if (fl> s 0.0)
             (fl- (fl* 0.5 (PI)) angle)
             (fl- (fl* -0.5 (PI)) angle)))])))

;; The picture at (x, y), measured from the middle of its first pixel: its seam is passed, its upper and
;; lower edge are not.
(: put-interpolated! (-> FlVector Fixnum FlVector Fixnum Fixnum Flonum Flonum Flonum Void))
(define (put-interpolated! r to pixels width height x y scale)
  (let* ([left (flfloor x)]
         [above (flfloor y)]
         [s (fl- x left)]
         [t (fl- y above)]
         [x0 (wrapped (fl->fx left) width)]
         [x1 (wrapped (fx+ 1 (fl->fx left)) width)]
         [y0 (clamped (fl->fx above) height)]
         [y1 (clamped (fx+ 1 (fl->fx above)) height)])
    (let-float3 ([a (Float3-in pixels (fx* 3 (fx+ x0 (fx* y0 width))))]
                 [b (Float3-in pixels (fx* 3 (fx+ x1 (fx* y0 width))))]
                 [c (Float3-in pixels (fx* 3 (fx+ x0 (fx* y1 width))))]
                 [d (Float3-in pixels (fx* 3 (fx+ x1 (fx* y1 width))))]
                 [upper (Float3-linear-interpolate a b s)]
                 [lower (Float3-linear-interpolate c d s)])
      (Float3-put! r to
                   (Float3-scale-by-scalar (Float3-linear-interpolate upper lower t) scale)))))

(define-syntax-rule (wrapped k0 count)
  (let ([k k0]) (cond [(fx< k 0) (fx+ k count)] [(fx>= k count) (fx- k count)] [else k])))
(define-syntax-rule (clamped k0 count)
  (let ([k k0]) (cond [(fx< k 0) 0] [(fx>= k count) (fx- count 1)] [else k])))

;; ----------------------------------------------------------------------------------------------

;; How the picture is sampled: for every row the sums of its cells' weights from the left, the last one
;; 1; the sums of the rows' weights from the top, the last one 1; and the density of every cell per
;; solid angle. A cell is a pixel; its weight is the luminance interpolated over it, times its solid
;; angle, so that it is 0 only where the whole cell is black.
(struct Distribution ([columns : FlVector] [rows : FlVector] [densities : FlVector] [power : Flonum]))

(: make-distribution (-> EnvironmentMap Distribution))
(define (make-distribution map)
  (define image (EnvironmentMap-image map))
  (define pixels (Image-pixels image))
  (define width (Image-width image))
  (define height (Image-height image))
  (define luminances (make-flvector (* width height)))
  (each-below (k (fx* width height))
    (flvector-set! luminances k (mean-component (Float3-in pixels (fx* 3 k)))))
  (define columns (make-flvector (* width height)))
  (define rows (make-flvector height))
  (define densities (make-flvector (* width height)))
  ;; the integral of the interpolated picture over a cell: 1/8, 6/8, 1/8 along each axis
  (: smooth-row (-> Fixnum Fixnum Flonum))
  (define (smooth-row x y)
    (define at (fx* width (clamped y height)))
    (fl+ (fl* 0.75 (flvector-ref luminances (fx+ at x)))
         (fl* 0.125 (fl+ (flvector-ref luminances (fx+ at (wrapped (fx- x 1) width)))
                         (flvector-ref luminances (fx+ at (wrapped (fx+ x 1) width)))))))
  (: smooth (-> Fixnum Fixnum Flonum))
  (define (smooth x y)
    (fl+ (fl* 0.75 (smooth-row x y))
         (fl* 0.125 (fl+ (smooth-row x (fx- y 1)) (smooth-row x (fx+ y 1))))))
  (define total
    (let each-row : Flonum ([y : Fixnum 0] [total : Flonum 0.0])
      (cond
        [(fx< y height)
         (define share (row-height y height))
         (define sum
           (let each : Flonum ([x : Fixnum 0] [sum : Flonum 0.0])
             (cond
               [(fx< x width)
                (define weight (smooth x y))
                (define next (fl+ sum weight))
                (flvector-set! densities (fx+ x (fx* y width)) weight)
                (flvector-set! columns (fx+ x (fx* y width)) next)
                (each (fx+ x 1) next)]
               [else (fl+ sum 0.0)])))
         (normalize! columns (fx* y width) width sum)
         (define next (fl+ total (fl* sum share)))
         (flvector-set! rows y next)
         (each-row (fx+ y 1) next)]
        [else (fl+ total 0.0)])))
  (normalize! rows 0 height total)
  ;; a cell's solid angle is its row's height times the width of a column
  (define column-angle (fl/ (TWO-PI) (fx->fl width)))
  (when (fl> total 0.0)
    (each-below (k (fx* width height))
      (flvector-set! densities k
                     (fl/ (flvector-ref densities k) (fl* total column-angle)))))
  (Distribution columns rows densities
                (fl* (fl* total column-angle) (EnvironmentMap-scale map))))

;; Sums become parts of their total; where it is 0, equal parts.
(: normalize! (-> FlVector Fixnum Fixnum Flonum Void))
(define (normalize! sums start count total)
  (let each ([k : Fixnum 0])
    (when (fx< k count)
      (flvector-set! sums (fx+ start k)
                     (if (fl> total 0.0)
                         (fl/ (flvector-ref sums (fx+ start k)) total)
                         (fl/ (fx->fl (fx+ k 1)) (fx->fl count))))
      (each (fx+ k 1))))
  (flvector-set! sums (fx+ start (fx- count 1)) 1.0))

;; The first place from `start` whose sum is above u.
(: find-place (-> FlVector Fixnum Fixnum Flonum Fixnum))
(define (find-place sums start count u)
  (let halve ([low : Fixnum 0] [high : Fixnum (fx- count 1)])
    (if (fx= low high)
        low
        (let ([middle (fxrshift (fx+ low high) 1)])
          (if (fl> (flvector-ref sums (fx+ start middle)) u)
              (halve low middle)
              (halve (fx+ middle 1) high))))))

;; The light of a map, as a light of its world.
(: EnvironmentMap-light-kernel (-> EnvironmentMap LightKernel))
(define (EnvironmentMap-light-kernel map)
  (define width (Image-width (EnvironmentMap-image map)))
  (define height (Image-height (EnvironmentMap-image map)))
  (define rotation (EnvironmentMap-rotation map))
  (define scale (EnvironmentMap-scale map))
  (define pixels (Image-pixels (EnvironmentMap-image map)))
  (define distribution (make-distribution map))
  (define columns (Distribution-columns distribution))
  (define rows (Distribution-rows distribution))
  (define densities (Distribution-densities distribution))
  (: sample! (-> FlVector FxVector Void))
  (define (sample! r i)
    (let* ([row (find-place rows 0 height (flvector-ref r sample-v))]
           [start (fx* row width)]
           [column (find-place columns start width (flvector-ref r sample-u))]
           [v (part-within rows 0 row (flvector-ref r sample-v))]
           [u (part-within columns start column (flvector-ref r sample-u))]
           ;; uniform over the cell's solid angle: the sine of the latitude is
           [upper (edge-sine row height)]
           [lower (edge-sine (fx+ row 1) height)]
           [sine (fl+ upper (fl* v (fl- lower upper)))]
           [cosine (flsqrt (flmax 0.0 (fl- 1.0 (fl* sine sine))))]
           [x (fl+ (fx->fl column) u)]
           [longitude (fl- (fl* (TWO-PI) (fl- (fl/ x (fx->fl width)) 0.5)) rotation)]
           [density (flvector-ref densities (fx+ start column))])
      (Float3-put! r light-direction
                   (Float3 (fl* cosine (flsin longitude)) sine
                           (fl* -1.0 (fl* cosine (flcos longitude)))))
      (flvector-set! r light-distance +inf.0)
      (flvector-set! r light-density density)
      (put-interpolated! r light-radiance pixels width height (fl- x 0.5)
                         (fl- (fl* (latitude-part sine) (fx->fl height)) 0.5)
                         (if (fl> density 0.0) (fl/ scale density) 0.0))))
  (: density! (-> FlVector FxVector Void))
  (define (density! r i)
    (let-float3 ([d (Float3-normalized (Float3-in r in-direction))])
      (let* ([x (fl->fx (fl* (longitude-part (Float3-x d) (Float3-z d) rotation)
                             (fx->fl width)))]
             [y (fl->fx (fl* (latitude-part (Float3-y d)) (fx->fl height)))]
             [column (if (fx< x width) x (fx- width 1))]
             [row (if (fx< y height) y (fx- height 1))])
        (flvector-set! r light-density (flvector-ref densities (fx+ column (fx* row width)))))))
  (LightKernel sample! density! #t -1
               (LightBound #f (Distribution-power distribution) #f 0.0 0.0)))

;; How far a number is into the part of the sums at `place` that it chose.
(define-syntax-rule (part-within sums start place u)
  (let* ([low (if (fx= place 0) 0.0 (flvector-ref sums (fx+ start (fx- place 1))))]
         [high (flvector-ref sums (fx+ start place))])
    (if (fl> high low) (flmin 0.9999999999999999 (fl/ (fl- u low) (fl- high low))) 0.5)))
