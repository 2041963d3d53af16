#lang scribble/manual
@; The command: every flag with its range and default, the subcommands, exit codes and files.
@(require (for-label racket/base raytrace))
@(define (tt . words) (apply exec words)) @; two hyphens stay two hyphens
@title[#:tag "reference-command"]{The command raco raytrace}

@commandline{raco raytrace [flag ...] scene}

renders a scene to a picture file. The scene is a @filepath{.rkt} file, a mesh file
(@filepath{.obj}, @filepath{.ply} or @filepath{.stl}), or the name of a scene that @tt{raco raytrace
list} shows. Flags may stand before and after it. Where a file's name begins with a hyphen, @tt{--}
before it tells that it is none. What is wrong with a flag is told in one line before the first ray,
and there is no output file then.

A @filepath{.rkt} file is a module that provides @racketidfont{world}, a @racket[World],
@racketidfont{camera}, a @racket[Camera], and perhaps @racketidfont{settings}, a hash with any of
the keys @racket['size] (a list of width and height), @racket['samples], @racket['seed],
@racket['integrator], @racket['max-depth] and @racket['shading]. A flag goes before the scene's
setting, and the setting before the default that is told here. A mesh file is shown 2 units large on
a studio's floor under three lights, 640 by 480 pixels with 64 samples.

Here is such a scene; @tt{raco raytrace new} writes one with comments.

@racketblock[
(define world
  (World (list (Disk (Float3 0 0 0) (Float3 0 1 0) 40 (Lambertian (Float3 0.5 0.5 0.5)))
               (Sphere (Float3 0 1 0) 1 (gold 0.15)))
         '()
         (GradientSky (Float3 0.75 0.8 0.85) (Float3 0.2 0.35 0.7))))
(define camera (Camera-look-at (Float3 1.5 2.6 8.5) (Float3 0 0.9 0)))
(define settings (hash 'size '(640 360) 'samples 64))
(provide world camera settings)
]

@section[#:tag "reference-command-picture"]{The picture}

@itemlist[
@item{@tt{-o FILE}, @tt{--output FILE}: the file to write, by its extension @filepath{.ppm},
 @filepath{.png}, @filepath{.pfm} or @filepath{.hdr}. A single hyphen is PPM to standard output. By
 default the scene's name with @filepath{.ppm}, in the current folder.}
@item{@tt{--size WxH}: width and height in pixels, whole numbers from 1 to 100000. By default the
 scene's, else 640x360. What is rendered has at most 268435456 pixels.}
@item{@tt{--crop X,Y,W,H}: renders only this part, whole numbers of pixels from the upper left
 corner; it must lie in the picture. By default all of it.}
@item{@tt{--samples N}: camera rays a pixel, from 1 to 1000000000. By default the scene's, else 16.
 With @tt{--error} or @tt{--seconds} the most that a pixel gets, by default 65536, whatever the
 scene says. With @tt{--integrator raster} from 1 to 64, by default 4.}
@item{@tt{--error E}: goes on until the picture's estimated root mean squared error is this part of
 its mean, with samples where they pay. Above 0 up to 10, as 0.01, or in percent, as 1%. By default
 there is no such goal.}
@item{@tt{--seconds S}: the best picture in that time, by the clock on the wall. Above 0 up to
 1000000000 seconds. By default there is no such goal. With @tt{--error} too, the first that is
 reached ends the render.}
@item{@tt{--seed N}: from 0 to 4294967295. Another seed gives another noise, the same seed the same
 picture, to the bit. By default the scene's, else 0.}
@item{@tt{--sampler NAME}: how samples are spread: @tt{owen-sobol}, the default, @tt{independent},
 @tt{stratified} or @tt{r2}.}
@item{@tt{--filter NAME}: what a pixel sees of its neighbourhood: @tt{box}, the default, @tt{tent},
 @tt{gaussian} or @tt{blackman-harris}.}
@item{@tt{--integrator NAME}: what a pixel shows: @tt{auto}, @tt{path}, @tt{naive-path}, @tt{seed},
 @tt{ambient-occlusion}, @tt{normals}, @tt{depth}, @tt{cost}, @tt{error} or @tt{raster}. By default
 the scene's, else @tt{auto}. @tt{cost} and @tt{error} are in false colours, except in
 @filepath{.pfm} and @filepath{.hdr} files, which keep the numbers.}
@item{@tt{--shading NAME}: with @tt{--integrator raster}: @tt{phong}, @tt{gouraud}, @tt{flat},
 @tt{toon}, @tt{wireframe}, @tt{hidden-lines}, @tt{normals}, @tt{depth} or @tt{texture-coordinates};
 several, with commas between them, give as many pictures side by side. By default the scene's, else
 @tt{phong}.}
@item{@tt{--max-depth N}: the most bounces of a path, from 0 to 1000000000. By default the scene's,
 else without limit.}]

What the names mean is told with @racket[render] and @racket[preview].

@section[#:tag "reference-command-speed"]{How fast it comes}

These change not one bit of the picture, except of one for @tt{--seconds}.

@itemlist[
@item{@tt{--schedule NAME}: @tt{sequential}, @tt{futures}, the default, @tt{places}, or
 @tt{hosts:FILE}, over ssh on the hosts of a file.}
@item{@tt{--workers N}: how many at a time, from 1 to 1024. By default one for each processor. For
 @tt{hosts:FILE} the file says how many.}
@item{@tt{--tile N}: the side in pixels of the squares that workers take, from 1 to 100000. By default
 16.}]

@section[#:tag "reference-command-long"]{Long renders and many machines}

@itemlist[
@item{@tt{--resume}: keeps what is done in a file named as the output with @filepath{.checkpoint}
 after it, goes on from there if there is one, and deletes it at the end. A checkpoint of another
 scene, other settings or another version is refused. Not with @tt{-o -} or @tt{--integrator
 raster}. Off by default.}
@item{@tt{--checkpoint-seconds S}: at least so many seconds between two checkpoints, above 0 up to
 1000000000. By default 10.}
@item{@tt{--keep-partial}: after an interrupt writes the picture as far as it got, black where there
 is nothing yet. Off by default.}
@item{@tt{--part I/N}: renders the I-th of N parts, with I from 1 to N and N at most 1000000, into a
 file for @tt{merge}. By default that is the scene's name with @filepath{.I-of-N.part}. Not with
 @tt{--error}, @tt{--seconds}, @tt{-o -} or @tt{--integrator raster}. By default the whole picture
 is rendered.}]

@section[#:tag "reference-command-faults"]{What fails}

@itemlist[
@item{@tt{--strict}: a pixel where a function of the scene raises an exception twice ends the render
 with one line. By default such a pixel is left magenta, (1, 0, 1), and told on standard error.}]

@section[#:tag "reference-command-told"]{What is told}

Unless said otherwise it goes to standard error. Where that is a terminal, a line of progress is
drawn too.

@itemlist[
@item{@tt{--stats}: a table of counts and times, and what the scene needed of the renderer. Off by
 default.}
@item{@tt{--stats-json FILE}: the same numbers as JSON in a file; a single hyphen is standard
 output, unless the picture goes there. By default none is written.}
@item{@tt{--preview}: the picture as it forms, where standard error is a terminal of 24-bit colours.
 Off by default.}
@item{@tt{--quiet}: no progress and no closing line. Off by default.}
@item{@tt{-h}, @tt{--help}: tells the flags on standard output, and ends. After a subcommand, that
 one's.}]

@section[#:tag "reference-command-subcommands"]{Subcommands}

@tt{raco raytrace view SCENE} shows the scene in a window: drawn at once, then traced with more and
more samples. The mouse moves the camera, and the scene is read again when its file changes. It
takes @tt{--size}, @tt{--samples} (the most, by default 65536), @tt{--error} (what is good enough,
by default nothing is), @tt{--seed}, @tt{--integrator}, @tt{--shading} and @tt{--max-depth}, with
ranges and defaults as above. See @secref["view"].

@tt{raco raytrace check SCENE} tells in a line each what is probably a mistake in a scene that is no
mesh file, as @racket[World-problems] does. It takes no flags but @tt{--help}, and ends with exit
code 1 where there is something to tell.

@tt{raco raytrace explain SCENE --pixel X,Y} tells how a pixel of a scene that is no mesh file comes
about, as @racket[explain] does. @tt{--pixel X,Y}, column and row from 0,0 at the upper left, is
required. @tt{--paths N}, at least 1 and by default 4, is how many paths are told, those that bring
most. It takes @tt{--size}, @tt{--samples} (up to 1000000), @tt{--seed}, @tt{--sampler},
@tt{--filter}, @tt{--integrator} (but not @tt{raster}) and @tt{--max-depth} as above, and the pixel
is the one that a render with the same flags has.

@tt{raco raytrace new FILE} writes a commented scene to start from. The name ends with
@filepath{.rkt}, and there is no such file yet. It takes no flags but @tt{--help}.

@tt{raco raytrace list} tells the scenes of this package, each with a sentence. It takes no flags but
@tt{--help}.

@tt{raco raytrace compare A B} tells how far picture A is from picture B, its reference, in linear
RGB: the numbers of @racket[Image-compare]. Both are files that @racket[Image-read] reads, of the
same size. @tt{-o FILE}, or @tt{--output FILE}, writes the difference in false colours. How large
the difference is does not change the exit code.

@tt{raco raytrace merge PART ...} joins all parts that @tt{--part} rendered, in any order, into the
picture that one render would have made, to the bit. Parts that are missing, or are of another
picture, are told in one line. @tt{-o FILE}, or @tt{--output FILE}, is where to write it, by default
the scene's name with @filepath{.ppm}.

@section[#:tag "reference-command-codes"]{Exit codes}

@tabular[#:sep (hspace 2)
(list (list @tt{0} "done; also where pixels were left magenta")
      (list @tt{1} "something is wrong, told in one line on standard error; or check found something")
      (list @tt{130} "interrupted, as by Ctrl-C")
      (list @tt{143} "terminated by SIGTERM"))]

@section[#:tag "reference-command-files"]{Files}

@itemlist[
@item{@filepath{.ppm}, written as P6, and @filepath{.png}: 8 bits a channel, sRGB, clipped at white.
 P3 is read too.}
@item{@filepath{.pfm}: linear RGB in 32-bit floating point. @filepath{.hdr}: linear RGB in Radiance's
 RGBE.}
@item{JPEG is read, by @tt{compare} and @racket[Image-read], and not written.}
@item{@filepath{.checkpoint} and @filepath{.part}: what is known of each pixel that is done, with
 the scene, settings and versions that it belongs to. They are for the same version of this package
 and of Racket.}
@item{The file of @tt{hosts:FILE}: a host on each line, as @litchar{[user@"@"]name[:port] [workers]
 [racket]}, with one worker and the command @tt{racket} unless said otherwise; @litchar{#} begins a
 comment.}
@item{The file of @tt{--stats-json}: one object. Its keys are the render's settings and numbers,
 such as @tt{samples}, @tt{passes}, @tt{relativeError}, @tt{seconds}, @tt{processorSeconds} and
 @tt{failedPixels}; a number that is unknown is @tt{null}, a setting that was not given @tt{false}.}]

Picture files appear whole or not at all.
