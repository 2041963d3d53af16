#lang scribble/manual
@; Shapes, shapes made of other shapes, and shapes by functions of a program's own.
@(require (for-label racket/base raytrace))

@title[#:tag "reference-shapes"]{Shapes}

@declare-exporting[raytrace]

All lengths and coordinates are in world units and have to be finite; what does not fit raises
@racket[exn:fail:contract]. The material of a simple shape may be given by place, after the last
argument shown, or by keyword, which comes first where there are both. Where a material is wanted, a
colour means @racket[(Phong color)]. Constructors are patterns of @racketidfont{match} too, of the
parts that the accessors name, in their order.

@defproc[(Shape? [v any/c]) boolean?]{
Whether a value is a shape of any kind.}

@defproc[(Shape-material [shape Shape?]) Material?]{
The material of a shape; that of its first part, where it is made of others and does not replace
theirs. An empty group has a grey one.}

@deftogether[(@defproc[(Shape-intersect [shape Shape?] [ray Ray?]) Intersection?]
              @defproc[(Sphere-intersect [sphere Sphere?] [ray Ray?]) Intersection?])]{
The first hit of a ray with one shape; one whose parameter is @racket[INTERSECTION-T-MAX] where there
is none. The colour stands for the shape's material: what it reflects of white light, 1 for glass, the
mean of a mixture's; grey, 0.5, where a texture says it; black where it only shines.}

@section[#:tag "reference-shapes-simple"]{Simple shapes}

@defproc[(Sphere [point Float3?] [radius (>/c 0)]
                 [#:material material (or/c Material? Float3?) (Float3 0.5 0.5 0.5)]) Sphere?]{
A sphere around @racket[point]. Texture coordinates: u around the y axis from −x, v from the south
pole to the north pole, both from 0 to 1. Rays meet it by the method of Haines, Günther and
Akenine-Möller, ``Precision Improvements for Ray/Sphere Intersection'', Ray Tracing Gems, 2019.}

@deftogether[(@defproc[(Sphere? [v any/c]) boolean?]
              @defproc[(Sphere-point [sphere Sphere?]) Float3?]
              @defproc[(Sphere-radius [sphere Sphere?]) flonum?]
              @defproc[(Sphere-material [sphere Sphere?]) Material?]
              @defproc[(Sphere-color [sphere Sphere?]) Float3?])]{
Its parts; the colour is the one that @racket[Shape-intersect] reports.}

@defproc[(Plane [point Float3?] [normal Float3?]
                [#:material material (or/c Material? Float3?) (Float3 0.5 0.5 0.5)]) Plane?]{
The infinite plane through a point. The normal, of any length but zero, is outside; it is kept as a
unit vector. Texture coordinates are world units from the point.}

@deftogether[(@defproc[(Plane? [v any/c]) boolean?]
              @defproc[(Plane-point [plane Plane?]) Float3?]
              @defproc[(Plane-normal [plane Plane?]) Float3?]
              @defproc[(Plane-material [plane Plane?]) Material?])]{
Its parts.}

@defproc[(Disk [point Float3?] [normal Float3?] [radius (>/c 0)]
               [#:material material (or/c Material? Float3?) (Float3 0.5 0.5 0.5)]) Disk?]{
A flat disk around @racket[point], seen from both sides, with a normal as that of @racket[Plane].
Texture coordinates: u around the normal, v from the middle out.}

@deftogether[(@defproc[(Disk? [v any/c]) boolean?]
              @defproc[(Disk-point [disk Disk?]) Float3?]
              @defproc[(Disk-normal [disk Disk?]) Float3?]
              @defproc[(Disk-radius [disk Disk?]) flonum?]
              @defproc[(Disk-material [disk Disk?]) Material?])]{
Its parts.}

@defproc[(Quad [corner Float3?] [edge-u Float3?] [edge-v Float3?]
               [#:material material (or/c Material? Float3?) (Float3 0.5 0.5 0.5)]) Quad?]{
A parallelogram, seen from both sides: the points from @racket[corner] along two edges, whose parts
from 0 to 1 are the texture coordinates. Outside is the side from which they turn counter-clockwise.
Edges that span no area raise.}

@deftogether[(@defproc[(Quad? [v any/c]) boolean?]
              @defproc[(Quad-corner [quad Quad?]) Float3?]
              @defproc[(Quad-edge-u [quad Quad?]) Float3?]
              @defproc[(Quad-edge-v [quad Quad?]) Float3?]
              @defproc[(Quad-material [quad Quad?]) Material?])]{
Its parts.}

@defproc[(Triangle [a Float3?] [b Float3?] [c Float3?]
                   [#:material material (or/c Material? Float3?) (Float3 0.5 0.5 0.5)]) Triangle?]{
A triangle of three corners, counter-clockwise as seen from outside. Texture coordinates are the
weights of @racket[b] and @racket[c]. One without area is allowed, and no ray hits it. No ray passes
between two triangles that share an edge: Woop, Benthin and Wald, ``Watertight Ray/Triangle
Intersection'', JCGT, 2013.}

@deftogether[(@defproc[(Triangle? [v any/c]) boolean?]
              @defproc[(Triangle-a [triangle Triangle?]) Float3?]
              @defproc[(Triangle-b [triangle Triangle?]) Float3?]
              @defproc[(Triangle-c [triangle Triangle?]) Float3?]
              @defproc[(Triangle-material [triangle Triangle?]) Material?])]{
Its parts.}

@defproc[(Box [low Float3?] [high Float3?]
              [#:material material (or/c Material? Float3?) (Float3 0.5 0.5 0.5)]) Box?]{
A closed box along the axes, between its corners of least and of largest coordinates; all three of
@racket[high] have to be greater. Texture coordinates go from 0 to 1 on each face, u to the right and
v up as seen from outside.}

@deftogether[(@defproc[(Box? [v any/c]) boolean?]
              @defproc[(Box-low [box Box?]) Float3?]
              @defproc[(Box-high [box Box?]) Float3?]
              @defproc[(Box-material [box Box?]) Material?])]{
Its parts.}

@defproc[(Cylinder [base Float3?] [top Float3?] [radius (>/c 0)]
                   [#:material material (or/c Material? Float3?) (Float3 0.5 0.5 0.5)]
                   [#:caps? caps? boolean? #t]) Cylinder?]{
A cylinder between the middles of its two ends, which must differ. Without caps it is a tube that is
seen from both sides. Texture coordinates: u around the axis, v from base to top, on the caps from
the middle out.}

@deftogether[(@defproc[(Cylinder? [v any/c]) boolean?]
              @defproc[(Cylinder-base [cylinder Cylinder?]) Float3?]
              @defproc[(Cylinder-top [cylinder Cylinder?]) Float3?]
              @defproc[(Cylinder-radius [cylinder Cylinder?]) flonum?]
              @defproc[(Cylinder-material [cylinder Cylinder?]) Material?]
              @defproc[(Cylinder-caps? [cylinder Cylinder?]) boolean?])]{
Its parts.}

@defproc[(Cone [base Float3?] [radius (>/c 0)] [apex Float3?]
               [#:material material (or/c Material? Float3?) (Float3 0.5 0.5 0.5)]
               [#:caps? caps? boolean? #t]) Cone?]{
A right circular cone: the middle and the radius of its base, and its tip, which must differ from
that middle. Without caps the base is open. Texture coordinates are as those of @racket[Cylinder], v
from base to tip.}

@deftogether[(@defproc[(Cone? [v any/c]) boolean?]
              @defproc[(Cone-base [cone Cone?]) Float3?]
              @defproc[(Cone-radius [cone Cone?]) flonum?]
              @defproc[(Cone-apex [cone Cone?]) Float3?]
              @defproc[(Cone-material [cone Cone?]) Material?]
              @defproc[(Cone-caps? [cone Cone?]) boolean?])]{
Its parts.}

@defproc[(Torus [center Float3?] [axis Float3?] [major-radius (>/c 0)]
                [minor-radius (and/c (>/c 0) (</c major-radius))]
                [#:material material (or/c Material? Float3?) (Float3 0.5 0.5 0.5)]) Torus?]{
A ring about an axis of any length but zero: the radius of the circle in its middle, and that of its
cross section. Texture coordinates: u around the axis, v around the cross section, 1/2 on the outer
equator.}

@deftogether[(@defproc[(Torus? [v any/c]) boolean?]
              @defproc[(Torus-center [torus Torus?]) Float3?]
              @defproc[(Torus-axis [torus Torus?]) Float3?]
              @defproc[(Torus-major-radius [torus Torus?]) flonum?]
              @defproc[(Torus-minor-radius [torus Torus?]) flonum?]
              @defproc[(Torus-material [torus Torus?]) Material?])]{
Its parts.}

@racketblock[
(define blue (Lambertian (Float3 0.2 0.4 0.8)))
(define shapes
  (list (Plane (Float3 0 0 0) (Float3 0 1 0) (Lambertian (Float3 0.5 0.5 0.5)))
        (Sphere (Float3 -4 1 0) 1 blue)
        (Box (Float3 -2.5 0 -1) (Float3 -1 2 1) #:material blue)
        (Cylinder (Float3 0 0 0) (Float3 0 2 0) 0.7 blue #:caps? #f)
        (Cone (Float3 2 0 0) 0.8 (Float3 2 2 0) blue)
        (Torus (Float3 4 0.3 0) (Float3 0 1 0) 0.8 0.3 blue)
        (Disk (Float3 0 4 -2) (Float3 0 -1 1) 1 (Emitter (Float3 4 4 4)))))
(render (World shapes '() (Float3 0.5 0.6 0.8))
        (Camera-look-at (Float3 0 3 12) (Float3 0 1 0)) #:width 32 #:height 18 #:samples 4)
]

@section[#:tag "reference-shapes-meshes"]{Meshes}

@defproc[(Mesh [positions flvector?] [triangles fxvector?]
               [#:normals normals (or/c #f flvector?) #f]
               [#:uvs uvs (or/c #f flvector?) #f]
               [#:material material (or/c Material? Float3?) (Float3 0.5 0.5 0.5)]) Mesh?]{
Triangles over shared vertices: three coordinates a vertex, and three numbers of vertices, from 0, a
triangle, counter-clockwise as seen from outside. With @racket[normals], three numbers a vertex and
of any length, shading is smooth; with @racket[uvs], two numbers a vertex, these are the texture
coordinates, else the weights of the second and third corner. The vectors are not copied and must not
change. Triangles without area are never hit. Lengths that do not fit, numbers that are not finite
and vertices that do not exist raise.}

@deftogether[(@defproc[(Mesh? [v any/c]) boolean?]
              @defproc[(Mesh-positions [mesh Mesh?]) flvector?]
              @defproc[(Mesh-triangles [mesh Mesh?]) fxvector?]
              @defproc[(Mesh-normals [mesh Mesh?]) (or/c #f flvector?)]
              @defproc[(Mesh-uvs [mesh Mesh?]) (or/c #f flvector?)]
              @defproc[(Mesh-material [mesh Mesh?]) Material?]
              @defproc[(Mesh-triangle-count [mesh Mesh?]) exact-nonnegative-integer?])]{
Its parts, and how many triangles there are. A mesh of more than 100 triangles prints short.}

@defproc[(Mesh-read [path path-string?]
                    [#:material material (or/c #f Material? Float3?) #f]
                    [#:smooth? smooth? boolean? #f]
                    [#:progress progress (or/c #f (-> real? any)) #f]
                    [#:warn warn (-> string? any) void]) (or/c Mesh? Group?)]{
The shape in a file whose name ends in @filepath{.obj}, @filepath{.ply} or @filepath{.stl}: a mesh, or
a group of one mesh a material. @racket[material] replaces all of the file's own; without it, the
diffuse colour Kd of a material, cut to 0 to 1, becomes a @racket[Lambertian], grey where there is
none. A file without normals is flat unless @racket[smooth?]. @racket[progress] is called now and
then with the part that is read, from 0 to 1, and @racket[warn] with one line a warning. A file that
cannot be read raises @racket[exn:fail:user] with one line that names it and what is wrong where.}

@defproc[(teapot [#:tolerance tolerance (>/c 0) 0.005]
                 [#:material material (or/c Material? Float3?) (Float3 0.5 0.5 0.5)]) Mesh?]{
The Utah teapot: it stands on y = 0 around the y axis, 3.15 high, its handle towards −x and its spout
towards +x, with smooth normals and texture coordinates. No point of it is farther than
@racket[tolerance] world units from the patches it is made of.}

@racketblock[
(require racket/flonum racket/fixnum)
(define tent
  (Mesh (flvector 0.0 0.0 0.0  1.0 0.0 0.0  0.5 1.0 0.5  0.5 0.0 1.0)
        (fxvector 0 2 1  1 2 3  3 2 0)
        #:material (Float3 0.9 0.6 0.2)))
(Mesh-triangle-count tent)                       (code:comment "3")
(Mesh-triangle-count (teapot #:tolerance 0.1))
]

@section[#:tag "reference-shapes-composite"]{Shapes made of shapes}

These nest at most seven levels deep; deeper ones raise. A solid of solids is one level. See
@secref["reference-transforms"] for transforms.

@defproc[(Group [shapes (listof Shape?)]) Group?]{
Many shapes as one, each with its own material, for instances to share. Where several are equally
near, the first of the list is seen.}

@deftogether[(@defproc[(Group? [v any/c]) boolean?]
              @defproc[(Group-shapes [group Group?]) (listof Shape?)])]{
Its shapes.}

@defproc[(Instance [shape Shape?] [transform Transform?]
                   [#:material material (or/c #f Material? Float3?) #f]) Instance?]{
A shape in another place, size or attitude. The shape itself is shared, not copied. @racket[material]
takes the place of all its materials.}

@deftogether[(@defproc[(Instance? [v any/c]) boolean?]
              @defproc[(Instance-shape [instance Instance?]) Shape?]
              @defproc[(Instance-transform [instance Instance?]) Transform?]
              @defproc[(Instance-material [instance Instance?]) (or/c #f Material?)])]{
Its parts.}

@defproc[(Moving [shape Shape?] [from Transform?] [to Transform?]) Moving?]{
A shape on its way from one place, at time 0, to another, at time 1: every point along a straight
line, at even speed. @racket[Camera-with] says in which part of that time the shutter is open. Raises
where the shape would be flat on its way, as one that turns by half a circle. If it shines, only
scattered rays find it.}

@deftogether[(@defproc[(Moving? [v any/c]) boolean?]
              @defproc[(Moving-shape [moving Moving?]) Shape?]
              @defproc[(Moving-from [moving Moving?]) Transform?]
              @defproc[(Moving-to [moving Moving?]) Transform?])]{
Its parts.}

@deftogether[(@defproc[(SolidUnion [a Shape?] [b Shape?]
                                   [#:material material (or/c #f Material? Float3?) #f]) SolidUnion?]
              @defproc[(SolidIntersection [a Shape?] [b Shape?]
                                          [#:material material (or/c #f Material? Float3?) #f])
                       SolidIntersection?]
              @defproc[(SolidDifference [a Shape?] [b Shape?]
                                        [#:material material (or/c #f Material? Float3?) #f])
                       SolidDifference?])]{
What is in @racket[a] or in @racket[b]; in both; and in @racket[a] but not in @racket[b]. Each part
of the surface has the material of the shape it comes from, unless @racket[material] replaces them.
Both have to be closed: planes, disks, quads, triangles, and cylinders and cones without caps raise,
alone or inside of others; other shapes are taken as closed. The shapes of a group must not overlap.
A tree of solids has at most 48 shapes. A part that shines is found by scattered rays alone. The
method is that of Roth, ``Ray Casting for Modeling Solids'', 1982.}

@deftogether[(@defproc[(SolidUnion? [v any/c]) boolean?]
              @defproc[(SolidIntersection? [v any/c]) boolean?]
              @defproc[(SolidDifference? [v any/c]) boolean?]
              @defproc[(Solid? [v any/c]) boolean?]
              @defproc[(Solid-a [solid Solid?]) Shape?]
              @defproc[(Solid-b [solid Solid?]) Shape?]
              @defproc[(Solid-material [solid Solid?]) (or/c #f Material?)])]{
Which of them a value is, whether it is any of them, and the parts of one.}

@racketblock[
(define ball (Sphere (Float3 0 0 0) 1 (Lambertian (Float3 0.8 0.2 0.1))))
(define drill (Cylinder (Float3 0 0 -2) (Float3 0 0 2) 1/2))
(define bead (SolidDifference ball drill #:material (Plastic (Float3 0.1 0.5 0.3))))
(define necklace
  (Group (for/list ([k 12])
           (Instance bead (Transform-compose (Transform-rotate (Float3 0 1 0) (* k (/ pi 6)))
                                             (Transform-translate 5 0 0))))))
(define swinging (Moving necklace (Transform-identity) (Transform-translate 1/2 0 0)))
(Intersection-t (Shape-intersect bead (Ray (Float3 0.7 0 5) (Float3 0 0 -1))))
(Shape-material swinging)
]

@section[#:tag "reference-shapes-functions"]{Shapes by functions}

@defproc[(DistanceShape [distance (-> flonum? flonum? flonum? flonum?)] [low Float3?] [high Float3?]
                        [#:material material (or/c Material? Float3?) (Float3 0.5 0.5 0.5)]
                        [#:error error (or/c #f (>/c 0)) #f]
                        [#:lipschitz lipschitz (>/c 0) 1.0]) DistanceShape?]{
The surface where a function of x, y and z is zero. It returns a flonum: how far that surface is, or
less, negative inside. Where it changes by more than 1 a unit, @racket[lipschitz] has to say by how
much at most, or rays pass through. Rays look for the surface only in the box between @racket[low]
and @racket[high], of which all coordinates have to be greater. A ray hits, from either side, where
the distance over @racket[lipschitz] is below @racket[error], in world units; @racket[#f] means a
millionth of the box's diagonal, or 64 roundings of its largest coordinate where that is more; less
than those raises. A ray ends without a hit at NaN and after 4096 steps. Texture coordinates are
those of a sphere with the same normal. After Hart, ``Sphere Tracing: A Geometric Method for the
Antialiased Ray Tracing of Implicit Surfaces'', 1996.}

@deftogether[(@defproc[(DistanceShape? [v any/c]) boolean?]
              @defproc[(DistanceShape-distance [shape DistanceShape?]) procedure?]
              @defproc[(DistanceShape-low [shape DistanceShape?]) Float3?]
              @defproc[(DistanceShape-high [shape DistanceShape?]) Float3?]
              @defproc[(DistanceShape-error [shape DistanceShape?]) flonum?]
              @defproc[(DistanceShape-lipschitz [shape DistanceShape?]) flonum?]
              @defproc[(DistanceShape-material [shape DistanceShape?]) Material?])]{
Its parts.}

@defproc[(CustomShape [low Float3?] [high Float3?]
                      [intersect (-> Float3? Float3? flonum? (or/c #f (list/c flonum? Float3?)))]
                      [#:material material (or/c Material? Float3?) (Float3 0.5 0.5 0.5)]
                      [#:error error (>=/c 0) 0.0]
                      [#:uv uv (or/c #f (-> Float3? Float3? (values flonum? flonum?))) #f])
         CustomShape?]{
A shape by a procedure, anywhere a shape can be. No hit may lie outside the box, whose coordinates may
be infinite; none of @racket[high] may be less than that of @racket[low]. @racket[intersect] is given
the origin of a ray, its direction, of any length, and the largest parameter wanted, perhaps
infinite. It returns @racket[#f], or a list of the least positive parameter below that at which the
ray is on the shape and the unit normal there, outward whichever side the ray comes from. It has to
be a pure function: it runs in any order and more than once a ray. Other parameters and NaN are no
hit. @racket[error] is how far the point of a hit may be from the surface, in world units, beyond 32
roundings. @racket[uv] takes a point and its normal to texture coordinates; @racket[#f] means those
of a sphere with the same normal. Procedures that return something else raise when a ray calls them.}

@deftogether[(@defproc[(CustomShape? [v any/c]) boolean?]
              @defproc[(CustomShape-low [shape CustomShape?]) Float3?]
              @defproc[(CustomShape-high [shape CustomShape?]) Float3?]
              @defproc[(CustomShape-intersect [shape CustomShape?]) procedure?]
              @defproc[(CustomShape-error [shape CustomShape?]) flonum?]
              @defproc[(CustomShape-uv [shape CustomShape?]) (or/c #f procedure?)]
              @defproc[(CustomShape-material [shape CustomShape?]) Material?])]{
Its parts.}

@racketblock[
(define (egg-distance x y z)
  (- (sqrt (+ (* x x) (* 0.5 y y) (* z z))) 1.0))
(define egg
  (DistanceShape egg-distance (Float3 -1.1 -1.5 -1.1) (Float3 1.1 1.5 1.1)
                 (Lambertian (Float3 0.9 0.8 0.6))))
(define (floor-hit origin direction t-max)
  (define slope (Float3-y direction))
  (define t (if (= slope 0.0) -1.0 (/ (- (Float3-y origin)) slope)))
  (and (< 0.0 t t-max) (list t (Float3 0 1 0))))
(define ground
  (CustomShape (Float3 -inf.0 0 -inf.0) (Float3 +inf.0 0 +inf.0) floor-hit))
(define ray (Ray (Float3 0 5 0.2) (Float3 0 -1 0)))
(Intersection-t (Shape-intersect egg ray))
(Intersection-t (Shape-intersect ground ray))      (code:comment "5.0")
]
