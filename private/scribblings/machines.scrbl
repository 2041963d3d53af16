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

@exec{racket tests/bench/scaling.rkt} renders one picture in each way and writes this table. Two parts
and two hosts run on the same two processors, so that it shows what a way costs and not what more machines
bring. Start is what the command takes for one pixel, with everything it starts; the last column what
a tile costs more than its pixels.

TABLE

@section[#:tag "machines-hundred"]{A hundred machines}

