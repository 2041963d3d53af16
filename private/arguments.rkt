#lang racket/base
;; What the public constructors are called with by untyped code, looked at before types do: a wrong
;; argument is told in one line that names the constructor, the argument and what was expected.
(require racket/flonum racket/fixnum racket/list
         (only-in "base/float3.rkt" Float3?) (only-in "base/check.rkt" raise-expected)
         (only-in "base/transform.rkt" Transform?)
         (only-in "material/material.rkt" Material?)
         (only-in "material/texture/texture.rkt" Texture?)
         (only-in "shape/shape.rkt" Shape?) (only-in "light/light.rkt" Light?)
         (only-in "light/environment.rkt" EnvironmentMap?)
         (only-in "world/background.rkt" GradientSky?) (only-in "world/camera.rkt" Camera?)
         (only-in "image/image.rkt" Image?))

(provide check-arguments constructor-signature constructor-names)

(define (list-of right? v) (and (list? v) (andmap right? v)))

;; The kinds of arguments: what is of the kind, and how it is called. Predicates of typed modules are
;; not referred to before they are asked, for with the first a module makes all its contracts.
(define kinds
  (hasheq
   'real (cons real? "a real number")
   'whole (cons exact-integer? "a whole number")
   'vector (cons (lambda (v) (Float3? v)) "a Float3")
   'color (cons (lambda (v) (Float3? v)) "a colour, a Float3,")
   'paint (cons (lambda (v) (or (Float3? v) (Texture? v))) "a colour or a texture")
   'share (cons (lambda (v) (or (real? v) (Texture? v))) "a real number or a texture")
   'mirror (cons (lambda (v) (or (real? v) (Float3? v))) "a real number or a colour")
   'surface (cons (lambda (v) (or (Material? v) (Float3? v))) "a material or a colour")
   'material (cons (lambda (v) (Material? v)) "a material")
   'shape (cons (lambda (v) (Shape? v)) "a shape")
   'shapes (cons (lambda (v) (list-of Shape? v)) "a list of shapes")
   'lights (cons (lambda (v) (or (Light? v) (list-of Light? v))) "a light or a list of lights")
   'background (cons (lambda (v) (or (Float3? v) (GradientSky? v) (EnvironmentMap? v)))
                     "a colour, a GradientSky or an EnvironmentMap")
   'transform (cons (lambda (v) (Transform? v)) "a Transform")
   'camera (cons (lambda (v) (Camera? v)) "a Camera")
   'image (cons (lambda (v) (Image? v)) "an Image")
   'flags (cons boolean? "#t or #f")
   'name (cons symbol? "a symbol")
   'fresnel (cons (lambda (v) (memq v '(exact schlick))) "'exact or 'schlick")
   'procedure (cons procedure? "a procedure")
   'flvector (cons flvector? "an flvector")
   'fxvector (cons fxvector? "an fxvector")))

;; Arguments by place, then by keyword: each a name and its kind; `maybe` allows #f too.
(define signatures
  (hasheq
   'Float3 '((x real) (y real) (z real))
   'Camera '((eye vector) (forward vector) (right vector) (up vector) (lens-radius real)
             (focus-distance real) (#:lens-radius real) (#:focus-distance real) (#:blades whole)
             (#:projection name) (#:angle real) (#:shutter-open real) (#:shutter-close real)
             (#:end maybe camera))
   'Ray '((point vector) (direction vector) (time real))
   'Intersection '((t real) (point vector) (normal vector) (color color))
   'Sphere '((point vector) (radius real) (material surface) (#:material surface))
   'Plane '((point vector) (normal vector) (material surface) (#:material surface))
   'Disk '((point vector) (normal vector) (radius real) (material surface) (#:material surface))
   'Quad '((corner vector) (edge-u vector) (edge-v vector) (material surface)
           (#:material surface))
   'Triangle '((a vector) (b vector) (c vector) (material surface) (#:material surface))
   'Box '((low vector) (high vector) (material surface) (#:material surface))
   'Cylinder '((base vector) (top vector) (radius real) (material surface) (#:material surface)
               (#:caps? flags))
   'Cone '((base vector) (radius real) (apex vector) (material surface) (#:material surface)
           (#:caps? flags))
   'Torus '((center vector) (axis vector) (major-radius real) (minor-radius real)
            (material surface) (#:material surface))
   'Mesh '((positions flvector) (triangles fxvector) (#:normals maybe flvector)
           (#:uvs maybe flvector) (#:material surface))
   'Group '((shapes shapes))
   'Instance '((shape shape) (transform transform) (#:material maybe surface))
   'Moving '((shape shape) (from transform) (to transform))
   'SolidUnion '((a shape) (b shape) (#:material maybe surface))
   'SolidIntersection '((a shape) (b shape) (#:material maybe surface))
   'SolidDifference '((a shape) (b shape) (#:material maybe surface))
   'DistanceShape '((distance procedure) (low vector) (high vector) (material surface)
                    (#:material surface) (#:error maybe real) (#:lipschitz real))
   'CustomShape '((low vector) (high vector) (intersect procedure) (material surface)
                  (#:material surface) (#:error real) (#:uv maybe procedure))
   'DistantLight '((direction vector) (color color))
   'PointLight '((point vector) (intensity color))
   'SpotLight '((point vector) (direction vector) (intensity color) (cone-angle real)
                (falloff-angle real))
   'Phong '((color paint) (specularity real) (shininess real) (reflectivity mirror)
            (#:specularity real) (#:shininess real) (#:reflectivity mirror))
   'Emitter '((radiance paint) (two-sided? flags) (surface maybe material) (#:two-sided? flags)
              (#:surface maybe material))
   'Lambertian '((albedo paint))
   'Mirror '((color paint))
   'Metal '((albedo paint) (fuzz real) (#:fuzz real))
   'Dielectric '((ior real) (fresnel fresnel) (absorption color) (outside-ior real)
                 (#:fresnel fresnel) (#:absorption color) (#:outside-ior real))
   'Plastic '((albedo paint) (ior real) (#:ior real))
   'ModifiedPhong '((albedo color) (specular color) (shininess real))
   'Mix '((first material) (second material) (weight share))
   'RoughConductor '((roughness real) (color maybe color) (eta maybe color) (k maybe color)
                     (#:color maybe color) (#:eta maybe color) (#:k maybe color))
   'RoughDielectric '((ior real) (roughness real) (absorption color) (outside-ior real)
                      (#:roughness real) (#:absorption color) (#:outside-ior real))
   'Checker '((even paint) (odd paint) (size real) (#:size real))
   'CheckerUV '((even paint) (odd paint) (columns real) (rows maybe real) (#:columns real)
                (#:rows maybe real))
   'ImageTexture '((image image) (filter name) (wrap name) (#:filter name) (#:wrap name))
   'Noise '((first color) (second color) (scale real) (octaves whole) (seed whole)
            (#:scale real) (#:octaves whole) (#:seed whole))
   'Turbulence '((first color) (second color) (scale real) (octaves whole) (seed whole)
                 (#:scale real) (#:octaves whole) (#:seed whole))
   'Marble '((first color) (second color) (scale real) (bands real) (disorder real)
             (octaves whole) (seed whole) (#:scale real) (#:bands real) (#:disorder real)
             (#:octaves whole) (#:seed whole))
   'GradientTexture '((first color) (second color) (start maybe vector) (end maybe vector)
                      (#:start maybe vector) (#:end maybe vector))
   'UVTexture '()
   'FunctionTexture '((function procedure))
   'GradientSky '((bottom color) (top color))
   'EnvironmentMap '((image image) (#:rotation-degrees real) (#:scale real))
   'World '((shapes shapes) (lights lights) (background background) (#:shapes shapes)
            (#:lights lights) (#:background background) (#:ambient-color maybe color)
            (#:ambient-samples whole) (#:max-occlusion-distance real) (#:ambient-weighting name)
            (#:occlusion-falloff name) (#:shadow-samples whole) (#:mirror-bounces whole))))

;; constructor-signature : the arguments of the public constructor of that name, each a list of a
;; name or a keyword, perhaps `maybe`, and a kind; #f where there is none of that name.
(define (constructor-signature name) (hash-ref signatures name #f))

;; constructor-names : of all that are known here.
(define (constructor-names) (sort (hash-keys signatures) symbol<?))

;; check-arguments : the constructor that the thunk get returns with its checks in front, under its
;; public name; without them where its arguments are not known here.
(define (check-arguments name get)
  (define signature (constructor-signature name))
  (cond
    [(not signature)
     (procedure-rename
      (make-keyword-procedure
       (lambda (given values . arguments) (keyword-apply (get) given values arguments))
       (lambda arguments (apply (get) arguments)))
      name)]
    [(eq? name 'Float3) (check-numbers get)]
    [else
     (define-values (keywords places)
       (partition (lambda (argument) (keyword? (car argument))) signature))
     (define (check-places arguments)
       (unless (procedure-arity-includes? (get) (length arguments) #t)
         (raise-arity name (get) places arguments))
       (for ([value (in-list arguments)] [argument (in-list places)])
         (check name argument value)))
     (define (check-keyword keyword value)
       (define argument (assq keyword keywords))
       (unless argument
         (raise-expected name "keyword" (keywords-text (map car keywords)) keyword))
       (check name argument value))
     (procedure-rename
      (make-keyword-procedure
       (lambda (given values . arguments)
         (check-places arguments)
         (for-each check-keyword given values)
         (keyword-apply (get) given values arguments))
       (lambda arguments
         (check-places arguments)
         (apply (get) arguments)))
      name)]))

(define (check-numbers get)
  (define places (constructor-signature 'Float3))
  (procedure-rename
   (case-lambda
     [(x y z)
      (unless (and (real? x) (real? y) (real? z))
        (for ([value (in-list (list x y z))] [argument (in-list places)])
          (check 'Float3 argument value)))
      ((get) x y z)]
     [arguments (raise-arity 'Float3 (get) places arguments)])
   'Float3))

(define (check name argument value)
  (define maybe? (eq? (cadr argument) 'maybe))
  (define kind (hash-ref kinds (last argument)))
  (unless (or ((car kind) value) (and maybe? (not value)))
    (raise-expected name (format "~a" (car argument))
                    (if maybe? (string-append (cdr kind) " or #f") (cdr kind)) value)))

(define (keywords-text keywords)
  (if (null? keywords) "none" (format "one of ~a" keywords)))

(define (raise-arity name make places arguments)
  (define least
    (for/first ([k (in-naturals)] #:when (procedure-arity-includes? make k #t)) k))
  (define (words names) (apply string-append (map (lambda (n) (format " ~a" n)) names)))
  (define-values (required optional) (split-at (map car places) (min least (length places))))
  (define wanted (append required (map list optional)))
  (raise (exn:fail:contract:arity
          (format "~a: expected ~a, given ~a" name
                  (if (null? wanted) "no arguments" (string-append "the arguments" (words wanted)))
                  (length arguments))
          (current-continuation-marks))))
