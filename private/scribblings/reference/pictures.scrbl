#lang scribble/manual
@; What a render gives: numbers, files, changed pictures, comparisons, other libraries' pictures.
@(require (for-label racket/base racket/contract/base racket/class racket/draw racket/flonum
                     racket/math images/flomap (only-in pict pict?) raytrace))
@title[#:tag "reference-pictures"]{Pictures}
@declare-exporting[raytrace]

@racketblock[
(define world
  (World (list (Sphere (Float3 0 1 0) 1 (Plastic (Float3 0.1 0.3 0.8))))
         (DistantLight (Float3 1 2 1) (Float3 2 2 2))
         (Float3 0.5 0.7 1)))
(define camera (Camera-look-at (Float3 0 1 5) (Float3 0 1 0)))
(define picture (render world camera #:width 32 #:height 18 #:samples 8))
(define rough (render world camera #:width 32 #:height 18 #:samples 2))
(Image-relative-error picture)
(Image-pixel picture 16 9)
(Image-tone picture #:exposure 1/2)
(Images-side-by-side (list picture (Image-false-color (Image-error-map picture))))
(Comparison-rmse (Image-compare rough picture))
]

@section[#:tag "reference-pictures-numbers"]{Numbers}

@deftogether[(@defproc[(Image? [value any/c]) boolean?]
              @defproc[(Image-width [image Image?]) exact-positive-integer?]
              @defproc[(Image-height [image Image?]) exact-positive-integer?]
              @defproc[(Image-pixels [image Image?]) flvector?])]{
A picture of linear RGB with the primaries of Rec. 709: 1 is white, and more is brighter than a
screen shows. The red, green and blue of the pixel in column @italic{x}, from 0 at the left, and row
@italic{y}, from 0 at the top, are in the vector from 3 (@italic{y} width + @italic{x}) on. The
vector is the picture's own: do not change it.

@racket[render], @racket[preview], @racket[Image-read] and @racket[flomap->Image] make pictures. A
picture prints short, and shows itself where pictures are shown among text, as in DrRacket.}

@defproc[(Image-pixel [image Image?] [x exact-nonnegative-integer?] [y exact-nonnegative-integer?])
         (values flonum? flonum? flonum?)]{
The linear red, green and blue of the pixel in column @racket[x] and row @racket[y]. Raises
@racket[exn:fail:contract] outside the picture.}

@defproc[(Image-standard-error [image Image?]) (or/c flvector? #f)]{
The standard error of each channel of each pixel, laid out as the pixels; @racket[#f] where none is
known, as for pictures of one sample a pixel, previews and pictures from files.}

@defproc[(Image-relative-error [image Image?]) (or/c flonum? #f)]{
The estimated root of the mean squared error over all pixels and channels, relative to the mean of
the pixels: what @racket[#:error] of @racket[render] asks for. 0 for a black picture, @racket[#f]
where no errors are known.}

@defproc[(Image-relative-error-uncertainty [image Image?]) (or/c flonum? #f)]{
The standard error of that estimate, from how much the errors of pixels scatter.}

@section[#:tag "reference-pictures-files"]{Files}

@defproc[(Image-write [image Image?] [path path-string?]
                      [#:format format (or/c 'ppm 'pfm 'hdr 'png #f) #f])
         void?]{
Writes the picture to a file. The extension tells the format, in either case, unless @racket[format]
does:

@itemlist[
@item{@filepath{.png} and @filepath{.ppm} (P6): 8 bits a channel, sRGB, clipped at white.}
@item{@filepath{.pfm}: linear numbers in 32-bit floating point.}
@item{@filepath{.hdr}: linear numbers in Radiance's RGBE.}]

The file appears whole or not at all: it is written under a temporary name beside it and renamed.
The path @racket["-"] is the current output port, as PPM unless @racket[format] says otherwise.
Raises @racket[exn:fail:user] with one line where the file cannot be written or its name has another
extension.}

@defproc[(Image-read [path path-string?]) Image?]{
The picture in a PPM (P3 or P6), PFM, Radiance, PNG or JPEG file, told by its first bytes whatever
its name. What a file has in sRGB becomes linear light. Raises @racket[exn:fail:user] with one line
that tells the file, the place in it and what was expected there.}

@section[#:tag "reference-pictures-changed"]{Pictures from pictures}

Each function returns another picture and raises @racket[exn:fail:contract] for values of another
kind or out of range.

@defproc[(Image-crop [image Image?] [x exact-nonnegative-integer?] [y exact-nonnegative-integer?]
                     [width exact-positive-integer?] [height exact-positive-integer?])
         Image?]{
The part of @racket[width] by @racket[height] pixels whose upper left one is in column @racket[x]
and row @racket[y], with its standard errors. It must lie inside the picture.}

@defproc[(Image-scale [image Image?] [factor (or/c (>/c 0) #f) #f]
                      [#:width width (or/c (integer-in 1 100000) #f) #f]
                      [#:height height (or/c (integer-in 1 100000) #f) #f])
         Image?]{
The picture @racket[factor] times as large, or of the given sides in pixels; one of the two keeps
the shape. A factor and a side together are refused. Pixels are weighted in linear light by a tent
as wide as two of the coarser grid's. The standard errors are lost, for the pixels are no longer
independent.}

@defproc[(Image-exposed [image Image?] [stops (real-in -1000 1000)]) Image?]{
The picture 2@superscript{@racket[stops]} times as bright, its standard errors too: 1 is one stop
more.}

@defproc[(Image-tone [image Image?]
                     [#:curve curve (or/c 'filmic 'sRGB 'linear) 'filmic]
                     [#:exposure stops (real-in -1000 1000) 0])
         Image?]{
The picture as a display shows it best, after @racket[stops] of exposure. @racket['filmic] rolls
highlights off and deepens shadows (K. Narkowicz's fit to the ACES curve, 2016); @racket['sRGB]
clips at white, as files and screens do anyway; @racket['linear] shows the numbers themselves, 0 as
black and 1 as white, without the display's own curve, as for data. The result is linear light from
0 to 1 for a file or a screen, and its errors are unknown.}

@defproc[(Image-false-color [image Image?] [#:scale scale (or/c (>/c 0) #f) #f]) Image?]{
The luminance (Rec. 709) of every pixel as a colour: black for 0, then violet, red and orange, pale
yellow for @racket[scale] or more. @racket[#f] takes what 99 of 100 pixels do not exceed.}

@defproc[(Image-error-map [image Image?]) Image?]{
The standard error of every pixel as a grey, the root of the mean square of its channels'. Raises
@racket[exn:fail:contract] where no errors are known.}

@defproc[(Images-side-by-side [images (and/c (listof Image?) pair?)]
                              [#:labels labels (or/c (listof string?) #f) #f]
                              [#:gap gap (integer-in 0 10000) 8])
         Image?]{
The pictures in a row, their upper edges level, black around them and @racket[gap] pixels between two.
@racket[labels], as many as pictures, are written below.}

@section[#:tag "reference-pictures-compared"]{Comparisons}

@defproc[(Image-difference [image Image?] [reference Image?] [#:scale scale (or/c (>/c 0) #f) #f])
         Image?]{
A picture that shows for each pixel the root of the mean over channels of the squared difference, in
the colours of @racket[Image-false-color]: black for none, pale yellow for @racket[scale] or more,
which is by default the largest finite one. Raises @racket[exn:fail:user] where the sizes differ and
@racket[exn:fail:contract] for another scale.}

@defproc[(Image-compare [image Image?] [reference Image?]) Comparison?]{
How far a picture is from a reference of the same size, over all pixels and channels in linear RGB.
A pixel that is no number makes the means no numbers, and is the worst one. Raises
@racket[exn:fail:user] where the sizes differ.}

@deftogether[(@defproc[(Comparison? [value any/c]) boolean?]
              @defproc[(Comparison-rmse [comparison Comparison?]) flonum?]
              @defproc[(Comparison-rmse1 [comparison Comparison?]) flonum?]
              @defproc[(Comparison-relative-mse [comparison Comparison?]) flonum?]
              @defproc[(Comparison-bias [comparison Comparison?]) flonum?]
              @defproc[(Comparison-psnr [comparison Comparison?]) flonum?]
              @defproc[(Comparison-worst-x [comparison Comparison?]) exact-nonnegative-integer?]
              @defproc[(Comparison-worst-y [comparison Comparison?]) exact-nonnegative-integer?]
              @defproc[(Comparison-worst-difference [comparison Comparison?]) flonum?])]{
With @italic{a} for a channel of the picture and @italic{b} for the reference's:

@itemlist[
@item{@racketidfont{rmse}: the root of the mean of (@italic{a} - @italic{b})²;}
@item{@racketidfont{rmse1}: the same where both are cut off at 1;}
@item{@racketidfont{relative-mse}: the mean of (@italic{a} - @italic{b})² / (@italic{b}² + 0.01);}
@item{@racketidfont{bias}: the mean of @italic{a} over the mean of @italic{b}, less 1;}
@item{@racketidfont{psnr}: of the rmse for a peak of 1, in decibels, infinite for equal pictures;}
@item{@racketidfont{worst-x}, @racketidfont{worst-y} and @racketidfont{worst-difference}: the first
 pixel with the largest difference of a channel, and that difference.}]}

@section[#:tag "reference-pictures-elsewhere"]{Pictures elsewhere}

@defproc[(Image->flomap [image Image?]) flomap?]{
The linear pixels as a @racket[flomap] of three components, for @racketmodname[images/flomap].}

@defproc[(flomap->Image [flomap flomap?]) Image?]{
A picture of a flomap's values as they are: three components are linear red, green and blue, one is a
grey; of two or four the first is how much it covers, over black, and is left out, for flomaps are
premultiplied. Raises @racket[exn:fail:contract] for others.}

@defproc[(Image->bitmap [image Image?]) (is-a?/c bitmap%)]{
The picture for @racketmodname[racket/draw], encoded as sRGB and clipped at white.}

@defproc[(Image->pict [image Image?]) pict?]{
The same for @racketmodname[pict].}

@defproc[(show [image Image?] [out output-port? (current-output-port)]
               [#:columns columns exact-positive-integer? (or _COLUMNS 80)])
         void?]{
Prints the picture to a port: itself where the port takes more than text, as DrRacket's does; else
in half blocks of 24-bit colour, at most @racket[columns] of them side by side, by default as many
as the terminal has by @envvar{COLUMNS}, else 80.}

@racketblock[
(define tiny
  (preview (World (list (Sphere (Float3 0 0 0) 1 (Lambertian (Float3 0.8 0.2 0.1))))
                  (DistantLight (Float3 1 2 3) (Float3 2 2 2)))
           (Camera-look-at (Float3 0 0 4) (Float3 0 0 0))
           #:width 32 #:height 18))
(show tiny #:columns 32)
(Image-width (Image-scale (Image-crop tiny 8 0 16 18) 2))
(Image-height (flomap->Image (Image->flomap tiny)))
]
