#lang scribble/manual
@; From one sphere to the weekend's scene, a few lines at a time.
@(require scribble/example "pictures.rkt" (for-label racket/base raytrace))

@(define tutorial (make-pictures))

@title[#:tag "tutorial"]{From one sphere to a weekend}

Each step of this page adds a few lines to the ones before it. Type them at a prompt of DrRacket, or of
@exec{racket} in a terminal: DrRacket shows a picture as it is, and in a terminal
@racket[(show picture)] draws it with coloured blocks.

@section[#:tag "tutorial-sphere"]{A sphere and a camera}

A world needs a shape, and a picture needs a camera. Points and colours are both a @racket[Float3]. Points are
x to the right, y up and z towards you; colours are red, green and blue, from 0 for none to 1 for all, in linear
light. A sphere is a middle, a radius and a material; @racket[Lambertian] is a matte material, like chalk,
and its colour says how much of the light it sends back.

@racketinput[(require raytrace)]
@examples[#:eval tutorial #:label #f
(define red (Lambertian (Float3 0.8 0.15 0.1)))
(define ball (Sphere (Float3 0 1 0) 1 red))
(define camera
  (Camera-look-at (Float3 0 2 6) (Float3 0 1 0) #:vertical-field-of-view-degrees 32))
(define world (World (list ball) '() (Float3 1 1 1)))
(render world camera #:width 256 #:height 144)
]

The camera stands at (0, 2, 6), looks at (0, 1, 0), the middle of the ball, and sees 32 degrees from the lower to the
upper edge of the picture. A @racket[World] has shapes,
lights (none here), and a colour that rays see where they meet no shape. That colour is white, and it lights the ball:
from every side alike, so nothing tells a ball from a disk.

@section[#:tag "tutorial-light"]{A light}

Light from one direction shows the form. A @racket[DistantLight] is a sun: the direction towards it, of any
length, and how much light arrives. The background is now almost black.

@examples[#:eval tutorial #:label #f
(define sun (DistantLight (Float3 1 2 1.5) (Float3 3 2.8 2.4)))
(define night (Float3 0.005 0.007 0.015))
(render (World (list ball) sun night) camera #:width 256 #:height 144)
]

@section[#:tag "tutorial-material"]{Materials}

What a shape looks like is decided by its material. Here is the same ball three times: matte, under a
clear coat, and with a soft highlight. @racket[Images-side-by-side] puts pictures in a row.

@examples[#:eval tutorial #:label #f
(define color (Float3 0.8 0.15 0.1))
(define materials
  (list (Lambertian color)
        (Plastic color)
        (ModifiedPhong color (Float3 0.15 0.15 0.15) 30)))
(Images-side-by-side
 (for/list ([material materials])
   (render (World (list (Sphere (Float3 0 1 0) 1 material)) sun (Float3 0.3 0.35 0.4))
           camera #:width 120 #:height 120))
 #:labels '("Lambertian" "Plastic" "ModifiedPhong"))
]

Nothing was changed to make these pictures. A world is a value: another material makes another world.

@section[#:tag "tutorial-ground"]{Ground}

A ball that floats is hard to place. Ground gives it a shadow. A @racket[Disk] has a middle, a direction
that it faces, and a radius. Where a material takes a colour it takes a texture too, such as a
@racket[Checker].

@examples[#:eval tutorial #:label #f
(define ground
  (Disk (Float3 0 0 0) (Float3 0 1 0) 50
        (Lambertian (Checker (Float3 0.6 0.6 0.55) (Float3 0.25 0.3 0.3)))))
(render (World (list ground ball) sun night) camera #:width 256 #:height 144)
]

The shadow is black but for a trace of the dark background, and a touch of red on the ground beside the ball: light
that the ball has passed on. Nobody asked for it. Rays go on from where they hit, so light takes as
many turns as it likes.

@section[#:tag "tutorial-sky"]{Sky}

Shadows outdoors are blue because the sky lights them. A @racket[GradientSky] is a colour at the bottom and
one at the top, mixed by height.

@examples[#:eval tutorial #:label #f
(define sky (GradientSky (Float3 0.9 0.9 0.9) (Float3 0.3 0.5 0.9)))
(define low-sun (DistantLight (Float3 2 1.5 1) (Float3 2 1.6 1.1)))
(render (World (list ground ball) low-sun sky) camera #:width 256 #:height 144)
]

A physical sky is two calls away: see @racket[daylight-sky] and @racket[daylight-sun].

@section[#:tag "tutorial-spheres"]{Several spheres}

Shapes come in a list, and a list is made by a loop. Thirty small balls stand on a spiral; each takes its
colour from @racket[Float3-random-color]. What looks random here is a function of a seed and an index: the
same picture comes out today and tomorrow.

@examples[#:eval tutorial #:label #f
(define small-balls
  (for/list ([k 30])
    (define angle (* 0.6 k))
    (define distance (+ 1.6 (* 0.09 k)))
    (Sphere (Float3 (* distance (cos angle)) 0.22 (* distance (sin angle))) 0.22
            (Lambertian (Float3-random-color #:seed 4 #:index k)))))
(define higher
  (Camera-look-at (Float3 0 3 8) (Float3 0 0.5 0) #:vertical-field-of-view-degrees 36))
(render (World (list* ground ball small-balls) low-sun sky) higher
        #:width 256 #:height 144)
]

@section[#:tag "tutorial-glass"]{Glass}

A @racket[Dielectric] is clear glass, water or diamond, by its index of refraction. What it lets through is
turned around and bent; what it reflects grows towards the rim. The large ball is now of glass.

@examples[#:eval tutorial #:label #f
(define glass-ball (Sphere (Float3 0 1 0) 1 (Dielectric 1.5)))
(render (World (list* ground glass-ball small-balls) low-sun sky) higher
        #:width 256 #:height 144)
]

The sun is a @racket[DistantLight], a point in the sky without a size. No ray that leaves the glass can hit a
point, so its light does not come through: the glass has a shadow and no bright spot in it.
A lamp that is a shape, with an @racket[Emitter] for its material, is met by such rays. It is dimmer here than
a lamp would be outdoors, so the sky is darkened as well.

@examples[#:eval tutorial #:label #f
(define lamp (Sphere (Float3 5 8 -4) 2 (Emitter (Float3 18 16 13))))
(define evening (GradientSky (Float3 0.25 0.22 0.2) (Float3 0.06 0.1 0.2)))
(render (World (list* ground glass-ball lamp small-balls) '() evening) higher
        #:width 256 #:height 144 #:samples 24)
]

@section[#:tag "tutorial-metal"]{Metal}

Metals reflect, and colour what they reflect. @racket[gold], @racket[copper], @racket[silver] and
@racket[aluminium] are metals by their measured indices; they take a roughness, 0 for a mirror. @racket[Metal] is the
simpler metal of the books, a colour and a fuzz.

@examples[#:eval tutorial #:label #f
(define trio
  (list (Sphere (Float3 -2.2 1 0) 1 (gold 0.2))
        glass-ball
        (Sphere (Float3 2.2 1 0) 1 (Metal (Float3 0.75 0.8 0.85) 0.02))))
(define marbles
  (for*/list ([row 4] [column 9])
    (define k (+ column (* 9 row)))
    (define shift (Float3-random-point-in-sphere 0.2 #:seed 9 #:index k))
    (Sphere (Float3 (+ (* 0.8 (- column 4)) (Float3-x shift)) 0.18
                    (+ 1.6 (* 0.8 row) (Float3-z shift)))
            0.18 (Plastic (Float3-random-color #:seed 4 #:index k)))))
(define still-life (World (cons ground (append trio marbles)) low-sun sky))
(define wide (Camera-look-at (Float3 0 2.6 9) (Float3 0 0.8 0)
                             #:vertical-field-of-view-degrees 28))
(render still-life wide #:width 256 #:height 144)
]

@section[#:tag "tutorial-lens"]{Depth of field}

A camera with a lens is sharp at one distance. @racket[#:lens-radius] is the size of the lens in world units,
0 for a pinhole; @racket[#:focus-distance] is by default the distance of the point that the camera looks at.

@examples[#:eval tutorial #:label #f
(define with-lens
  (Camera-look-at (Float3 0 2.6 9) (Float3 0 0.8 0)
                  #:vertical-field-of-view-degrees 28 #:lens-radius 0.25))
(render still-life with-lens #:width 256 #:height 144)
]

@section[#:tag "tutorial-error"]{Samples and error}

A pixel is the mean of what many rays bring, 16 unless told otherwise. More rays make less noise:

@examples[#:eval tutorial #:label #f
(define (with-samples count)
  (render still-life with-lens #:width 128 #:height 72 #:samples count))
(define pictures (map with-samples '(1 8 32)))
(Images-side-by-side pictures #:labels '("1 sample" "8 samples" "32 samples"))
]

Every picture knows how far it is off. @racket[Image-relative-error] is the estimated root mean square error of its
pixels, relative to the picture's mean, and @racket[Image-error-map] shows where the error is. One sample alone cannot know it.

@examples[#:eval tutorial #:label #f
(map Image-relative-error pictures)
(Image-false-color (Image-error-map (caddr pictures)))
]

So the plain way to ask for a picture is to say how exact it shall be. Samples then go to the pixels that need them:

@examples[#:eval tutorial #:label #f
(define exact (render still-life with-lens #:width 128 #:height 72 #:error 0.04))
exact
(Image-relative-error exact)
]

@section[#:tag "tutorial-weekend"]{The weekend's scene}

Everything is there for a picture like the one on the cover of @emph{Ray Tracing in One Weekend}: three large balls amid
hundreds of small ones, each of a material chosen by chance. A colour times another one is dark and rich,
which suits matte things.

@examples[#:eval tutorial #:label #f
(define (chance k series) (Float3-x (Float3-random-color #:seed series #:index k)))
(define (some-material k)
  (define color (Float3-random-color #:seed 20 #:index k))
  (define choice (chance k 21))
  (cond
    [(< choice 0.8)
     (Lambertian (Float3-scale-by-vector color (Float3-random-color #:seed 22 #:index k)))]
    [(< choice 0.95)
     (Metal (Float3-linear-interpolate color (Float3 1 1 1) 0.5) (* 0.5 (chance k 23)))]
    [else (Dielectric 1.5)]))
(define field
  (for*/list ([row 22] [column 22])
    (define k (+ column (* 22 row)))
    (Sphere (Float3 (+ -11 column (* 0.9 (chance k 24))) 0.2
                    (+ -11 row (* 0.9 (chance k 25))))
            0.2 (some-material k))))
(define large
  (list (Sphere (Float3 0 1 0) 1 (Dielectric 1.5))
        (Sphere (Float3 -4 1 0) 1 (Lambertian (Float3 0.4 0.2 0.1)))
        (Sphere (Float3 4 1 0) 1 (Metal (Float3 0.7 0.6 0.5)))))
(define earth (Sphere (Float3 0 -1000 0) 1000 (Lambertian (Float3 0.5 0.5 0.5))))
(define (apart? small)
  (for/and ([ball large])
    (> (Float3-distance (Sphere-point small) (Sphere-point ball)) 1.3)))
(define weekend
  (World (cons earth (append large (filter apart? field))) '()
         (GradientSky (Float3 1 1 1) (Float3 0.5 0.7 1))))
(define weekend-camera
  (Camera-look-at (Float3 13 2 3) (Float3 0 0 0) #:vertical-field-of-view-degrees 20
                  #:focus-distance 10 #:lens-radius 0.05))
(render weekend weekend-camera #:width 320 #:height 180 #:samples 16)
]

The scene with the very same 487 spheres that other renderers are measured by is @filepath{scenes/weekend.rkt}
of this package; @exec{raco raytrace weekend -o weekend.png} renders it.

@section[#:tag "tutorial-file"]{As a file}

A scene in a file is a module that provides @racketidfont{world} and @racketidfont{camera}, and perhaps
@racketidfont{settings}. Any module will do:

@codeblock|{
#lang racket/base
(require raytrace)
(provide world camera settings)

(define ball (Sphere (Float3 0 1 0) 1 (gold 0.1)))
(define ground (Disk (Float3 0 0 0) (Float3 0 1 0) 50 (Lambertian (Float3 0.5 0.5 0.5))))
(define sky (GradientSky (Float3 0.9 0.9 0.9) (Float3 0.3 0.5 0.9)))
(define world (World (list ball ground) '() sky))
(define camera (Camera-look-at (Float3 0 2 6) (Float3 0 1 0)))
(define settings (hash 'size '(320 180) 'samples 32))
}|

In the shell:

@commandline{raco raytrace my-scene.rkt -o my-scene.png}
@commandline{raco raytrace my-scene.rkt -o my-scene.png --size 1280x720 --error 1%}

@exec{raco raytrace new my-scene.rkt} writes a commented one to start from, and @exec{raco raytrace check
my-scene.rkt} tells what is probably wrong with a scene. From here, @secref["how-to"] goes on.
