#lang scribble/manual
@; Affine maps of space: what makes them, what they are composed of, what they do to points.
@(require (for-label racket/base raytrace))

@title[#:tag "reference-transforms"]{Transforms}

@declare-exporting[raytrace]

A transform is an affine map of space, kept with its inverse. @racket[Instance] and @racket[Moving]
place shapes with it. Arguments that do not fit raise @racket[exn:fail:contract], among them numbers
that are not finite and maps that flatten space so far that they cannot be undone in double precision.

@section[#:tag "reference-transforms-make"]{Making transforms}

@defproc[(Transform [a real?] [b real?] [c real?] [d real?]
                    [e real?] [f real?] [g real?] [h real?]
                    [i real?] [j real?] [k real?] [l real?]) Transform?]{
The map with the matrix of rows (a b c d), (e f g h), (i j k l) and (0 0 0 1), for column vectors: d,
h and l are how far it moves the origin. Transforms print in this form. It is a procedure, and no
pattern of @racketidfont{match}; see @racket[Transform-matrix-rows].}

@defproc[(Transform? [v any/c]) boolean?]{
Whether a value is a transform. Two transforms are @racket[equal?] where their matrices are.}

@defproc[(Transform-matrix-rows [transform Transform?]) (listof (listof flonum?))]{
The first three rows of the matrix, four numbers each; the last row is 0 0 0 1.}

@defproc[(Transform-identity) Transform?]{
The map that leaves everything where it is.}

@defproc*[([(Transform-translate [offset Float3?]) Transform?]
           [(Transform-translate [x real?] [y real?] [z real?]) Transform?])]{
Moves by a vector, or by three numbers, in world units.}

@defproc*[([(Transform-scale [factor real?]) Transform?]
           [(Transform-scale [x real?] [y real?] [z real?]) Transform?])]{
Stretches from the origin by one factor, or by one along each axis. Negative factors mirror. Zero
raises, and so does a factor so small that its reciprocal overflows.}

@defproc[(Transform-rotate [axis Float3?] [radians (or/c #f real?) #f]
                           [#:degrees degrees (or/c #f real?) #f]) Transform?]{
Turns about an axis through the origin, counter-clockwise as seen from its tip, by Rodrigues'
formula. The axis may be of any length but zero. The angle is given once, in radians by place or in
degrees by keyword; both or none raise. Whole multiples of 90 degrees are turned by exactly.}

@defproc[(Transform-shear [#:x-by-y x-by-y real? 0.0] [#:x-by-z x-by-z real? 0.0]
                          [#:y-by-x y-by-x real? 0.0] [#:y-by-z y-by-z real? 0.0]
                          [#:z-by-x z-by-x real? 0.0] [#:z-by-y z-by-y real? 0.0]) Transform?]{
Moves each coordinate in proportion to the others: @racket[x-by-y] is how far x moves for each unit
of y, and so on.}

@defproc[(Transform-look-at [eye Float3?] [focus Float3?] [up Float3? (Float3 0 1 0)]) Transform?]{
Takes what was made at the origin, looking along −z with its top towards +y, to @racket[eye], so that
it looks at @racket[focus] with its top towards @racket[up]. Distances stay; the inverse is the usual
view matrix. Raises where eye and focus agree, or @racket[up] is zero or along the line of sight.}

@section[#:tag "reference-transforms-use"]{Composing and applying}

@defproc[(Transform-compose [transform Transform?] ...) Transform?]{
The map that does the last of its arguments first and the first one last; the identity of none.}

@defproc[(Transform-inverse [transform Transform?]) Transform?]{
The map that undoes it.}

@deftogether[(@defproc[(Transform-point [transform Transform?] [point Float3?]) Float3?]
              @defproc[(Transform-vector [transform Transform?] [vector Float3?]) Float3?]
              @defproc[(Transform-normal [transform Transform?] [normal Float3?]) Float3?])]{
The image of a point; that of a direction, with its length and without the translation; and the unit
normal of the image of a surface, by the transpose of the inverse. A zero normal raises.}

@racketblock[
(define lean (Transform-shear #:x-by-y 1/2))
(define turn (Transform-rotate (Float3 0 1 0) #:degrees 90))
(define same-turn (Transform-rotate (Float3 0 1 0) (/ pi 2)))
(define place (Transform-compose (Transform-translate 0 1 0) turn (Transform-scale 2)))
(Transform-point place (Float3 1 0 0))       (code:comment "(Float3 0.0 1.0 -2.0)")
(Transform-vector place (Float3 1 0 0))      (code:comment "(Float3 0.0 0.0 -2.0)")
(Transform-normal lean (Float3 1 0 0))
(Transform-point (Transform-inverse place) (Float3 0 1 -2))
(Transform-matrix-rows lean)
(Instance (Box (Float3 -1 0 -1) (Float3 1 2 1) (Lambertian (Float3 0.2 0.5 0.8))) lean)
]
