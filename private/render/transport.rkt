#lang racket/base
;; Worlds as messages: a value made of the library's structs becomes vectors a place channel carries,
;; and the same value again on the other side, field by field, with no constructor's arithmetic in
;; between. What is shared in the value is sent once and shared again.
(require racket/flonum racket/fixnum
         (only-in "../base/float3.rkt" make-Float3)
         (only-in "../base/transform.rkt" Transform-identity)
         (only-in "../world/world.rkt" make-World World? World-parts World-shading World-from-parts)
         (only-in "../world/camera.rkt" Camera-look-at)
         (only-in "../world/background.rkt" make-GradientSky)
         (only-in "../light/environment.rkt" make-EnvironmentMap)
         (only-in "../image/image.rkt" make-Image)
         (only-in "../shape/sphere.rkt" make-Sphere) (only-in "../shape/plane.rkt" make-Plane)
         (only-in "../shape/disk.rkt" make-Disk) (only-in "../shape/quad.rkt" make-Quad)
         (only-in "../shape/triangle.rkt" make-Triangle) (only-in "../shape/box.rkt" make-Box)
         (only-in "../shape/cylinder.rkt" make-Cylinder) (only-in "../shape/cone.rkt" make-Cone)
         (only-in "../shape/torus.rkt" make-Torus) (only-in "../shape/group.rkt" make-Group)
         (only-in "../shape/instance.rkt" make-Instance)
         (only-in "../shape/moving.rkt" make-Moving)
         (only-in "../shape/solid.rkt" make-SolidUnion make-SolidIntersection make-SolidDifference)
         (only-in "../shape/mesh.rkt" make-Mesh Mesh? Mesh-positions Mesh-triangles Mesh-normals
                  Mesh-uvs Mesh-material)
         (only-in "../light/distant.rkt" make-DistantLight)
         (only-in "../light/point.rkt" make-PointLight)
         (only-in "../light/spot.rkt" make-SpotLight)
         (only-in "../material/phong.rkt" make-Phong)
         (only-in "../material/emitter.rkt" make-Emitter)
         (only-in "../material/lambertian.rkt" make-Lambertian)
         (only-in "../material/mirror.rkt" make-Mirror)
         (only-in "../material/metal.rkt" make-Metal)
         (only-in "../material/dielectric.rkt" make-Dielectric)
         (only-in "../material/plastic.rkt" make-Plastic)
         (only-in "../material/modified-phong.rkt" make-ModifiedPhong)
         (only-in "../material/mix.rkt" make-Mix) (only-in "../material/bumped.rkt" make-Bumped)
         (only-in "../material/rough-conductor.rkt" make-RoughConductor)
         (only-in "../material/rough-dielectric.rkt" make-RoughDielectric)
         (only-in "../material/texture/checker.rkt" make-Checker make-CheckerUV)
         (only-in "../material/texture/image.rkt" make-ImageTexture)
         (only-in "../material/texture/noises.rkt" make-Noise make-Turbulence make-Marble)
         (only-in "../material/texture/gradient.rkt" make-GradientTexture)
         (only-in "../material/texture/uv.rkt" make-UVTexture)
         (only-in "../material/interior.rkt" make-Interior)
         (only-in "../medium/medium.rkt" make-Medium)
         (only-in "pixel.rkt" Tiling)
         (only-in "job.rkt" Job))

(provide value->message message->value)

;; One value of every struct a Job may hold; World and Mesh are apart, for they hold promises. What a
;; value says of its own struct type is enough to build others of it.
(define examples
  (let* ([zero (make-Float3 0 0 0)]
         [up (make-Float3 0 1 0)]
         [side (make-Float3 1 0 0)]
         [here (Transform-identity)]
         [ball (make-Sphere zero 1)]
         [matte (make-Lambertian zero)]
         [world (make-World '() '() zero)]
         [camera (Camera-look-at up zero side)]
         [dot (make-Image 1 1 (flvector 0.0 0.0 0.0))]
         [tiling (Tiling 1 1 1 '(0 0 1 1))])
    (list zero here (World-shading world) camera tiling 
          (Job world camera tiling 1 0 'owen-sobol 'box 'auto #f #f)
          (make-GradientSky zero zero)
          (make-Image 1 1 (flvector 0.0 0.0 0.0)) (make-EnvironmentMap (make-Image 1 1 (flvector 0.0 0.0 0.0)))
          ball (make-Plane zero up matte) (make-Disk zero up 1 matte) (make-Quad zero up side matte)
          (make-Triangle zero up side matte) (make-Box zero (make-Float3 1 1 1) matte)
          (make-Cylinder zero up 1 matte) (make-Cone zero 1 up matte) (make-Torus zero up 2 1 matte)
          (make-Group (list ball)) (make-Instance ball here) (make-Moving ball here here)
          (make-SolidUnion ball ball) (make-SolidIntersection ball ball)
          (make-SolidDifference ball ball)
          (make-DistantLight up zero) (make-PointLight zero zero) (make-SpotLight zero up zero 1 0.5)
          (make-Phong zero) (make-Emitter zero) matte (make-Mirror zero) (make-Metal zero 0)
          (make-Dielectric 1.5) (make-Plastic zero 1.5) (make-ModifiedPhong zero zero 1)
          (make-Mix matte matte 0.5) (make-RoughConductor 0.1) (make-RoughDielectric 1.5)
          (make-Bumped matte (make-UVTexture))
          (make-Checker zero zero) (make-CheckerUV zero zero) dot (make-ImageTexture dot)
          (make-Noise zero zero) (make-Turbulence zero zero) (make-Marble zero zero)
          (make-GradientTexture zero zero) (make-UVTexture)
          (make-Medium 1 zero) (make-Interior (make-Medium 1 zero)))))

(define (value-type value)
  (define-values (type skipped?) (struct-info value))
  type)

(define (struct-type-name type)
  (define-values (name own auto ref set immutables super skipped?) (struct-type-info type))
  name)

(define (Mesh-from-parts positions triangles normals uvs material)
  (make-Mesh positions triangles #:normals normals #:uvs uvs #:material material))

;; By the name of the struct type: what builds a value from its fields.
(define constructors
  (for/fold ([constructors (hasheq 'World World-from-parts 'Mesh Mesh-from-parts
                                   'flvector values 'fxvector values)])
            ([example (in-list examples)])
    (define type (value-type example))
    (hash-set constructors (struct-type-name type) (struct-type-make-constructor type))))

;; The name and the fields of a value that is no atom and no pair.
(define (name+fields value)
  (cond
    [(World? value)
     (cons 'World (World-parts value))]
    [(Mesh? value)
     (list 'Mesh (Mesh-positions value) (Mesh-triangles value) (Mesh-normals value)
           (Mesh-uvs value) (Mesh-material value))]
    [(struct? value)
     (define type (value-type value))
     (define name (and type (struct-type-name type)))
     (unless (hash-has-key? constructors name)
       (raise-user-error (format "a ~a cannot be sent to another place" (or name "struct"))))
     (cons name (cdr (vector->list (struct->vector value))))]
    [else
     (raise-user-error (format "a world that holds ~e cannot be sent to another place" value))]))

;; value->message : a pair of what stands for the value and a vector of nodes. Atoms stand for
;; themselves, #(k) for the value of node k; a node is a vector of a name and fields, and comes
;; after those it refers to. Raises exn:fail:user where the value holds a procedure or a struct that
;; is not listed.
(define (value->message value)
  (define numbers (make-hasheq))
  (define nodes '())
  (define (add-node! value node)
    (hash-set! numbers value (hash-count numbers))
    (set! nodes (cons node nodes)))
  (define (encode value)
    (cond
      [(or (number? value) (boolean? value) (symbol? value) (string? value) (null? value)) value]
      [(pair? value)
       (define first (encode (car value)))
       (cons first (encode (cdr value)))]
      [else
       (unless (hash-has-key? numbers value)
         (add-node! value
                    (cond
                      [(flvector? value) (vector 'flvector (shared-flvector value))]
                      [(fxvector? value) (vector 'fxvector (shared-fxvector value))]
                      [else
                       (define parts (name+fields value))
                       (list->vector (cons (car parts) (map encode (cdr parts))))])))
       (vector (hash-ref numbers value))]))
  (define root (encode value))
  (cons root (list->vector (reverse nodes))))

(define (shared-flvector v)
  (define copy (make-shared-flvector (flvector-length v)))
  (for ([x (in-flvector v)] [k (in-naturals)]) (flvector-set! copy k x))
  copy)

(define (shared-fxvector v)
  (define copy (make-shared-fxvector (fxvector-length v)))
  (for ([x (in-fxvector v)] [k (in-naturals)]) (fxvector-set! copy k x))
  copy)

;; message->value : the value that value->message was given.
(define (message->value message)
  (define nodes (cdr message))
  (define values (make-vector (vector-length nodes) #f))
  (define (decode part)
    (cond
      [(pair? part) (cons (decode (car part)) (decode (cdr part)))]
      [(vector? part) (vector-ref values (vector-ref part 0))]
      [else part]))
  (for ([node (in-vector nodes)] [k (in-naturals)])
    (define fields
      (if (memq (vector-ref node 0) '(flvector fxvector))
          (list (vector-ref node 1))
          (for/list ([field (in-vector node 1)]) (decode field))))
    (vector-set! values k (apply (hash-ref constructors (vector-ref node 0)) fields)))
  (decode (car message)))
