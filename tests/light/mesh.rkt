#lang racket/base
;; Meshes and boxes that shine: the same light as from the flat shapes they are made of, whether
;; they are sampled or hit.

(module+ test
  (require racket/flonum racket/fixnum racket/list racket/math rackunit
           "../../main.rkt" "../statistics.rkt" "light-samples.rkt"
           (only-in "../shape/mesh-examples.rkt" icosphere)
           (only-in "../../private/shape/mesh.rkt" Mesh-positions Mesh-triangles))

  (define uniform (seeded 1))
  (define black (Float3 0 0 0))
  (define origin black)
  (define up (Float3 0 0 1))
  (define shining (Emitter (Float3 1 1 1)))
  (define both (Emitter (Float3 1 1 1) #:two-sided? #t))
  (define (estimates world point normal count)
    (for/list ([seed 16]) (light-irradiance world point normal count seed)))

  ;; The parallelogram of corner and edges as two triangles, and two without area.
  (define (two-triangles corner u v material)
    (define points
      (list corner (Float3-add corner u) (Float3-add (Float3-add corner u) v) (Float3-add corner v)))
    (Mesh (apply flvector (append* (for/list ([p points])
                                     (list (Float3-x p) (Float3-y p) (Float3-z p)))))
          (fxvector 0 0 0 0 1 2 2 1 2 0 2 3) #:material material))

  (test-case "two triangles are the quad of the same shape: A02's irradiance, 4 standard errors"
    (define-values (corner u v) (values (Float3 -1 -1 1) (Float3 0 2 0) (Float3 2 0 0)))
    (define world (World (list (two-triangles corner u v shining)) '() black))
    (check-mean "A02" (estimates world origin up 4096) 1.7408395027342063 0.001)
    (define quad (World (list (Quad corner u v shining)) '() black))
    (for ([k 8])
      (define point (Float3 (uniform -3.0 3.0) (uniform -3.0 3.0) (uniform -1.0 0.8)))
      (define-values (by-mesh by-quad)
        (values (estimates world point up 4096) (estimates quad point up 4096)))
      (define error (sqrt (+ (expt (standard-error by-mesh) 2) (expt (standard-error by-quad) 2))))
      (check-true (< error (* 0.01 (mean by-quad))))
      (check-true (< (abs (- (mean by-mesh) (mean by-quad))) (* 4.0 error))))
    ;; from behind
    (check-equal? (drop (sample-light world (Float3 0 0 2) 0.3 0.6) 4) '(0.0 0.0 0.0 0.0)))

  ;; A mesh of 20 triangles around the origin, or more.
  (define (icosphere-of material radius [levels 0])
    (define mesh (icosphere levels #:scale radius))
    (Mesh (Mesh-positions mesh) (Mesh-triangles mesh) #:material material))

  (test-case "points by area: the density is distance^2 / (cosine area), directions end on the mesh"
    (define mesh (icosphere-of shining 1.0))
    (define world (World (list mesh) '() black))
    (for ([k 500])
      (define point (Float3 (uniform 2.0 4.0) (uniform 2.0 4.0) (uniform -4.0 4.0)))
      (define s (sample-light world point (uniform) (uniform)))
      (when (> (last s) 0.0)
        (define end
          (Float3-add point (Float3-scale-by-scalar (apply Float3 (take s 3)) (fourth s))))
        ;; on a face of the icosahedron, between the inscribed and the circumscribed sphere
        (check-true (< 0.7946 (Float3-length end) 1.0000001))
        (check-= (* (fifth s) (last s)) 1.0 1e-14))))

  ;; Radiance of a floor of albedo 1/2 at the origin under a light, by the path integrator.
  (define (floor-radiances shape seeds [samples 64])
    (define floor (Disk black up 50 (Lambertian (Float3 0.5 0.5 0.5))))
    (define camera
      (Camera-look-at (Float3 0.4 -0.3 0.3) black #:vertical-field-of-view-degrees 1e-6))
    (for/list ([seed seeds])
      (define-values (red green blue)
        (Image-pixel (render (World (list floor shape) '() black) camera #:width 1 #:height 1
                             #:samples samples #:seed seed #:integrator 'path #:max-depth 1
                             #:schedule 'sequential)
                     0 0))
      red))

  (test-case "through the renderer: two triangles above a floor, A02, 4 standard errors"
    (check-mean "A02"
                (floor-radiances
                 (two-triangles (Float3 -1 -1 1) (Float3 0 2 0) (Float3 2 0 0) shining) 64)
                (/ 1.7408395027342063 2 pi) 0.01))

  (test-case "a closed mesh shadows its own far side, two-sided or not: Lambert's formula"
    (define moved (Float3 0.3 0.2 1.6))
    (define (moved-icosphere material)
      (define mesh (icosphere 0))
      (define positions (Mesh-positions mesh))
      (define offsets (list (Float3-x moved) (Float3-y moved) (Float3-z moved)))
      (Mesh (for/flvector #:length (flvector-length positions)
                          ([x (in-flvector positions)] [offset (in-cycle offsets)])
              (+ x offset))
            (Mesh-triangles mesh) #:material material))
    ;; the irradiance from every triangle of a convex body that faces the floor, summed (Lambert)
    (define mesh (moved-icosphere shining))
    (define (vertex k)
      (define at (* 3 (fxvector-ref (Mesh-triangles mesh) k)))
      (Float3 (flvector-ref (Mesh-positions mesh) at) (flvector-ref (Mesh-positions mesh) (+ at 1))
              (flvector-ref (Mesh-positions mesh) (+ at 2))))
    (define irradiance
      (for/sum ([t (quotient (fxvector-length (Mesh-triangles mesh)) 3)])
        (define corners (for/list ([k 3]) (vertex (+ k (* 3 t)))))
        ;; Lambert's formula: half the sum of edge angles times the normals' height, for one side
        (max 0.0
             (* -0.5
                (for/sum ([p corners] [q (append (cdr corners) (list (car corners)))])
                  (define-values (a b) (values (Float3-normalized p) (Float3-normalized q)))
                  (define across (Float3-cross a b))
                  (* (atan (Float3-length across) (Float3-dot a b))
                     (Float3-z (Float3-normalized across))))))))
    (for ([material (list shining both)])
      (check-mean "icosahedron" (floor-radiances (moved-icosphere material) 64 512)
                  (/ irradiance 2 pi) 0.005)))

  (test-case "a shining box is the quads of its faces; from within it is pi when two-sided"
    (define (sum-of-faces low high)
      (define size (Float3-subtract high low))
      (define-values (x y z) (values (Float3-x size) (Float3-y size) (Float3-z size)))
      ;; of the faces only the lower one and the one towards -x face the point
      (list (Quad low (Float3 0 y 0) (Float3 x 0 0) shining)
            (Quad low (Float3 0 0 z) (Float3 0 y 0) shining)))
    (define-values (low high) (values (Float3 0.5 -1 0.8) (Float3 1.5 0.7 2.0)))
    (define by-faces
      (for/sum ([face (sum-of-faces low high)])
        (mean (estimates (World (list face) '() black) origin up 8192))))
    (for ([material (list shining both)])
      (define world (World (list (Box low high material)) '() black))
      (check-mean "outside" (estimates world origin up 8192) by-faces 0.002)
      (check-mean "rendered" (floor-radiances (Box low high material) 64)
                  (/ by-faces 2 pi) 0.01))
    (define inside (World (list (Box (Float3 -1 -2 -1) (Float3 2 1 3) both)) '() black))
    (check-mean "inside" (estimates inside origin up 8192) pi 0.01)
    (define dark (World (list (Box (Float3 -1 -1 -1) (Float3 1 1 1) shining)) '() black))
    (check-equal? (drop (sample-light dark origin 0.2 0.7) 4) '(0.0 0.0 0.0 0.0)))

  (test-case "meshes without triangles or area are no lights"
    (define floor (Disk black up 50 (Lambertian (Float3 0.5 0.5 0.5))))
    (for ([mesh (list (Mesh (flvector) (fxvector) #:material shining)
                      (Mesh (flvector 0.0 0.0 1.0 1.0 0.0 1.0) (fxvector 0 1 1 0 0 1)
                            #:material shining))])
      (check-equal? (floor-radiances mesh 1) '(0.0)))))
