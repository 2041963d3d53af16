#lang scribble/manual
@; Points, directions and colours; rays and what they meet.
@(require (for-label racket/base raytrace))

@title[#:tag "reference-vectors"]{Vectors, colours and rays}

@declare-exporting[raytrace]

@section[#:tag "reference-vectors-float3"]{Vectors and colours}

@defproc[(Float3 [x real?] [y real?] [z real?]) Float3?]{
A point, a direction, or a linear RGB colour: three double-precision numbers. Any real number is
taken, infinities and NaN too; constructors of shapes, lights and materials check what they are
given. Anything else than a real number raises @racket[exn:fail:contract]. @racket[Float3] is a
pattern of @racketidfont{match} as well, and the name of the type in Typed Racket.}

@deftogether[(@defproc[(Float3? [v any/c]) boolean?]
              @defproc[(Float3-x [v Float3?]) flonum?]
              @defproc[(Float3-y [v Float3?]) flonum?]
              @defproc[(Float3-z [v Float3?]) flonum?])]{
Whether a value is a @racket[Float3], and its components: x, y, z or red, green, blue.}

@racketblock[
(define warm (Float3 1 0.8 1/2))
(equal? warm (Float3 1.0 0.8 0.5))   (code:comment "#t")
(Float3-x (Float3-scale-by-scalar warm 2))   (code:comment "2.0")
]

All operations below return new values, raise @racket[exn:fail:contract] where an argument is of
another kind, and check no ranges unless they say so.

@deftogether[(@defproc[(Float3-add [a Float3?] [b Float3?]) Float3?]
              @defproc[(Float3-subtract [a Float3?] [b Float3?]) Float3?]
              @defproc[(Float3-negate [v Float3?]) Float3?])]{
The sum by components, the difference @racketvarfont{a} − @racketvarfont{b}, and the opposite vector.}

@deftogether[(@defproc[(Float3-scale-by-scalar [v Float3?] [s real?]) Float3?]
              @defproc[(Float3-scale-by-vector [a Float3?] [b Float3?]) Float3?])]{
Every component times @racket[s], and the product by components, as for the colour of a light on that
of a surface.}

@deftogether[(@defproc[(Float3-dot [a Float3?] [b Float3?]) flonum?]
              @defproc[(Float3-cross [a Float3?] [b Float3?]) Float3?])]{
The dot product, and the right-handed cross product: that of the x axis and the y axis is the z axis.}

@deftogether[(@defproc[(Float3-length [v Float3?]) flonum?]
              @defproc[(Float3-length-squared [v Float3?]) flonum?]
              @defproc[(Float3-distance [a Float3?] [b Float3?]) flonum?])]{
The Euclidean length, its square, and the Euclidean distance of two points.}

@defproc[(Float3-normalized [v Float3?]) Float3?]{
The unit vector of the same direction. Lengths whose squares would overflow or vanish are right too,
and to normalize twice is to normalize once. A zero vector, or one with a component that is infinite
or NaN, raises @racket[exn:fail:contract].}

@defproc[(Float3-reflect [v Float3?] [normal Float3?]) Float3?]{
The mirror image 2 (@racketvarfont{v} · @racketvarfont{n}) @racketvarfont{n} − @racketvarfont{v} of a
vector that points away from the surface. The normal has to be a unit vector, of either side.}

@defproc[(Float3-clamped [v Float3?] [low real?] [high real?]) Float3?]{
Every component brought into the range from @racket[low] to @racket[high]; where @racket[low] is the
larger one, @racket[high].}

@defproc[(Float3-linear-interpolate [a Float3?] [b Float3?] [s real?]) Float3?]{
(1 − @racketvarfont{s}) @racketvarfont{a} + @racketvarfont{s} @racketvarfont{b}; @racket[s] may lie
outside of 0 to 1.}

@racketblock[
(define v (Float3 1 -1 0))
(define ground-normal (Float3 0 1 0))
(Float3-reflect (Float3-negate v) ground-normal)   (code:comment "(Float3 1.0 1.0 0.0)")
(Float3-length (Float3-normalized v))
(Float3-linear-interpolate (Float3 0 0 0) (Float3 1 1 1) 1/4)
]

@section[#:tag "reference-vectors-random"]{Random vectors}

Each of these is a function of its arguments alone. A @racket[seed] chooses a sequence that is spread
well, and an @racket[index] one of its elements; both are whole numbers from 0 to 2@superscript{32} −
1, and others raise @racket[exn:fail:contract].

@defproc[(Float3-random-hemisphere-direction [normal Float3?]
                                             [#:seed seed exact-nonnegative-integer? 0]
                                             [#:index index exact-nonnegative-integer? 0]) Float3?]{
A unit direction, uniform over the hemisphere around @racket[normal], which may be of any length but
zero.}

@defproc[(Float3-random-point-in-sphere [radius (>/c 0)]
                                        [#:seed seed exact-nonnegative-integer? 0]
                                        [#:index index exact-nonnegative-integer? 0]) Float3?]{
A point, uniform in the ball of that finite radius, in world units, around the origin.}

@defproc[(Float3-random-color [#:seed seed exact-nonnegative-integer? 0]
                              [#:index index exact-nonnegative-integer? 0]) Float3?]{
A colour, uniform in the unit cube.}

@racketblock[
(for/list ([k 4]) (Float3-random-point-in-sphere 2 #:seed 7 #:index k))
(Float3-random-color #:seed 1)
]

@section[#:tag "reference-vectors-rays"]{Rays and what they hit}

@defproc[(Ray [point Float3?] [direction Float3?] [time (real-in 0 1) 0.0]) Ray?]{
A half line from a finite point in a finite direction, of any length but zero; it is kept as it is.
The time is the moment at which moving shapes are met. Other values raise @racket[exn:fail:contract].}

@deftogether[(@defproc[(Ray? [v any/c]) boolean?]
              @defproc[(Ray-point [ray Ray?]) Float3?]
              @defproc[(Ray-direction [ray Ray?]) Float3?]
              @defproc[(Ray-time [ray Ray?]) flonum?])]{
Whether a value is a ray, and its parts.}

@defproc[(Ray-point-at [ray Ray?] [t real?]) Float3?]{
The point at the parameter @racket[t]: the ray's point plus @racket[t] times its direction. Where the
direction is a unit vector, @racket[t] is a distance in world units.}

@defproc[(Intersection [t real?] [point Float3?] [normal Float3?] [color Float3?]) Intersection?]{
What a ray meets: the parameter on the ray, the point, the unit normal, and one colour that stands
for the material, as @racket[Shape-intersect] says. The ranges are not checked; queries such as
@racket[World-nearest-hit] make these values.}

@deftogether[(@defproc[(Intersection? [v any/c]) boolean?]
              @defproc[(Intersection-t [hit Intersection?]) flonum?]
              @defproc[(Intersection-point [hit Intersection?]) Float3?]
              @defproc[(Intersection-normal [hit Intersection?]) Float3?]
              @defproc[(Intersection-color [hit Intersection?]) Float3?])]{
Whether a value is an intersection, and its parts.}

@defproc[(Intersection-empty) Intersection?]{
The intersection of a ray that meets nothing: its parameter is @racket[INTERSECTION-T-MAX], and all
else is zero.}

@defthing[INTERSECTION-T-MAX flonum?]{
10@superscript{300}: a parameter beyond every scene.}

@defthing[EPSILON flonum?]{
10@superscript{-6}: a fixed offset from a surface, for programs that want one. The library does not
use it: its rays start at an offset that is a bound of the error of their point.}

@racketblock[
(define ball (Sphere (Float3 0 0 0) 1 (Lambertian (Float3 0.5 0.5 0.5))))
(define ray (Ray (Float3 0 0 5) (Float3 0 0 -2)))
(define hit (Shape-intersect ball ray))
(Intersection-t hit)                               (code:comment "2.0")
(Ray-point-at ray (Intersection-t hit))            (code:comment "(Float3 0.0 0.0 1.0)")
(< (Intersection-t hit) INTERSECTION-T-MAX)        (code:comment "#t")
]
