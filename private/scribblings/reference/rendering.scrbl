#lang scribble/manual
@; From a world and a camera to a picture, and why a pixel of it looks as it does.
@(require (for-label racket/base racket/contract/base racket/math
                     (only-in racket/future processor-count) raytrace))
@title[#:tag "reference-rendering"]{Rendering}
@declare-exporting[raytrace]

@racketblock[
(define world
  (World (list (Plane (Float3 0 0 0) (Float3 0 1 0) (Lambertian (Float3 0.5 0.5 0.5)))
               (Sphere (Float3 0 1 0) 1 (Plastic (Float3 0.1 0.3 0.8))))
         (DistantLight (Float3 1 2 1) (Float3 2 2 2))
         (GradientSky (Float3 1 1 1) (Float3 0.5 0.7 1))))
(define camera (Camera-look-at (Float3 0 2 6) (Float3 0 1 0)))
(render world camera #:width 32 #:height 18 #:samples 8)
(render world camera #:width 32 #:height 18 #:error 0.1 #:filter 'tent)
(Image-false-color (render world camera #:width 32 #:height 18 #:integrator 'cost #:samples 2))
]

@defproc[(render [world World?] [camera Camera?]
                 [#:width width (integer-in 1 100000) 640]
                 [#:height height (integer-in 1 100000) 360]
                 [#:samples samples (or/c (integer-in 1 1000000000) #f) #f]
                 [#:error error (or/c (>/c 0) #f) #f]
                 [#:seconds seconds (or/c (>/c 0) #f) #f]
                 [#:seed seed (integer-in 0 4294967295) 0]
                 [#:sampler sampler (or/c 'owen-sobol 'independent 'stratified 'r2) 'owen-sobol]
                 [#:filter filter (or/c 'box 'tent 'gaussian 'blackman-harris) 'box]
                 [#:integrator integrator symbol? 'auto]
                 [#:max-depth max-depth (or/c (integer-in 0 1000000000) #f) #f]
                 [#:schedule schedule (or/c 'sequential 'futures 'places 'hosts) 'futures]
                 [#:workers workers (integer-in 1 1024) (processor-count)]
                 [#:tile tile (integer-in 1 100000) 16]
                 [#:crop crop (or/c (list/c exact-integer? exact-integer?
                                            exact-integer? exact-integer?) #f) #f]
                 [#:shading shading (or/c symbol? (listof symbol?)) 'phong]
                 [#:strict? strict? boolean? #f]
                 [#:scene scene (or/c path-string? #f) #f]
                 [#:hosts hosts (or/c path-string? #f) #f])
         Image?]{
The picture of a world through a camera, in linear RGB, with its standard error where a pixel had
two samples or more. The same arguments give the same picture, to the bit, whatever the schedule,
the workers and the tile; @racket[seconds] alone depends on the machine.

Raises @racket[exn:fail:contract] for values of another kind or out of range, and
@racket[exn:fail:user] where the machine's memory is too small for the picture.}

@section[#:tag "reference-rendering-keywords"]{The keywords of render}

@bold{What is seen.} @racket[#:width] and @racket[#:height] are the sides of the whole picture in
pixels. @racket[#:crop], a list of x, y, width and height in pixels from the upper left corner,
renders only that part, which must lie in the picture; its pixels are those of the whole picture.

@bold{When to stop.} @racket[#:samples] is the number of camera rays a pixel; @racket[#f] is 16.
@racket[#:error] is the error at which to stop, the root of the mean squared error relative to the
picture's mean: 0.01 is one percent. Samples go where they lower it most. @racket[#:seconds] is the
time to use, by the clock on the wall. With both, the first that is reached ends the render; with
either, @racket[#:samples] is the most that a pixel gets, and @racket[#f] is 65536.

@bold{What a ray's colour means.} @racket[#:integrator] is one of

@itemlist[
@item{@racket['auto]: @racket['seed] where all materials are @racket[Phong] or @racket[Emitter] and
 no medium
 fills the world, else @racket['path].}
@item{@racket['path]: path tracing (J. T. Kajiya, 1986), with lights and materials both sampled at
 every
 vertex and weighted by the power heuristic (E. Veach, 1997).}
@item{@racket['naive-path]: paths that find lights by chance, as in the three books, for comparison.
 Lights
 without an area are never found.}
@item{@racket['seed]: the article's shading, with ambient light under occlusion, Phong's diffuse
 light and
 highlight, and mirrors. The keywords of @racket[World] set its numbers.}
@item{@racket['ambient-occlusion]: the share of the hemisphere that nothing near hides, as a grey.}
@item{@racket['normals]: the normal towards the viewer, each component from -1 to 1 shown as 0 to 1.}
@item{@racket['depth]: the distance along the ray in world units, as a grey; 0 where nothing is hit.}
@item{@racket['cost]: how many rays a sample of the pixel took, as a grey.}
@item{@racket['error]: the standard error of the pixel in the picture that @racket['auto] makes, as
 a grey, the
 root of the mean square of its channels'. It needs at least 2 samples.}
@item{@racket['raster]: a picture without rays, as @racket[preview] draws it, with
 @racket[#:samples] from 1 to 64, of which @racket[#f] is 4, and @racket[#:shading] as there. It
 takes neither @racket[#:error] nor @racket[#:seconds].}]

@racket[#:max-depth] is the most bounces of a path: 0 is light seen directly, 1 adds light reflected
once. @racket[#f] is no limit; paths then end by Russian roulette (J. Arvo and D. Kirk, 1990). It
has no meaning for @racket['seed], whose mirrors are limited by the world.

@bold{How samples are spread.} @racket[#:seed] chooses the random numbers. @racket[#:sampler] is one
of

@itemlist[
@item{@racket['owen-sobol]: Sobol's points, scrambled by hashes (B. Burley, @italic{Practical
 Hash-based Owen
 Scrambling}, 2020). Best at powers of two.}
@item{@racket['independent]: numbers that have nothing to do with each other.}
@item{@racket['stratified]: one point anywhere in each cell of a grid as square as the number of
 samples allows.}
@item{@racket['r2]: the sequence of the generalised golden ratio (M. Roberts, 2018), rotated by the
 seed.}]

@racket[#:filter] is how a pixel weighs what falls near it. Its samples are drawn with the filter as
their density (M. Ernst, M. Stamminger and G. Greiner, 2006), so that a pixel's samples remain its
own.

@itemlist[
@item{@racket['box]: the pixel's square, all alike.}
@item{@racket['tent]: falls to 0 at one pixel from the middle.}
@item{@racket['gaussian]: a standard deviation of half a pixel, cut at 2 pixels.}
@item{@racket['blackman-harris]: the window of four terms (F. J. Harris, 1978), 0 at 2 pixels.}]

@bold{Who renders.} @racket[#:schedule] is @racket['sequential] for this thread alone,
@racket['futures] for @racket[#:workers] threads of this process, @racket['places] for as many
places, each with a copy of the library, or @racket['hosts] for workers on other machines over ssh,
which the file @racket[#:hosts] lists (see @secref["machines-hosts"]). @racket[#:workers] is as many
as the machine has processors unless said otherwise. @racket[#:tile] is the side in pixels of the
squares that are handed out. @racket[#:scene] is the file of a module that provides
@racketidfont{world}: workers in places and on hosts load it where the world holds functions, which
cannot be sent.

@bold{What fails.} A pixel for which a function of the scene raises an exception twice is left
magenta,
(1, 0, 1); with @racket[#:strict?] the render stops there and raises @racket[exn:fail:user] with the
message, the pixel and the seed. A sample that is no finite number of at least 0 counts as black.

@section[#:tag "reference-rendering-preview"]{Previews}

@defproc[(preview [world World?] [camera Camera?]
                  [#:width width (integer-in 1 100000) 640]
                  [#:height height (integer-in 1 100000) 360]
                  [#:shading shading (or/c symbol? (listof symbol?)) 'phong]
                  [#:samples samples (integer-in 1 64) 4]
                  [#:tolerance tolerance (>/c 0) 0.2]
                  [#:faces faces (or/c 'both 'front 'back) 'both]
                  [#:fog-color fog-color Float3? (Float3 1 1 1)]
                  [#:fog-density fog-density (real-in 0 1e300) 0]
                  [#:crop crop (or/c (list/c exact-integer? exact-integer?
                                             exact-integer? exact-integer?) #f) #f])
         Image?]{
The picture at once, by rasterization: without shadows, reflections of other surfaces, blur and noise.

@itemlist[
@item{@racket[shading]: @racket['phong] for normals interpolated between corners, @racket['gouraud]
 for colours, @racket['flat] for one colour a triangle, @racket['toon] for steps with an outline,
 @racket['wireframe] for all edges, @racket['hidden-lines] for those that no surface hides, or the
 views @racket['normals], @racket['depth] and @racket['texture-coordinates]. A list draws as many
 pictures side by side, which share the width.}
@item{@racket[samples]: how many points of a pixel decide what covers it.}
@item{@racket[tolerance]: how far, in pixels, the triangles may be seen from a curved surface.}
@item{@racket[faces]: the triangles that are drawn: those seen from outside, @racket['front], from
 inside,
 @racket['back], or all.}
@item{@racket[fog-density]: light from a surface at distance @italic{d} loses all but the
 exponential of
 -@racket[fog-density] @italic{d} of itself to @racket[fog-color].}
@item{@racket[crop]: x, y, width and height in pixels of the part that is drawn.}]

What moves is where it is when the shutter opens, and a lens is a pinhole. Raises
@racket[exn:fail:contract] for values of another kind or out of range.}

@racketblock[
(define room (World (list (Box (Float3 -1 -1 -1) (Float3 1 1 1) (Lambertian (Float3 0.8 0.6 0.2))))
                    (DistantLight (Float3 1 2 3) (Float3 2 2 2))))
(preview room (Camera-look-at (Float3 2 3 5) (Float3 0 0 0)) #:width 32 #:height 18
         #:shading '(phong hidden-lines))
]

@section[#:tag "reference-rendering-samples"]{Samples}

@defproc[(sample-point [sampler (or/c 'owen-sobol 'independent 'stratified 'r2)]
                       [#:index index (integer-in 0 4294967295)]
                       [#:pixel pixel (integer-in 0 4294967295) 0]
                       [#:dimension dimension (integer-in 0 4294967295) 0]
                       [#:seed seed (integer-in 0 4294967295) 0]
                       [#:count count (integer-in 1 4294967295) 16])
         (values flonum? flonum?)]{
The pair of numbers in [0, 1) that a sampler gives for one sample of a pixel in one dimension. The
indices from 0 to @racket[count] - 1 are one grid of the stratified sampler; the others take no
notice of @racket[count]. Raises @racket[exn:fail:contract] for other values.}

@racketblock[
(for/list ([index 4])
  (define-values (u v) (sample-point 'owen-sobol #:index index))
  (list u v))
]

@section[#:tag "reference-rendering-explain"]{Why a pixel looks as it does}

@defproc[(explain [world World?] [camera Camera?]
                  [x exact-nonnegative-integer?] [y exact-nonnegative-integer?]
                  [#:width width (integer-in 1 100000) 640]
                  [#:height height (integer-in 1 100000) 360]
                  [#:samples samples (integer-in 1 1000000) 16]
                  [#:seed seed (integer-in 0 4294967295) 0]
                  [#:sampler sampler symbol? 'owen-sobol]
                  [#:filter filter symbol? 'box]
                  [#:integrator integrator symbol? 'auto]
                  [#:max-depth max-depth (or/c exact-nonnegative-integer? #f) #f])
         Explanation?]{
How the pixel in column @racket[x] and row @racket[y], both from 0 at the upper left, comes about in
a picture of @racket[width] by @racket[height] pixels. The other keywords are as @racket[render]
takes them, with any integrator but @racket['raster]; with the same ones the colour is that of the
picture, to the bit. The value prints as text: the colour and its error, where the light came from,
and the paths that bring most, with what they hit and which lights were sampled. Raises
@racket[exn:fail:contract] where the pixel is not in the picture.}

@deftogether[(@defproc[(Explanation? [value any/c]) boolean?]
              @defproc[(Explanation-color [explanation Explanation?]) Float3?]
              @defproc[(Explanation-standard-error [explanation Explanation?]) (or/c Float3? #f)]
              @defproc[(Explanation-rays [explanation Explanation?]) flonum?]
              @defproc[(Explanation-sources [explanation Explanation?])
                       (listof (cons/c (or/c Shape? Light? 'background 'ambient) Float3?))]
              @defproc[(Explanation-depths [explanation Explanation?])
                       (listof (cons/c exact-nonnegative-integer? Float3?))]
              @defproc[(Explanation-paths [explanation Explanation?]) list?])]{
The predicate and the parts: the pixel's colour, linear RGB; the standard error of its channels,
@racket[#f] with one sample; rays a sample; the sources of its light, brightest first, each with its
part of the colour; the parts by the number of bounces; and one value for each sample's path, to be
printed. The sources, and the depths, add up to the colour up to rounding.}

@racketblock[
(define lit (World (list (Sphere (Float3 0 1 0) 1 (Lambertian (Float3 0.8 0.2 0.1))))
                   (DistantLight (Float3 1 2 1) (Float3 2 2 2))))
(define why
  (explain lit (Camera-look-at (Float3 0 1 6) (Float3 0 1 0)) 16 9
           #:width 32 #:height 18 #:samples 4))
(map car (Explanation-sources why))
]
