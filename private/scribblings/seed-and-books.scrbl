#lang scribble/manual
@; Where the ideas of two articles and three books are found in this library.
@(require scribble/example "pictures.rkt" (for-label racket/base racket/math raytrace))

@(define seed (make-pictures))
@(define (names . rows)
   (tabular #:sep (hspace 2) #:row-properties '(bottom-border ())
            (cons (list (bold "there") (bold "here")) rows)))

@title[#:tag "seed-and-books"]{From articles and books to this library}

You have read about ray tracing, and want to know what it is called here. This page goes through two articles and three
books, in their order.

@; ------------------------------------------------------------------------------------------------
@section[#:tag "map-article"]{A ray tracer in Typed Racket}

The article about functional programming and ray tracing, whose program is @emph{AnardilRayTracer}, gave this library its
names. Its pieces of code run nearly word for word after @racket[(require raytrace)].

@names[
(list @elem{@racketidfont{(struct Camera (eye forward right up))}}
      @elem{@racket[Camera], the same four fields; @racket[Camera-look-at] makes one})
(list "rays through points spread evenly over the image plane"
      @elem{@racket[Camera-ray]; @racket[Camera-get-ray-direction] as in the article})
(list @racketidfont{World-ray-trace} @racket[World-ray-trace])
(list @racketidfont{World-nearest-hit} @elem{@racket[World-nearest-hit], by the hierarchy and not by a loop over the list})
(list @racketidfont{Intersection-t} @elem{@racket[Intersection-t], @racket[Intersection-point], @racket[Intersection-normal], @racket[Intersection-color]})
(list @racketidfont{Intersection-empty} @racket[Intersection-empty])
(list @racketidfont{INTERSECTION-T-MAX} @racket[INTERSECTION-T-MAX])
(list @racketidfont{World-get-color-at} @racket[World-get-color-at])
(list @racketidfont{World-background-color} @racket[World-background-color])
(list @racketidfont{World-spheres} @elem{@racket[World-spheres]; all shapes are @racket[World-shapes]})
(list @racketidfont{Sphere-intersect} @elem{@racket[Sphere-intersect]; for any shape @racket[Shape-intersect]})
(list "rays towards a light, to see if a point is in shadow" @elem{@racket[World-occluded?]})
(list @racketidfont{World-get-ambient-percent} @elem{@racket[World-get-ambient-percent]})
(list @racketidfont{WORLD-AMBIENT-SAMPLES} @elem{@racket[WORLD-AMBIENT-SAMPLES]; for one world @racket[#:ambient-samples]})
(list @racketidfont{WORLD-MAX-OCCLUSION-DISTANCE} @elem{@racket[WORLD-MAX-OCCLUSION-DISTANCE]; for one world @racket[#:max-occlusion-distance]})
(list @racketidfont{EPSILON} @elem{@racket[EPSILON] is there for the article's code; the library itself uses none})
(list @racketidfont{Float3-random-hemisphere-direction} @elem{@racket[Float3-random-hemisphere-direction], with a seed and an index instead of a hidden state})
(list @elem{@racketidfont{Float3-add}, @racketidfont{Float3-scale-by-scalar}} @elem{@racket[Float3-add], @racket[Float3-scale-by-scalar], and the rest of @racketidfont{Float3-})})
(list "more careful distributions of samples, which the article leaves out" @elem{@racket[#:sampler]: @racket['owen-sobol], @racket['stratified], @racket['r2], @racket['independent]})
(list "path tracing, which it mentions" @elem{@racket[#:integrator] @racket['path]; it is chosen by itself where materials need it})
(list "immutable data, pure functions" "all of it; the kernels change only a worker's own scratch")
(list "pixels are independent: parallel without effort" @elem{@racket[#:schedule] @racket['futures], @racket['places], @racket['hosts]})
(list "the cost of the heap" @elem{@secref["inside-registers"]})
(list "an algorithm apart from its schedule, as in Halide" @elem{@racket[#:schedule], @racket[#:tile], @racket[#:workers]: they change no bit})
]

So the function at the heart of the article can be written down as it stands there, and gives the colour that the library gives:

@examples[#:eval seed #:label #f
(define world
  (World (list (Sphere (Float3 0 0 0) 1 (Float3 0.8 0.2 0.2)))
         (DistantLight (Float3 1 1 1) (Float3 1 0.8 0.65)) (Float3 0.45 0.65 1)))
(define (trace world ray)
  (define nearest-hit (World-nearest-hit world ray))
  (if (< (Intersection-t nearest-hit) INTERSECTION-T-MAX)
      (World-get-color-at world ray nearest-hit)
      (World-background-color world)))
(define ray (Ray (Float3 0.2 0.3 5) (Float3 0 0 -1)))
(equal? (trace world ray) (World-ray-trace world ray))
]

@exec{raco raytrace seed -o seed.png} renders the article's scene.

@; ------------------------------------------------------------------------------------------------
@section[#:tag "map-introduction"]{An introduction to 3D computer graphics}

The article from Manipal about both ways to make a picture, rays and triangles.

@names[
(list "ray tracing, backwards from the eye" @racket[render])
(list "rasterization, with a z-buffer" @elem{@racket[preview], or @racket[#:integrator] @racket['raster]})
(list "the teapot, rasterized" @elem{@racket[teapot]; @filepath{scenes/teapot-shading.rkt}})
(list "Monte Carlo: a mean by random samples" @secref["pi"])
(list "the area of a circle by random points" @elem{@filepath{scenes/pi.rkt}})
(list "r = O + t d" @elem{@racket[Ray], @racket[Ray-point-at]})
(list @racketidfont{ray_color} @elem{@racket[World-ray-trace]; the integrator @racket['naive-path]})
(list @elem{the sampling frequency @racketidfont{ns}} @racket[#:samples])
(list @elem{@racketidfont{depth}, the most bounces} @racket[#:max-depth])
(list @racketidfont{cam.get_ray(u, v)} @racket[Camera-ray])
(list "metallic reflection" @elem{@racket[Mirror], @racket[Metal]; @racket[Float3-reflect]})
(list "refraction; Schlick's approximation" @elem{@racket[Dielectric]; @racket[#:fresnel] @racket['schlick], by default the exact formula})
(list "diffuse reflection" @racket[Lambertian])
(list "fog and other volumes" @racket[Medium])
(list "transforms: translation, rotation, scaling" @elem{@racket[Transform-translate], @racket[Transform-rotate], @racket[Transform-scale], @racket[Transform-compose]})
(list "object space, world space, view space, image space" @secref["spaces"])
(list "orthographic and perspective projection" @elem{@racket[Projection-orthographic], @racket[Projection-perspective]; cameras @racket[Camera-orthographic], @racket[Camera-look-at]})
(list "the view matrix" @racket[Camera-view])
(list "the near plane of the frustum" @elem{@racket[Camera-frustum], @racket[Projection-clip-planes]})
(list "Phong, Gouraud and toon shading" @elem{@racket[#:shading] @racket['phong], @racket['gouraud], @racket['toon]})
]

@; ------------------------------------------------------------------------------------------------
@section[#:tag "map-one-weekend"]{Ray Tracing in One Weekend}

@names[
(list "writing a PPM image" @racket[Image-write])
(list "a progress indicator" @elem{the command shows one on a terminal; @exec{--preview}})
(list "the class vec3" @racket[Float3])
(list "rays, a simple camera, a background" @elem{@racket[Ray], @racket[Camera], @racket[GradientSky]})
(list "a sphere; its normals" @elem{@racket[Sphere]; the integrator @racket['normals]})
(list "front faces and back faces" @elem{normals point outwards; materials know the side})
(list "a list of hittable objects" @elem{the shapes of a @racket[World]; @racket[Group]})
(list "an interval of t" @elem{the limit t-max of a @racket[CustomShape]})
(list "antialiasing by many samples" @elem{@racket[#:samples], @racket[#:filter]})
(list "diffuse materials, gamma correction" @elem{@racket[Lambertian]; @racket[Image-write] encodes sRGB})
(list "limiting the child rays" @racket[#:max-depth])
(list "shadow acne, and the small constant against it" @elem{none needed: @secref["inside-numbers"]})
(list "metal, and fuzzy reflection" @elem{@racket[Metal]})
(list "dielectrics, Snell's law, total reflection, Schlick" @elem{@racket[Dielectric]})
(list "a hollow glass sphere" @elem{a @racket[Sphere] in another, with @racket[#:outside-ior]})
(list "positioning the camera" @elem{@racket[Camera-look-at], @racket[#:vertical-field-of-view-degrees]})
(list "defocus blur" @elem{@racket[#:lens-radius], @racket[#:focus-distance]; the book's angle a is a radius of focus distance × tan(a/2)})
(list "the final scene" @elem{@filepath{scenes/weekend.rkt}; step by step in @secref["tutorial"]})
]

The book's bubble of air is a sphere of index 1 in one of glass:

@examples[#:eval seed #:label #f
(define bubble
  (list (Sphere (Float3 0 0 0) 1 (Dielectric 1.5))
        (Sphere (Float3 0 0 0) 0.8 (Dielectric 1 #:outside-ior 1.5))))
(define floor (Disk (Float3 0 -1 0) (Float3 0 1 0) 30 (Lambertian (Checker (Float3 0.7 0.7 0.2) (Float3 0.2 0.2 0.2)))))
(render (World (cons floor bubble) '() (GradientSky (Float3 1 1 1) (Float3 0.5 0.7 1)))
        (Camera-look-at (Float3 0 0.6 5) (Float3 0 0 0) #:vertical-field-of-view-degrees 30)
        #:width 240 #:height 135)
]

@; ------------------------------------------------------------------------------------------------
@section[#:tag "map-next-week"]{Ray Tracing: The Next Week}

@names[
(list "motion blur: rays with a time, moving spheres" @elem{@racket[Ray-time]; @racket[Moving] any shape, @racket[Camera-moving]; @filepath{scenes/bouncing-spheres.rkt}})
(list "bounding volume hierarchies" @elem{built by themselves: @secref["inside-hierarchy"]})
(list "solid colours, the checker texture" @elem{any colour; @racket[Checker]; @filepath{scenes/checkered-spheres.rkt}})
(list "texture coordinates of a sphere" @elem{@racket[UVTexture] shows them, @racket[CheckerUV] uses them})
(list "image textures, the earth" @elem{@racket[ImageTexture] with @racket[Image-read]; @filepath{scenes/globe.rkt}})
(list "Perlin noise, turbulence, marble" @elem{@racket[Noise], @racket[Turbulence], @racket[Marble]; @racket[perlin-noise], @racket[perlin-turbulence]; @filepath{scenes/perlin-spheres.rkt}})
(list "quadrilaterals" @elem{@racket[Quad]; @filepath{scenes/quads.rkt}})
(list "other planar shapes" @elem{@racket[Triangle], @racket[Disk], @racket[Plane]})
(list "emissive materials" @elem{@racket[Emitter]; @filepath{scenes/simple-light.rkt}})
(list "the Cornell box, boxes of quads" @elem{@racket[Box]; @filepath{scenes/cornell-box.rkt}})
(list "instances: translation and rotation" @elem{@racket[Instance] with any @racket[Transform?]})
(list "volumes of constant density" @elem{@racket[Medium] in an @racket[Interior]; @filepath{scenes/cornell-smoke.rkt}})
(list "the isotropic phase function" @elem{@racket[#:anisotropy] 0})
(list "the final scene" @filepath{scenes/next-week-final.rkt})
]

@; ------------------------------------------------------------------------------------------------
@section[#:tag "map-rest"]{Ray Tracing: The Rest of Your Life}

@names[
(list "estimating π" @elem{@secref["pi"]; @filepath{scenes/pi.rkt}})
(list "stratified samples" @elem{@racket[#:sampler] @racket['stratified]; by default @racket['owen-sobol], which is better})
(list "one-dimensional integrals, densities, importance sampling" "every material and light has a density; tests compare it with what is sampled")
(list "random directions over sphere and hemisphere" @elem{@racket[Float3-random-hemisphere-direction]; warps in @filepath{private/sample/}})
(list "orthonormal bases" @filepath{private/base/frame.rkt})
(list "the scattering density of a material" @elem{@racketidfont{evaluate}, @racketidfont{sample} and @racketidfont{density} of a kernel in @filepath{private/material/}})
(list "sampling lights directly" @elem{every @racket[Emitter] that can be sampled is, and it need not be listed})
(list "mixing densities half and half" "multiple importance sampling, which weighs the two samples and does not choose between them")
(list "sampling a sphere by the cone it is seen in" @filepath{private/light/sphere.rkt})
(list "lists of lights" @elem{a tree that chooses among them; @filepath{scenes/many-lights.rkt}})
(list "surface acne, NaN pixels" "a sample that is no number counts as 0, is counted and told")
(list "the book's own estimator" @elem{the integrator @racket['naive-path]})
(list "the last picture" @filepath{scenes/cornell-glass.rkt})
]

@(close-eval seed)
