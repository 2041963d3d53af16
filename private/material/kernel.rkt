#lang typed/racket/base
;; What the path integrator needs of a material: three kernels over a worker's scratch.
(provide (struct-out MaterialKernel))

;; All read the surface in the scratch: out-direction, the unit direction back to where the ray
;; came from; surface-normal and surface-shading-normal, turned to that side; surface-inside, 1
;; where that side is the inside of the shape.
;; sample: draws its own pairs (sample-next-pair!), writes in-direction (unit), bsdf-weight (value
;; times cosine over density, linear RGB) and bsdf-density (per solid angle; infinite for a
;; direction that has no neighbours, as from a mirror); weight 0 where the light is absorbed.
;; evaluate: for the in-direction given, value times cosine into bsdf-weight and the density with
;; which sample would choose it into bsdf-density; 0 for both where sample has no density.
;; specular?: whether every sample has infinite density, so that lights need not be sampled.
;; transmits?: whether light may pass to the other side.
;; prepare: #f, or what has to be done once at a surface before sample and evaluate: it reads
;; texture-point and surface-uv, and leaves in surface-color what a texture shows there.
(struct MaterialKernel
  ([sample : (-> FlVector FxVector Void)]
   [evaluate : (-> FlVector FxVector Void)]
   [specular? : Boolean]
   [transmits? : Boolean]
   [prepare : (U #f (-> FlVector FxVector Void))]))
