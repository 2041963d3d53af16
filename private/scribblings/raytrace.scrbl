#lang scribble/manual
@; The manual of the package raytrace; its pages are the files beside this one.
@(require (for-label racket/base raytrace))

@title{raytrace: pictures as pure functions}

@defmodule[raytrace #:no-declare #:packages ("raytrace")]

A functional ray tracer. A world, a camera and a handful of settings are immutable values; a picture
is a pure function of them, and tells how exact it is. This manual has four kinds of pages:

@itemlist[
@item{@secref["tutorial"] goes from one sphere to a large scene, a few lines at a time.}
@item{@secref["how-to"] has short answers to questions that begin with ``how do I''.}
@item{@secref["accuracy"], @secref["inside"] and @secref["seed-and-books"] tell how exact the pictures are,
how they are made, and where ideas of articles and books are found here. @secref["spaces"] and
@secref["pi"] explain one idea each, with numbers.}
@item{@secref["reference"] tells all of every name: arguments and their ranges, units, errors, sources.
@secref["view"] and @secref["machines"] are about the window and about long renders.}
]

All pictures and numbers printed below a line of code were computed while the manual was built.

@local-table-of-contents[]

@include-section["tutorial.scrbl"]
@include-section["how-to.scrbl"]
@include-section["accuracy.scrbl"]
@include-section["inside.scrbl"]
@include-section["seed-and-books.scrbl"]
@include-section["spaces.scrbl"]
@include-section["pi.scrbl"]
@include-section["reference.scrbl"]
@include-section["view.scrbl"]
@include-section["machines.scrbl"]
