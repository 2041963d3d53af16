#lang racket/base
;; The public surface of raytrace.
(require racket/require "private/surface.rkt"
         (subtract-in
          (combine-in
           "private/base/float3.rkt"
           "private/shape/shape.rkt" "private/shape/kernels.rkt" "private/shape/sphere.rkt"
           "private/shape/plane.rkt" "private/shape/disk.rkt" "private/shape/quad.rkt"
           "private/shape/triangle.rkt" "private/shape/box.rkt" "private/shape/cylinder.rkt"
           "private/shape/cone.rkt" "private/shape/torus.rkt"
           "private/base/transform.rkt" "private/shape/mesh.rkt" "private/shape/mesh-file.rkt"
           "private/shape/teapot.rkt" "private/shape/group.rkt" "private/shape/instance.rkt"
           "private/shape/moving.rkt" "private/shape/solid.rkt" "private/shape/distance.rkt"
           "private/shape/custom.rkt"
           "private/material/material.rkt" "private/material/phong.rkt"
           "private/material/emitter.rkt" "private/material/lambertian.rkt"
           "private/material/mirror.rkt" "private/material/metal.rkt"
           "private/material/dielectric.rkt" "private/material/plastic.rkt"
           "private/material/modified-phong.rkt" "private/material/mix.rkt"
           "private/material/bumped.rkt"
           "private/material/rough-conductor.rkt" "private/material/rough-dielectric.rkt"
           "private/material/interior.rkt" "private/medium/medium.rkt"
           "private/material/texture/texture.rkt" "private/material/texture/checker.rkt"
           "private/material/texture/image.rkt" "private/material/texture/noise.rkt"
           "private/material/texture/noises.rkt" "private/material/texture/gradient.rkt"
           "private/material/texture/uv.rkt" "private/material/texture/function.rkt"
           "private/light/light.rkt" "private/light/distant.rkt" "private/light/point.rkt"
           "private/light/spot.rkt" "private/light/environment.rkt"
           "private/light/sun-and-sky.rkt"
           "private/world/ray.rkt" "private/world/camera.rkt" "private/world/camera-kernel.rkt"
           "private/world/projection.rkt" "private/world/background.rkt"
           "private/world/world.rkt" "private/integrate/query.rkt"
           "private/sample/sampler.rkt" "private/render/render.rkt" "private/image/image.rkt"
           "private/image/error.rkt" "private/image/write.rkt" "private/raster/view.rkt"
           "private/raster/raster.rkt" "private/world/update.rkt" "private/explore.rkt")
          "private/surface.rkt"))

(provide
 ;; vectors and colours
 Float3 Float3? (rename-out [Float3-x/function Float3-x] [Float3-y/function Float3-y]
                            [Float3-z/function Float3-z]
                            [Float3-add/function Float3-add]
                            [Float3-subtract/function Float3-subtract]
                            [Float3-negate/function Float3-negate]
                            [Float3-scale-by-scalar/function Float3-scale-by-scalar]
                            [Float3-scale-by-vector/function Float3-scale-by-vector]
                            [Float3-dot/function Float3-dot]
                            [Float3-cross/function Float3-cross]
                            [Float3-length/function Float3-length]
                            [Float3-length-squared/function Float3-length-squared]
                            [Float3-distance/function Float3-distance]
                            [Float3-normalized/checked Float3-normalized]
                            [Float3-reflect/function Float3-reflect]
                            [Float3-clamped/function Float3-clamped]
                            [Float3-linear-interpolate/function Float3-linear-interpolate])
 Float3-random-hemisphere-direction Float3-random-point-in-sphere Float3-random-color
 ;; rays and what they hit
 Ray Ray? Ray-point Ray-direction Ray-time Ray-point-at
 Intersection Intersection? Intersection-t Intersection-point Intersection-normal
 Intersection-color Intersection-empty INTERSECTION-T-MAX EPSILON
 ;; cameras
 Camera Camera? Camera-eye Camera-forward Camera-right Camera-up Camera-lens-radius
 Camera-focus-distance Camera-look-at Camera-orthographic Camera-panoramic Camera-fisheye
 Camera-with Camera-moving Camera-blades Camera-projection Camera-shutter-open
 Camera-shutter-close Camera-global-up Camera-get-ray-direction Camera-ray
 ;; shapes
 Shape? Shape-intersect Sphere Sphere? Sphere-point Sphere-radius Sphere-material
 Sphere-color Sphere-intersect Shape-material
 Plane Plane? Plane-point Plane-normal Plane-material
 Disk Disk? Disk-point Disk-normal Disk-radius Disk-material
 Quad Quad? Quad-corner Quad-edge-u Quad-edge-v Quad-material
 Triangle Triangle? Triangle-a Triangle-b Triangle-c Triangle-material
 Box Box? Box-low Box-high Box-material
 Cylinder Cylinder? Cylinder-base Cylinder-top Cylinder-radius Cylinder-material Cylinder-caps?
 Cone Cone? Cone-base Cone-radius Cone-apex Cone-material Cone-caps?
 Torus Torus? Torus-center Torus-axis Torus-major-radius Torus-minor-radius Torus-material
 Mesh Mesh? Mesh-positions Mesh-triangles Mesh-normals Mesh-uvs Mesh-material
 Mesh-triangle-count Mesh-read teapot
 ;; shapes made of shapes
 Group Group? Group-shapes
 Instance Instance? Instance-shape Instance-transform Instance-material
 Moving Moving? Moving-shape Moving-from Moving-to
 SolidUnion SolidUnion? SolidIntersection SolidIntersection? SolidDifference SolidDifference?
 Solid? Solid-a Solid-b Solid-material
 Transform? Transform-matrix-rows Transform-identity Transform-translate Transform-scale
 Transform-rotate Transform-shear Transform-look-at Transform-compose Transform-inverse
 Transform-point Transform-vector Transform-normal (rename-out [make-Transform Transform])
 ;; shapes by a user's functions
 DistanceShape DistanceShape? DistanceShape-distance DistanceShape-low DistanceShape-high
 DistanceShape-error DistanceShape-lipschitz DistanceShape-material
 CustomShape CustomShape? CustomShape-low CustomShape-high CustomShape-intersect
 CustomShape-error CustomShape-uv CustomShape-material
 ;; materials
 Material? Phong Phong? Phong-color Phong-specularity Phong-shininess Phong-reflectivity
 WORLD-SHAPE-SPECULARITY WORLD-SHAPE-SHININESS Emitter Emitter? Emitter-radiance
 Emitter-two-sided? Emitter-surface Lambertian Lambertian? Lambertian-albedo Mirror Mirror?
 Mirror-color
 Metal Metal? Metal-albedo Metal-fuzz
 Dielectric Dielectric? Dielectric-ior Dielectric-fresnel Dielectric-absorption
 Dielectric-outside-ior Plastic Plastic? Plastic-albedo Plastic-ior
 ModifiedPhong ModifiedPhong? ModifiedPhong-albedo ModifiedPhong-specular
 ModifiedPhong-shininess Mix Mix? Mix-first Mix-second Mix-weight
 Bumped Bumped? Bumped-material Bumped-texture Bumped-height
 RoughConductor RoughConductor? RoughConductor-roughness RoughConductor-color RoughConductor-eta
 RoughConductor-k gold copper silver aluminium
 RoughDielectric RoughDielectric? RoughDielectric-ior RoughDielectric-roughness
 RoughDielectric-absorption RoughDielectric-outside-ior
 Medium Medium? Medium-extinction Medium-albedo Medium-anisotropy Medium-density Medium-majorant
 Interior Interior? Interior-medium Interior-surface
 ;; textures
 Texture? Checker Checker? Checker-even Checker-odd Checker-size
 CheckerUV CheckerUV? CheckerUV-even CheckerUV-odd CheckerUV-columns CheckerUV-rows
 ImageTexture ImageTexture? ImageTexture-image ImageTexture-filter ImageTexture-wrap
 Noise Noise? Noise-first Noise-second Noise-scale Noise-octaves Noise-seed
 Turbulence Turbulence? Turbulence-first Turbulence-second Turbulence-scale Turbulence-octaves
 Turbulence-seed
 Marble Marble? Marble-first Marble-second Marble-scale Marble-bands Marble-disorder
 Marble-octaves Marble-seed
 GradientTexture GradientTexture? GradientTexture-first GradientTexture-second
 GradientTexture-start GradientTexture-end UVTexture UVTexture?
 FunctionTexture FunctionTexture? FunctionTexture-function perlin-noise perlin-turbulence
 ;; lights and what lies behind everything
 Light? DistantLight DistantLight? DistantLight-direction DistantLight-color
 PointLight PointLight? PointLight-point PointLight-intensity
 SpotLight SpotLight? SpotLight-point SpotLight-direction SpotLight-intensity
 SpotLight-cone-angle SpotLight-falloff-angle
 GradientSky GradientSky? GradientSky-bottom GradientSky-top
 daylight-sky daylight-sun EnvironmentMap EnvironmentMap? EnvironmentMap-image EnvironmentMap-rotation EnvironmentMap-scale
 Projection? Projection-perspective Projection-orthographic Projection-point Projection-unproject
 Projection-matrix-rows Projection-clip-planes Projection-frustum-corners
 Camera-project Camera-unproject Camera-view Camera-frustum Transform-viewport
 ;; worlds
 World World? World-shapes World-spheres World-lights World-sun World-background
 World-background-color World-medium World-nearest-hit World-occluded? World-ray-trace World-get-color-at
 World-get-ambient-percent WORLD-AMBIENT-SAMPLES WORLD-MAX-OCCLUSION-DISTANCE
 ;; pictures
 render preview sample-point Image? Image-width Image-height Image-pixels Image-pixel Image-write
 Image-read Image-standard-error Image-relative-error Image-relative-error-uncertainty
 Image-crop Image-scale Image-exposed Image-tone Image-false-color Image-error-map
 Images-side-by-side Image-difference Image-compare Comparison? Comparison-rmse Comparison-rmse1
 Comparison-relative-mse Comparison-bias Comparison-psnr Comparison-worst-x Comparison-worst-y
 Comparison-worst-difference Image->flomap flomap->Image Image->bitmap Image->pict show
 ;; a world in a window
 view
 ;; worlds and cameras that differ a little
 World-add World-with-shapes World-with-lights World-with-background
 Camera-orbit Camera-dolly Camera-pan
 ;; why a pixel looks as it does
 explain Explanation? Explanation-color Explanation-standard-error Explanation-rays
 Explanation-sources Explanation-depths Explanation-paths
 ;; what is probably wrong with a world
 World-problems)
