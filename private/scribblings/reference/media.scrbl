#lang scribble/manual
@; Fog, smoke and milk: what fills a shape or the whole world and scatters light on its way.
@(require (for-label racket/base racket/contract/base racket/math raytrace))
@title[#:tag "reference-media"]{Media}
@declare-exporting[raytrace]

A medium takes light from a ray on its way, and scatters part of it: fog, smoke, milk. It fills the
whole world, as @racket[#:medium] of @racket[World], or a closed shape whose material is an
@racket[Interior]. Path tracing sees media: the integrators @racket['path], @racket['naive-path] and
@racket['auto] of @racket[render]; the integrator @racket['seed], the views and previews do not.

@racketblock[
(define (cloud point)
  (max 0 (- 1 (Float3-distance point (Float3 1.2 1 0)))))
(define smoke (Medium 3 (Float3 0.2 0.2 0.2)))
(define milk (Medium (Float3 0.5 1 2) (Float3 0.95 0.9 0.8) #:anisotropy 0.5))
(define white (Float3 0.95 0.95 0.95))
(define world
  (World (list (Plane (Float3 0 0 0) (Float3 0 1 0) (Lambertian (Float3 0.5 0.5 0.5)))
               (Sphere (Float3 -3.5 1 0) 1 (Interior smoke))
               (Sphere (Float3 -1.2 1 0) 1 (Interior milk #:surface (Dielectric 1.33)))
               (Sphere (Float3 1.2 1 0) 1 (Interior (Medium 8 white #:density cloud))))
         (DistantLight (Float3 1 2 1) (Float3 2 2 2))
         (Float3 0.5 0.7 1)
         #:medium (Medium 0.02 white)))
(define camera (Camera-look-at (Float3 0 2 8) (Float3 -1 1 0)))
(render world camera #:width 32 #:height 18 #:samples 2)
]

@defproc[(Medium [extinction (or/c (>=/c 0) Float3?)] [albedo Float3?]
                 [#:anisotropy anisotropy (real-in -0.999 0.999) 0]
                 [#:density density (or/c (-> Float3? real?) #f) #f]
                 [#:majorant majorant (>/c 0) 1])
         Medium?]{
A medium. The last three may also be given by place, in this order after the others.

@itemlist[
@item{@racket[extinction] is what fades, one over the world unit: light falls as the exponential of
 -@racket[extinction] times the distance, and goes 1/@racket[extinction] on average before it meets
 something. A number fades all colours alike; a linear RGB colour, with finite components of at
 least 0, each as it says.}
@item{@racket[albedo] is the part of what is lost that is scattered and not absorbed, linear RGB with
 components from 0 (all is absorbed) to 1 (nothing is).}
@item{@racket[anisotropy] is the mean cosine of the angle by which scattered light is turned: from
 -0.999 (back) over 0 (all directions alike) to 0.999 (straight on). The phase function is that of
 L. G. Henyey and J. L. Greenstein, @italic{Diffuse radiation in the Galaxy} (1941).}
@item{@racket[density] is a pure function from a point to a number from 0 to @racket[majorant], by
 which the extinction is multiplied there; what is more counts as @racket[majorant], what is less
 than 0 or not a number as 0. @racket[#f] is 1 everywhere. A medium with a density fills shapes, not
 the world. A world with one cannot be sent to places or hosts unless they load its scene: see
 @racket[#:scene] at @racket[render].}
@item{@racket[majorant] is what the density nowhere exceeds, positive and finite. The tighter it is,
 the faster the render.}]

Distances are chosen by tracking with colour-dependent chances (P. Kutz and others,
@italic{Spectral and Decomposition Tracking}, 2017), the light left along a shadow ray in a
varying density by ratio tracking (J. Novák, A. Selle and W. Jarosz, 2014), and points near lamps
by their angle from the lamp (C. Kulla and M. Fajardo, @italic{Importance Sampling Techniques for
Path Tracing in Participating Media}, 2012).

A @racket[PointLight] or @racket[SpotLight] deep in a dense medium leaves single bright pixels, for
the light scattered twice near it is unbounded with a finite mean; more samples thin them out, and a
small shining sphere in its place bounds them.

Raises @racket[exn:fail:contract] for values out of their range.}

@deftogether[(@defproc[(Medium? [value any/c]) boolean?]
              @defproc[(Medium-extinction [medium Medium?]) Float3?]
              @defproc[(Medium-albedo [medium Medium?]) Float3?]
              @defproc[(Medium-anisotropy [medium Medium?]) flonum?]
              @defproc[(Medium-density [medium Medium?]) (or/c (-> Float3? real?) #f)]
              @defproc[(Medium-majorant [medium Medium?]) flonum?])]{
The predicate and the fields; the extinction is a colour even where a number was given.}

@defproc[(Interior [medium Medium?] [#:surface surface (or/c Material? #f) #f]) Interior?]{
The material of a closed shape that is filled with @racket[medium]. @racket[surface] is a material
that transmits, such as a @racket[Dielectric] or a @racket[RoughDielectric], or @racket[#f] where
there is nothing to see but the medium; it may also be given second, by place. Where shapes overlap,
their media are all there, at most 8 at one place. A shape that is not closed, as a @racket[Quad],
has no inside to fill.

Raises @racket[exn:fail:contract] where @racket[surface] is an @racket[Emitter] or an
@racket[Interior] itself.}

@deftogether[(@defproc[(Interior? [value any/c]) boolean?]
              @defproc[(Interior-medium [material Interior?]) Medium?]
              @defproc[(Interior-surface [material Interior?]) (or/c Material? #f)])]{
The predicate and the fields.}
