#lang scribble/manual
@; What a camera sees: shapes, lights and what lies behind them; rays through it one at a time.
@(require (for-label racket/base racket/contract/base racket/math racket/match raytrace))
@title[#:tag "reference-worlds"]{Worlds}
@declare-exporting[raytrace]

A world is all that a camera may see: shapes, lights, a background, and perhaps a medium that fills
it.

@racketblock[
(define ball (Sphere (Float3 0 1 0) 1 (Lambertian (Float3 0.8 0.2 0.1))))
(define sun (DistantLight (Float3 1 2 1) (Float3 2 1.9 1.7)))
(define world (World (list ball) sun (Float3 0.45 0.65 1)))
(define camera (Camera-look-at (Float3 0 2 6) (Float3 0 1 0)))
(World-problems world camera)
(World-nearest-hit world (Ray (Float3 0 1 6) (Float3 0 0 -1)))
(define floor-too (World-add world (Plane (Float3 0 0 0) (Float3 0 1 0) (Float3 0.7 0.7 0.7))))
(render floor-too camera #:width 32 #:height 18 #:samples 4)
]

@defproc[(World [shapes (listof Shape?) '()]
                [lights (or/c Light? (listof Light?)) '()]
                [background (or/c Float3? GradientSky? EnvironmentMap?) (Float3 0.45 0.65 1.0)]
                [#:medium medium (or/c Medium? #f) #f]
                [#:ambient-color ambient-color (or/c Float3? #f) #f]
                [#:ambient-samples ambient-samples (integer-in 0 1000000) WORLD-AMBIENT-SAMPLES]
                [#:max-occlusion-distance distance (>/c 0) WORLD-MAX-OCCLUSION-DISTANCE]
                [#:ambient-weighting weighting (or/c 'uniform 'cosine) 'uniform]
                [#:occlusion-falloff falloff (or/c 'linear 'binary) 'linear]
                [#:shadow-samples shadow-samples (integer-in 0 1000000) 16]
                [#:mirror-bounces mirror-bounces (integer-in 0 1000000) 50])
         World?]{
A world of these shapes and lights; one light needs no list, and shapes that shine, by an
@racket[Emitter], are no lights but shapes. The first three may also be given by the keywords
@racket[#:shapes], @racket[#:lights] and @racket[#:background]. @racket[background] is what a ray
sees that meets no shape: a linear RGB colour with finite components of at least 0, a
@racket[GradientSky] or an @racket[EnvironmentMap]. @racket[medium] fills all space, and has no
density function.

The other keywords are for the article's shading, the integrator @racket['seed] of @racket[render],
and mean nothing to paths:

@itemlist[
@item{@racket[ambient-color]: light from everywhere, linear RGB. @racket[#f] takes the background's
 mean
 colour. Black costs no rays.}
@item{@racket[ambient-samples]: how many occlusion rays a point sends; 0 for none, when all ambient
 light
 arrives.}
@item{@racket[distance]: in world units, or infinite; what is farther does not occlude.}
@item{@racket[weighting]: whether occlusion rays are uniform over the hemisphere or go by the cosine.}
@item{@racket[falloff]: whether a hit counts by its share of the distance, @racket['linear], or as
 dark,
 @racket['binary].}
@item{@racket[shadow-samples]: rays to each light that has an area, at each point; lights without
 one take
 one ray. 0 for no shadows.}
@item{@racket[mirror-bounces]: how many mirrors a ray follows.}]

A world is compiled when it is first rendered or asked for a ray, and renders of the same world
share that. Worlds are compared by @racket[equal?] by all their parts. As a pattern of
@racket[match], @racket[World] has shapes, lights and background.

Raises @racket[exn:fail:contract] for a value of another kind or out of its range.}

@deftogether[(@defproc[(World? [value any/c]) boolean?]
              @defproc[(World-shapes [world World?]) (listof Shape?)]
              @defproc[(World-lights [world World?]) (listof Light?)]
              @defproc[(World-background [world World?])
                       (or/c Float3? GradientSky? EnvironmentMap?)]
              @defproc[(World-medium [world World?]) (or/c Medium? #f)])]{
The predicate and the fields; the lights are always a list.}

@deftogether[(@defproc[(World-spheres [world World?]) (listof Sphere?)]
              @defproc[(World-sun [world World?]) DistantLight?]
              @defproc[(World-background-color [world World?]) Float3?])]{
The article's accessors: the spheres among the shapes; the first @racket[DistantLight] among the
lights, which raises @racket[exn:fail:contract] where there is none; and one colour for the
background, its mean over all directions.}

@defthing[WORLD-AMBIENT-SAMPLES exact-positive-integer? #:value 64]{
The article's number of occlusion rays.}

@defthing[WORLD-MAX-OCCLUSION-DISTANCE flonum? #:value 5.0]{
The article's reach of ambient occlusion, in world units.}

@section[#:tag "reference-worlds-update"]{Worlds that differ a little}

Each function returns another world; what it does not name stays as it was.

@defproc[(World-add [world World?] [thing (or/c Shape? Light?)] ...) World?]{
The world with these shapes and lights too, in this order after those it has.}

@defproc[(World-with-shapes [world World?] [shapes (listof Shape?)]) World?]{
The world with these shapes in place of its own; those that shone are gone with the others.}

@defproc[(World-with-lights [world World?] [lights (or/c Light? (listof Light?))]) World?]{
The world with these lights in place of its own; shapes that shine stay.}

@defproc[(World-with-background [world World?]
                                [background (or/c Float3? GradientSky? EnvironmentMap?)])
         World?]{
The world before another background. Its ambient colour stays, unless it was the old background's:
then it is the new one's.}

@racketblock[
(define one (World (list (Sphere (Float3 0 1 0) 1 (Plastic (Float3 0.1 0.3 0.8))))))
(define dusk (World-with-background one (GradientSky (Float3 1 0.5 0.2) (Float3 0.1 0.2 0.5))))
(define lit (World-add dusk (PointLight (Float3 2 3 2) (Float3 20 20 20))))
(length (World-lights (World-with-lights lit '())))
]

@section[#:tag "reference-worlds-rays"]{One ray at a time}

These functions run what a render runs, and give the same numbers. Those that draw samples take them
from @racket[seed]: the same call gives the same result.

@defproc[(World-nearest-hit [world World?] [ray Ray?]) Intersection?]{
What the ray meets first: the parameter along the ray, the point, the unit normal and the colour that
@racket[Shape-intersect] tells. Where the ray meets nothing, the parameter is
@racket[INTERSECTION-T-MAX].}

@defproc[(World-occluded? [world World?] [ray Ray?] [limit (>/c 0) INTERSECTION-T-MAX]) boolean?]{
Whether the ray meets anything at a parameter below @racket[limit], which counts in lengths of the
ray's direction. Raises @racket[exn:fail:contract] for a limit that is not positive.}

@defproc[(World-ray-trace [world World?] [ray Ray?]
                          [#:seed seed (integer-in 0 4294967295) 0])
         Float3?]{
One sample of the colour seen along the ray, linear RGB, by the integrator @racket['auto] of
@racket[render].}

@defproc[(World-get-color-at [world World?] [ray Ray?] [intersection Intersection?]
                             [#:seed seed (integer-in 0 4294967295) 0])
         Float3?]{
The shaded colour at an intersection of the ray. Where that is the ray's nearest hit, it is what
@racket[World-ray-trace] sees; elsewhere an article's surface of the intersection's colour is
assumed, a @racket[Phong] with its defaults.}

@defproc[(World-get-ambient-percent [world World?] [point Float3?] [normal Float3?]
                                    [#:seed seed (integer-in 0 4294967295) 0])
         flonum?]{
The share of ambient light, from 0 to 1, that reaches a point with that normal: 1 where nothing is
near. The normal has any length but 0. How many rays are sent, how far and in which directions is as
the world's keywords say; 1 where it sends none.}

@section[#:tag "reference-worlds-problems"]{What is probably wrong}

@defproc[(World-problems [world World?] [camera Camera?]
                         [#:integrator integrator symbol? 'auto]
                         [#:max-depth max-depth (or/c exact-nonnegative-integer? #f) #f]
                         [#:aspect aspect (>/c 0) 16/9])
         (listof string?)]{
A list of sentences, each one thing that is probably a mistake and what to do about it; empty where
nothing looks wrong. It finds: no light at all; a camera or a light inside an opaque shape; no
shapes, or none that the camera sees; a picture that is black or white throughout; samples that are
no numbers of at least 0. A camera or lamp in a room with everything else is no mistake.

Two small pictures are rendered to see, 60 pixels high and @racket[aspect] times as wide, with 4
samples a pixel. @racket[integrator] and @racket[max-depth] are as @racket[render] takes them.
Raises @racket[exn:fail:contract] where @racket[world] is no @racket[World] or @racket[camera] no
@racket[Camera].}
