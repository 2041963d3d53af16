#lang typed/racket/base
;; How much of the light a smooth boundary reflects, and where it sends the rest: operations that
;; fuse in kernels. Unpolarised light; cosine is that of the angle of incidence, from 0 to 1.
(require "../base/unsafe.rkt" "../base/float3.rkt")

(provide Fresnel-dielectric Fresnel-schlick Fresnel-schlick-dielectric
         Fresnel-conductor Fresnel-conductor-color Float3-refract
         Fresnel-dielectric/function Fresnel-schlick/function Fresnel-schlick-dielectric/function
         Fresnel-conductor/function Fresnel-conductor-color/function Float3-refract/function
         Fresnel-average Fresnel-average-inside)

;; The square of the refracted ray's cosine times eta, negative in total internal reflection;
;; factored so that neither small nor nearly equal indices lose digits.
(define-syntax-rule (refracted-square cosine eta)
  (fl+ (fl* (fl- eta 1.0) (fl+ eta 1.0)) (fl* cosine cosine)))

;; Fresnel-dielectric : the reflected part at a boundary of two clear media, from 0 to 1, and 1 in
;; total internal reflection. eta: index of refraction of the far side over that of the near side.
(define-float3-operation (Fresnel-dielectric [cosine : Flonum] [eta : Flonum])
  #:let ([square (refracted-square cosine eta)]
         [refracted (flsqrt (flmax 0.0 square))]
         [across (fl/ (fl- cosine refracted) (fl+ cosine refracted))]
         [scaled (fl* (fl* eta eta) cosine)]
         [within (fl/ (fl- scaled refracted) (fl+ scaled refracted))])
  : Flonum (if (fl> square 0.0)
               (fl* 0.5 (fl+ (fl* across across) (fl* within within)))
               1.0))

;; Fresnel-schlick : Schlick's approximation ("An Inexpensive BRDF Model for Physically-based
;; Rendering", 1994) of the reflected part, given that of light along the normal.
(define-float3-operation (Fresnel-schlick [cosine : Flonum] [at-normal : Flonum])
  #:let ([x (flmax 0.0 (fl- 1.0 cosine))] [xx (fl* x x)])
  : Flonum (fl+ at-normal (fl* (fl- 1.0 at-normal) (fl* x (fl* xx xx)))))

;; Fresnel-schlick-dielectric : the same as "Ray Tracing in One Weekend" uses it: on both sides of
;; the boundary with the cosine of incidence, and 1 in total internal reflection. From the denser
;; side it is too small: .041 where .380 is right (41 degrees, eta 1/1.5).
(define-float3-operation (Fresnel-schlick-dielectric [cosine : Flonum] [eta : Flonum])
  #:let ([ratio (fl/ (fl- eta 1.0) (fl+ eta 1.0))])
  : Flonum (if (fl> (refracted-square cosine eta) 0.0)
               (Fresnel-schlick cosine (fl* ratio ratio))
               1.0))

;; Fresnel-conductor : the reflected part at a conductor of complex index eta + i k, relative to
;; the near side (Born and Wolf, Principles of Optics, section 14.2, in squares).
(define-float3-operation (Fresnel-conductor [cosine : Flonum] [eta : Flonum] [k : Flonum])
  #:let ([c-squared (fl* cosine cosine)]
         [s-squared (fl* (fl- 1.0 cosine) (fl+ 1.0 cosine))]
         [product (fl* (fl* 2.0 eta) k)]
         [difference (fl- (fl* (fl- eta k) (fl+ eta k)) s-squared)]
         [sum (flsqrt (fl+ (fl* difference difference) (fl* product product)))]
         ;; (sum + difference) / 2, without cancelling where the difference is negative
         [a-squared (if (fl>= difference 0.0)
                        (fl* 0.5 (fl+ sum difference))
                        (fl/ (fl* 0.5 (fl* product product)) (fl- sum difference)))]
         [twice (fl* 2.0 (fl* cosine (flsqrt a-squared)))]
         [across (fl/ (fl- (fl+ sum c-squared) twice) (fl+ (fl+ sum c-squared) twice))]
         [u (fl+ (fl* c-squared sum) (fl* s-squared s-squared))]
         [v (fl* twice s-squared)])
  : Flonum (if (fl> cosine 0.0)
               (fl* 0.5 (fl* across (fl+ 1.0 (fl/ (fl- u v) (fl+ u v)))))
               1.0))

;; Fresnel-conductor-color : the same for the three components of linear RGB.
(define-float3-operation
  (Fresnel-conductor-color [cosine : Flonum] [(ex ey ez) : Float3] [(kx ky kz) : Float3])
  : Float3 ((Fresnel-conductor cosine ex kx)
            (Fresnel-conductor cosine ey ky)
            (Fresnel-conductor cosine ez kz)))

;; Float3-refract : the direction in which light goes on that came against v: v is the unit vector
;; back to where it came from, n the unit normal of that side, eta as above. In total internal
;; reflection there is none, and the result means nothing.
(define-float3-operation
  (Float3-refract [(vx vy vz) : Float3] [(nx ny nz) : Float3] [eta : Flonum])
  #:let ([cosine (fl+ (fl+ (fl* vx nx) (fl* vy ny)) (fl* vz nz))]
         [s (fl- cosine (flsqrt (flmax 0.0 (refracted-square cosine eta))))])
  : Float3 ((fl/ (fl- (fl* s nx) vx) eta)
            (fl/ (fl- (fl* s ny) vy) eta)
            (fl/ (fl- (fl* s nz) vz) eta)))

;; Fresnel-average : the part of diffuse light that a denser medium of index eta >= 1 reflects from
;; outside, which is the mean over the hemisphere by cosine (Walsh 1926), for eta up to 100. Error
;; below 1e-9, and below 1e-13 for eta >= 1.01.
(: Fresnel-average (-> Flonum Flonum))
(define (Fresnel-average eta)
  (define n2 (fl* eta eta))
  (define n4 (fl* n2 n2))
  (define less (fl* (fl- eta 1.0) (fl+ eta 1.0)))
  (define n4-less (fl* less (fl+ n2 1.0)))
  (cond
    ;; the formula's limit, where its terms cancel
    [(fl< eta 1.000001) (fl/ less 6.0)]
    [else
     (fl+ (fl+ 0.5 (fl/ (fl* (fl- eta 1.0) (fl+ (fl* 3.0 eta) 1.0))
                        (fl* 6.0 (fl* (fl+ eta 1.0) (fl+ eta 1.0)))))
          (fl+ (fl* (fl/ (fl* n2 (fl* less less))
                         (fl* (fl+ n2 1.0) (fl* (fl+ n2 1.0) (fl+ n2 1.0))))
                    (fllog (fl/ (fl- eta 1.0) (fl+ eta 1.0))))
               (fl- (fl/ (fl* 8.0 (fl* n4 (fl* (fl+ n4 1.0) (fllog eta))))
                         (fl* (fl+ n2 1.0) (fl* n4-less n4-less)))
                    (fl/ (fl* 2.0 (fl* (fl* n2 eta) (fl+ n2 (fl- (fl* 2.0 eta) 1.0))))
                         (fl* (fl+ n2 1.0) n4-less)))))]))

;; Fresnel-average-inside : the same for light that comes from within the denser medium, total
;; internal reflection included; by reciprocity.
(: Fresnel-average-inside (-> Flonum Flonum))
(define (Fresnel-average-inside eta)
  (fl- 1.0 (fl/ (fl- 1.0 (Fresnel-average eta)) (fl* eta eta))))
