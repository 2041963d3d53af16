#lang scribble/manual
@; The Monte Carlo method on one number, with the samplers of the library.
@(require scribble/example (for-label racket/base raytrace))

@(define monte-carlo
   (make-base-eval #:lang 'racket/base
                   '(require raytrace raytrace/scenes/pi racket/math plot/pict)
                   '(plot-font-size 9)))

@title[#:tag "pi"]{Monte Carlo, explained by π}

Light is computed here by averaging: what a pixel receives is the mean over many rays, chosen at
random or better. How good such a mean is can be seen on a number that everyone knows. Points are
thrown into a square of side 1; the part of them that lies within distance 1 of one corner is the area
of a quarter disk, π/4. So four times that part is an estimate of π. The code is in
@filepath{scenes/pi.rkt}; @exec{racket -l raytrace/scenes/pi} prints its table, and
@exec{raco raytrace pi} draws its points.

@examples[#:eval monte-carlo #:label #f
(pi-estimate 'independent 100)
(pi-estimate 'independent 10000)
(render world camera #:integrator 'raster #:width 300 #:height 300 #:samples 16)
]

@section[#:tag "pi-error"]{An estimate comes with its error}

One number says nothing about how far it may be off. Several runs with other seeds do: how much they scatter tells
the standard error of their mean, without knowing π. That is how @racket[render] knows the error
of its pictures. @racket[pi-error] gives the mean of 32 runs, its standard error, and what a single run
is off by (which one has to know π for).

@examples[#:eval monte-carlo #:label #f
(pi-error 'independent 1024)
(define-values (mean standard-error error) (pi-error 'independent 1024))
(code:comment "how many standard errors the mean is away from the truth")
(/ (- mean pi) standard-error)
(code:comment "and what theory says about a single run: the square root of p (1 - p) / n, times 4")
(let ([p (/ pi 4)]) (* 4 (sqrt (/ (* p (- 1 p)) 1024))))
]

@section[#:tag "pi-slopes"]{Better than chance}

Independent points gain slowly: four times as many halve the error. Points that keep out of each
other's way gain faster. The samplers differ in how they do it: @racket['stratified] puts one point
into each cell of a grid, @racket['owen-sobol] into each cell of many grids at once, and
@racket['r2] follows a sequence that fills every region evenly. The error falls like a power of the number of points;
these are the powers:

@examples[#:eval monte-carlo #:label #f
(for ([sampler SAMPLERS])
  (printf "~a: ~a\n" sampler (real->decimal-string (pi-slope sampler) 2)))
]

Chance gives −1/2. The edge of the disk keeps the others from more than about −3/4: a cell that the
edge runs through is as uncertain as ever, there are just fewer of these. Where nothing has an edge
they do better still.

@examples[#:eval monte-carlo #:label #f
(define counts '(16 64 256 1024))
(parameterize ([plot-x-transform log-transform] [plot-y-transform log-transform]
               [plot-x-ticks (log-ticks #:base 4)] [plot-y-ticks (log-ticks)])
  (plot-pict #:x-label "points" #:y-label "error of one run" #:width 420 #:height 300
             (for/list ([sampler SAMPLERS] [color '(1 2 3 4)])
               (define errors
                 (for/list ([count counts])
                   (define-values (mean standard-error error) (pi-error sampler count))
                   (vector count error)))
               (list (lines errors #:color color #:width 2 #:label (symbol->string sampler))
                     (points errors #:color color #:sym 'fullcircle)))))
]

In pictures the same is seen as noise: with @racket[#:sampler 'independent] a picture needs many times
the samples of @racket['owen-sobol], the default, to look as smooth.
