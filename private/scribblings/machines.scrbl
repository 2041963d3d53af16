#lang scribble/manual
@; Renders that take a night or more than one machine: checkpoints, parts, hosts, and what they cost.
@(require scribble/example (for-label racket/base raytrace))

@(define machines (make-base-eval #:lang 'racket/base '(require raytrace)))

@title[#:tag "machines"]{Many machines}

A picture is a pure function of the world, the camera and the settings. Tiles of it can be rendered
anywhere, in any order, and again if one is lost; what comes out has the same bits. This page tells the
ways to use more than one processor and more than one machine, and what each costs.

@section[#:tag "machines-night"]{One machine, a long night}

@verbatim{
raco raytrace weekend -o w.png --samples 4096 --resume
}

With @exec{--resume} all tiles that are done are kept in @filepath{w.png.checkpoint}. It is written to
a temporary name and renamed, at most every 10 seconds, and less often where writing takes more than
2% of the time. The same command goes on from there, on any schedule and with any number of workers.
A checkpoint tells what it is of; one of another scene, size, seed or version is refused in one line
and stays where it is. So is a damaged one: every tile is under a checksum of its own.

@exec{--schedule futures}, the default, shares one heap between its workers. @exec{--schedule places}
gives each worker a heap and a collector of its own and copies the world there; a worker that ends or
stalls is replaced and its tile done again.

@section[#:tag "machines-parts"]{Parts, under any batch system}

@exec{--part I/N} renders every N-th tile, beginning with the I-th, into a small file that says what
it belongs to. Parts need nothing of each other: no network, no common start, no order. All they need is
the same scene and the same version, which @exec{merge} checks; it names the parts that are missing.
Neighbouring tiles go to different parts, so that all take about the same time.

@verbatim{
parallel raco raytrace weekend --samples 1024 --part {}/8 ::: 1 2 3 4 5 6 7 8
seq 8 | xargs -P 4 -I{} raco raytrace weekend --samples 1024 --part {}/8
sbatch --array=1-100 --wrap 'raco raytrace weekend --samples 1024 --part $SLURM_ARRAY_TASK_ID/100'

raco raytrace merge weekend.*.part -o weekend.png
}

The first is GNU parallel (with @exec{--sshlogin} on several machines), the second plain @exec{xargs},
the third a job array of Slurm: one job for each part, anywhere in the cluster. Every job uses all
processors it sees; under Slurm give it @exec{--workers $SLURM_CPUS_PER_TASK}. A job that may be stopped
and put back into the queue wants @exec{--resume}. A part that is lost is rendered again by its own
command. Parts need @exec{--samples}: an error or a time is a property of the whole picture.

@section[#:tag "machines-hosts"]{Hosts, over ssh}

@exec{--schedule hosts:FILE} gives tiles on demand to workers on the hosts that the file names:

@verbatim{
# [user@"@"]host[:port]  workers  racket's path there, if it is not in PATH
alba                  4
me@"@"brig:2222          8        /opt/racket/bin/racket
}

Each host must log in without a password and have the same Racket, the same library and the same scene.
They are compared by checksums before any tile goes there; a host where something differs is named in
one line and left out. The tiles of a host that is lost are done elsewhere, and it is tried again
every three seconds, so that it can come back or come late. @exec{--error} and @exec{--seconds} work as
on one machine.

Workers listen on 127.0.0.1 only and ssh carries the connection. Other users who are logged in on such a
host can reach its 127.0.0.1 too, and what listens there runs what it is sent: on hosts that are shared
with people you do not trust, use parts.

@section[#:tag "machines-cost"]{What each costs}

@exec{racket tests/bench/scaling.rkt} renders one picture in each way and writes a table. Two parts
and two hosts run on the same two processors, so it shows what a way costs and not what more machines
bring. These numbers are of one round on a machine that had other work to do, so they are CPU seconds,
good to a few tenths. The picture is @exec{weekend}, 320 × 180 with 16 samples, in 240 tiles of 16 × 16
pixels; start is what the command takes for a single pixel, with everything it starts; efficiency is that
of one future's CPU seconds to these; a tile is what one costs beside its pixels, from a render with
3600 tiles of 4 × 4.

@tabular[#:sep (hspace 2)
(list (list "" "CPU s" "start, s" "efficiency" "a tile, ms" "limited by")
      (list "1 future" "3.8" "1.6" "100%" "under 0.1" "one processor")
      (list "2 futures" "3.7" "1.8" "103%" "under 0.1" "the collector, which stops both")
      (list "2 places" "7.0" "4.6" "55%" "0.1" "loading the library in each place")
      (list "2 parts" "6.4" "5.4" "60%" "0.3" "three starts; checksums of tiles")
      (list "2 hosts" "10.7" "8.0" "36%" "1.2" "starts; tiles written as text"))]

The picture is a small one on purpose: most of what the last three take is their start, which
does not grow with the picture. Of the tile on a host the process that gives tiles out takes 0.6 ms, and
1.5 ms where it is one of 16 × 16 pixels.

@section[#:tag "machines-hundred"]{A hundred machines}

Let a picture take @italic{W} CPU seconds in @italic{M} tiles, and let there be @italic{N} workers. With a
start of @italic{s} seconds and @italic{t} seconds more for each tile, a render takes about

@nested[#:style 'inset]{@italic{T} = @italic{s} + (@italic{W} + @italic{M t}) / @italic{N} + @italic{W} / @italic{M} + @italic{c M} + @italic{j N}}

The third term is the last tile, for which the others wait. For parts @italic{c} is what merging takes for
a tile, and @italic{j} is 0. For hosts tiles are given out while others are rendered, so
@italic{c M} is no sum but a bound: no more than 1 / @italic{c} tiles a second; and @italic{j} is what
connecting a worker takes, half of it on average, for the first work while the last are still connected.

A sample of this scene takes 2.4 µs here, so @exec{--size 1920x1080 --samples 4096} takes
@italic{W} = 20,300 s, more than five and a half hours, in @italic{M} = 8160 tiles of 2.5 s.

@examples[#:eval machines #:label #f
(define (seconds-on workers #:start s #:tile t #:merge c #:join j)
  (define W 20300.0)
  (define M 8160)
  (+ s (/ (+ W (* M t)) workers) (/ W M) (* c M) (* j workers)))
(define (efficiency-on workers seconds) (/ 20300.0 workers seconds))
(code:comment "parts: start and merge 2.7 and 1.6 s, 0.3 ms a tile in writing and in merging")
(define by-parts (seconds-on 100 #:start 4.3 #:tile 0.0003 #:merge 0.0003 #:join 0))
(list by-parts (efficiency-on 100 by-parts))
(code:comment "hosts: 0.7 s to connect each, 1.2 ms a tile there")
(define by-hosts (seconds-on 100 #:start 4.1 #:tile 0.0012 #:merge 0 #:join 0.35))
(list by-hosts (efficiency-on 100 by-hosts))
(code:comment "the most workers that one process can give tiles of 2.5 s, at 1.5 ms each")
(/ 2.5 0.0015)
]

This is a projection from what two workers cost; a hundred machines have not been tried. It says
what to watch. Parts lose little whatever their number, but a picture has to be worth the start: with
@italic{N} parts, @italic{W} / @italic{N} should be a minute or more. Hosts lose the time it takes to connect
them, one after the other, and for many hosts and few samples the process that gives out tiles becomes the
limit: a tile should take at least 1.5 ms times the number of workers, which @exec{--tile 32} makes four
times as likely to hold. Uneven machines are no trouble to hosts, which take tiles as they can; parts
are all of one size, so make several for each machine.
