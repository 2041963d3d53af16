#lang scribble/manual
@; Colours that depend on where a surface is met.
@(require (for-label racket/base racket/contract/base racket/math raytrace))
@title[#:tag "reference-textures"]{Textures}
@declare-exporting[raytrace]

A texture stands where a material takes a colour, such as the albedo of @racket[Lambertian],
@racket[Plastic], @racket[Metal] and @racket[Phong], the colour of a @racket[Mirror] or the radiance
of an @racket[Emitter]; also where one takes a share from 0 to 1, such as the weight of a
@racket[Mix], and as the height of a @racket[Bumped]. A share is the texture's luminance (Rec. 709).
What a texture shows is clamped to what its place allows: an albedo and a share to 0 to 1, a
radiance to at least 0.

@racket[Checker], @racket[Noise], @racket[Turbulence], @racket[Marble] and a
@racket[GradientTexture] between two points live in the space that the shape is made in, as if it
were cut from a block: an @racket[Instance] carries its texture along. @racket[CheckerUV],
@racket[ImageTexture], @racket[UVTexture] and a @racket[GradientTexture] without points follow the
shape's coordinates u and v.

Colours are linear RGB with finite components of at least 0. Every constructor raises
@racket[exn:fail:contract] for another kind of value and for a number out of its range. The optional
arguments of each may be given by keyword, as shown, or by place, in the same order after the
others; a keyword has the last word.

@racketblock[
(define white (Float3 0.8 0.8 0.8))
(define marble (Marble (Float3 0.1 0.05 0.05) white #:scale 2))
(define rings
  (FunctionTexture
   (lambda (point u v)
     (if (> (sin (* 20 (Float3-y point))) 0) white (Float3 0.7 0.2 0.1)))))
(define world
  (World (list (Plane (Float3 0 0 0) (Float3 0 1 0)
                      (Lambertian (Checker white (Float3 0.1 0.2 0.2) #:size 1/2)))
               (Sphere (Float3 -1 1 0) 1 (Plastic marble))
               (Sphere (Float3 1 1 0) 1 (Lambertian rings)))
         (DistantLight (Float3 1 2 1) (Float3 2 2 2))
         (Float3 0.5 0.7 1)))
(render world (Camera-look-at (Float3 0 2 6) (Float3 0 1 0)) #:width 32 #:height 18 #:samples 4)
]

@defproc[(Texture? [value any/c]) boolean?]{
Whether a value is one of the textures below. A colour, a @racket[Float3], is none, though it may
stand wherever a texture may.}

@section[#:tag "reference-textures-checkers"]{Checkers}

@defproc[(Checker [even (or/c Float3? Texture?)] [odd (or/c Float3? Texture?)]
                  [#:size size (>/c 0) 1])
         Checker?]{
Cubes of space with the edge @racket[size], in world units of the space that the shape is made in.
The cube from the origin to (@racket[size], @racket[size], @racket[size]) is even, and so is each
whose numbers along the three axes have an even sum. Either part may be a texture itself. A surface
that lies in the border of two cubes, as a floor at height 0, shows the upper one throughout.}

@deftogether[(@defproc[(Checker? [value any/c]) boolean?]
              @defproc[(Checker-even [texture Checker?]) (or/c Float3? Texture?)]
              @defproc[(Checker-odd [texture Checker?]) (or/c Float3? Texture?)]
              @defproc[(Checker-size [texture Checker?]) flonum?])]{
The predicate and the fields.}

@defproc[(CheckerUV [even (or/c Float3? Texture?)] [odd (or/c Float3? Texture?)]
                    [#:columns columns (>/c 0) 8]
                    [#:rows rows (or/c (>/c 0) #f) #f])
         CheckerUV?]{
Rectangles of the coordinates: u from 0 to 1 is cut into @racket[columns], v from 0 to 1 into
@racket[rows], which is @racket[columns] where it is @racket[#f]. The rectangle at u = v = 0 is even.}

@deftogether[(@defproc[(CheckerUV? [value any/c]) boolean?]
              @defproc[(CheckerUV-even [texture CheckerUV?]) (or/c Float3? Texture?)]
              @defproc[(CheckerUV-odd [texture CheckerUV?]) (or/c Float3? Texture?)]
              @defproc[(CheckerUV-columns [texture CheckerUV?]) flonum?]
              @defproc[(CheckerUV-rows [texture CheckerUV?]) flonum?])]{
The predicate and the fields.}

@section[#:tag "reference-textures-images"]{Pictures}

@defproc[(ImageTexture [image Image?]
                       [#:filter filter (or/c 'bilinear 'nearest) 'bilinear]
                       [#:wrap wrap (or/c 'repeat 'clamp) 'repeat])
         ImageTexture?]{
A picture, rendered or read by @racket[Image-read], which turns files in 8-bit sRGB into linear
light. Its lower left corner is at u = v = 0, its upper right one at u = v = 1. The filter
@racket['bilinear] takes the mean of the nearest four pixels, weighted by nearness, and
@racket['nearest] takes one. Outside 0 to 1, @racket['repeat] shows the picture again and
@racket['clamp] the colours of its border.}

@deftogether[(@defproc[(ImageTexture? [value any/c]) boolean?]
              @defproc[(ImageTexture-image [texture ImageTexture?]) Image?]
              @defproc[(ImageTexture-filter [texture ImageTexture?]) symbol?]
              @defproc[(ImageTexture-wrap [texture ImageTexture?]) symbol?])]{
The predicate and the fields.}

@section[#:tag "reference-textures-noise"]{Noise}

Gradient noise after K. Perlin, @italic{Improving Noise} (2002), with gradients chosen by a hash, so
that it has no period. @racket[scale] is the number of lattice points a world unit. @racket[octaves]
is how many layers are summed: 1 is smooth, and each more adds detail half as wide and half as
strong. Another @racket[seed] is another pattern.

@defproc[(Noise [first Float3?] [second Float3?]
                [#:scale scale (>/c 0) 1]
                [#:octaves octaves (integer-in 1 32) 1]
                [#:seed seed (integer-in 0 4294967295) 0])
         Noise?]{
Goes from @racket[first] to @racket[second] as the noise goes from the least to the greatest value
that it can take; the sum of octaves is divided by the sum of their weights.}

@deftogether[(@defproc[(Noise? [value any/c]) boolean?]
              @defproc[(Noise-first [texture Noise?]) Float3?]
              @defproc[(Noise-second [texture Noise?]) Float3?]
              @defproc[(Noise-scale [texture Noise?]) flonum?]
              @defproc[(Noise-octaves [texture Noise?]) exact-integer?]
              @defproc[(Noise-seed [texture Noise?]) exact-integer?])]{
The predicate and the fields.}

@defproc[(Turbulence [first Float3?] [second Float3?]
                     [#:scale scale (>/c 0) 1]
                     [#:octaves octaves (integer-in 1 32) 7]
                     [#:seed seed (integer-in 0 4294967295) 0])
         Turbulence?]{
Goes from @racket[first] to @racket[second] as the magnitude of the noise's sum goes from 0 to 1,
and is @racket[second] above: creases of the first colour in the second.}

@deftogether[(@defproc[(Turbulence? [value any/c]) boolean?]
              @defproc[(Turbulence-first [texture Turbulence?]) Float3?]
              @defproc[(Turbulence-second [texture Turbulence?]) Float3?]
              @defproc[(Turbulence-scale [texture Turbulence?]) flonum?]
              @defproc[(Turbulence-octaves [texture Turbulence?]) exact-integer?]
              @defproc[(Turbulence-seed [texture Turbulence?]) exact-integer?])]{
The predicate and the fields.}

@defproc[(Marble [first Float3?] [second Float3?]
                 [#:scale scale (>/c 0) 1]
                 [#:bands bands (and/c real? (not/c infinite?) (not/c nan?)) 4]
                 [#:disorder disorder (and/c real? (not/c infinite?) (not/c nan?)) 10]
                 [#:octaves octaves (integer-in 1 32) 7]
                 [#:seed seed (integer-in 0 4294967295) 0])
         Marble?]{
Layers across z: from @racket[first] to @racket[second] and back as the sine of @racket[bands] times
z plus @racket[disorder] times the turbulence. The point is multiplied by @racket[scale] for both.
The defaults are the marble of @italic{Ray Tracing: The Next Week} at scale 1.}

@deftogether[(@defproc[(Marble? [value any/c]) boolean?]
              @defproc[(Marble-first [texture Marble?]) Float3?]
              @defproc[(Marble-second [texture Marble?]) Float3?]
              @defproc[(Marble-scale [texture Marble?]) flonum?]
              @defproc[(Marble-bands [texture Marble?]) flonum?]
              @defproc[(Marble-disorder [texture Marble?]) flonum?]
              @defproc[(Marble-octaves [texture Marble?]) exact-integer?]
              @defproc[(Marble-seed [texture Marble?]) exact-integer?])]{
The predicate and the fields.}

@section[#:tag "reference-textures-gradients"]{Gradients and coordinates}

@defproc[(GradientTexture [first Float3?] [second Float3?]
                          [#:start start (or/c Float3? #f) #f]
                          [#:end end (or/c Float3? #f) #f])
         GradientTexture?]{
From @racket[first] at v = 0 to @racket[second] at v = 1. Where @racket[start] and @racket[end] are
given, from @racket[first] in the plane through @racket[start] to @racket[second] in the plane
through @racket[end], both square to the line between the two points. Beyond its ends the gradient
is constant. Raises @racket[exn:fail:contract] where only one of the points is given or both are the
same.}

@deftogether[(@defproc[(GradientTexture? [value any/c]) boolean?]
              @defproc[(GradientTexture-first [texture GradientTexture?]) Float3?]
              @defproc[(GradientTexture-second [texture GradientTexture?]) Float3?]
              @defproc[(GradientTexture-start [texture GradientTexture?]) (or/c Float3? #f)]
              @defproc[(GradientTexture-end [texture GradientTexture?]) (or/c Float3? #f)])]{
The predicate and the fields.}

@defproc[(UVTexture) UVTexture?]{
The coordinates as colours, to see where a picture would come to lie: red is u, green is v, again
and again outside 0 to 1.}

@defproc[(UVTexture? [value any/c]) boolean?]{
The predicate.}

@section[#:tag "reference-textures-functions"]{Functions}

@defproc[(FunctionTexture [function (-> Float3? flonum? flonum? Float3?)]) FunctionTexture?]{
The colour that @racket[function] gives for a point, in the space that the shape is made in, and the
coordinates u and v. The function must be pure: it is called in any order, and more than once for a
pixel. Workers in other processes cannot be sent a function, they load the scene's module instead:
see @racket[#:scene] at @racket[render]. A sample for which it raises an exception, or gives
something else than a @racket[Float3], has failed: see @racket[#:strict?] at @racket[render].}

@deftogether[(@defproc[(FunctionTexture? [value any/c]) boolean?]
              @defproc[(FunctionTexture-function [texture FunctionTexture?])
                       (-> Float3? flonum? flonum? Float3?)])]{
The predicate and the function.}

@defproc[(perlin-noise [point Float3?]
                       [#:octaves octaves (integer-in 1 32) 1]
                       [#:seed seed (integer-in 0 4294967295) 0])
         flonum?]{
Smooth noise at a point, for textures by a function and for shapes: from -1 to 1 with mean 0 for one
octave, and 0 at points whose coordinates are whole. More octaves add detail and at most double the
range. Raises @racket[exn:fail:contract] for numbers out of range.}

@defproc[(perlin-turbulence [point Float3?]
                            [#:octaves octaves (integer-in 1 32) 7]
                            [#:seed seed (integer-in 0 4294967295) 0])
         flonum?]{
The magnitude of that sum, as in @italic{Ray Tracing: The Next Week}.}

@racketblock[
(define cloudy
  (FunctionTexture
   (lambda (point u v)
     (define grey (min 1 (perlin-turbulence (Float3-scale-by-scalar point 3) #:octaves 4)))
     (Float3 grey grey grey))))
(define sky-ball
  (World (list (Sphere (Float3 0 1 0) 1 (Lambertian cloudy))) '() (Float3 1 1 1)))
(render sky-ball (Camera-look-at (Float3 0 1 4) (Float3 0 1 0)) #:width 32 #:height 18 #:samples 2)
]
