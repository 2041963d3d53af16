#lang scribble/manual
@; How a picture is computed: the rooms of the source, and the facts that its kernels live by.
@(require scribble/example "pictures.rkt" (for-label racket/base racket/flonum raytrace))

@(define inside (make-pictures))

@title[#:tag "inside"]{How it works inside}

This page is for readers of the source. Nothing in it is needed to make pictures.

@section[#:tag "inside-ideas"]{Five ideas}

@itemlist[#:style 'ordered
@item{@bold{A picture is a pure function} of a world, a camera and the settings. Every sample of every pixel is a function of
the pixel, the number of the sample, the dimension and the seed; there is no random generator with a state.}
@item{@bold{How it is computed is another value.} Schedule, workers and tiles decide when a pixel is computed, and change
no bit of it.}
@item{@bold{An answer comes with its error.} Each pixel's samples are two streams that are randomised independently of each
other; how far the streams differ says how far their mean is off.}
@item{@bold{A scene pays for what it uses.} Before the first ray it is known whether a world has lenses, motion, media, glass
or lights, and what it lacks is skipped. @exec{--stats} tells what was found.}
@item{@bold{One definition.} What a prompt shows as a function over structs and what renders are the same
source: @racket[World-nearest-hit] runs the kernel that the picture is made by.}
]

@examples[#:eval inside #:label #f
(define world
  (World (list (Disk (Float3 0 0 0) (Float3 0 1 0) 9 (Lambertian (Float3 0.5 0.5 0.5)))
               (Sphere (Float3 0 1 0) 1 (gold 0.1)))))
(define camera (Camera-look-at (Float3 0 2 6) (Float3 0 1 0)))
(define (picture . how)
  (Image-pixels (keyword-apply render '(#:height #:schedule #:tile #:width #:workers)
                               (list 36 (car how) (cadr how) 64 (caddr how))
                               (list world camera))))
(code:comment "another schedule, other tiles, other workers: the same picture, bit for bit")
(equal? (picture 'sequential 16 1) (picture 'futures 5 3))
]

@section[#:tag "inside-rooms"]{The rooms}

The source is in @filepath{private/}, one folder for each subject, and a file is mostly one idea: a shape, a material, a
light, a format. A folder uses those above it in this list; @filepath{image} and @filepath{read} stand
beside.

@tabular[#:sep @hspace[2] #:row-properties '(bottom-border ())
(list
 (list @bold{folder} @bold{what is in it})
 (list @filepath{base} "vectors, transforms, roots, the scratch registers; the one file with unsafe operations")
 (list @filepath{sample} "points in the unit square by pixel, sample and dimension; warps to disks, cones, spheres")
 (list @filepath{shape} "one file a shape: nearest hit, any hit, the surface there, bounds; meshes, groups, solids")
 (list @filepath{material} "one file a material: value, sampling, density; textures in their own folder")
 (list @filepath{medium} "what scatters between surfaces")
 (list @filepath{light} "one file a light; the tree that chooses among many")
 (list @filepath{world} "camera, world, the hierarchy of boxes: its building and its traversal")
 (list @filepath{integrate} "what a ray's colour means: the article's shading, paths, views")
 (list @filepath{render} "pixels, passes, films, checkpoints; the schedules in their own folder")
 (list @filepath{raster} "the same worlds drawn by triangles and a z-buffer")
 (list @filepath{image} "pictures, their formats, comparison, tone, bridges to other libraries")
 (list @filepath{read} "OBJ, PLY and STL")
 (list @filepath{command} "raco raytrace"))]

To add a shape or a material, read @filepath{shape/sphere.rkt} or @filepath{material/lambertian.rkt}: the other ones are written the same way.

@section[#:tag "inside-registers"]{Registers}

In Racket CS a flonum that stays inside one function costs no memory. One that is passed to another function, or
returned by it, is boxed: 16 bytes each. A ray has at least seven numbers, a hit as many, and a picture has a billion of
them. So rays and hits do not travel as arguments. Each worker has one flvector and one fxvector, its
@deftech{scratch}; a ray's origin, its direction, the nearest hit and the radiance have places in it with names, its
@deftech{registers}. A kernel reads what it needs, computes in local variables, and writes
back what it found. What crosses a call are fixnums and booleans, which are never boxed.

Kernels made this way take well below four bytes a ray. It is also how mistakes show: a flonum that is alive across a
call that is not a tail call is boxed, and the bytes per ray rise at once. The benchmarks count them.

@section[#:tag "inside-fusing"]{Fusing vectors}

Code in scalars is fast and hard to read; code in vectors reads well and allocates. A macro,
@racketidfont{let-float3}, gives both. Inside it, @racket[Float3-add] and its kin are not calls: each knows its three
components as expressions, and an expression of vectors becomes three expressions of flonums, with shared
parts bound once. Outside, the same names are ordinary functions over ordinary structs. So the intersection of a
sphere is written in the words of a textbook and compiles to the code one would write by hand.

@section[#:tag "inside-closures"]{Closures}

When a world is rendered for the first time, each of its shapes becomes a kernel: a few closures over the numbers that are
fixed from then on, such as a sphere's centre and squared radius. The same goes for materials, textures, lights and the
background. Reading a number from a closure is as fast as from a variable. Spheres, the article's shape, need no
closure: where a world has only these, they lie packed in one flvector.

@section[#:tag "inside-hierarchy"]{The hierarchy}

A tree of boxes finds what a ray may hit. It is built top down: along each axis, triangles or shapes are sorted into
bins, and the cut with the least expected cost by surface area wins. Leaves hold up to four. On its way down a ray enters
the nearer box first, as told by the signs of its direction, and boxes that begin behind the nearest hit so far are
skipped. Shadow rays stop at the first hit of all.

Boxes are padded by the rounding errors of what is inside, and of two hits at the same distance the shape that comes first
in the list wins. That is why the tree's answer is the answer of trying all shapes in turn, and tests
compare them bit by bit.

@section[#:tag "inside-paths"]{Paths}

The integrator @racket['path] follows light backwards. At each hit it adds what the surface emits; it samples one light, chosen by a
bound on what it can contribute, and one direction by the material. Both find the same light, so both are weighted by how
likely the other one was to find it (multiple importance sampling). A path ends by Russian roulette, which keeps
the mean as it is, so there is no limit to the bounces and no bias from one. In a medium, distances are sampled too.

@section[#:tag "inside-schedules"]{Schedules and tiles}

The picture is cut into tiles. A tile is a transaction: a worker takes a number from a counter, computes the tile in its
own scratch, writes the pixels, which nobody else writes, and says so. A tile that is not done has not happened. So all that
can go wrong with a worker has one answer, which is to do the tile again:

@itemlist[
@item{@racket['sequential] does one tile after the other; @racket['futures] runs a worker on each processor in one
memory; @racket['places] runs workers with memories of their own; @racket['hosts] runs them elsewhere, over ssh.}
@item{A checkpoint is the list of tiles that are done, with their pixels. @exec{--part} does every N-th tile.}
@item{A worker that dies, stalls or loses its network loses its tile, which another one takes.}
]

Inside a future one may not touch parameters, handlers, ports or a random generator: each of these makes it wait for the main
thread. Kernels use none.

@section[#:tag "inside-numbers"]{Numbers without an epsilon}

There is no small constant in the kernels to keep a shadow ray from hitting the surface it leaves. Every hit carries a
bound on its own rounding error, a multiple of the unit roundoff times the magnitudes involved; a ray that leaves starts
that far off. So a scene that is scaled by a power of two gives the same picture bit for bit, and one the size of an
atom or of a galaxy looks as it should. @secref["accuracy"] has the figures.

@(close-eval inside)
