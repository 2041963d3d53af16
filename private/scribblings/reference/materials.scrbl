#lang scribble/manual
@; What surfaces do with light: matte, glossy, metal, clear, shining, mixed and bumped ones.
@(require (for-label racket/base raytrace))

@title[#:tag "reference-materials"]{Materials}

@declare-exporting[raytrace]

A material says how a surface scatters or sends out light. A colour is a linear RGB @racket[Float3];
where @racket[Texture?] is allowed, a texture shows it, clamped to what is allowed there. Where a
number may be a texture, it is the luminance of what the texture shows. Arguments that do not fit
raise @racket[exn:fail:contract]. An albedo is the part of the light that is reflected, each
component from 0 to 1. Arguments with a keyword and a default may be given by place too, in the order
shown. Constructors are patterns of @racketidfont{match}, of the parts that the accessors name, in
their order.

@defproc[(Material? [v any/c]) boolean?]{
Whether a value is a material of any kind.}

@section[#:tag "reference-materials-matte"]{Matte and glossy}

@defproc[(Lambertian [albedo (or/c Float3? Texture?)]) Lambertian?]{
Matte: equally bright from every side, as chalk or unglazed clay.}

@deftogether[(@defproc[(Lambertian? [v any/c]) boolean?]
              @defproc[(Lambertian-albedo [material Lambertian?]) (or/c Float3? Texture?)])]{
Its albedo.}

@defproc[(Plastic [albedo (or/c Float3? Texture?)]
                  [#:ior ior (real-in 1 100) 1.5]) Plastic?]{
A matte body under a smooth clear coat, as billiard balls, glazed tiles or varnish. The albedo is
that of the body alone, which looks darker and more saturated under the coat; @racket[ior] is the
coat's index of refraction, 1 for none. Light that the coat throws back inside is counted after
Saunderson, 1942.}

@deftogether[(@defproc[(Plastic? [v any/c]) boolean?]
              @defproc[(Plastic-albedo [material Plastic?]) (or/c Float3? Texture?)]
              @defproc[(Plastic-ior [material Plastic?]) flonum?])]{
Its parts.}

@defproc[(ModifiedPhong [albedo Float3?] [specular Float3?] [shininess (real-in 0 1e9)])
         ModifiedPhong?]{
Matte with a soft highlight that reflects its surroundings, as satin paint or waxed wood: Phong's
model made reciprocal and energy-conserving by Lafortune and Willems, 1994. The two colours, the
parts of the light that body and highlight reflect, add up to at most 1 in each component. The
highlight is about the square root of 2/@racket[shininess] radians wide.}

@deftogether[(@defproc[(ModifiedPhong? [v any/c]) boolean?]
              @defproc[(ModifiedPhong-albedo [material ModifiedPhong?]) Float3?]
              @defproc[(ModifiedPhong-specular [material ModifiedPhong?]) Float3?]
              @defproc[(ModifiedPhong-shininess [material ModifiedPhong?]) flonum?])]{
Its parts.}

@defproc[(Phong [color (or/c Float3? Texture?)]
                [#:specularity specularity (>=/c 0) WORLD-SHAPE-SPECULARITY]
                [#:shininess shininess (>=/c 0) WORLD-SHAPE-SHININESS]
                [#:reflectivity reflectivity (or/c (real-in 0 1) Float3?) 0.0]) Phong?]{
The surface of Phong, ``Illumination for Computer Generated Pictures'', 1975: ambient and diffuse
light times a colour with components of at least 0, a white highlight of that strength and exponent,
and the share of a mirror, a number or a colour with components from 0 to 1, which the rest lacks.
Neither reciprocal nor energy-conserving: color + 2 specularity / (shininess + 1) should stay below 1
where light is traced on paths.}

@deftogether[(@defproc[(Phong? [v any/c]) boolean?]
              @defproc[(Phong-color [material Phong?]) (or/c Float3? Texture?)]
              @defproc[(Phong-specularity [material Phong?]) flonum?]
              @defproc[(Phong-shininess [material Phong?]) flonum?]
              @defproc[(Phong-reflectivity [material Phong?]) Float3?])]{
Its parts; the reflectivity as a colour.}

@deftogether[(@defthing[WORLD-SHAPE-SPECULARITY flonum?]
              @defthing[WORLD-SHAPE-SHININESS flonum?])]{
0.3 and 16: what @racket[Phong] has where nothing is said.}

@racketblock[
(define red (Float3 0.7 0.1 0.1))
(define materials
  (list (Lambertian red)
        (Lambertian (Checker red (Float3 0.9 0.9 0.9) #:size 1/2))
        (Plastic red)
        (ModifiedPhong red (Float3 0.2 0.2 0.2) 40)
        (Phong red #:reflectivity 0.2)))
(define (picture material)
  (render (World (list (Sphere (Float3 0 0 0) 1 material)
                       (Sphere (Float3 2 4 3) 1 (Emitter (Float3 20 20 20))))
                 '() (Float3 0.3 0.4 0.5))
          (Camera-look-at (Float3 0 0 5) (Float3 0 0 0)) #:width 16 #:height 9 #:samples 4))
(Images-side-by-side (map picture materials))
]

@section[#:tag "reference-materials-metal"]{Mirrors and metals}

@defproc[(Mirror [color (or/c Float3? Texture?) (Float3 1 1 1)]) Mirror?]{
Perfectly smooth: every ray is reflected to one direction. The colour is an albedo.}

@deftogether[(@defproc[(Mirror? [v any/c]) boolean?]
              @defproc[(Mirror-color [material Mirror?]) (or/c Float3? Texture?)])]{
Its colour.}

@defproc[(Metal [albedo (or/c Float3? Texture?)]
                [#:fuzz fuzz (or/c (real-in 0 1) Texture?) 0.0]) Metal?]{
The metal of ``Ray Tracing in One Weekend'': a mirror whose rays are nudged at random by up to
@racket[fuzz]. Its rim grows dark, as rays nudged below the surface are lost, and only scattered rays
find lights in it.}

@deftogether[(@defproc[(Metal? [v any/c]) boolean?]
              @defproc[(Metal-albedo [material Metal?]) (or/c Float3? Texture?)]
              @defproc[(Metal-fuzz [material Metal?]) (or/c flonum? Texture?)])]{
Its parts.}

@defproc[(RoughConductor [roughness (or/c (real-in 0 1) Texture?)]
                         [#:color color (or/c #f Float3?) #f]
                         [#:eta eta (or/c #f Float3?) #f]
                         [#:k k (or/c #f Float3?) #f]) RoughConductor?]{
Metal with a GGX microsurface (Walter and others, ``Microfacet Models for Refraction'', EGSR, 2007).
The roughness is GGX's alpha itself: 0 is a mirror, and so is all below 10@superscript{-4}; 0.1 is
satin. Either @racket[eta] and @racket[k] are the complex index of refraction for red, green and
blue, of components of at least 0; or @racket[color] is what is reflected along the normal, of
components from 0 to 1, rising to white at grazing angles by Schlick's formula. Without any of them
the colour is white; one of the two indices alone, or both with a colour, raise. Light that bounces
among the microfacets is given back after Kulla and Conty, ``Revisiting Physically Based Shading at
Imageworks'', 2017.}

@deftogether[(@defproc[(RoughConductor? [v any/c]) boolean?]
              @defproc[(RoughConductor-roughness [material RoughConductor?]) (or/c flonum? Texture?)]
              @defproc[(RoughConductor-color [material RoughConductor?]) (or/c #f Float3?)]
              @defproc[(RoughConductor-eta [material RoughConductor?]) (or/c #f Float3?)]
              @defproc[(RoughConductor-k [material RoughConductor?]) (or/c #f Float3?)])]{
Its parts.}

@deftogether[(@defproc[(gold [roughness (or/c (real-in 0 1) Texture?) 0.1]) RoughConductor?]
              @defproc[(copper [roughness (or/c (real-in 0 1) Texture?) 0.1]) RoughConductor?]
              @defproc[(silver [roughness (or/c (real-in 0 1) Texture?) 0.1]) RoughConductor?]
              @defproc[(aluminium [roughness (or/c (real-in 0 1) Texture?) 0.1]) RoughConductor?])]{
Metals with indices as measured at 650, 550 and 450 nm: gold, copper and silver from Johnson and
Christy, ``Optical Constants of the Noble Metals'', 1972; aluminium from Rakić, ``Algorithm for the
Determination of Intrinsic Optical Constants of Metal Films'', 1995.}

@racketblock[
(RoughConductor-eta (gold 0.2))
(define brushed (RoughConductor 0.3 #:color (Float3 0.9 0.8 0.7)))
(define worn (RoughConductor (Noise (Float3 0.1 0.1 0.1) (Float3 0.6 0.6 0.6))))
(define balls
  (list (Sphere (Float3 -2 0 0) 1 (Mirror (Float3 0.9 0.9 1)))
        (Sphere (Float3 0 0 0) 1 brushed)
        (Sphere (Float3 2 0 0) 1 (Metal (Float3 0.8 0.6 0.2) #:fuzz 0.3))
        (Sphere (Float3 0 2 0) 1 (silver))))
(render (World balls '() (GradientSky (Float3 0.9 0.9 0.9) (Float3 0.2 0.4 0.8)))
        (Camera-look-at (Float3 0 1 7) (Float3 0 1 0)) #:width 32 #:height 18 #:samples 4)
]

@section[#:tag "reference-materials-clear"]{Glass and water}

@defproc[(Dielectric [ior (>/c 0)]
                     [#:fresnel fresnel (or/c 'exact 'schlick) 'exact]
                     [#:absorption absorption Float3? (Float3 0 0 0)]
                     [#:outside-ior outside-ior (>/c 0) 1.0]) Dielectric?]{
Smooth and clear, of an index of refraction: 1.33 for water, 1.5 for glass, 2.42 for diamond.
@racket[outside-ior] is that of what is around the shape, 1 for air. Light fades as
exp(−@racketvarfont{absorption} × @racketvarfont{distance}) inside (Beer and Lambert), per world unit
and colour, of components of at least 0. @racket['schlick] is the approximation that ``Ray Tracing in
One Weekend'' has.}

@deftogether[(@defproc[(Dielectric? [v any/c]) boolean?]
              @defproc[(Dielectric-ior [material Dielectric?]) flonum?]
              @defproc[(Dielectric-fresnel [material Dielectric?]) (or/c 'exact 'schlick)]
              @defproc[(Dielectric-absorption [material Dielectric?]) Float3?]
              @defproc[(Dielectric-outside-ior [material Dielectric?]) flonum?])]{
Its parts.}

@defproc[(RoughDielectric [ior (>/c 0)]
                          [#:roughness roughness (or/c (real-in 0 1) Texture?) 0.1]
                          [#:absorption absorption Float3? (Float3 0 0 0)]
                          [#:outside-ior outside-ior (>/c 0) 1.0]) RoughDielectric?]{
Glass with a GGX microsurface, from slightly blurred to frosted; roughness and the light among the
microfacets are as in @racket[RoughConductor], all else as in @racket[Dielectric]. A boundary of two
equal indices does not scatter, however rough.}

@deftogether[(@defproc[(RoughDielectric? [v any/c]) boolean?]
              @defproc[(RoughDielectric-ior [material RoughDielectric?]) flonum?]
              @defproc[(RoughDielectric-roughness [material RoughDielectric?])
                       (or/c flonum? Texture?)]
              @defproc[(RoughDielectric-absorption [material RoughDielectric?]) Float3?]
              @defproc[(RoughDielectric-outside-ior [material RoughDielectric?]) flonum?])]{
Its parts.}

@racketblock[
(define bottle-green (Dielectric 1.5 #:absorption (Float3 1.2 0.3 0.9)))
(define frosted (RoughDielectric 1.5 #:roughness 0.3))
(define bubble (Sphere (Float3 1.2 0 0) 0.6 (Dielectric 1.0 #:outside-ior 1.5)))
(render (World (list (Sphere (Float3 -1.2 0 0) 1 bottle-green)
                     (Sphere (Float3 1.2 0 0) 1 frosted) bubble)
               '() (GradientSky (Float3 0.9 0.9 0.9) (Float3 0.2 0.4 0.8)))
        (Camera-look-at (Float3 0 0 5) (Float3 0 0 0)) #:width 32 #:height 18 #:samples 4)
]

@section[#:tag "reference-materials-light"]{Surfaces that shine}

@defproc[(Emitter [radiance (or/c Float3? Texture?)]
                  [#:two-sided? two-sided? boolean? #f]
                  [#:surface surface (or/c #f Material?) #f]) Emitter?]{
A surface that sends out light, the same in every direction and however far away: a linear RGB colour
of components of at least 0. A shape of it is a light, and need not be among the lights of a world.
With @racket[two-sided?] the inside or back shines too. @racket[surface] scatters the light that
falls on it; it may not shine itself, and @racket[#f] reflects none; only path tracing shows it.
Spheres, quads, disks, triangles, boxes and meshes are looked for by rays of their own, in groups and
instances too; other shapes, those with a texture, those that move and the parts of solids are found
by scattered rays alone, with more noise.}

@deftogether[(@defproc[(Emitter? [v any/c]) boolean?]
              @defproc[(Emitter-radiance [material Emitter?]) (or/c Float3? Texture?)]
              @defproc[(Emitter-two-sided? [material Emitter?]) boolean?]
              @defproc[(Emitter-surface [material Emitter?]) (or/c #f Material?)])]{
Its parts.}

@section[#:tag "reference-materials-composed"]{Mixed and bumped materials}

@defproc[(Mix [first Material?] [second Material?] [weight (or/c (real-in 0 1) Texture?)]) Mix?]{
Two materials at once, as dust on glass or a worn coat of paint. The weight is the part of the
second. Mixes may be mixed again, of at most eight materials where a texture is a weight. Neither may
shine, be bumped or bound a medium; the mix itself may be bumped.}

@deftogether[(@defproc[(Mix? [v any/c]) boolean?]
              @defproc[(Mix-first [material Mix?]) Material?]
              @defproc[(Mix-second [material Mix?]) Material?]
              @defproc[(Mix-weight [material Mix?]) (or/c flonum? Texture?)])]{
Its parts.}

@defproc[(Bumped [material Material?] [texture Texture?] [#:height height real? 0.1]) Bumped?]{
A material whose surface looks dented and raised, as hammered metal or rippled water (Blinn,
``Simulation of Wrinkled Surfaces'', SIGGRAPH, 1978). The luminance of the texture is how high the
surface stands, outwards; @racket[height] is that of luminance 1 over 0, finite and in world units,
and below 0 the texture is carved in. Outlines and shadows stay those of the shape. The material may
not be an @racket[Emitter] nor an @racket[Interior], though the surface of either may be bumped. Path
tracing shows bumps; previews, and the shading that @racket[render] takes for worlds of @racket[Phong]
alone, do not. Slopes are found after Mikkelsen, ``Bump Mapping Unparametrized Surfaces on the GPU'',
2010.}

@deftogether[(@defproc[(Bumped? [v any/c]) boolean?]
              @defproc[(Bumped-material [material Bumped?]) Material?]
              @defproc[(Bumped-texture [material Bumped?]) Texture?]
              @defproc[(Bumped-height [material Bumped?]) flonum?])]{
Its parts.}

@racketblock[
(define lamp (Emitter (Float3 9 8 7) #:two-sided? #t))
(define dusty (Mix (Mirror) (Lambertian (Float3 0.6 0.5 0.4)) 0.3))
(define hammered
  (Bumped (copper 0.2) (Noise (Float3 0 0 0) (Float3 1 1 1) #:scale 6) #:height 0.05))
(render (World (list (Quad (Float3 -1 4 1) (Float3 2 0 0) (Float3 0 0 2) lamp)
                     (Sphere (Float3 -1.2 0 0) 1 dusty)
                     (Sphere (Float3 1.2 0 0) 1 hammered))
               '() (Float3 0.2 0.25 0.3))
        (Camera-look-at (Float3 0 1 6) (Float3 0 0 0)) #:width 32 #:height 18 #:samples 4)
]
