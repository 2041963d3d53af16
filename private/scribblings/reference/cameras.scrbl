#lang scribble/manual
@; Cameras, how they move, and where they see a point of the world.
@(require (for-label racket/base raytrace))

@title[#:tag "reference-cameras"]{Cameras}

@declare-exporting[raytrace]

A camera does not know how many pixels its picture has: @racket[render] keeps the height of the view
and makes it as wide as the picture needs. Arguments that do not fit raise
@racket[exn:fail:contract].

@section[#:tag "reference-cameras-make"]{Making a camera}

@defproc[(Camera-look-at [eye Float3?] [focus Float3?]
                         [#:up up Float3? (Camera-global-up)]
                         [#:aspect aspect (>/c 0) 16/9]
                         [#:zoom zoom (>/c 0) 1.5]
                         [#:vertical-field-of-view-degrees degrees (real-in 1e-9 179.9999999)
                                                           #,(elem "that of " (racket zoom))]
                         [#:lens-radius lens-radius (>=/c 0) 0.0]
                         [#:focus-distance focus-distance (or/c #f (>/c 0)) #f]) Camera?]{
A camera at @racket[eye] that looks at @racket[focus]. @racket[zoom] is the distance of the image
plane where that plane is 2 high; an angle from the lower to the upper edge, in degrees, says the
same and comes first where both are given. @racket[aspect] is the width of the view for a height of
1. A lens with a radius above 0, in world units, blurs what is nearer or farther than
@racket[focus-distance], which is the distance of @racket[focus] where it is @racket[#f]. Up, aspect
and zoom may be given by place too. Raises where eye and focus agree, or @racket[up] is zero or along
the line of sight.}

@defproc[(Camera-orthographic [eye Float3?] [focus Float3?]
                              [#:height height (>/c 0)]
                              [#:up up Float3? (Camera-global-up)]
                              [#:lens-radius lens-radius (>=/c 0) 0.0]
                              [#:focus-distance focus-distance (or/c #f (>/c 0)) #f]) Camera?]{
Parallel rays along the line from @racket[eye] to @racket[focus], from the plane through the eye on;
@racket[height] world units from the lower to the upper edge of the picture. Lens and errors are
those of @racket[Camera-look-at].}

@defproc[(Camera-panoramic [eye Float3?] [focus Float3?]
                           [#:up up Float3? (Camera-global-up)]) Camera?]{
All directions around the eye, that to @racket[focus] in the middle: longitude across the picture,
latitude down it (equirectangular). In a picture twice as wide as high the pixels at the equator are
squares. It has no lens.}

@defproc[(Camera-fisheye [eye Float3?] [focus Float3?]
                         [#:up up Float3? (Camera-global-up)]
                         [#:field-of-view-degrees degrees (real-in 1e-6 360) 180.0]
                         [#:lens-radius lens-radius (>=/c 0) 0.0]
                         [#:focus-distance focus-distance (or/c #f (>/c 0)) #f]) Camera?]{
An equidistant fisheye: the angle from the line of sight grows with the distance from the middle of
the picture. The field of view, in degrees, is that from corner to corner. What is sharp lies on a
sphere of radius @racket[focus-distance].}

@racketblock[
(define world
  (World (list (Sphere (Float3 0 1 0) 1 (Lambertian (Float3 0.8 0.2 0.1)))) '() (Float3 1 1 1)))
(define eye (Float3 0 2 6))
(define middle (Float3 0 1 0))
(for ([camera (list (Camera-look-at eye middle #:vertical-field-of-view-degrees 32)
                    (Camera-look-at eye middle #:zoom 3 #:lens-radius 0.1)
                    (Camera-orthographic eye middle #:height 4)
                    (Camera-panoramic eye middle)
                    (Camera-fisheye eye middle #:field-of-view-degrees 120))])
  (render world camera #:width 32 #:height 18 #:samples 4))
]

@defproc[(Camera [eye Float3?] [forward Float3?] [right Float3?] [up Float3?]
                 [#:lens-radius lens-radius (>=/c 0) 0.0]
                 [#:focus-distance focus-distance (>/c 0) 1.0]
                 [#:blades blades (or/c 0 (integer-in 3 1000)) 0]
                 [#:projection projection
                               (or/c 'perspective 'orthographic 'panoramic 'fisheye) 'perspective]
                 [#:angle angle (real-in 1e-9 pi) 1.0]
                 [#:shutter-open shutter-open (real-in 0 1) 0.0]
                 [#:shutter-close shutter-close (real-in shutter-open 1) 1.0]
                 [#:end end (or/c #f Camera?) #f]) Camera?]{
A camera of its parts. @racket[forward] goes from the eye to the middle of the image plane,
@racket[right] and @racket[up] from there to the middles of its right and of its upper edge; none may
be zero. Lens radius and focus distance are in world units, the latter along @racket[forward]; both
may be given by place. The aperture is round, or a regular polygon with @racket[blades] corners, one
of them at the top. @racket[angle] is used by a fisheye alone: radians from the middle of the picture
to its corner. Light is gathered from @racket[shutter-open] to @racket[shutter-close], parts of the
time from 0 to 1, and @racket[end] is the camera at time 1 where it moves. A panoramic camera with a
lens raises. In a pattern of @racketidfont{match}, @racket[Camera] has six places: eye, forward,
right, up, lens radius and focus distance.}

@deftogether[(@defproc[(Camera? [v any/c]) boolean?]
              @defproc[(Camera-eye [camera Camera?]) Float3?]
              @defproc[(Camera-forward [camera Camera?]) Float3?]
              @defproc[(Camera-right [camera Camera?]) Float3?]
              @defproc[(Camera-up [camera Camera?]) Float3?]
              @defproc[(Camera-lens-radius [camera Camera?]) flonum?]
              @defproc[(Camera-focus-distance [camera Camera?]) flonum?]
              @defproc[(Camera-blades [camera Camera?]) exact-nonnegative-integer?]
              @defproc[(Camera-projection [camera Camera?]) symbol?]
              @defproc[(Camera-shutter-open [camera Camera?]) flonum?]
              @defproc[(Camera-shutter-close [camera Camera?]) flonum?])]{
Whether a value is a camera, and its parts.}

@defproc[(Camera-global-up) Float3?]{
The direction away from the ground, @racket[(Float3 0 1 0)].}

@section[#:tag "reference-cameras-change"]{Cameras that differ a little}

@defproc[(Camera-with [camera Camera?]
                      [#:eye eye Float3? (Camera-eye camera)]
                      [#:lens-radius lens-radius (>=/c 0) (Camera-lens-radius camera)]
                      [#:focus-distance focus-distance (>/c 0) (Camera-focus-distance camera)]
                      [#:blades blades (or/c 0 (integer-in 3 1000)) (Camera-blades camera)]
                      [#:shutter-open shutter-open (real-in 0 1) (Camera-shutter-open camera)]
                      [#:shutter-close shutter-close (real-in shutter-open 1)
                                       (Camera-shutter-close camera)]
                      [#:end end (or/c #f Camera?) #,(elem "as it was")]) Camera?]{
The same camera but for what is given; see @racket[Camera].}

@defproc[(Camera-moving [from Camera?] [to Camera?]) Camera?]{
A camera that goes from @racket[from] at time 0 to @racket[to] at time 1: its eye and its three axes
change linearly. Lens, shutter and projection are those of @racket[from].}

@defproc[(Camera-orbit [camera Camera?] [right-degrees real?] [up-degrees real? 0.0]
                       [#:around around (or/c #f Float3?) #f]
                       [#:up up Float3? (Camera-global-up)]) Camera?]{
The camera carried around a point, which keeps its place in the picture: by @racket[right-degrees] to
the camera's right on a circle about the vertical @racket[up] through the point, then by
@racket[up-degrees] over it; past the pole it hangs upside down. Where @racket[around] is @racket[#f]
the point is the one in the middle of the picture at the focus distance. Angles have to be finite.}

@deftogether[(@defproc[(Camera-dolly [camera Camera?] [distance real?]) Camera?]
              @defproc[(Camera-pan [camera Camera?] [right real?] [up real? 0.0]) Camera?])]{
The camera moved by finite numbers of world units, with its direction as it was: forward, or back
where @racket[distance] is negative, and to its right and up. When it moves forward, what is in focus
stays so while it is ahead.}

@racketblock[
(define start
  (Camera-look-at (Float3 0 2 6) (Float3 0 1 0) #:vertical-field-of-view-degrees 32
                  #:lens-radius 0.1))
(define six-sided (Camera-with start #:blades 6))
(define turned (Camera-orbit six-sided 90))
(Camera-eye turned)                               (code:comment "(Float3 6.0 2.0 0.0)")
(define blurred (Camera-with (Camera-moving start (Camera-pan start 1/2)) #:shutter-close 0.5))
(Camera-focus-distance (Camera-dolly start 2))
(Camera-shutter-close blurred)                    (code:comment "0.5")
]

@section[#:tag "reference-cameras-rays"]{Points, rays and pixels}

@deftogether[(@defproc[(Camera-ray [camera Camera?] [x real?] [y real?]) Ray?]
              @defproc[(Camera-get-ray-direction [camera Camera?] [x real?] [y real?]) Float3?])]{
The ray through a place of the picture and the middle of the lens, at time 0, and its unit direction.
Places go from 0 at the left and the top to 1 at the right and the bottom; the width of the view is
the camera's own, not that of a picture. Places outside that are allowed; those that are not finite
raise.}

@defproc[(Camera-project [camera Camera?] [point Float3?]
                         [#:width width (integer-in 1 100000) 640]
                         [#:height height (integer-in 1 100000) 360]) (or/c #f Float3?)]{
Where a point of the world is seen in a picture of that size: x from the left edge and y from the top
edge in pixels, and the distance of the point along the ray through that place, in world units. The
place may lie outside the picture. @racket[#f] for a point that no ray leads to: one behind the eye
of a perspective or orthographic camera, or the eye itself. A lens is taken as a pinhole, and a
camera that moves is where its shutter opens. Raises for a camera whose three axes lie in one plane.}

@defproc[(Camera-unproject [camera Camera?] [seen Float3?]
                           [#:width width (integer-in 1 100000) 640]
                           [#:height height (integer-in 1 100000) 360]) Float3?]{
The point of the world that @racket[Camera-project] finds at @racket[seen]: x and y in pixels, and
the distance along the ray.}

@defproc[(Camera-view [camera Camera?]) Transform?]{
The view matrix, from the world to eye space: the eye at the origin, the camera's right along x, its
up along y, its line of sight along −z. Distances stay. A camera that moves is where its shutter
opens.}

@defproc[(Camera-frustum [camera Camera?]
                         [#:near near (>/c 0)]
                         [#:far far (>/c near) +inf.0]
                         [#:width width (integer-in 1 100000) 640]
                         [#:height height (integer-in 1 100000) 360]) Projection?]{
The projection from that eye space, for a picture of that size and the part of space between two
distances along the line of sight, in world units. Raises for panoramic and fisheye cameras, which no
matrix describes, and for an orthographic one with an infinite @racket[far].}

@racketblock[
(define camera
  (Camera-look-at (Float3 0 2 6) (Float3 0 1 0) #:vertical-field-of-view-degrees 32))
(define seen (Camera-project camera (Float3 0 0 0) #:width 320 #:height 180))
seen
(Camera-unproject camera seen #:width 320 #:height 180)
(Ray-direction (Camera-ray camera 1/2 1/2))
(Projection-point (Camera-frustum camera #:near 1 #:far 100)
                  (Transform-point (Camera-view camera) (Float3 0 0 0)))
]

@section[#:tag "reference-cameras-projections"]{Projections}

A projection takes eye space, seen along −z, to device coordinates: each from −1 to 1 for what is
seen, depth −1 being near, as in OpenGL.

@defproc[(Projection-perspective [#:vertical-field-of-view-degrees degrees
                                                                   (real-in 1e-9 179.9999999)]
                                 [#:aspect aspect (>/c 0)]
                                 [#:near near (>/c 0)]
                                 [#:far far (>/c near)]) Projection?]{
That of a pinhole camera with the angle from the lower to the upper edge in degrees, width over height
@racket[aspect], and planes at the distances @racket[near] and @racket[far] before the eye;
@racket[far] may be @racket[+inf.0].}

@defproc[(Projection-orthographic [#:left left real?] [#:right right real?]
                                  [#:bottom bottom real?] [#:top top real?]
                                  [#:near near real?] [#:far far real?]) Projection?]{
That of the box from @racket[left] to @racket[right], @racket[bottom] to @racket[top], and
−@racket[near] to −@racket[far] along z. All have to be finite, and the two of a pair have to differ.}

@defproc[(Projection? [v any/c]) boolean?]{
Whether a value is a projection.}

@deftogether[(@defproc[(Projection-point [projection Projection?] [point Float3?]) Float3?]
              @defproc[(Projection-unproject [projection Projection?] [seen Float3?]) Float3?])]{
A point of eye space in device coordinates, and back. What lies behind the eye of a perspective comes
out mirrored: clip first.}

@defproc[(Projection-matrix-rows [projection Projection?]) (listof (listof flonum?))]{
The 4 × 4 matrix, for column vectors: four rows of four numbers.}

@defproc[(Projection-clip-planes [projection Projection?]) (listof (listof flonum?))]{
The planes left, right, bottom, top, near and far of what is seen, in eye space, each as
@racketidfont{(list a b c d)}: @racketvarfont{a} x + @racketvarfont{b} y + @racketvarfont{c} z +
@racketvarfont{d} is the distance of a point from it, positive on the side that is seen. A
perspective with an infinite far distance has five. After Gribb and Hartmann, ``Fast Extraction of
Viewing Frustum Planes from the World-View-Projection Matrix'', 2001.}

@defproc[(Projection-frustum-corners [projection Projection?]) (listof Float3?)]{
The eight corners of what is seen, in eye space: four near, four far, each time left bottom, right
bottom, left top, right top. Raises where a perspective has an infinite far distance.}

@defproc[(Transform-viewport [width (integer-in 1 100000)]
                             [height (integer-in 1 100000)]) Transform?]{
From device coordinates to a picture: x and y in pixels from the left and the top edge, and depth
from 0, near, to 1, far.}

@racketblock[
(define projection
  (Projection-perspective #:vertical-field-of-view-degrees 90 #:aspect 1 #:near 1 #:far 3))
(define far-middle (Projection-point projection (Float3 0 0 -3)))
far-middle                                                   (code:comment "(Float3 0.0 0.0 1.0)")
(Transform-point (Transform-viewport 640 360) far-middle)   (code:comment "x 320, y 180, depth 1")
(length (Projection-clip-planes projection))                 (code:comment "6")
(length (Projection-frustum-corners projection))             (code:comment "8")
]
