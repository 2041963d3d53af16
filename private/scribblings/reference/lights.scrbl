#lang scribble/manual
@; Lights without a surface, the sky and the sun, and what rays see where they meet nothing.
@(require (for-label racket/base racket/contract/base racket/match racket/math raytrace))
@title[#:tag "reference-lights"]{Lights and what lies behind everything}
@declare-exporting[raytrace]

A shape shines when its material is an @racket[Emitter]. The lights of this page have no surface:
they light what they reach and cast sharp shadows, but no ray can meet them, so that they are seen
neither directly nor in a mirror nor through glass. Colours are linear RGB with finite components of
at least 0, and may be above 1.

@racketblock[
(define world
  (World (list (Plane (Float3 0 0 0) (Float3 0 1 0) (Lambertian (Float3 0.6 0.6 0.6)))
               (Sphere (Float3 0 1 0) 1 (Lambertian (Float3 0.8 0.2 0.1))))
         (list (DistantLight (Float3 1 2 1) (Float3 2 1.9 1.7))
               (PointLight (Float3 -2 3 1) (Float3 6 6 8))
               (SpotLight (Float3 0 5 2) (Float3 0 -5 -2) (Float3 20 20 20)
                          (* 1/8 pi) (* 1/12 pi)))
         (GradientSky (Float3 1 1 1) (Float3 0.5 0.7 1))))
(define camera (Camera-look-at (Float3 0 2 6) (Float3 0 1 0)))
(render world camera #:width 32 #:height 18 #:samples 4)
]

@section[#:tag "reference-lights-lights"]{Lights}

@defproc[(Light? [value any/c]) boolean?]{
Whether a value is a @racket[DistantLight], a @racket[PointLight] or a @racket[SpotLight].
Backgrounds are no lights in this sense, and neither are shapes that shine: all of them light a
world without being listed among its lights.}

@defproc[(DistantLight [direction Float3?] [color Float3?]) DistantLight?]{
A light so far away that its direction is the same everywhere: the sun without its disk.
@racket[direction] points towards the light and has any length but 0. @racket[color] is the
irradiance on a surface that faces it: a white matte surface under @racket[(Float3 pi pi pi)] has
radiance 1.

Raises @racket[exn:fail:contract] for a direction that is zero or not finite, and for a colour with a
component that is negative or not finite.}

@deftogether[(@defproc[(DistantLight? [value any/c]) boolean?]
              @defproc[(DistantLight-direction [light DistantLight?]) Float3?]
              @defproc[(DistantLight-color [light DistantLight?]) Float3?])]{
The predicate and the fields; the direction is kept with length 1.}

@defproc[(PointLight [point Float3?] [intensity Float3?]) PointLight?]{
A light that shines from one point equally in all directions. @racket[intensity] is its radiant
intensity: a surface that faces it at distance @italic{d} receives the irradiance @racket[intensity]
/ @italic{d}².

Raises @racket[exn:fail:contract] for a point that is not finite, and for an intensity with a
component that is negative or not finite.}

@deftogether[(@defproc[(PointLight? [value any/c]) boolean?]
              @defproc[(PointLight-point [light PointLight?]) Float3?]
              @defproc[(PointLight-intensity [light PointLight?]) Float3?])]{
The predicate and the fields.}

@defproc[(SpotLight [point Float3?] [direction Float3?] [intensity Float3?]
                    [cone-angle (and/c (>/c 0) (<=/c pi))]
                    [falloff-angle (and/c (>=/c 0) (<=/c cone-angle))])
         SpotLight?]{
A light that shines from @racket[point] into a cone around @racket[direction], which has any length
but 0. @racket[intensity] is the radiant intensity along the axis, as for a @racket[PointLight].
Both angles are in radians, measured from the axis. Up to @racket[falloff-angle] the intensity is
whole; from there to @racket[cone-angle] it falls to 0 as the smoothstep 3@italic{s}² - 2@italic{s}³
of the cosine. Equal angles give a sharp edge. The opening of the whole cone is twice
@racket[cone-angle].

Raises @racket[exn:fail:contract] for other values.}

@deftogether[(@defproc[(SpotLight? [value any/c]) boolean?]
              @defproc[(SpotLight-point [light SpotLight?]) Float3?]
              @defproc[(SpotLight-direction [light SpotLight?]) Float3?]
              @defproc[(SpotLight-intensity [light SpotLight?]) Float3?]
              @defproc[(SpotLight-cone-angle [light SpotLight?]) flonum?]
              @defproc[(SpotLight-falloff-angle [light SpotLight?]) flonum?])]{
The predicate and the fields; the direction is kept with length 1, the angles in radians.}

@section[#:tag "reference-lights-background"]{Backgrounds}

The background of a @racket[World] is what a ray sees that meets no shape: one colour, a
@racket[GradientSky] or an @racket[EnvironmentMap]. It lights the world from all sides.

@defproc[(GradientSky [bottom Float3?] [top Float3?]) GradientSky?]{
A sky that goes from @racket[bottom], seen straight down, to @racket[top], seen straight up,
linearly in the y of the direction: the sky of @italic{Ray Tracing in One Weekend}. Both are
radiances. Raises @racket[exn:fail:contract] for a colour with a component that is negative or not
finite.}

@deftogether[(@defproc[(GradientSky? [value any/c]) boolean?]
              @defproc[(GradientSky-bottom [sky GradientSky?]) Float3?]
              @defproc[(GradientSky-top [sky GradientSky?]) Float3?])]{
The predicate and the fields.}

@defproc[(EnvironmentMap [image Image?]
                         [#:rotation-degrees degrees (real-in -1e6 1e6) 0]
                         [#:scale scale (real-in 0 1e30) 1])
         EnvironmentMap?]{
Radiance from all directions out of a picture: longitude across it, latitude down it
(equirectangular). The middle of the picture is seen along -z, its right half towards +x, its top
row straight up; so a @racket[Camera-panoramic] that looks along -z sees it. Between the middles of
its pixels it is interpolated, across the seam too. @racket[degrees] turns it about the y axis,
counterclockwise seen from above; @racket[scale] multiplies its radiance.

Directions are sampled by the picture's luminance and the solid angle of its pixels, so that small
bright places light the world without much noise. Any width and height will do; twice as wide as
high has square pixels at the horizon. Raises @racket[exn:fail:contract] where a pixel is negative,
not a number or above 1e30, and where a number is out of its range.}

@deftogether[(@defproc[(EnvironmentMap? [value any/c]) boolean?]
              @defproc[(EnvironmentMap-image [map EnvironmentMap?]) Image?]
              @defproc[(EnvironmentMap-rotation [map EnvironmentMap?]) flonum?]
              @defproc[(EnvironmentMap-scale [map EnvironmentMap?]) flonum?])]{
The predicate and the fields; the rotation is in radians. As a pattern of @racket[match],
@racket[EnvironmentMap] has the picture alone.}

@section[#:tag "reference-lights-daylight"]{Daylight}

A clear sky by day and its sun, after A. J. Preetham, P. Shirley and B. Smits, @italic{A Practical
Analytic Model for Daylight} (1999). The model's luminances, in thousands of candela a square metre,
and illuminances, in thousands of lux, are multiplied by the scale. The default of 0.06 makes
pictures about as bright as those of a white background. Give both functions the same direction,
turbidity and scale.

@defproc[(daylight-sky [sun-direction Float3?]
                       [#:turbidity turbidity (real-in 2 10) 3.0]
                       [#:scale scale (>=/c 0) 0.06]
                       [#:ground ground Float3? (Float3 0.12 0.11 0.1)]
                       [#:width width (and/c even? (integer-in 8 8192)) 256])
         EnvironmentMap?]{
The sky without the sun's disk. @racket[sun-direction] points towards the sun, with any length,
above the horizon: its y is positive. @racket[turbidity] is the haze, from 2 for clear to 10 for
hazy. @racket[ground] is the radiance of what lies below the horizon; @racket[scale] leaves it
alone. The picture is @racket[width] pixels wide and half as high.

Raises @racket[exn:fail:contract] where the sun is not above the horizon or a number is out of its
range.}

@defproc[(daylight-sun [sun-direction Float3?]
                       [#:turbidity turbidity (real-in 2 10) 3.0]
                       [#:scale scale (>=/c 0) 0.06])
         DistantLight?]{
The sun of that sky, whitest overhead and reddened near the horizon by the air that its light passes:
Rayleigh scattering and haze at one wavelength for each of red, green and blue. Raises
@racket[exn:fail:contract] as @racket[daylight-sky] does.}

@racketblock[
(define towards-sun (Float3 1 0.6 0.8))
(define ground (Plane (Float3 0 0 0) (Float3 0 1 0) (Lambertian (Float3 0.4 0.4 0.4))))
(define hazy
  (World (list ground (Sphere (Float3 0 1 0) 1 (Plastic (Float3 0.1 0.3 0.8))))
         (daylight-sun towards-sun #:turbidity 5)
         (daylight-sky towards-sun #:turbidity 5 #:width 64)))
(render hazy (Camera-look-at (Float3 0 2 6) (Float3 0 1 0)) #:width 32 #:height 18 #:samples 4)
]
