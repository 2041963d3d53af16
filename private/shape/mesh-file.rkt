#lang typed/racket/base
;; Shapes from mesh files: one mesh for each material that is used.
(require racket/list "../base/unsafe-typed.rkt"
         "../base/unsafe.rkt" "../base/float3.rkt" "../material/material.rkt"
         "../material/lambertian.rkt" "shape.rkt" "group.rkt" "mesh.rkt" "vertex-normals.rkt")

(provide Mesh-read mesh-data->shape)

(define-type Run (List (U #f String) Nonnegative-Fixnum Nonnegative-Fixnum))

;; What the untyped readers return, by its accessors alone.
(define-type MeshData Any)
(define-type MeshMaterial Any)
(unsafe-require/typed "../read/mesh.rkt"
  [read-mesh (-> Path-String #:progress (U #f (-> Real Any)) MeshData)]
  [mesh-data-positions (-> MeshData FlVector)]
  [mesh-data-normals (-> MeshData (U #f FlVector))]
  [mesh-data-uvs (-> MeshData (U #f FlVector))]
  [mesh-data-triangles (-> MeshData FxVector)]
  [mesh-data-groups (-> MeshData (Listof Run))]
  [mesh-data-materials (-> MeshData (HashTable (U #f String) MeshMaterial))]
  [mesh-data-warnings (-> MeshData (Listof String))]
  [mesh-material-Kd (-> MeshMaterial (U #f (Listof Flonum)))])

;; Mesh-read : the shape in a mesh file, .obj, .ply or .stl by its name: a Mesh, or a Group of
;; Meshes where the file uses several materials. #:material: instead of all the file's own.
;; #:smooth? : whether a file without normals gets smooth ones; else it is flat. #:progress: called
;; now and then with the part that is read, from 0 to 1. #:warn: called with each warning, a line.
;; Raises a user error of one line that names the file and what is wrong where.
(: Mesh-read (->* (Path-String)
                  (#:material (U #f MaterialOrColor) #:smooth? Boolean
                   #:progress (U #f (-> Real Any)) #:warn (-> String Any))
                  (U Mesh Group)))
(define (Mesh-read path #:material [material #f] #:smooth? [smooth? #f]
                   #:progress [progress #f] #:warn [warn void])
  (define data (read-mesh path #:progress progress))
  (for-each warn (mesh-data-warnings data))
  (mesh-data->shape data #:material material #:smooth? smooth?))

;; mesh-data->shape : the same from what a reader returns. A material's Kd becomes a Lambertian of
;; that albedo; where there is none it is grey, 0.5.
(: mesh-data->shape (->* (MeshData) (#:material (U #f MaterialOrColor) #:smooth? Boolean)
                         (U Mesh Group)))
(define (mesh-data->shape data #:material [material #f] #:smooth? [smooth? #f])
  (define positions (mesh-data-positions data))
  (define triangles (mesh-data-triangles data))
  (define uvs (mesh-data-uvs data))
  (define normals
    (or (mesh-data-normals data) (and smooth? (vertex-normals positions triangles))))
  (: mesh (-> FxVector MaterialOrColor Mesh))
  (define (mesh triangles material)
    (make-Mesh positions triangles #:normals normals #:uvs uvs #:material material))
  (: material-of (-> (U #f String) Material))
  (define (material-of name)
    (mesh-material->material (hash-ref (mesh-data-materials data) name (lambda () #f))))
  (define groups (mesh-data-groups data))
  (define names (remove-duplicates (map (lambda ([run : Run]) (first run)) groups)))
  (cond
    [material (mesh triangles material)]
    [(null? names) (mesh triangles (material-of #f))]
    [(null? (cdr names)) (mesh triangles (material-of (car names)))]
    [else
     (make-Group
      (for/list : (Listof Mesh) ([name (in-list names)])
        (define runs (filter (lambda ([run : Run]) (equal? (first run) name)) groups))
        (mesh (join-runs triangles runs) (material-of name))))]))

;; Albedos beyond what a surface can reflect are cut to 0 and 1.
(: mesh-material->material (-> MeshMaterial Material))
(define (mesh-material->material m)
  (define Kd (and m (mesh-material-Kd m)))
  (: albedo (-> Flonum Flonum))
  (define (albedo c) (flmax 0.0 (flmin 1.0 c)))
  (make-Lambertian (if Kd
                       (make-Float3 (albedo (first Kd)) (albedo (second Kd)) (albedo (third Kd)))
                       (make-Float3 0.5 0.5 0.5))))

;; The triangles of some runs, in their order.
(: join-runs (-> FxVector (Listof Run) FxVector))
(define (join-runs triangles runs)
  (define joined (make-fxvector (* 3 (apply + (map (lambda ([run : Run]) (third run)) runs))) 0))
  (for/fold ([to : Fixnum 0]) ([run (in-list runs)])
    (define from (fx* 3 (second run)))
    (define size (fx* 3 (third run)))
    (let copy ([k : Fixnum 0])
      (when (fx< k size)
        (fxvector-set! joined (fx+ to k) (fxvector-ref triangles (fx+ from k)))
        (copy (fx+ k 1))))
    (fx+ to size))
  joined)
