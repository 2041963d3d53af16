#lang scribble/manual
@; Short answers to questions that begin with: how do I.
@(require racket/file racket/sandbox scribble/example "pictures.rkt" (for-label racket/base raytrace))

@; Files that an example writes go to a folder of their own.
@(define folder (make-temporary-file "raytrace-manual~a" 'directory))
@(define how-to (make-pictures))
@(void (call-in-sandbox-context how-to (lambda () (current-directory folder))))

@title[#:tag "how-to"]{How do I ...}

Every section stands alone, but for a stage that all pictures of this page use: ground, a sky, and a lamp that is a
square.

@racketinput[(require raytrace)]
@examples[#:eval how-to #:label #f
(define ground (Disk (Float3 0 0 0) (Float3 0 1 0) 40 (Lambertian (Float3 0.4 0.4 0.42))))
(define lamp
  (Quad (Float3 -3 5 2) (Float3 0 0 2) (Float3 2 0.5 0) (Emitter (Float3 9 8 7) #:two-sided? #t)))
(define sky (GradientSky (Float3 0.6 0.6 0.6) (Float3 0.25 0.4 0.7)))
(define camera
  (Camera-look-at (Float3 0 1.8 7) (Float3 0 0.9 0) #:vertical-field-of-view-degrees 29))
(define (stage . shapes) (World (list* ground lamp shapes) '() sky))
(define (picture world [camera camera] #:samples [samples 12])
  (render world camera #:width 208 #:height 117 #:samples samples))
(define (ball x material) (Sphere (Float3 x 1 0) 1 material))
(define (three left middle right #:samples [samples 12])
  (picture (stage (ball -2.1 left) (ball 0 middle) (ball 2.1 right)) #:samples samples))
]

@; ------------------------------------------------------------------------------------------------
@section[#:tag "how-to-materials"]{choose a material?}

@itemlist[
@item{Matte: @racket[Lambertian]. With a clear coat, as billiard balls: @racket[Plastic]. With a soft
highlight, as satin paint: @racket[ModifiedPhong].}
@item{Metal: @racket[gold], @racket[copper], @racket[silver], @racket[aluminium] with a roughness, or any
@racket[RoughConductor]; a @racket[Mirror]; the books' @racket[Metal] with its fuzz.}
@item{Clear: @racket[Dielectric], with @racket[#:absorption] for coloured glass. Frosted:
@racket[RoughDielectric].}
@item{Shining: @racket[Emitter]. Two at once: @racket[Mix]. The article's: @racket[Phong].}
]

@examples[#:eval how-to #:label #f
(three (Lambertian (Float3 0.7 0.3 0.2)) (Plastic (Float3 0.1 0.3 0.6)) (copper 0.15))
(three (Dielectric 1.5) (RoughDielectric 1.5 0.2) (Dielectric 1.5 #:absorption (Float3 1.2 0.2 0.6)))
(three (Mix (Lambertian (Float3 0.7 0.7 0.7)) (silver 0.1) 0.5)
       (Emitter (Float3 2 1.4 0.6))
       (Metal (Float3 0.8 0.7 0.5) 0.3))
]

A colour as a material is the article's @racket[Phong] surface. Where all surfaces of a world are that (or shine), it is shaded
as in the article; as soon as one is not, by paths. @racket[#:integrator] decides otherwise.

@; ------------------------------------------------------------------------------------------------
@section[#:tag "how-to-textures"]{paint a surface?}

Where a material takes a colour, it takes a texture. Some live in space, so that the shape is as if cut from a
block: @racket[Checker], @racket[Noise], @racket[Turbulence], @racket[Marble], @racket[GradientTexture]. Others are
wrapped around the shape: @racket[CheckerUV], and @racket[ImageTexture] with a picture, by @racket[Image-read] from a file
or rendered. A @racket[FunctionTexture] is any pure function of the point and the coordinates u and v.

@examples[#:eval how-to #:label #f
(define white (Float3 0.8 0.8 0.8))
(three (Lambertian (Checker white (Float3 0.1 0.2 0.2) 0.4))
       (Lambertian (Marble (Float3 0.1 0.05 0.05) white #:scale 2))
       (Lambertian (Noise (Float3 0.1 0.2 0.5) white #:scale 3 #:octaves 4)))
(define stripes
  (FunctionTexture
   (lambda (point u v) (if (even? (floor (inexact->exact (* 16 v)))) (Float3 0.7 0.2 0.1) white))))
(three (Lambertian (ImageTexture (picture (stage (ball 0 (gold 0.1))))))
       (Plastic (CheckerUV white (Float3 0.6 0.1 0.1) 16 8))
       (Plastic stripes))
]

@; ------------------------------------------------------------------------------------------------
@section[#:tag "how-to-lights"]{light a scene?}

By any shape whose material is an @racket[Emitter]: the larger it is, the softer the shadows. By lights
without a size, as second argument of @racket[World]: a @racket[DistantLight], a @racket[PointLight], a
@racket[SpotLight]. By the background: a colour, a @racket[GradientSky], or an @racket[EnvironmentMap], which
is a picture of all that is around (an @filepath{.hdr} file, say).

@examples[#:eval how-to #:label #f
(define still (list ground (ball -1.2 (Lambertian white)) (ball 1.2 (silver 0.1))))
(define dim (Float3 0.03 0.03 0.05))
(picture (World still (SpotLight (Float3 0 6 3) (Float3 0 -1 -0.45) (Float3 90 80 60) 0.4 0.3) dim))
(define towards-sun (Float3 -0.6 0.4 0.5))
(picture (World still (daylight-sun towards-sun) (daylight-sky towards-sun)))
]

A light without a size is seen in no mirror and through no glass: no ray finds it by chance. Where a bright spot
behind glass or a highlight on polished metal matters, use a shape that shines.

@; ------------------------------------------------------------------------------------------------
@section[#:tag "how-to-cameras"]{place a camera?}

@racket[Camera-look-at] takes where it stands and where it looks. @racket[#:vertical-field-of-view-degrees] is how much it sees
from the lower to the upper edge; @racket[#:lens-radius] and @racket[#:focus-distance] blur what is nearer and farther.
@racket[Camera-orthographic] sees along parallel lines, @racket[Camera-panoramic] all around at once, and
@racket[Camera-fisheye] up to that. Cameras are values: @racket[Camera-orbit], @racket[Camera-dolly],
@racket[Camera-pan] and @racket[Camera-with] make others of them.

@examples[#:eval how-to #:label #f
(define things (apply stage (for/list ([x '(-2.1 0 2.1)] [k 3])
                              (ball x (Plastic (Float3-random-color #:seed 3 #:index k))))))
(Images-side-by-side
 (list (preview things camera #:width 130 #:height 100)
       (preview things (Camera-orbit camera 50 25) #:width 130 #:height 100)
       (preview things (Camera-orthographic (Float3 4 4 7) (Float3 0 1 0) #:height 4)
                #:width 130 #:height 100))
 #:labels '("the camera" "carried around" "orthographic"))
(picture things (Camera-fisheye (Float3 0 1.5 3) (Float3 0 1 0) #:field-of-view-degrees 200))
]

Motion blur: @racket[Moving] carries a shape from one @racket[Transform?] to another while the shutter is open, and
@racket[Camera-moving] does it to the camera.

@examples[#:eval how-to #:label #f
(define flying
  (Moving (ball 0 (Plastic (Float3 0.7 0.1 0.1)))
          (Transform-translate -1.5 0 0) (Transform-translate 0.5 0.4 0)))
(picture (stage flying))
]

@; ------------------------------------------------------------------------------------------------
@section[#:tag "how-to-meshes"]{use a mesh?}

@racket[Mesh-read] takes @filepath{.obj}, @filepath{.ply} and @filepath{.stl} files. Where a file has no normals,
@racket[#:smooth?] makes some. The result is a shape like all others; @racket[Instance] places it, any number of times, without
copying a triangle. A mesh can be given by its numbers as well: see @racket[Mesh].

@examples[#:eval how-to #:label #f
(with-output-to-file "roof.obj"
  (lambda ()
    (display "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 1.2 0\n")
    (display "f 1 5 2\nf 2 5 3\nf 3 5 4\nf 4 5 1\nf 1 2 3 4\n")))
(define roof (Mesh-read "roof.obj" #:material (Plastic (Float3 0.6 0.15 0.1))))
(Mesh-triangle-count roof)
(define (placed shape x degrees scale)
  (Instance shape (Transform-compose (Transform-translate x 0 0)
                                     (Transform-rotate (Float3 0 1 0) #:degrees degrees)
                                     (Transform-scale scale))))
(picture (stage (placed roof -2.2 20 1) (placed roof 2.2 60 0.8)
                (placed (teapot #:material (Plastic white)) 0 30 0.5)))
]

From the shell a mesh file is a scene of its own, on a studio's floor:

@commandline{raco raytrace roof.obj -o roof.png}

@; ------------------------------------------------------------------------------------------------
@section[#:tag "how-to-solids"]{cut and join shapes?}

@racket[SolidUnion], @racket[SolidIntersection] and @racket[SolidDifference] of closed shapes are closed shapes
again.

@examples[#:eval how-to #:label #f
(define cube (Box (Float3 -0.8 0.2 -0.8) (Float3 0.8 1.8 0.8) (Plastic (Float3 0.2 0.35 0.6))))
(define hole (Cylinder (Float3 0 1 -2) (Float3 0 1 2) 0.55 (Plastic (Float3 0.8 0.6 0.2))))
(define bored (SolidDifference (SolidIntersection cube (ball 0 (Plastic white))) hole))
(picture (stage (Instance bored (Transform-rotate (Float3 0 1 0) #:degrees 25))))
]

@; ------------------------------------------------------------------------------------------------
@section[#:tag "how-to-media"]{make fog, smoke and milk?}

A @racket[Medium] has an extinction (one over the mean distance that light goes in it), and an albedo (the part that is
scattered and not absorbed). It fills the whole world by @racket[#:medium], or a closed shape whose material is an
@racket[Interior]. @racket[#:anisotropy] throws light on forward, above 0, or back. A density, as a function of the point,
makes clouds.

@examples[#:eval how-to #:label #f
(define (cloud point)
  (define d (Float3-distance point (Float3 2.1 1 0)))
  (max 0 (- 1 d)))
(three (Interior (Medium 3 (Float3 0.2 0.2 0.2)))
       (Interior (Medium (Float3 0.5 1 2) (Float3 0.95 0.9 0.8)) (Dielectric 1.33))
       (Interior (Medium 8 (Float3 0.95 0.95 0.95) #:density cloud))
       #:samples 8)
(define lantern (SpotLight (Float3 -2 4 0) (Float3 0.5 -1 0) (Float3 60 50 40) 0.35 0.25))
(picture (World (list ground (ball 0.3 (Lambertian white))) lantern (Float3 0.01 0.01 0.02)
                #:medium (Medium 0.06 (Float3 0.8 0.8 0.8)))
         #:samples 8)
]

@; ------------------------------------------------------------------------------------------------
@section[#:tag "how-to-error"]{ask for an error, or a time?}

@racket[#:error] is the root mean square error of the picture relative to its mean, at which to stop;
@racket[#:seconds] is the time to take. Samples then go where they lower the error most. With
@racket[#:samples] every pixel gets as many.

@examples[#:eval how-to #:label #f
(define world (stage (ball 0 (gold 0.2))))
(Image-relative-error (render world camera #:width 80 #:height 45 #:samples 16))
(Image-relative-error (render world camera #:width 80 #:height 45 #:error 0.02))
(Image-relative-error (render world camera #:width 80 #:height 45 #:seconds 0.5))
]

In the shell:

@commandline{raco raytrace my-scene.rkt -o my-scene.png --error 2%}
@commandline{raco raytrace my-scene.rkt -o my-scene.png --seconds 60}

What the number means and how far it can be trusted is in @secref["accuracy"]. @racket[Image-compare] measures a picture against
a reference, and so does

@commandline{raco raytrace compare my-scene.pfm reference.pfm}

@; ------------------------------------------------------------------------------------------------
@section[#:tag "how-to-bright"]{make it brighter, crop it, hand it on?}

@racket[Image-exposed] takes stops, @racket[Image-tone] rolls highlights off as film does, and @racket[Image-crop]
and @racket[Image-scale] do what they say. @racket[Image-write] writes @filepath{.png}, @filepath{.ppm},
@filepath{.pfm} and @filepath{.hdr}; the last two keep linear light. @racket[Image->bitmap],
@racket[Image->pict] and @racket[Image->flomap] hand a picture to other libraries.

@examples[#:eval how-to #:label #f
(define taken (render world camera #:width 128 #:height 72))
(Images-side-by-side (list taken (Image-exposed taken 1) (Image-tone taken #:exposure 1))
                     #:labels '("as it is" "one stop more" "and toned"))
(Image-write taken "taken.pfm")
(Comparison-rmse (Image-compare taken (Image-read "taken.pfm")))
]

@; ------------------------------------------------------------------------------------------------
@section[#:tag "how-to-many"]{use many processors, and many machines?}

One machine needs no asking: a render takes all its processors. @racket[#:workers] and @racket[#:schedule] say otherwise, and
change no bit of the picture. For more machines there are two ways.

@bold{Parts.} @exec{--part I/N} renders every N-th tile into a file; @exec{merge} joins the files. All need the
scene's file, the same version of this package, and the same @exec{--samples}. Whatever starts commands on machines will do. GNU
parallel, xargs on one machine, and an array of Slurm jobs:

@commandline{parallel raco raytrace weekend --samples 1024 --part {}/8 ::: 1 2 3 4 5 6 7 8}
@commandline{seq 8 | xargs -P 4 -I{} raco raytrace weekend --samples 1024 --part {}/8}
@commandline{sbatch --array=1-100 --wrap 'raco raytrace weekend --samples 1024 --part $SLURM_ARRAY_TASK_ID/100'}

And then, where all the parts are:

@commandline{raco raytrace merge weekend.*.part -o weekend.png}

A hundred machines are a hundred parts. Machines that are unequal get more parts than there are machines, so
that the fast ones do more of them.

@bold{Hosts.} @exec{--schedule hosts:FILE} renders on the hosts of a file over ssh, a tile here and a tile there, with one command and
without files to join. Each line is a host, how many workers it has, and where its Racket is if that is not in its
path:

@verbatim|{
alba            4
me@brig:2222    8   /opt/racket/bin/racket
}|

@commandline{raco raytrace weekend -o weekend.png --schedule hosts:hosts.txt}

Each host lets you in without a password and has the same Racket, the same package and the same scene file in the same
place; what differs is told before it gets a tile. Tiles of a host that is lost are rendered by the others. All ports are bound to
127.0.0.1 and carried by ssh; but other users of a host can reach its 127.0.0.1 and so run code as you. Use
it on hosts that you share with nobody, and parts elsewhere.

@; ------------------------------------------------------------------------------------------------
@section[#:tag "how-to-resume"]{stop a render and go on later?}

@commandline{raco raytrace weekend -o weekend.png --samples 4096 --resume}

@exec{--resume} keeps what is done in @filepath{weekend.png.checkpoint}. Kill it whenever you like; the
same command goes on, with any number of workers, and the picture is the one an undisturbed render
would have made, to the bit. With @exec{--keep-partial} an interrupt writes the picture as far as it is, and @exec{--preview} draws it in the terminal as it
forms. A checkpoint of another scene, of other settings or of another version is refused and left as it is. The exit code is 130 after an
interrupt and 143 after SIGTERM.

A render for a number of samples takes 48 bytes of memory a pixel, so 7680 × 4320 pixels fit into 2 GiB; one for an
error or a time takes 128.

@; ------------------------------------------------------------------------------------------------
@section[#:tag "how-to-distance"]{make a shape of a formula?}

A @racket[DistanceShape] is the surface where a function of x, y and z is 0. The function tells the distance to the surface,
negative inside. It may tell less than the true distance. Where it changes by more than 1 a unit, say how much by
@racket[#:lipschitz]. This one is a ball whose radius waves; its slope stays below 1.6.

@examples[#:eval how-to #:label #f
(define (waves x y z)
  (- (sqrt (+ (* x x) (* (- y 1) (- y 1)) (* z z)))
     0.85
     (* 0.08 (sin (* 8 x)) (sin (* 8 y)) (sin (* 8 z)))))
(picture (stage (DistanceShape waves (Float3 -1 0 -1) (Float3 1 2 1) #:lipschitz 2
                               #:material (Plastic (Float3 0.6 0.3 0.1))))
         #:samples 4)
]

@; ------------------------------------------------------------------------------------------------
@section[#:tag "how-to-custom"]{write a shape of my own?}

A @racket[CustomShape] is a box that it lies in and a procedure that meets it with a ray. The procedure gets an origin, a direction of any
length and the largest parameter of interest. It returns @racket[#f], or a list of the least parameter t above 0 and below the
largest where the ray is on the shape, and the outward unit normal there. Here is a paraboloid, y = x² + z²,
cut off by its box.

@examples[#:eval how-to #:label #f
(define (paraboloid origin direction t-max)
  (define-values (ox oy oz) (values (Float3-x origin) (Float3-y origin) (Float3-z origin)))
  (define-values (dx dy dz) (values (Float3-x direction) (Float3-y direction) (Float3-z direction)))
  (define a (+ (* dx dx) (* dz dz)))
  (define half-b (- (+ (* ox dx) (* oz dz)) (* 0.5 dy)))
  (define c (- (+ (* ox ox) (* oz oz)) oy))
  (define root (let ([d (- (* half-b half-b) (* a c))]) (and (> a 0) (>= d 0) (sqrt d))))
  (for/or ([t (if root (list (/ (- (- half-b) root) a) (/ (+ (- half-b) root) a)) '())])
    (define point (Float3-add origin (Float3-scale-by-scalar direction t)))
    (and (< 0 t t-max) (<= 0 (Float3-y point) 1.7)
         (list t (Float3-normalized
                  (Float3 (* 2 (Float3-x point)) -1 (* 2 (Float3-z point))))))))
(define bowl
  (CustomShape (Float3 -1.31 0 -1.31) (Float3 1.31 1.7 1.31) paraboloid
               #:material (Lambertian (Float3 0.6 0.65 0.5)) #:error 1e-12))
(picture (stage bowl) (Camera-orbit camera 0 15) #:samples 6)
]

@racket[#:error] says how far the computed point may be off the surface, in world units: rays that go on from there start
so far away from it, and do not meet the same place again.

@; ------------------------------------------------------------------------------------------------
@section[#:tag "how-to-why"]{find out why a pixel looks as it does?}

@racket[explain] renders one pixel and tells its paths: what was hit, which lights were sampled and what they
brought, and where the light came from.

@examples[#:eval how-to #:label #f
(explain world camera 104 35 #:width 208 #:height 117 #:samples 2)
(map car (Explanation-sources (explain world camera 104 35 #:width 208 #:height 117)))
]

@racket[World-problems] looks for what is probably a mistake: a camera inside a shape, a light inside
another one, everything black. An empty list is good news.

@examples[#:eval how-to #:label #f
(World-problems world camera)
(World-problems (World (list (ball 0 (Plastic white))) '() (Float3 0 0 0)) camera)
]

Some integrators show one thing each: @racket['normals], @racket['depth], how many rays a pixel took (@racket['cost]) and its
error (@racket['error]).

@examples[#:eval how-to #:label #f
(Images-side-by-side
 (for/list ([integrator '(normals cost error)])
   (define seen (render world camera #:width 120 #:height 68 #:integrator integrator))
   (if (eq? integrator 'normals) seen (Image-false-color seen)))
 #:labels '("normals" "cost" "error"))
]

A magenta pixel is one where a function of the scene, such as a texture of your own, raised twice. The command tells which
and why in one line, and goes on; with @exec{--strict} it stops there. Such a function should raise an
exception, as @racket[error] does: Racket's futures hang where @racket[raise] is given any other value.

In the shell:

@commandline{raco raytrace check my-scene.rkt}
@commandline{raco raytrace explain my-scene.rkt --pixel 320,180}
@commandline{raco raytrace my-scene.rkt -o cost.png --integrator cost}

@; ------------------------------------------------------------------------------------------------
@section[#:tag "how-to-manual"]{read this manual offline?}

The package is installed without it, since it renders its pictures while it is built, which takes a minute or
two. In a clone of the repository this builds it into the folder @filepath{manual}, to be read by any browser from
@filepath{manual/raytrace/index.html}:

@commandline{raco scribble --htmls +m --dest manual private/scribblings/raytrace.scrbl}

@(close-eval how-to)
@(delete-directory/files folder)
