#lang typed/racket/base
;; Shading for previews: what every material looks like under every light, without shadows and without
;; light from other surfaces but as a constant ambient term.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/matrix.rkt"
         "../base/transform.rkt" "../material/material.rkt" "../material/color.rkt" "../material/phong.rkt"
         "../material/emitter.rkt" "../material/lambertian.rkt" "../material/mirror.rkt"
         "../material/metal.rkt" "../material/dielectric.rkt" "../material/plastic.rkt"
         "../material/modified-phong.rkt" "../material/mix.rkt" "../material/rough-conductor.rkt"
         "../material/rough-dielectric.rkt" "../material/bumped.rkt" "../material/texture/texture.rkt"
         "../material/texture/kernels.rkt"
         "../light/light.rkt" "../light/kernels.rkt"
         "../world/world.rkt" "../world/background.rkt" "tessellate.rkt")

(provide make-shader Material-texture Material-clear?)

;; --- what a material looks like, in twenty numbers ---

;; color: of the body, of highlights, of a mirror; the sharpness of highlights; the reflectance of a
;; coat seen along its normal, or -1 for none; light it gives off; whether on both sides; the part
;; that is seen through.
(define-syntax-rule (STRIDE) 20)
(define-syntax-rule (highlight-place) 3)
(define-syntax-rule (shininess-place) 6)
(define-syntax-rule (mirror-place) 7)
(define-syntax-rule (coat-place) 10)
(define-syntax-rule (emission-place) 11)
(define-syntax-rule (two-sided-place) 14)
(define-syntax-rule (clear-place) 15)

(define-syntax-rule (PI) 3.141592653589793)
(define-syntax-rule (INVERSE-PI) 0.3183098861837907)
(define BLACK : Float3 (make-Float3 0 0 0))

(: look (->* () (#:body Float3 #:highlight Float3 #:shininess Flonum #:mirror Float3 #:coat Flonum
                 #:emission Float3 #:two-sided? Boolean #:clear Flonum)
             FlVector))
(define (look #:body [body BLACK] #:highlight [highlight BLACK] #:shininess [shininess 1.0]
              #:mirror [mirror BLACK] #:coat [coat -1.0] #:emission [emission BLACK]
              #:two-sided? [two-sided? #f] #:clear [clear 0.0])
  (define packed (make-flvector (STRIDE) 0.0))
  (Float3-put! packed 0 body)
  (Float3-put! packed (highlight-place) highlight)
  (flvector-set! packed (shininess-place) shininess)
  (Float3-put! packed (mirror-place) mirror)
  (flvector-set! packed (coat-place) coat)
  (Float3-put! packed (emission-place) emission)
  (flvector-set! packed (two-sided-place) (if two-sided? 1.0 0.0))
  (flvector-set! packed (clear-place) clear)
  packed)

;; The texture that drives a material, and the place in its look of the colour that it drives; there
;; stands what the texture's colour is multiplied with.
(: Material-texture (-> Material (Values (U #f Texture) Fixnum)))
(define (Material-texture material)
  (define-values (source place)
    (cond
      [(Phong? material) (values (Phong-color material) 0)]
      [(Lambertian? material) (values (Lambertian-albedo material) 0)]
      [(Plastic? material) (values (Plastic-albedo material) 0)]
      [(Mirror? material) (values (Mirror-color material) (mirror-place))]
      [(Metal? material) (values (Metal-albedo material) (mirror-place))]
      [(Emitter? material) (values (Emitter-radiance material) (emission-place))]
      [(Bumped? material) (Material-texture (Bumped-material material))]
      [else (values #f 0)]))
  (values (and (Texture? source) source) place))

(: factor (-> ColorOrTexture Float3))
(define (factor source) (if (Float3? source) source (make-Float3 1 1 1)))

;; One colour for what shines or reflects: a texture's mean over a grid of texture coordinates.
(: mean-color (-> ColorOrTexture Float3))
(define (mean-color source)
  (cond
    [(Float3? source) source]
    [else
     (define show! (radiance-kernel source))
     (define r (make-flonum-registers))
     (define i (make-fixnum-registers))
     (define sum (make-flvector 3 0.0))
     (let each ([k : Fixnum 0])
       (when (fx< k 64)
         (let ([u (fl/ (fl+ 0.5 (fx->fl (fxand k 7))) 8.0)]
               [v (fl/ (fl+ 0.5 (fx->fl (fxrshift k 3))) 8.0)])
           (flvector-set! r surface-uv u)
           (flvector-set! r (fx+ 1 surface-uv) v)
           (Float3-put! r texture-point (Float3 u v 0.0)))
         (show! r i)
         (Float3-put! sum 0 (Float3-multiply-add (Float3-in sum 0) (fl/ 1.0 64.0)
                                                 (Float3-in r surface-color)))
         (each (fx+ k 1))))
     (Float3-in sum 0)]))

;; The same of what stands for a number.
(: mean-number (-> (U Flonum Texture) Flonum))
(define (mean-number source)
  (if (flonum? source)
      source
      (flmin 1.0 (Float3-dot (mean-color source) (Float3 0.2126 0.7152 0.0722)))))

;; Whether something is seen through a material.
(: Material-clear? (-> Material Boolean))
(define (Material-clear? material)
  (fl> (flvector-ref (Material-look material 1.0) (clear-place)) 0.0))

;; irradiance-share: what a surface of colour 1 sends of the light it gets: 1 in the article's
;; shading, 1/pi where light is traced.
(: Material-look (-> Material Flonum FlVector))
(define (Material-look material share)
  (define-syntax-rule (grey x) (let ([value x]) (Float3 value value value)))
  ;; a lobe of the same energy for any sharpness
  (define (lobe [color : Float3] [shininess : Flonum])
    (Float3-scale-by-scalar color (fl* (fl* 0.5 INVERSE-PI*) (fl+ 2.0 shininess))))
  (define (reflectance [ior : Flonum])
    (let ([root (fl/ (fl- ior 1.0) (fl+ ior 1.0))]) (fl* root root)))
  ;; a metal's mirror image blurs into its highlight and its share of the ambient light
  (define (metal [color : Float3] [roughness : Flonum])
    (define sharp (fl- 1.0 (flmin 1.0 roughness)))
    (define shininess (flmin 1000.0 (fl/ 2.0 (flmax 1e-4 (fl* roughness roughness)))))
    (look #:body (Float3-scale-by-scalar color (fl- 1.0 sharp))
          #:highlight (lobe color shininess) #:shininess shininess
          #:mirror (Float3-scale-by-scalar color sharp)))
  (cond
    [(Phong? material)
     (let-float3 ([mirror (Phong-reflectivity material)]
                  [rest (Float3-subtract (Float3 1.0 1.0 1.0) mirror)])
       (look #:body (Float3-scale-by-vector rest (factor (Phong-color material)))
             #:highlight (Float3-scale-by-scalar rest (fl* share (Phong-specularity material)))
             #:shininess (Phong-shininess material) #:mirror mirror))]
    [(Emitter? material)
     (define surface (Emitter-surface material))
     (define packed (if surface (Material-look surface share) (look)))
     (Float3-put! packed (emission-place) (factor (Emitter-radiance material)))
     (flvector-set! packed (two-sided-place) (if (Emitter-two-sided? material) 1.0 0.0))
     packed]
    [(Lambertian? material) (look #:body (factor (Lambertian-albedo material)))]
    [(Mirror? material) (look #:mirror (factor (Mirror-color material)))]
    [(Metal? material) (metal (factor (Metal-albedo material)) (mean-number (Metal-fuzz material)))]
    [(RoughConductor? material)
     (metal (RoughConductor-reflectance material) (mean-number (RoughConductor-roughness material)))]
    [(Bumped? material) (Material-look (Bumped-material material) share)]
    [(Plastic? material)
     (define f0 (reflectance (Plastic-ior material)))
     (look #:body (factor (Plastic-albedo material)) #:coat f0
           #:highlight (lobe (grey f0) 200.0) #:shininess 200.0)]
    [(ModifiedPhong? material)
     (define shininess (ModifiedPhong-shininess material))
     (look #:body (ModifiedPhong-albedo material)
           #:highlight (lobe (ModifiedPhong-specular material) shininess) #:shininess shininess)]
    [(Dielectric? material) (glass (reflectance (relative-index (Dielectric-ior material)
                                                                (Dielectric-outside-ior material))))]
    [(RoughDielectric? material)
     (glass (reflectance (relative-index (RoughDielectric-ior material)
                                         (RoughDielectric-outside-ior material))))]
    [(Mix? material)
     (define first (Material-look (Mix-first material) share))
     (define second (Material-look (Mix-second material) share))
     (define given-weight (Mix-weight material))
     (define weight (mean-number given-weight))
     (define mixed (make-flvector (STRIDE) 0.0))
     (let each ([k : Fixnum 0])
       (when (fx< k (STRIDE))
         (flvector-set! mixed k (fl+ (fl* (fl- 1.0 weight) (flvector-ref first k))
                                     (fl* weight (flvector-ref second k))))
         (each (fx+ k 1))))
     mixed]
    [else (look #:body (Material-color material))]))

(define INVERSE-PI* : Flonum (INVERSE-PI))

(: relative-index (-> Flonum Flonum Flonum))
(define (relative-index ior outside) (fl/ ior outside))

(: glass (-> Flonum FlVector))
(define (glass f0)
  (define strength (fl* (fl* 0.5 (INVERSE-PI)) (fl* 202.0 f0)))
  (look #:coat f0 #:clear 1.0 #:highlight (make-Float3 strength strength strength)
        #:shininess 200.0))

;; --- lights ---

;; A piece that shines, as seen from afar, in ten numbers: its middle, its area as a vector, its area,
;; its radiance. In a direction w it shows |V.w| or V.w of the area V that lies flat, and a quarter
;; of the rest (Cauchy).
(define-syntax-rule (LIGHT-STRIDE) 11)

(: Piece-light (-> Piece Emitter (U #f FlVector)))
(define (Piece-light piece emitter)
  (define mesh (Piece-mesh piece))
  (define packed (make-flvector (LIGHT-STRIDE) 0.0))
  (and mesh
       (let ([area (put-areas! packed mesh (Piece-transform piece))])
         (and (fl> area 0.0)
              (begin
                (Float3-put! packed 0 (Float3-scale-by-scalar (Float3-in packed 0) (fl/ 1.0 area)))
                (Float3-put! packed 7 (mean-color (Emitter-radiance emitter)))
                (flvector-set! packed 6 area)
                (flvector-set! packed 10 (if (Emitter-two-sided? emitter) 1.0 0.0))
                packed)))))

;; Sums the middles of a mesh's triangles, weighed by their areas, and their vectors of area; the area.
(: put-areas! (-> FlVector Tessellation Transform Flonum))
(define (put-areas! packed mesh transform)
  (define matrix (Transform-matrix transform))
  (define positions (Tessellation-positions mesh))
  (define triangles (Tessellation-triangles mesh))
  (define-syntax-rule (corner k)
    (matrix-point matrix 0 (Float3-in positions (fx* 3 (fxvector-ref triangles k)))))
  (let each : Flonum ([k : Fixnum 0] [area : Flonum 0.0])
    (cond
      [(fx< k (fxvector-length triangles))
       (let-float3 ([p (corner k)] [q (corner (fx+ k 1))] [s (corner (fx+ k 2))]
                    [across (Float3-scale-by-scalar
                             (Float3-cross (Float3-subtract q p) (Float3-subtract s p)) 0.5)])
         (let ([own (Float3-length across)])
           (Float3-put! packed 0
                        (Float3-multiply-add (Float3-in packed 0) (fl/ own 3.0)
                                             (Float3-add p (Float3-add q s))))
           (Float3-put! packed 3 (Float3-add (Float3-in packed 3) across))
           (each (fx+ k 3) (fl+ area own))))]
      [else (fl+ area 0.0)])))

;; --- the shader ---

;; make-shader : a procedure that takes the surface in the scratch (surface-point, surface-normal and
;; surface-shading-normal turned to the viewer, surface-inside, out-direction, hit-material,
;; surface-uv, and the distance in hit-t) and leaves in `radiance` what it shows. shading: one of
;; SHADINGS; all but toon and the views shade alike, where the normals decide. behind?: whether what
;; is seen through a surface is left out, and light-density says how much of it is missing; else the
;; background is taken for it.
(: make-shader (-> World (Vectorof Piece) (Vectorof Material) Symbol Boolean
                   (-> FlVector FxVector Void)))
(define (make-shader world pieces materials shading behind?)
  (case shading
    [(normals)
     (lambda ([r : FlVector] [i : FxVector])
       (Float3-put! r radiance
                    (Float3-multiply-add (Float3 0.5 0.5 0.5) 0.5
                                         (Float3-in r surface-shading-normal))))]
    [(depth)
     (lambda ([r : FlVector] [i : FxVector])
       (let ([t (flvector-ref r hit-t)]) (Float3-put! r radiance (Float3 t t t))))]
    [(texture-coordinates)
     (lambda ([r : FlVector] [i : FxVector])
       (Float3-put! r radiance
                    (Float3 (flvector-ref r surface-uv) (flvector-ref r (fx+ 1 surface-uv)) 0.0)))]
    [(wireframe hidden-lines)
     (define colors
       (for/vector : (Vectorof Float3) ([material (in-vector materials)]) (line-color material)))
     (lambda ([r : FlVector] [i : FxVector])
       (Float3-put! r radiance (vector-ref colors (fxvector-ref i hit-material))))]
    [else (light-shader world pieces materials (eq? shading 'toon) behind?)]))

;; The colour of a material's lines: the strongest it has, never too dark for a black ground.
(: line-color (-> Material Float3))
(define (line-color material)
  (define packed (Material-look material 1.0))
  (let-float3 ([sum (Float3-add (Float3-in packed 0)
                                (Float3-add (Float3-in packed (mirror-place))
                                            (Float3-in packed (emission-place))))])
    (let ([largest (Float3-largest-component sum)])
      (if (fl> largest 0.05)
          (Float3-scale-by-scalar sum (fl/ (flmax 0.5 (flmin 1.0 largest)) largest))
          (Float3 0.7 0.7 0.7)))))

(: light-shader (-> World (Vectorof Piece) (Vectorof Material) Boolean Boolean
                    (-> FlVector FxVector Void)))
(define (light-shader world pieces materials toon? behind?)
  (define article?
    (for/and : Boolean ([material (in-vector materials)])
      (or (Phong? material) (Emitter? material))))
  (define share (if article? 1.0 (INVERSE-PI)))
  (define looks (make-flvector (fx* (STRIDE) (vector-length materials)) 0.0))
  (for ([material (in-vector materials)]
        [k : Nonnegative-Fixnum (in-range (vector-length materials))])
    (define packed (Material-look material share))
    (let each ([n : Fixnum 0])
      (when (fx< n (STRIDE))
        (flvector-set! looks (fx+ n (fx* k (STRIDE))) (flvector-ref packed n))
        (each (fx+ n 1)))))
  (define kernels (list->vector (map Light-kernel (World-lights world))))
  (define area-lights
    (for*/vector : (Vectorof FlVector)
                 ([piece (in-vector pieces)]
                  [material (in-value (vector-ref materials (Piece-material piece)))]
                  #:when (Emitter? material)
                  [packed (in-value (Piece-light piece material))]
                  #:when packed)
      packed))
  (define background (World-background world))
  (define background! (Background-kernel background))
  (define room (if article? BLACK (interreflection pieces looks area-lights)))
  (define ambient
    (if article?
        (Shading-ambient-color (World-shading world))
        (Float3-add (Background-color background) room)))
  ;; what a gradient adds to the ambient light of a surface that looks up: two thirds of half the
  ;; difference between its ends (its irradiance over pi)
  (define ambient-slope
    (if (and (GradientSky? background) (not article?))
        (Float3-scale-by-scalar (Float3-subtract (GradientSky-top background)
                                                 (GradientSky-bottom background))
                                (fl/ 1.0 3.0))
        BLACK))
  ;; where ambient light is all there is, part of it comes from the viewer, to show forms
  (define headlight
    (if (and (= 0 (vector-length kernels)) (= 0 (vector-length area-lights))) 0.6 0.0))
  (define textures
    (for/vector : (Vectorof (U #f TextureKernel)) ([material (in-vector materials)])
      (define-values (texture place) (Material-texture material))
      (and texture (radiance-kernel texture))))
  (define texture-places
    (for/vector : (Vectorof Fixnum) ([material (in-vector materials)])
      (define-values (texture place) (Material-texture material))
      place))
  (lambda ([r : FlVector] [i : FxVector])
    (define at (fx* (STRIDE) (fxvector-ref i hit-material)))
    (define texture! (vector-ref textures (fxvector-ref i hit-material)))
    (let copy ([k : Fixnum 0])
      (when (fx< k (STRIDE))
        (flvector-set! r (fx+ (HERE) k) (flvector-ref looks (fx+ at k)))
        (copy (fx+ k 1))))
    (when texture!
      (texture! r i)
      (let ([place (fx+ (HERE) (vector-ref texture-places (fxvector-ref i hit-material)))])
        (Float3-put! r place
                     (Float3-scale-by-vector (Float3-in r place) (Float3-in r surface-color)))))
    (Float3-put! r bsdf-weight (Float3 0.0 0.0 0.0)) ; irradiance times cosines
    (Float3-put! r throughput (Float3 0.0 0.0 0.0)) ; in highlights
    (let each ([k : Fixnum 0])
      (when (fx< k (vector-length kernels))
        ((LightKernel-sample (vector-ref kernels k)) r i)
        (add-light! r toon? (flvector-ref r (fx+ (HERE) (shininess-place))))
        (each (fx+ k 1))))
    (let each ([k : Fixnum 0])
      (when (fx< k (vector-length area-lights))
        (sample-area-light! r (vector-ref area-lights k))
        (add-light! r toon? (flvector-ref r (fx+ (HERE) (shininess-place))))
        (each (fx+ k 1))))
    (let ([front? (or (fx= 0 (fxvector-ref i surface-inside))
                      (fl= 1.0 (flvector-ref r (fx+ (HERE) (two-sided-place)))))]
          [coat (flvector-ref r (fx+ (HERE) (coat-place)))])
      (let-float3 ([n (Float3-in r surface-shading-normal)]
                   [view (Float3-in r out-direction)])
        (let* ([cosine (flabs (Float3-dot n view))]
               [fresnel (if (fl>= coat 0.0) (fl+ coat (fl* (fl- 1.0 coat) (fifth (fl- 1.0 cosine))))
                            0.0)]
               [around (fl+ (fl- 1.0 headlight) (fl* headlight cosine))])
          (let-float3 ([body (Float3-scale-by-vector
                              (Float3-scale-by-scalar (Float3-in r (HERE)) (fl- 1.0 fresnel))
                              (Float3-multiply-add
                               (Float3-scale-by-scalar
                                (Float3-multiply-add ambient (Float3-y n) ambient-slope) around)
                               share (Float3-in r bsdf-weight)))]
                       [highlight (Float3-scale-by-vector (Float3-in r (fx+ (HERE) (highlight-place)))
                                                          (Float3-in r throughput))]
                       [emission (Float3-scale-by-scalar (Float3-in r (fx+ (HERE) (emission-place)))
                                                         (if front? 1.0 0.0))])
            (Float3-put! r radiance
                         (Float3-add emission (Float3-add body highlight)))
            (let-float3 ([mirror (Float3-add (Float3-in r (fx+ (HERE) (mirror-place)))
                                             (Float3 fresnel fresnel fresnel))])
              (Float3-put! r light-radiance mirror))
            (flvector-set! r light-density
                           (fl* (fl- 1.0 fresnel) (flvector-ref r (fx+ (HERE) (clear-place)))))))))
    (when (fl> (Float3-largest-component (Float3-in r light-radiance)) 0.0)
      (let-float3 ([view (Float3-in r out-direction)])
        (Float3-put! r ray-direction (Float3-reflect view (Float3-in r surface-shading-normal))))
      (background! r i)
      (Float3-put! r radiance
                   (Float3-add (Float3-in r radiance)
                               (Float3-scale-by-vector
                                (Float3-in r light-radiance)
                                (Float3-add room (Float3-in r surface-color))))))
    (when (and (not behind?) (fl> (flvector-ref r light-density) 0.0))
      (Float3-put! r ray-direction (Float3-negate (Float3-in r out-direction)))
      (background! r i)
      (Float3-put! r radiance
                   (Float3-multiply-add (Float3-in r radiance) (flvector-ref r light-density)
                                        (Float3-add room (Float3-in r surface-color)))))))

;; The look of the surface that is being shaded, textures included: far up the stack, where no kernel
;; comes.
(define-syntax-rule (HERE) (fx+ flonum-stack 970))

(define-syntax-rule (fifth x) (let* ([y x] [z (fl* y y)]) (fl* y (fl* z z))))

;; The light in light-direction and light-radiance on the surface, and in its highlight; in toon
;; shading in steps of a third.
(define-syntax-rule (add-light! r toon? shininess)
  (let-float3 ([n (Float3-in r surface-shading-normal)]
               [to-light (Float3-in r light-direction)])
    (let ([cosine (Float3-dot n to-light)]
          [geometric (Float3-dot (Float3-in r surface-normal) to-light)])
      (when (and (fl> cosine 0.0) (fl> geometric 0.0))
        (let-float3 ([light (Float3-in r light-radiance)]
                     [mirrored (Float3-reflect to-light n)])
          (let* ([along (Float3-dot mirrored (Float3-in r out-direction))]
                 [peak (if (fl> along 0.0) (flexpt along shininess) 0.0)]
                 [shown-cosine (if toon? (fl/ (flfloor (fl+ 0.5 (fl* 3.0 cosine))) 3.0) cosine)]
                 [shown-peak (if toon? (if (fl> peak 0.5) 1.0 0.0) peak)])
            (Float3-put! r bsdf-weight
                         (Float3-multiply-add (Float3-in r bsdf-weight) shown-cosine light))
            (Float3-put! r throughput
                         (Float3-multiply-add (Float3-in r throughput) shown-peak light))))))))

;; Writes light-direction and light-radiance of a piece that shines, as from its middle; the light of
;; a disk on its axis falls off with the square of the distance and its radius together.
(: sample-area-light! (-> FlVector FlVector Void))
(define (sample-area-light! r light)
  (let-float3 ([to-light (Float3-subtract (Float3-in light 0) (Float3-in r surface-point))])
    (let* ([squared (Float3-length-squared to-light)]
           [inverse (if (fl> squared 0.0) (fl/ 1.0 (flsqrt squared)) 0.0)])
      (let-float3 ([direction (Float3-scale-by-scalar to-light inverse)]
                   [flat (Float3-in light 3)])
        (let* ([area (flvector-ref light 6)]
               [flat-size (Float3-length flat)]
               [facing (fl* -1.0 (Float3-dot flat direction))]
               [two-sided? (fl= 1.0 (flvector-ref light 10))]
               [shown (fl+ (if two-sided? (flabs facing) (flmax 0.0 facing))
                           (fl* 0.25 (fl- area flat-size)))]
               [strength (fl/ shown (fl+ squared (fl* (INVERSE-PI) shown)))])
          (Float3-put! r light-direction direction)
          (Float3-put! r light-radiance
                       (Float3-scale-by-scalar (Float3-in light 7) (flmax 0.0 strength))))))))

;; The radiance that comes from everywhere after the first reflection, were all surfaces in one closed
;; room and lit alike (the ambient term of Cohen, Chen, Wallace and Greenberg, "A Progressive
;; Refinement Approach to Fast Radiosity Image Generation", 1988).
(: interreflection (-> (Vectorof Piece) FlVector (Vectorof FlVector) Float3))
(define (interreflection pieces looks lights)
  (define scratch (make-flvector (LIGHT-STRIDE) 0.0))
  (define sums (make-flvector 3 0.0))
  (define area
    (for/fold ([area : Flonum 0.0]) ([piece (in-vector pieces)])
      (define mesh (Piece-mesh piece))
      (define own (if mesh (put-areas! scratch mesh (Piece-transform piece)) 0.0))
      (Float3-put! sums 0
                   (Float3-multiply-add (Float3-in sums 0) own
                                        (Float3-in looks (fx* (STRIDE) (Piece-material piece)))))
      (fl+ area own)))
  (define flux ; over pi
    (for/fold ([flux : Float3 BLACK]) ([light (in-vector lights)])
      (Float3-multiply-add flux (flvector-ref light 6) (Float3-in light 7))))
  (define (bounced [flux : Flonum] [reflected : Flonum])
    (define albedo (flmin 0.8 (fl/ reflected area)))
    (fl/ (fl* flux albedo) (fl* area (fl- 1.0 albedo))))
  (if (fl> area 0.0)
      (Float3 (bounced (Float3-x flux) (flvector-ref sums 0))
              (bounced (Float3-y flux) (flvector-ref sums 1))
              (bounced (Float3-z flux) (flvector-ref sums 2)))
      BLACK))
