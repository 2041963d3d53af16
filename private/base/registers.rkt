#lang typed/racket/base
;; The named places of a worker's scratch. A ray, its hit and everything found on the way travel
;; between kernels in one flvector and one fxvector, so nothing is boxed at a call.
(require (for-syntax racket/base) "unsafe.rkt")

(provide make-flonum-registers make-fixnum-registers STACK-SIZE NEST-LIMIT)

;; (define-register-file provided-count [name width] ...) names consecutive places by literals,
;; which Typed Racket and the compiler both see as constants.
(define-syntax (define-register-file stx)
  (syntax-case stx ()
    [(_ count [name width] ...)
     (let* ([widths (map syntax-e (syntax->list #'(width ...)))]
            [starts (let loop ([widths widths] [at 0])
                      (if (null? widths) '() (cons at (loop (cdr widths) (+ at (car widths))))))])
       (with-syntax ([(start ...) starts] [total (apply + widths)])
         #'(begin
             (define-syntax (name use)
               (if (identifier? use) #'start (raise-syntax-error #f "is a place, not a function" use)))
             ...
             (define-syntax (count use) #'total)
             (provide name ...))))]))

;; How deep instances may nest, and places for the traversal stacks of all levels together.
(define-syntax (NEST-LIMIT stx) #'8)
(define-syntax (STACK-SIZE stx) #'1024)

(define-register-file flonum-count
  ;; the ray: origin, direction of any length, its reciprocal (written where a hierarchy is
  ;; entered), the parameter the ray ends at, the time in the shutter
  [ray-origin 3] [ray-direction 3] [ray-inverse 3] [ray-limit 1] [ray-time 1]
  ;; the nearest hit: parameter along the ray, and two surface parameters the shape chooses
  [hit-t 1] [hit-u 1] [hit-v 1]
  ;; its surface: point, outward unit geometric normal, shading normal, texture coordinates, and
  ;; a bound on the absolute error of the point
  [surface-point 3] [surface-normal 3] [surface-shading-normal 3] [surface-uv 2] [surface-error 1]
  ;; what textures are asked with and what they leave: the point in the space the shape was made
  ;; in; the colour there, a scalar that comes with it, and the weights of a mixture's parts
  [texture-point 3] [surface-color 3] [surface-roughness 1] [mix-weights 8]
  ;; scattering: direction back along the ray, direction onward, weight or value, its density
  [out-direction 3] [in-direction 3] [bsdf-weight 3] [bsdf-density 1]
  ;; light sampling: direction, distance, radiance over density, density per solid angle
  [light-direction 3] [light-distance 1] [light-radiance 3] [light-density 1]
  ;; the path so far
  [throughput 3] [radiance 3] [ambient-percent 1] [previous-density 1] [relative-index 1]
  ;; participating media: the way since the last vertex through boundaries that are not seen; the
  ;; sums of extinction and scattering where the ray is; the densities of the media there; what is
  ;; left of a shadow ray's light
  [travelled 1] [extinction 3] [scattering 3] [medium-densities 8] [transmittance 3]
  ;; the segment of the ray that a medium is sampled along: origin, unit direction, length; the
  ;; density with which the distance was chosen, and the distance; another way's density over it
  [segment-origin 3] [segment-direction 3] [segment-length 1] [segment-density 1] [segment-t 1]
  [distance-ratio 1]
  ;; the last vertex while boundaries are crossed; the places from ray-origin to surface-error while
  ;; shadow rays and lit points of a segment are looked at; the segment then, and the one before
  ;; the last vertex; the origin and time of known-media
  [kept-vertex 7] [kept-for-shadow 26] [kept-light-limit 1]
  [kept-for-segment 26] [kept-segment 9] [last-segment 9] [known-origin 4]
  ;; the numbers the sampler delivers, and the pixel position of this sample
  [sample-u 1] [sample-v 1] [film-x 1] [film-y 1]
  ;; an orthonormal frame, and room a kernel may use between two calls
  [frame-tangent 3] [frame-bitangent 3] [workspace 24]
  ;; for every gathered primitive the least and the greatest cosine to the normal at which it can be hit
  [gathered-bands 32]
  ;; rays kept while an instance is entered: 9 places a level
  [saved-rays 72]
  ;; flonums that have to survive calls: whoever owns places of the stack owns the same ones here
  [flonum-stack 1024])

(define-register-file fixnum-count
  ;; the nearest hit: index of the primitive in the world (-1 for none), its material, and the
  ;; path through meshes, groups and instances below it
  [hit-primitive 1] [hit-material 1] [hit-path 8]
  ;; 1 where the surface was met from inside: its normals were turned to the side of the ray
  [surface-inside 1]
  ;; a primitive that any-hit passes over (the light a shadow ray is aimed at), or -1
  [ignored-primitive 1]
  ;; 1 where a hit at exactly ray-limit should replace the known one, else 0
  [accept-ties 1]
  ;; nesting: level of instances entered, first free place of the traversal stack
  [nest-level 1] [stack-base 1]
  ;; the media around the ray: how many, and their numbers; the same for a shadow ray, and where the
  ;; camera's rays start (-1 while unknown); the places from hit-primitive to
  ;; surface-inside while other rays are traced
  [media-count 1] [media 8] [shadow-media-count 1] [shadow-media 8]
  [known-media-count 1] [known-media 8] [kept-hit-for-shadow 11] [kept-hit-for-segment 11]
  ;; 1 while surfaces are met that the path does not come to: by shadow rays, and to know the media
  [looking 1]
  ;; the sampler: its number and the size of its grid; hash of (pixel, seed), sample index, next
  ;; dimension; a fold over many samples
  [sampler-kind 1] [sampler-count 1] [sampler-key 1] [sampler-index 1] [sampler-dimension 1]
  [fold-start 1] [fold-count 1] [fold-seed-u 1] [fold-seed-v 1]
  ;; what was counted: rays asked for their nearest hit, occlusion rays, rejected samples; and of
  ;; these the first pixel's number plus 1 (0 for none) and its first sample
  [nearest-rays 1] [occlusion-rays 1] [rejected-samples 1] [rejected-pixel 1] [rejected-sample 1]
  ;; places of primitives gathered around a point, and how many; -1 when there were too many
  [gathered-count 1] [gathered 32]
  ;; the path: bounces so far
  [path-depth 1] [fixnum-workspace 8]
  [stack 1024])

;; A worker's scratch: nothing in it outlives the pixel it is used for but the counters.
(: make-flonum-registers (-> FlVector))
(define (make-flonum-registers) (make-flvector flonum-count 0.0))
(: make-fixnum-registers (-> FxVector))
(define (make-fixnum-registers)
  (define registers (make-fxvector fixnum-count 0))
  (fxvector-set! registers hit-primitive -1)
  (fxvector-set! registers ignored-primitive -1)
  (fxvector-set! registers known-media-count -1)
  registers)
