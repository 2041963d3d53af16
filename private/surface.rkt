#lang racket/base
;; The public names that are constructor, match pattern and type at once, for typed and untyped
;; code (see base/public.rkt).
(require "base/public.rkt" "checked.rkt"
         (prefix-in struct: (combine-in (except-in "base/float3.rkt" Float3)
                                        (only-in "base/fuse.rkt" Float3)
                                        "material/phong.rkt" "material/emitter.rkt"
                                        "material/lambertian.rkt" "material/mirror.rkt"
                                        "material/metal.rkt" "material/dielectric.rkt"
                                        "material/plastic.rkt" "material/modified-phong.rkt"
                                        "material/mix.rkt" "material/bumped.rkt"
                                        "material/rough-conductor.rkt"
                                        "material/rough-dielectric.rkt" "material/interior.rkt"
                                        "medium/medium.rkt"
                                        "material/texture/checker.rkt"
                                        "material/texture/image.rkt"
                                        "material/texture/noises.rkt"
                                        "material/texture/gradient.rkt"
                                        "material/texture/uv.rkt"
                                        "material/texture/function.rkt"
                                        "shape/sphere.rkt" "shape/plane.rkt" "shape/disk.rkt"
                                        "shape/quad.rkt" "shape/triangle.rkt" "shape/box.rkt"
                                        "shape/cylinder.rkt" "shape/cone.rkt" "shape/torus.rkt"
                                        "shape/mesh.rkt" "shape/group.rkt" "shape/instance.rkt"
                                        "shape/moving.rkt" "shape/solid.rkt"
                                        "shape/distance.rkt" "shape/custom.rkt"
                                        "light/environment.rkt" "light/distant.rkt"
                                        "light/point.rkt" "light/spot.rkt"
                                        "world/ray.rkt" "world/camera.rkt"
                                        "world/background.rkt" "world/world.rkt"))
         (for-syntax racket/base))

(define-surface Float3 (x y z) #:numbers)
(define-surface Camera (eye forward right up lens-radius focus-distance)
  #:struct (eye forward right up lens-radius focus-distance _ _ _ _ _ _))
(define-surface Ray (point direction time))
(define-surface Intersection (t point normal color))
(define-surface Sphere (point radius material))
(define-surface Plane (point normal material))
(define-surface Disk (point normal radius material))
(define-surface Quad (corner edge-u edge-v material))
(define-surface Triangle (a b c material))
(define-surface Box (low high material))
(define-surface Cylinder (base top radius material caps?))
(define-surface Cone (base radius apex material caps?))
(define-surface Torus (center axis major-radius minor-radius material))
(define-surface Mesh (positions triangles normals uvs material)
  #:struct (positions triangles normals uvs material _))
(define-surface Group (shapes) #:struct (_ shapes))
(define-surface Instance (shape transform material) #:struct (_ shape transform material))
(define-surface Moving (shape from to) #:struct (_ shape from to))
(define-surface SolidUnion (a b material) #:struct (_ a b material))
(define-surface SolidIntersection (a b material) #:struct (_ a b material))
(define-surface SolidDifference (a b material) #:struct (_ a b material))
(define-surface DistanceShape (distance low high error lipschitz material))
(define-surface CustomShape (low high intersect error uv material))
(define-surface DistantLight (direction color))
(define-surface PointLight (point intensity))
(define-surface SpotLight (point direction intensity cone-angle falloff-angle))
(define-surface Phong (color specularity shininess reflectivity))
(define-surface Emitter (radiance two-sided? surface))
(define-surface Lambertian (albedo))
(define-surface Mirror (color))
(define-surface Metal (albedo fuzz))
(define-surface Dielectric (ior fresnel absorption outside-ior))
(define-surface Plastic (albedo ior))
(define-surface ModifiedPhong (albedo specular shininess))
(define-surface Mix (first second weight))
(define-surface Bumped (material texture height))
(define-surface RoughConductor (roughness color eta k))
(define-surface RoughDielectric (ior roughness absorption outside-ior))
(define-surface Medium (extinction albedo anisotropy density majorant))
(define-surface Interior (medium surface))
(define-surface Checker (even odd size))
(define-surface CheckerUV (even odd columns rows))
(define-surface ImageTexture (image filter wrap))
(define-surface Noise (first second scale octaves seed))
(define-surface Turbulence (first second scale octaves seed))
(define-surface Marble (first second scale bands disorder octaves seed))
(define-surface GradientTexture (first second start end))
(define-surface UVTexture ())
(define-surface FunctionTexture (function))
(define-surface GradientSky (bottom top))
(define-surface EnvironmentMap (image) #:struct (image _ _))
(define-surface World (shapes lights background) #:struct (shapes lights background _ _ _))
