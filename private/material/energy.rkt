#lang typed/racket/base
;; How much light the single-scattering GGX model loses: light that leaves one microfacet and meets
;; another is missing from it. Losses by direction, as a column of numbers for one material.
(require "../base/unsafe-typed.rkt" racket/promise
         "../base/unsafe.rkt" "../base/check.rkt" "../base/float3.rkt"
         "microfacet.rkt" "fresnel.rkt")
(unsafe-require/typed "../base/promise.rkt" [once (All (a) (-> (-> a) (Promise a)))])

(provide CELLS loss-coordinate loss-coordinate/function node-cosine lost-energy
         conductor-losses single-scattering-losses loss-table table-losses
         gauss-legendre average-over-cosine
         GGX-directional-albedo GGX-average-albedo)

;; A column has CELLS + 1 nodes, evenly spaced in a coordinate from 0 to 1 that resolves cosines
;; from a fraction of alpha, where masking sets in, up to 1 equally well.
(define-syntax-rule (CELLS) 96)

(define-float3-operation (loss-coordinate [cosine : Flonum] [alpha : Flonum])
  : Flonum (flsqrt (fl* (fl* 0.5 cosine) (fl+ 1.0 (fl/ (fl+ 1.0 alpha) (fl+ cosine alpha))))))

;; The cosine at a node: the root of cosine^2 + b cosine - 2 alpha x^2 = 0.
(: node-cosine (-> Integer Flonum Flonum))
(define (node-cosine node alpha)
  (define x (fl/ (real->double-flonum node) (fx->fl (CELLS))))
  (define b (fl- (fl+ 1.0 (fl* 2.0 alpha)) (fl* 2.0 (fl* x x))))
  (define c (fl* (fl* 2.0 alpha) (fl* x x)))
  (define root (flsqrt (fl+ (fl* b b) (fl* 4.0 c))))
  (cond
    [(= node (CELLS)) 1.0]
    [(fl>= b 0.0) (fl/ (fl* 2.0 c) (fl+ b root))]
    [else (fl* 0.5 (fl- root b))]))

;; gauss-legendre : nodes and weights of the n-point rule on [0, 1], alternating.
(: gauss-legendre (-> Positive-Integer FlVector))
(define (gauss-legendre n)
  (define rule (make-flvector (* 2 n)))
  (for ([k (in-range n)])
    (let improve ([z : Flonum (flcos (fl/ (fl* 3.141592653589793 (real->double-flonum (+ k 0.75)))
                                          (real->double-flonum (+ n 0.5))))]
                  [steps : Fixnum 8])
      (define-values (value before)
        (for/fold ([p : Flonum 1.0] [q : Flonum 0.0]) ([j : Nonnegative-Integer (in-range n)])
          (define degree (real->double-flonum j))
          (values (fl/ (fl- (fl* (fl* (fl+ (fl* 2.0 degree) 1.0) z) p) (fl* degree q))
                       (fl+ degree 1.0))
                  p)))
      (define slope
        (fl/ (fl* (real->double-flonum n) (fl- (fl* z value) before)) (fl- (fl* z z) 1.0)))
      (cond
        [(> steps 0) (improve (fl- z (fl/ value slope)) (- steps 1))]
        [else
         (flvector-set! rule (* 2 k) (fl* 0.5 (fl- 1.0 z)))
         (flvector-set! rule (+ 1 (* 2 k))
                        (fl/ 1.0 (fl* (fl- 1.0 (fl* z z)) (fl* slope slope))))])))
  rule)

;; The rule under x = t t (3 - 2 t), which removes square roots and steep ends from an integrand.
(: smoothed (-> FlVector FlVector))
(define (smoothed rule)
  (define result (make-flvector (flvector-length rule)))
  (for ([k (in-range (quotient (flvector-length rule) 2))])
    (define t (flvector-ref rule (* 2 k)))
    (flvector-set! result (* 2 k) (fl* (fl* t t) (fl- 3.0 (fl* 2.0 t))))
    (flvector-set! result (+ 1 (* 2 k))
                   (fl* (flvector-ref rule (+ 1 (* 2 k))) (fl* 6.0 (fl* t (fl- 1.0 t))))))
  result)

(define-syntax-rule (RADII) 12)
(define RADIUS-RULE : FlVector (smoothed (gauss-legendre (RADII))))
(define AZIMUTH-RULE : FlVector (smoothed (gauss-legendre 8)))
;; for total internal reflection, whose edges run across the azimuths
(define FINE-AZIMUTH-RULE : FlVector (smoothed (gauss-legendre 16)))

;; average-over-cosine : 2 times the integral over [0, 1] of f(cosine) cosine, the mean over the
;; hemisphere by cosine; exact for polynomials of degree 62.
(: average-over-cosine (-> (-> Flonum Flonum) Flonum))
(define (average-over-cosine f)
  (define rule (gauss-legendre 32))
  (for/fold ([sum : Flonum 0.0]) ([k (in-range 32)])
    (define cosine (flvector-ref rule (* 2 k)))
    (fl+ sum (fl* (fl* 2.0 (flvector-ref rule (+ 1 (* 2 k)))) (fl* cosine (f cosine))))))

;; lost-energy : of the light along a direction of that cosine, the share that neither the
;; reflecting nor the refracting single-scattering model returns. eta: index of refraction of the
;; far side over that of the near side; 0 is a surface that reflects everything. Error below 2e-4
;; where eta is 0 and 6e-4 else: the visible normals are integrated in polar coordinates of
;; their slope, in pieces between which the integrand is smooth.
(: lost-energy (-> Flonum Flonum Flonum Flonum))
(define (lost-energy cosine alpha eta)
  (define sine (flsqrt (fl* (fl- 1.0 cosine) (fl+ 1.0 cosine))))
  (define half-pi 1.5707963267948966)
  ;; beyond total internal reflection at the mean plane, the azimuth from which some facets transmit
  (define squared (fl/ (fl- (fl* (fl- 1.0 eta) (fl+ 1.0 eta)) (fl* cosine cosine)) (fl* sine sine)))
  (define turn
    (if (and (fl> squared 0.0) (fl< squared 1.0)) (flacos (flsqrt squared)) 0.0))
  (define rule (if (and (fl> eta 0.0) (fl< eta 1.0)) FINE-AZIMUTH-RULE AZIMUTH-RULE))
  (define (between [from : Flonum] [to : Flonum]) : Flonum
    (let loop ([k : Fixnum 0] [sum : Flonum 0.0])
      (cond
        [(and (fx< k (flvector-length rule)) (fl< from to))
         (define azimuth (fl+ from (fl* (fl- to from) (flvector-ref rule k))))
         (loop (fx+ k 2)
               (fl+ sum (fl* (flvector-ref rule (fx+ k 1))
                             (lost-along (flcos azimuth) sine cosine alpha eta))))]
        [else (fl* sum (fl/ (fl- to from) (fl* 2.0 half-pi)))])))
  (fl+ (fl+ (between 0.0 turn) (between turn half-pi))
       (fl+ (between half-pi (fl- (fl* 2.0 half-pi) turn))
            (between (fl- (fl* 2.0 half-pi) turn) (fl* 2.0 half-pi)))))

;; The loss at normals whose slope points to an azimuth of that cosine from the direction. Slopes
;; r = alpha w / (1 - w), w from 0 to 1 or where facets turn away.
(: lost-along (-> Flonum Flonum Flonum Flonum Flonum Flonum))
(define (lost-along c sine cosine alpha eta)
  (define end
    (if (fl>= c 0.0) 1.0 (fl/ cosine (fl- cosine (fl* alpha (fl* sine c))))))
  (define critical (fl* (fl- 1.0 eta) (fl+ 1.0 eta)))
  (define sc (fl* sine c))
  (define breaks (make-flvector 6 end))
  ;; where the reflected, and where the refracted direction crosses the mean plane
  (put-roots! breaks 0 cosine sc (fl* -1.0 cosine) alpha)
  (put-roots! breaks 2 (fl* cosine cosine) (fl* cosine sc)
              (fl- critical (fl* cosine cosine)) alpha)
  ;; where total internal reflection sets in
  (put-roots! breaks 4 (fl- critical (fl* sc sc)) (fl* cosine sc)
              (fl- critical (fl* cosine cosine)) alpha)
  (let loop ([from : Flonum 0.0] [sum : Flonum 0.0])
    (define to (least-above breaks from end))
    (define more
      (fl+ sum (if (and (fl= eta 0.0) (fl> from 0.0))
                   (visible-between from to c sine cosine alpha)
                   (lost-between from to c sine cosine alpha eta))))
    (if (fl< to end) (loop to more) more)))

;; The positive roots r of a r^2 - 2 b r + c, as w, into two places that are left alone else.
(: put-roots! (-> FlVector Fixnum Flonum Flonum Flonum Flonum Void))
(define (put-roots! breaks place a b c alpha)
  (define discriminant (fl- (fl* b b) (fl* a c)))
  (when (fl> discriminant 0.0)
    (define root (flsqrt discriminant))
    (define q (if (fl>= b 0.0) (fl+ b root) (fl- b root)))
    (define (put! [place : Fixnum] [above : Flonum] [below : Flonum])
      (when (fl> (fl* above below) 0.0)
        (flvector-set! breaks place (fl/ above (fl+ above (fl* alpha below))))))
    (put! place q a)
    (put! (fx+ place 1) c q)))

(: least-above (-> FlVector Flonum Flonum Flonum))
(define (least-above breaks low high)
  (let loop ([k : Fixnum 0] [least : Flonum high])
    (cond
      [(fx< k 6)
       (define b (flvector-ref breaks k))
       (loop (fx+ k 1) (if (and (fl> b low) (fl< b least)) b (fl+ least 0.0)))]
      [else (fl+ least 0.0)])))

;; The share of visible normals between two places: what is lost where all is lost.
(: visible-between (-> Flonum Flonum Flonum Flonum Flonum Flonum Flonum))
(define (visible-between from to c sine cosine alpha)
  (define-syntax-rule (at w)
    (let* ([angle (if (fl< w 1.0) (flatan (fl/ w (fl- 1.0 w))) 1.5707963267948966)]
           [s (flsin angle)])
      (fl+ (fl* (fl* cosine s) s)
           (fl* (fl* alpha (fl* sine c)) (fl- angle (fl* s (flcos angle)))))))
  (fl/ (fl* 2.0 (fl- (at to) (at from))) (fl+ cosine (GGX-length cosine alpha))))

(: lost-between (-> Flonum Flonum Flonum Flonum Flonum Flonum Flonum Flonum))
(define (lost-between from to c sine cosine alpha eta)
  (define length (GGX-length cosine alpha))
  (define less (fl* (fl- eta 1.0) (fl+ eta 1.0)))
  (let loop ([k : Fixnum 0] [sum : Flonum 0.0])
    (cond
      [(fx< k (RADII))
       (let* ([w (fl+ from (fl* (fl- to from) (flvector-ref RADIUS-RULE (fx* 2 k))))]
              [rest (fl- 1.0 w)]
              [ww (fl+ (fl* w w) (fl* rest rest))]
              [r (fl/ (fl* alpha w) rest)]
              [facing (fl+ cosine (fl* sine (fl* r c)))]
              [h-squared (fl/ 1.0 (fl+ 1.0 (fl* r r)))]
              [reflected (fl- (fl* 2.0 (fl* facing h-squared)) cosine)]
              [lost-above
               (if (fl> reflected 0.0) (GGX-masked-share cosine length reflected alpha) 1.0)]
              [lost
               (if (fl= eta 0.0)
                   lost-above
                   (let* ([h (flsqrt h-squared)]
                          [o-h (flmin 1.0 (flmax 0.0 (fl* facing h)))]
                          [reflectance (Fresnel-dielectric o-h eta)]
                          [beyond (flsqrt (flmax 0.0 (fl+ less (fl* o-h o-h))))]
                          [refracted (fl/ (fl- cosine (fl* h (fl- o-h beyond))) eta)]
                          [lost-below
                           (if (fl> refracted 0.0)
                               (GGX-masked-share cosine length refracted alpha)
                               1.0)])
                     (fl+ (fl* reflectance lost-above)
                          (fl* (fl- 1.0 reflectance) lost-below))))]
              ;; the density of visible normals in w
              [density (fl/ (fl* (fl* 4.0 facing) (fl* w rest))
                            (fl* (fl+ cosine length) (fl* ww ww)))])
         (loop (fx+ k 1)
               (fl+ sum (fl* (flvector-ref RADIUS-RULE (fx+ 1 (fx* 2 k))) (fl* density lost)))))]
      [else (fl* sum (fl- to from))])))

;; single-scattering-losses : lost-energy at all nodes, by quadrature: 10 to 30 ms.
(: single-scattering-losses (-> Flonum Flonum FlVector))
(define (single-scattering-losses alpha eta)
  (define column (make-flvector (+ 1 (CELLS))))
  (for ([node (in-range (+ 1 (CELLS)))])
    (flvector-set! column node
                   (flmin 1.0 (flmax 0.0 (lost-energy (node-cosine node alpha) alpha eta)))))
  column)

;; loss-table : columns of a surface of that eta, at roughnesses (k / ROUGHNESSES)^2.5; the first
;; stands for the limit of a smooth surface. Square roots, because away from grazing the losses grow
;; with alpha^2, and so that what is interpolated stays positive. Takes a quarter of a second.
(define-syntax-rule (ROUGHNESSES) 12)
(: loss-table (-> Flonum (Vectorof FlVector)))
(define (loss-table eta)
  (for/vector : (Vectorof FlVector) #:length (+ 1 (ROUGHNESSES))
              ([k : Nonnegative-Integer (in-range (+ 1 (ROUGHNESSES)))])
    (define part (fl/ (real->double-flonum k) (fx->fl (ROUGHNESSES))))
    (map-column flsqrt (single-scattering-losses (flmax 1e-6 (flexpt part 2.5)) eta))))

;; Of a surface that reflects everything; computed once, when first needed.
(define CONDUCTOR-TABLE : (Promise (Vectorof FlVector)) (once (lambda () (loss-table 0.0))))

(: map-column (-> (-> Flonum Flonum) FlVector FlVector))
(define (map-column f column)
  (define result (make-flvector (+ 1 (CELLS))))
  (for ([node (in-range (+ 1 (CELLS)))])
    (flvector-set! result node (f (flvector-ref column node))))
  result)

;; conductor-losses : the column of a surface that reflects everything; alpha in (0, 1].
(: conductor-losses (-> Flonum FlVector))
(define (conductor-losses alpha) (table-losses (force CONDUCTOR-TABLE) alpha))

;; table-losses : a column by the cubic through the four nearest columns of a table; alpha in (0, 1].
(: table-losses (-> (Vectorof FlVector) Flonum FlVector))
(define (table-losses table alpha)
  (define place (fl* (fx->fl (ROUGHNESSES)) (flexpt alpha 0.4)))
  (define first (max 0 (min (- (ROUGHNESSES) 3) (- (fl->fx place) 1))))
  (define t (fl- place (fx->fl first)))
  (define-values (t1 t2 t3) (values (fl- t 1.0) (fl- t 2.0) (fl- t 3.0)))
  (define column (make-flvector (+ 1 (CELLS)) 0.0))
  (define (add! [k : Fixnum] [weight : Flonum])
    (define from (vector-ref table (+ first k)))
    (for ([node (in-range (+ 1 (CELLS)))])
      (flvector-set! column node
                     (fl+ (flvector-ref column node) (fl* weight (flvector-ref from node))))))
  (add! 0 (fl/ (fl* t1 (fl* t2 t3)) -6.0))
  (add! 1 (fl/ (fl* t (fl* t2 t3)) 2.0))
  (add! 2 (fl/ (fl* t (fl* t1 t3)) -2.0))
  (add! 3 (fl/ (fl* t (fl* t1 t2)) 6.0))
  (map-column (lambda ([root : Flonum]) (flmin 1.0 (fl* root root))) column))

;; GGX-directional-albedo : the part of the light from a direction of that cosine, 0 to 1, that a
;; single-scattering GGX mirror of roughness alpha, 1e-4 to 1, returns. From the table; error below
;; 5e-4.
(: GGX-directional-albedo (-> Real Real Flonum))
(define (GGX-directional-albedo cosine alpha)
  (define a (check-between 'GGX-directional-albedo "alpha" alpha 1e-4 1.0))
  (define c (check-between 'GGX-directional-albedo "cosine" cosine 0.0 1.0))
  (fl- 1.0 (column-at (conductor-losses a) c a)))

;; GGX-average-albedo : its mean over the hemisphere by cosine.
(: GGX-average-albedo (-> Real Flonum))
(define (GGX-average-albedo alpha)
  (define a (check-between 'GGX-average-albedo "alpha" alpha 1e-4 1.0))
  (define column (conductor-losses a))
  (fl- 1.0 (average-over-cosine (lambda ([cosine : Flonum]) (column-at column cosine a)))))

;; A column at a cosine, by the line through the two nearest nodes.
(: column-at (-> FlVector Flonum Flonum Flonum))
(define (column-at column cosine alpha)
  (define place (fl* (fx->fl (CELLS)) (loss-coordinate cosine alpha)))
  (define cell (min (- (CELLS) 1) (fl->fx place)))
  (define t (fl- place (fx->fl cell)))
  (fl+ (fl* (fl- 1.0 t) (flvector-ref column cell)) (fl* t (flvector-ref column (+ cell 1)))))
