#lang scribble/manual
@; Every name that raytrace provides, and every flag of the command: one page a family.
@(require (for-label racket/base raytrace))

@title[#:tag "reference" #:style '(toc)]{Reference}

Points, directions and colours are @racket[Float3]s. Lengths are in world units, colours are linear RGB,
angles are in radians unless a keyword's name says degrees. Constructors take any real numbers and check
them once: a value that does not fit raises @racket[exn:fail:contract] with one line that names the
constructor, the argument and what was expected. All values are immutable and compared by
@racket[equal?]; most print as expressions that make them again and are taken apart by @racket[match].

@local-table-of-contents[]

@include-section["reference/vectors.scrbl"]
@include-section["reference/cameras.scrbl"]
@include-section["reference/shapes.scrbl"]
@include-section["reference/transforms.scrbl"]
@include-section["reference/materials.scrbl"]
@include-section["reference/textures.scrbl"]
@include-section["reference/media.scrbl"]
@include-section["reference/lights.scrbl"]
@include-section["reference/worlds.scrbl"]
@include-section["reference/rendering.scrbl"]
@include-section["reference/pictures.scrbl"]
@include-section["reference/command.scrbl"]
