#lang scribble/manual
@; What is promised about numbers and errors, and what was measured.
@(require scribble/example "pictures.rkt" (for-label racket/base raytrace))

@(define accuracy (make-pictures))
@(define (table . rows)
   (tabular #:sep (hspace 2) #:row-properties '(bottom-border ()) rows))

@title[#:tag "accuracy"]{Accuracy}

@section[#:tag "accuracy-error"]{The error of a picture}

A pixel is a mean over samples, and a mean has a standard error. It cannot be taken from the scatter of the samples as if they
were independent: the default sampler spreads them evenly, and so they are much better than their scatter tells. Here every
pixel has two streams of samples, randomised independently of each other. How far the two means differ says how far their
own mean is off. One pixel knows this badly, with one degree of freedom; a picture has thousands.

@itemlist[
@item{@racket[Image-standard-error] is the standard error of each channel of each pixel.}
@item{@racket[Image-relative-error] is the estimated root mean square error (RMSE) over all pixels and channels, divided by the picture's
mean. It is what @racket[#:error] asks for.}
@item{@racket[Image-relative-error-uncertainty] is the standard error of that number itself.}
]

Is it true? Here the same scene is rendered with eight seeds and compared with a picture of far more samples.

@examples[#:eval accuracy #:label #f
(define world
  (World (list (Disk (Float3 0 0 0) (Float3 0 1 0) 9 (Lambertian (Float3 0.5 0.5 0.5)))
               (Sphere (Float3 0 1 0) 1 (Lambertian (Float3 0.7 0.2 0.1)))
               (Sphere (Float3 3 5 2) 1 (Emitter (Float3 12 12 12))))
         '() (Float3 0.2 0.25 0.3)))
(define camera
  (Camera-look-at (Float3 0 2 6) (Float3 0 1 0) #:vertical-field-of-view-degrees 30))
(define (picture samples seed)
  (render world camera #:width 64 #:height 36 #:samples samples #:seed seed))
(define reference (picture 512 1000))
(define (mean numbers) (/ (apply + numbers) (length numbers)))
(define brightness (mean (for/list ([x (Image-pixels reference)]) x)))
(define pictures (for/list ([seed 8]) (picture 16 seed)))
(code:comment "what the pictures say of themselves, and what is true")
(mean (map Image-relative-error pictures))
(/ (mean (for/list ([image pictures]) (Comparison-rmse (Image-compare image reference)))) brightness)
]

Over six scenes the test suite asks the same with many seeds. The true RMSE divided by the estimate was 0.95 to 1.03 over 64
seeds; with a few seeds, as the quick suite takes them, it scatters from 0.82 (glossy plates, known to 0.2) to 1.05.

With @racket[#:error] and @racket[#:seconds] samples go where the estimate is large, and stop where it is small. A pixel that
seems quiet by chance would then be stopped too early. So a pixel counts for no less than its neighbourhood of 5 by 5
does, and what decides is not the noise of one pixel. Rendered until an error, three scenes came out at 1.00, 1.01 and 1.03 of
their estimate, and their brightness was off by less than two hundredths of the error asked for. Glass and small lights come out up to
1.17 times the estimate. The known exception: a light so small that none of a pixel's first eight samples meets it is
not known to be there, so a picture of tiny lights in view may be worse than it says. Ask for a number of
samples then.

@section[#:tag "accuracy-contracts"]{Numerical contracts}

Each line is a test of the suite @filepath{tests/stress/}. The third column is what must hold, the second what a run
at the quick size measured on a computer of today (x86-64, Racket 8.7); @exec{racket tests/stress/run.rkt} measures at full
size. An ulp is the distance between neighbouring flonums.

@table[
(list @bold{contract} @bold{measured} @bold{must hold})
(list "S01  ray and sphere, up to 10⁸ radii away" "1.92 ulp, no false miss" "4 ulp")
(list "S02  a sphere of radius 10¹⁰ seen from 1 above" "3.2e-16 relative" "5e-14")
(list "S03  a hit point's distance from its sphere" "7.5e-17 at the origin" "2.3e-16")
(list "S04  a ray that leaves a surface hits it again, or leaks" "0 of 44,900, 10 kinds of shapes" "0")
(list "S05  rays at the edges of a closed mesh leak" "0 of 49,992" "0")
(list "S06  rays at its vertices leak" "0 of 49,992" "0")
(list "S07  hierarchy against trying all shapes in turn" "0 differences of 49,992 rays" "same shape, same bits")
(list "S08  rays in the planes of faces" "0 missed of 10,000" "0")
(list "S09  quadratic equations" "2.14 ulp" "8 ulp")
(list "S10  torus: residual of a hit" "6.2e-16 R, no odd count" "1e-12 R")
(list "S11  triangles without area" "0 hits" "0")
(list "S12  zeros, infinities and NaN as input" "0 strange of 1800 rays" "a miss, or one line")
(list "S13  frames around a normal" "1.9e-16 root mean square" "4e-16")
(list "S14  solid angles of small lights" "1.61 ulp" "4 ulp")
(list "S15  Fresnel at grazing angles" "4.4e-16" "1e-12")
(list "S16  light leaks at the edge of shadow" "0 of 15,000" "0")
(list "S17  of coincident surfaces the first one wins" "0 wrong of 1250" "0")
(list "S18  a world scaled by a power of 2" "0 of 14 pictures differ" "the same bits")
(list "S18  and by a power of 10" "0 of 2304 pixels differ" "1e-10")
(list "S19  a world 10⁶, 10⁷, 10⁸ from the origin" "0 of 28,800 rays differ" "1e-6, 1e-5, 1e-4 of them")
(list "S20  100,000 mirror bounces" "9e-15 relative, 0.34 bytes each" "1e-13, 16 bytes")
(list "S21  the mean of up to 50,000 equal samples" "0.75 roundings" "2")
(list "S30  film, lens and back" "1.2e-16" "1e-12")
(list "S31  points on, in and beside lights" "2.8 standard errors at worst of 48" "5")
(list "S32  rays cross a closed mesh an even number of times" "0 odd of 10,000" "0")
(list "damaged files of ten formats" "0 wrong of 1000" "read, or refused in one line")]

Known limit: a ray aimed exactly at a vertex of a mesh may count an odd number of crossings in rare cases of the full
size, so a solid of meshes may be missed there.

@section[#:tag "accuracy-light"]{Light is neither lost nor made}

In a white furnace everything reflects all light and is lit evenly by 1, so all is 1 and nothing can be seen.
@filepath{scenes/furnace.rkt} has one of each material. Rough metal and rough glass are usually too dark, since light that
bounces among their facets is dropped; here it is given back. What can be seen in this picture is noise:

@examples[#:eval accuracy #:label #f
(define furnace
  (World (for/list ([material (list (Lambertian (Float3 1 1 1))
                                    (Plastic (Float3 1 1 1))
                                    (RoughConductor 0.6)
                                    (RoughDielectric 1.5 0.5))]
                    [x '(-3.3 -1.1 1.1 3.3)])
           (Sphere (Float3 x 0 0) 1 material))
         '() (Float3 1 1 1)))
(define white
  (render furnace (Camera-look-at (Float3 0 0 12) (Float3 0 0 0) #:vertical-field-of-view-degrees 20)
          #:width 240 #:height 68 #:integrator 'path #:samples 64))
(code:comment "the mean of the middle of each ball")
(define width (Image-width white))
(define side (quotient width 16))
(for/list ([x '(67 102 138 173)])
  (define left (- (quotient (* x width) 240) (quotient side 2)))
  (define top (quotient (- (Image-height white) side) 2))
  (mean (for/list ([value (Image-pixels (Image-crop white left top side side))]) value)))
]

@section[#:tag "accuracy-samplers"]{Samplers}

How the error falls with the number of samples depends on how these are spread. On smooth integrands the default,
Owen-scrambled Sobol points, falls like the power −1.5 of their number, at edges like −0.72; independent ones like −0.5 always.
@secref["pi"] shows it with a single number, and @exec{racket tests/bench/error.rkt} with pictures.

@examples[#:eval accuracy #:label #f
(for/list ([sampler '(owen-sobol stratified r2 independent)])
  (define image
    (render world camera #:width 64 #:height 36 #:samples 64 #:sampler sampler))
  (list sampler (Comparison-rmse (Image-compare image reference))))
]

@section[#:tag "accuracy-same"]{The same picture everywhere}

The same scene, settings and seed give the same picture to the bit, whatever the schedule, the number of workers, the tiles, and
interrupts between. Only @racket[#:seconds] depends on the clock. Tests kill workers, hosts and whole renders on the way and
compare the files.

@(close-eval accuracy)
