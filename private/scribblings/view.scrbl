#lang scribble/manual
@; How to look at a world in a window.
@(require (for-label racket/base raytrace))

@title[#:tag "view"]{Looking around in a window}
@declare-exporting[raytrace]

A window shows a world at once and lets one walk around in it. From the shell it takes a scene, a mesh
file, or the name of a scene of the package:

@verbatim|{
raco raytrace view weekend
raco raytrace view my-scene.rkt --size 800x450
raco raytrace view dragon.ply
}|

In Racket, and in DrRacket, it takes a world and a camera:

@racketblock[
(define found (view world camera))
]

The picture is drawn at once by rasterization, as by @racket[preview], and then traced: first two
samples a pixel, then eight, then more and more where they lower the error most. Every move of the
camera starts again with a preview, which is as coarse as it has to be to keep up with the mouse. The
line below the picture tells how many samples a pixel has, the estimated error relative to the
picture's mean, and how long that took.

@section[#:tag "view-keys"]{Mouse and keys}

@tabular[#:sep @hspace[2]
  (list
   (list "left drag" "orbit around what is in focus")
   (list "middle drag, shift drag" "move sideways")
   (list "wheel" "nearer to what is in focus, or farther away")
   (list "right click, control click" "focus on what is under the pointer")
   (list @elem{@tt{+} @tt{-}} "half a stop brighter, darker")
   (list @elem{@tt{0}} "the scene's own camera and exposure")
   (list @elem{@tt{p} @tt{c}} "print the camera as an expression; copy it as well")
   (list @elem{@tt{s} @tt{S}} "save the picture under a name that is free; choose a name")
   (list @elem{@tt{r}} "read the scene again")
   (list @elem{@tt{h} @tt{?}} "show the keys in the window, or hide them")
   (list @elem{@tt{q} Escape} "close"))]

What is in focus is also what the camera turns around, and a drag across the whole picture is half a
turn. A click with the right button therefore does two things: it says what shall be sharp, where the
lens has a radius, and it says around what to orbit.

@section[#:tag "view-camera"]{Keeping a view}

@tt{p} prints the camera on standard output as an expression that builds it again:

@racketblock[
(Camera (Float3 1.3 2.0 5.5) (Float3 -0.3 -0.4 -1.4) (Float3 1.7 0.0 -0.4) (Float3 0.0 0.9 -0.3)
        #:focus-distance 6.0)
]

Pasted into the scene in place of its camera, it is the view that was in the window.
@racket[view] returns that camera when the window is closed, so that
@racket[(render world (view world camera) #:error 0.01)] renders the view one has found.

@tt{s} saves what is seen, with its exposure, as @filepath{NAME-1.png}, @filepath{NAME-2.png} and so on in the
current folder. With @tt{S} a name that ends with @tt{.pfm} or @tt{.hdr} keeps the linear values, without
the exposure.

@section[#:tag "view-reload"]{Working on a scene}

When the file of the scene changes, or a module in its folder that it requires, the scene is read
again: an editor beside the window is all it takes. A camera that was found by hand stays, unless the
scene's own camera has changed. A mistake is told in one line, below the picture and on standard error,
with the file and the line; the last picture that was right stays until the mistake is mended.

@section[#:tag "view-function"]{The function}

@defproc[(view [world World?] [camera Camera?]
               [#:width width exact-positive-integer? 640]
               [#:height height exact-positive-integer? 360]
               [#:samples samples (or/c #f exact-positive-integer?) #f]
               [#:error error (or/c #f (and/c real? positive?)) #f]
               [#:integrator integrator symbol? 'auto]
               [#:seed seed exact-nonnegative-integer? 0]
               [#:max-depth max-depth (or/c #f exact-nonnegative-integer?) #f]
               [#:shading shading (or/c symbol? (listof symbol?)) 'phong])
         Camera?]{

Opens a window and returns, when it is closed, the camera one looked through last. The picture has
@racket[width] by @racket[height] pixels, up to 100000 each, and is shown as large as the window allows.
It goes on getting better until every pixel has @racket[samples], by default 65536, or the estimated
error relative to the picture's mean is @racket[error]. The other arguments are those of @racket[render];
@racket['raster] as the integrator shows rasterization only, and @racket['cost] and @racket['error]
are shown in false colours.

While the window is open other windows of the program go on. A break closes it. Without a display
@racket[exn:fail:user] is raised, with one line; @racketmodname[racket/gui/base] is loaded by nothing
else in this library.}
