#lang racket/base
;; The closed Lambert sphere and rooms of other shapes: where every wall shines with L and reflects
;; the part a, the radiance is L / (1 - a) in every direction; one room for every kind of light that
;; has a surface. Lights without one shine into a matte sphere. All bounces, from renders, within 4.5
;; standard errors (see measure.rkt), which are at most 1 or 2%.
(require rackunit racket/flonum racket/fixnum racket/list racket/math raytrace "measure.rkt"
         (only-in "../shape/mesh-examples.rkt" icosphere)
         (only-in raytrace/private/shape/mesh Mesh-positions Mesh-triangles))

(define albedo 0.6)
(define (wall [two-sided? #f])
  (Emitter (Float3 1 1 1) #:two-sided? two-sided? #:surface (grey albedo)))

;; The cube from -1 to 1, its walls facing inwards.
(define (quad-room material)
  (for*/list ([axis 3] [side '(-1.0 1.0)])
    (define (vector-of a b c)
      (define v (list a b c))
      (Float3 (list-ref v (modulo (- 0 axis) 3)) (list-ref v (modulo (- 1 axis) 3))
              (list-ref v (modulo (- 2 axis) 3))))
    (define corner (vector-of side -1.0 -1.0))
    (define-values (u v) (values (vector-of 0.0 2.0 0.0) (vector-of 0.0 0.0 2.0)))
    (if (> side 0.0) (Quad corner v u material) (Quad corner u v material))))

(define (triangle-room material)
  (append*
   (for/list ([quad (quad-room material)])
     (define-values (a u v) (values (Quad-corner quad) (Quad-edge-u quad) (Quad-edge-v quad)))
     (define-values (b c d) (values (Float3-add a u) (Float3-add a v)
                                    (Float3-add (Float3-add a u) v)))
     (list (Triangle a b c material) (Triangle b d c material)))))

;; Disks that overlap beyond the edges of the cube.
(define (disk-room material)
  (for*/list ([axis (list (Float3 1 0 0) (Float3 0 1 0) (Float3 0 0 1))] [side '(-1.0 1.0)])
    (Disk (Float3-scale-by-scalar axis side) (Float3-scale-by-scalar axis (- side)) 1.6 material)))

(define (mesh-room material)
  (define mesh (icosphere 1 #:scale 1.2))
  (Mesh (Mesh-positions mesh) (Mesh-triangles mesh) #:material material))

(define turn (Transform-compose (Transform-rotate (Float3 1 2 -1) 0.7) (Transform-scale 2.5)))
(define from (Float3 0.2 0.1 -0.15))

(module+ test
  (define (check-room name shapes)
    (test-case name
      (for ([at (list (Float3 0.9 0.3 0.2) (Float3 -0.3 -0.8 0.4))])
        (check-radiance (World shapes '() black) (look-from from at) (/ 1.0 (- 1.0 albedo))
                        #:samples 32 #:seeds 32 #:precision 0.01))))

  (check-room "sphere" (list (Sphere black 1 (wall #t))))
  (check-room "box" (list (Box (Float3 -1 -0.8 -0.9) (Float3 1 1.1 0.9) (wall #t))))
  (check-room "quads" (quad-room (wall)))
  (check-room "quads, two-sided" (quad-room (wall #t)))
  (check-room "triangles" (triangle-room (wall)))
  (check-room "disks" (disk-room (wall)))
  (check-room "mesh" (list (mesh-room (wall #t))))
  (check-room "cylinder with caps: found by scattering"
              (list (Cylinder (Float3 0 -1 0) (Float3 0 1 0) 1 #:caps? #t #:material (wall #t))))
  (check-room "quads in a group" (list (Group (quad-room (wall)))))
  (check-room "sphere in an instance" (list (Instance (Sphere black 0.5 (wall #t)) turn)))
  (check-room "disks in an instance of a group"
              (list (Instance (Group (disk-room (wall))) turn)))
  (check-room "mesh in an instance" (list (Instance (mesh-room (wall #t)) turn)))

  ;; A black ball of radius 1/2 in the middle takes a quarter of what the wall sends out.
  (define ball (Sphere black 0.5 (grey 0)))
  (for ([name '("sphere" "sphere in an instance")]
        [room (list (Sphere black 1 (wall #t)) (Instance (Sphere black 0.4 (wall #t)) turn))])
    (test-case (format "~a around a black ball" name)
      (check-radiance (World (list room ball) '() black)
                      (look-from (Float3 0.4 0.5 0.1) (Float3 0.9 0.3 0.2))
                      (/ 1.0 (- 1.0 (* albedo 0.75))) #:samples 64 #:seeds 64 #:precision 0.01)))

  ;; Indirect light in a matte sphere of radius 1 is the same everywhere: a^2 flux / (A pi (1 - a)).
  (define (check-sphere name light flux)
    (test-case name
      (check-radiance (World (list (Sphere black 1 (grey albedo))) light black)
                      (look-from black (Float3 -1 0.2 0))
                      (/ (* albedo albedo flux) (* 4 pi pi (- 1 albedo)))
                      #:samples 256 #:seeds 32 #:precision 0.02)))
  (check-sphere "a spot that lights another part of the wall"
                (SpotLight black (Float3 1 0 0) (Float3 3 3 3) 0.8 0.3)
                (* 2 pi 3 (+ (- 1 (cos 0.3)) (/ (- (cos 0.3) (cos 0.8)) 2)))))
