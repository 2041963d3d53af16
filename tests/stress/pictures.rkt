#lang racket/base
;; S18, S19: the same pictures at other scales and far from the origin.

(provide cases)

(require racket/flonum racket/list "case.rkt" "../../main.rkt" "../statistics.rkt"
         (prefix-in seed: "../../scenes/seed.rkt")
         (only-in "../shape/mesh-examples.rkt" icosphere) "../world/worlds.rkt")

(define (grey x) (Float3 x x x))

;; --- S18 ---

;; The article's scene, `s` times as large.
(define (seed-picture s width height)
  (define (scaled v) (Float3-scale-by-scalar v s))
  (define world
    (World (for/list ([ball (World-spheres seed:world)])
             (Sphere (scaled (Sphere-point ball)) (* s (Sphere-radius ball)) (Sphere-material ball)))
           (World-lights seed:world) (World-background seed:world)
           #:max-occlusion-distance (* s WORLD-MAX-OCCLUSION-DISTANCE) #:ambient-samples 8))
  (define c seed:camera)
  (Image-pixels
   (render world (Camera (scaled (Camera-eye c)) (Camera-forward c) (Camera-right c) (Camera-up c))
           #:width width #:height height #:samples 1)))

;; A path-traced scene of every shape and most materials, `s` times as large.
(define (mixed-picture s width height)
  (define (at x y z) (Float3 (* s x) (* s y) (* s z)))
  (define ball (icosphere 2 #:offset (list (* s 2.1) (* s 0.6) (* s 1.3)) #:scale (* s 0.6)))
  (define world
    (World
     (list (Plane (at 0 0 0) (Float3 0.1 1 0.05) (Lambertian (grey 0.6)))
           (Sphere (at 0.3 1.1 0.2) (* s 1.0) (Dielectric 1.5))
           (Sphere (at -2.2 0.9 0.7) (* s 0.8) (Metal (Float3 0.9 0.6 0.3) 0.1))
           (Sphere (at 0.5 5.0 1.0) (* s 0.7) (Emitter (grey 8)))
           (Box (at -1.3 0.1 1.6) (at -0.5 0.9 2.3) (Plastic (Float3 0.2 0.5 0.8)))
           (Cylinder (at 1.2 0.1 2.5) (at 1.4 1.0 2.6) (* s 0.3) (Lambertian (Float3 0.8 0.2 0.2)))
           (Cone (at -2.9 0.4 2.4) (* s 0.5) (at -2.7 1.6 2.3) (Mirror (grey 0.9)))
           (Torus (at 0.6 0.5 3.1) (Float3 0.2 1 0.1) (* s 0.5) (* s 0.17) (Lambertian (grey 0.4)))
           (Disk (at 3.4 1.4 -0.5) (Float3 -0.5 0.2 1) (* s 0.9) (RoughConductor 0.3 (grey 0.8)))
           (Quad (at -4.0 0.3 -2.0) (at 2.0 0.1 -0.6) (at 0.2 2.5 0.1) (Mirror (grey 0.8)))
           (Triangle (at 1.1 0.3 -2.2) (at 3.3 0.2 -1.9) (at 2.2 2.3 -2.5) (Lambertian (grey 0.7)))
           (Mesh (Mesh-positions ball) (Mesh-triangles ball) #:normals #f
                 #:material (Lambertian (Float3 0.3 0.7 0.3))))
     (list (PointLight (at 3.0 4.0 5.0) (grey (* 6.0 s s))))
     (GradientSky (grey 1) (Float3 0.5 0.7 1))))
  (define (direction x y z) (Float3 x y z))
  (Image-pixels
   (render world (Camera (at 0.21 2.13 9.37) (direction 0.0 -0.31 -1.93) (direction 1.77 0.0 0.0)
                         (direction 0.0 0.98 -0.157))
           #:width width #:height height #:samples 1 #:integrator 'path #:max-depth 6)))

;; Pixels with a channel that differs by more than 1e-10 of it.
(define (different-pixels a b)
  (for/sum ([k (in-range 0 (flvector-length a) 3)])
    (if (for/and ([c 3])
          (define-values (x y) (values (flvector-ref a (+ c k)) (flvector-ref b (+ c k))))
          (<= (abs (- x y)) (* 1e-10 (max (abs x) (abs y)))))
        0
        1)))

(define (scale-invariance size)
  (define-values (width height) (if (< size 1) (values 64 36) (values 640 360)))
  (define-values (bits worst)
    (for/fold ([bits 0] [worst 0])
              ([picture (in-list (list seed-picture mixed-picture))]
               [exponents (in-list '((-300 -60 -30 -1 1 30 60 300) (-60 -30 -1 1 30 60)))])
      (define reference (picture 1.0 width height))
      (define same-bits?
        (for/sum ([e (in-list exponents)])
          (if (equal? (picture (expt 2.0 e) width height) reference) 0 1)))
      (values (+ bits same-bits?)
              (for/fold ([worst worst]) ([s (in-list '(1e-9 1e-6 1e6 1e9))])
                (max worst (different-pixels reference (picture s width height)))))))
  (define pixels (* width height))
  (values (format "~a of 14 by powers of two differ, by powers of ten at most ~a of ~a pixels"
                  bits worst pixels)
          (and (= bits 0) (<= worst (* 1e-5 pixels)))))

;; --- S19 ---

(define (moved-sphere s offset material)
  (Sphere (Float3-add (Sphere-point s) (grey offset)) (Sphere-radius s) material))

(define (moved-camera turn offset)
  (define c
    (Camera-look-at (Float3 (* 25.0 (sin turn)) 3.3 (* 25.0 (cos turn))) (Float3 0 0 0) #:aspect 1))
  (Camera (Float3-add (Camera-eye c) (grey offset))
          (Camera-forward c) (Camera-right c) (Camera-up c)))

;; Every sphere shines in a colour of its own, so that a pixel tells which one its ray hit.
(define (hit-picture spheres offset turn side)
  (define world
    (World (for/list ([s (in-list spheres)] [k (in-naturals 1)])
             (moved-sphere s offset (Emitter (grey k))))
           '() (grey 0)))
  (Image-pixels (render world (moved-camera turn offset) #:width side #:height side #:samples 1
                        #:integrator 'path #:max-depth 0)))

(define (occlusion-mean spheres offset seed)
  (define world
    (World (for/list ([s (in-list spheres)]) (moved-sphere s offset (Phong (grey 0.5))))
           '() (grey 0) #:ambient-samples 16))
  (mean (in-flvector (Image-pixels
                      (render world (moved-camera 0.3 offset) #:width 48 #:height 48 #:samples 1
                              #:seed seed #:integrator 'ambient-occlusion)))))

(define (far-from-origin size)
  (define uniform (seeded 19))
  (define spheres (random-spheres uniform 300))
  (define-values (side turns) (if (< size 1) (values 120 2) (values 1000 10)))
  (define rays (* side side turns))
  (define here
    (for/list ([turn (in-range turns)]) (hit-picture spheres 0.0 (+ 0.37 (* 0.6 turn)) side)))
  (define offsets '(1e6 1e7 1e8))
  (define mismatches
    (for/list ([offset (in-list offsets)])
      (for/sum ([picture (in-list here)] [turn (in-naturals)])
        (define there (hit-picture spheres offset (+ 0.37 (* 0.6 turn)) side))
        (for/sum ([k (in-range 0 (flvector-length there) 3)])
          (if (= (flvector-ref there k) (flvector-ref picture k)) 0 1)))))
  (define seeds 8)
  (define (occlusion offset start)
    (for/list ([seed (in-range seeds)]) (occlusion-mean spheres offset (+ start seed))))
  (define near (occlusion 0.0 0))
  (define deviations
    (for/list ([offset (in-list offsets)] [start (in-list '(100 200 300))])
      (define far (occlusion offset start))
      (/ (- (mean far) (mean near))
         (sqrt (+ (expt (standard-error near) 2) (expt (standard-error far) 2))))))
  (values (format "mismatches ~a of ~a rays at 1e6, 1e7, 1e8; occlusion ~a standard errors off"
                  mismatches rays (map rounded deviations))
          (and (for/and ([m (in-list mismatches)] [allowed (in-list '(1e-6 1e-5 1e-4))])
                 (<= m (* allowed rays)))
               (for/and ([d (in-list deviations)]) (< (abs d) 4.0)))))

(define cases
  (list (stress-case "S18 scale invariance"
                     "powers of two to the bit, else 1e-10 but for 1e-5 of pixels"
                     scale-invariance)
        (stress-case "S19 far from the origin"
                     "1e-6, 1e-5, 1e-4 of rays mismatch, occlusion within 4 standard errors"
                     far-from-origin)))
