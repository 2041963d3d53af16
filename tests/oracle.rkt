#lang typed/racket/base
;; The article's tracer with its mistakes corrected, as plain as it was published: structs, a list
;; of spheres tried in turn, a loop over random directions. It shares no code with the library; the
;; tests compare the library's pictures with its pictures, the benchmarks the times.

(provide oracle-render)

(require racket/flonum
         (prefix-in library:
                    (combine-in (only-in "../private/base/float3.rkt"
                                         Float3 Float3-x/function Float3-y/function Float3-z/function)
                                "../private/shape/sphere.rkt" "../private/light/distant.rkt"
                                "../private/world/camera.rkt" "../private/material/phong.rkt"
                                (only-in "../private/integrate/query.rkt" Sphere-color))))

(struct Float3 ([x : Flonum] [y : Flonum] [z : Flonum]))
(struct Ray ([point : Float3] [direction : Float3]))
(struct Intersection ([t : Flonum] [point : Float3] [normal : Float3] [color : Float3]))
(struct Sphere ([point : Float3] [radius : Flonum] [color : Float3]))
(struct World ([spheres : (Listof Sphere)] [sun-direction : Float3] [sun-color : Float3]
               [background-color : Float3] [ambient-samples : Natural]
               [generator : Pseudo-Random-Generator]))

(define INTERSECTION-T-MAX 1e300)
(define WORLD-MAX-OCCLUSION-DISTANCE 5.0)
(define SPECULARITY 0.30)
(define SHININESS 16)
;; how far a ray starts off a surface, for each unit of the coordinates there
(define EPSILON 1e-13)

(: Float3-add (-> Float3 Float3 Float3))
(define (Float3-add a b)
  (Float3 (+ (Float3-x a) (Float3-x b)) (+ (Float3-y a) (Float3-y b)) (+ (Float3-z a) (Float3-z b))))

(: Float3-scale-by-scalar (-> Float3 Flonum Float3))
(define (Float3-scale-by-scalar a s)
  (Float3 (* (Float3-x a) s) (* (Float3-y a) s) (* (Float3-z a) s)))

(: Float3-scale-by-vector (-> Float3 Float3 Float3))
(define (Float3-scale-by-vector a b)
  (Float3 (* (Float3-x a) (Float3-x b)) (* (Float3-y a) (Float3-y b)) (* (Float3-z a) (Float3-z b))))

(: Float3-subtract (-> Float3 Float3 Float3))
(define (Float3-subtract a b) (Float3-add a (Float3-scale-by-scalar b -1.0)))

(: Float3-dot (-> Float3 Float3 Flonum))
(define (Float3-dot a b)
  (+ (* (Float3-x a) (Float3-x b)) (* (Float3-y a) (Float3-y b)) (* (Float3-z a) (Float3-z b))))

(: Float3-length (-> Float3 Flonum))
(define (Float3-length a) (flsqrt (Float3-dot a a)))

(: Float3-normalized (-> Float3 Float3))
(define (Float3-normalized a) (Float3-scale-by-scalar a (/ 1.0 (Float3-length a))))

;; The mirror image of a vector that points away from the surface.
(: Float3-reflect (-> Float3 Float3 Float3))
(define (Float3-reflect a normal)
  (Float3-subtract (Float3-scale-by-scalar normal (* 2.0 (Float3-dot a normal))) a))

(: Float3-random-hemisphere-direction (-> Float3 Pseudo-Random-Generator Float3))
(define (Float3-random-hemisphere-direction normal generator)
  (: component (-> Flonum))
  (define (component) (- (* 2.0 (random generator)) 1.0))
  (let loop ([candidate (Float3 (component) (component) (component))])
    (define length (Float3-length candidate))
    (cond
      [(< 0.0 length 1.0)
       (define direction (Float3-scale-by-scalar candidate (/ 1.0 length)))
       (if (< (Float3-dot direction normal) 0.0)
           (Float3-scale-by-scalar direction -1.0)
           direction)]
      [else (loop (Float3 (component) (component) (component)))])))

(: Ray-point-at (-> Ray Flonum Float3))
(define (Ray-point-at ray t)
  (Float3-add (Ray-point ray) (Float3-scale-by-scalar (Ray-direction ray) t)))

(: Intersection-empty (-> Intersection))
(define (Intersection-empty)
  (define zero (Float3 0.0 0.0 0.0))
  (Intersection INTERSECTION-T-MAX zero zero zero))

;; The direction is a unit vector. The discriminant is taken where the ray passes the centre.
(: Sphere-intersect (-> Sphere Ray Intersection))
(define (Sphere-intersect sphere ray)
  (define to-center (Float3-subtract (Sphere-point sphere) (Ray-point ray)))
  (define along (Float3-dot to-center (Ray-direction ray)))
  (define aside
    (Float3-subtract to-center (Float3-scale-by-scalar (Ray-direction ray) along)))
  (define discriminant
    (- (* (Sphere-radius sphere) (Sphere-radius sphere)) (Float3-dot aside aside)))
  (cond
    [(< discriminant 0.0) (Intersection-empty)]
    [else
     (define half-chord (flsqrt discriminant))
     (define near (- along half-chord))
     (define t (if (> near 0.0) near (+ along half-chord)))
     (cond
       [(> t 0.0)
        (define point (Ray-point-at ray t))
        (Intersection t point
                      (Float3-normalized (Float3-subtract point (Sphere-point sphere)))
                      (Sphere-color sphere))]
       [else (Intersection-empty)])]))

;; Check every shape to find the nearest hit shape by a given ray.
(: World-nearest-hit (-> World Ray Intersection))
(define (World-nearest-hit world ray)
  (let loop ([nearest-shape (Intersection-empty)]
             [spheres (World-spheres world)])
    (if (null? spheres)
        nearest-shape
        (let ([current-try (Sphere-intersect (car spheres) ray)])
          (loop (if (< (Intersection-t current-try) (Intersection-t nearest-shape))
                    current-try
                    nearest-shape)
                (cdr spheres))))))

;; A point off the surface it is on.
(: offset (-> Float3 Float3 Float3))
(define (offset point normal)
  (Float3-add point (Float3-scale-by-scalar normal (* EPSILON (+ 1.0 (Float3-length point))))))

;; The percentage of ambient light visible at a point: 1 means there is no ambient occlusion.
(: World-get-ambient-percent (-> World Float3 Float3 Flonum))
(define (World-get-ambient-percent world point normal)
  (define point-offset (offset point normal))
  (define samples (World-ambient-samples world))
  (let loop : Flonum ([n 0] [percent : Flonum 0.0])
    (cond
      [(= samples 0) 1.0]
      [(= n samples) (/ percent (->fl samples))]
      [else
       (define hemisphere-ray
         (Ray point-offset (Float3-random-hemisphere-direction normal (World-generator world))))
       (define current-try (World-nearest-hit world hemisphere-ray))
       ;; closer geometry has a greater effect on occlusion
       (define new-percent
         (if (> (Intersection-t current-try) WORLD-MAX-OCCLUSION-DISTANCE)
             1.0
             (/ (Intersection-t current-try) WORLD-MAX-OCCLUSION-DISTANCE)))
       (loop (+ n 1) (+ percent new-percent))])))

;; The shaded color at an intersection point: ambient light, and the sun's where it is not hidden.
(: World-get-color-at (-> World Ray Intersection Float3))
(define (World-get-color-at world ray hit)
  (define point (Intersection-point hit))
  (define view (Float3-scale-by-scalar (Ray-direction ray) -1.0))
  (define normal
    (if (< (Float3-dot view (Intersection-normal hit)) 0.0)
        (Float3-scale-by-scalar (Intersection-normal hit) -1.0)
        (Intersection-normal hit)))
  (define to-sun (World-sun-direction world))
  (define cosine (Float3-dot normal to-sun))
  (define ambient
    (Float3-scale-by-scalar
     (Float3-scale-by-vector (Intersection-color hit) (World-background-color world))
     (World-get-ambient-percent world point normal)))
  (define hidden?
    (or (<= cosine 0.0)
        (< (Intersection-t (World-nearest-hit world (Ray (offset point normal) to-sun)))
           INTERSECTION-T-MAX)))
  (cond
    [hidden? ambient]
    [else
     (define along (Float3-dot (Float3-reflect to-sun normal) view))
     (define highlight (if (> along 0.0) (* SPECULARITY (flexpt along (->fl SHININESS))) 0.0))
     (Float3-add ambient
                 (Float3-scale-by-vector
                  (World-sun-color world)
                  (Float3-add (Float3-scale-by-scalar (Intersection-color hit) cosine)
                              (Float3 highlight highlight highlight))))]))

;; Trace a ray through the world and obtain a color.
(: World-ray-trace (-> World Ray Float3))
(define (World-ray-trace world ray)
  (define nearest-hit (World-nearest-hit world ray))
  (if (< (Intersection-t nearest-hit) INTERSECTION-T-MAX)
      (World-get-color-at world ray nearest-hit)
      (World-background-color world)))

;; --- the library's values as the oracle's ---

(: convert (-> library:Float3 Float3))
(define (convert v)
  (Float3 (library:Float3-x/function v) (library:Float3-y/function v)
          (library:Float3-z/function v)))

(: convert-sphere (-> library:Sphere Sphere))
(define (convert-sphere sphere)
  (Sphere (convert (library:Sphere-point sphere)) (library:Sphere-radius sphere)
          (convert (library:Sphere-color sphere))))

;; oracle-render : the article's picture of the library's spheres (with its surface in their
;; colours), its DistantLight, a background colour and a Camera, one ray through the middle of each
;; pixel, with that many occlusion rays a hit (0 for none): linear RGB, laid out as an Image's
;; pixels.
(: oracle-render (-> (Listof library:Sphere) library:DistantLight library:Float3 library:Camera
                     Index Index Natural FlVector))
(define (oracle-render spheres sun background camera width height ambient-samples)
  (define world
    (World (map convert-sphere spheres)
           (Float3-normalized (convert (library:DistantLight-direction sun)))
           (convert (library:DistantLight-color sun))
           (convert background) ambient-samples
           (vector->pseudo-random-generator (vector 1 2 3 4 5 6))))
  (define eye (convert (library:Camera-eye camera)))
  (define forward (convert (library:Camera-forward camera)))
  (define up (convert (library:Camera-up camera)))
  ;; as wide as the picture
  (define right
    (Float3-scale-by-scalar (Float3-normalized (convert (library:Camera-right camera)))
                            (* (Float3-length up) (/ (->fl width) (->fl height)))))
  (define film (make-flvector (* 3 width height)))
  (for* ([y (in-range height)] [x (in-range width)])
    (define across (- (* 2.0 (/ (+ (->fl x) 0.5) (->fl width))) 1.0))
    (define upwards (- 1.0 (* 2.0 (/ (+ (->fl y) 0.5) (->fl height)))))
    (define direction
      (Float3-normalized
       (Float3-add forward (Float3-add (Float3-scale-by-scalar right across)
                                       (Float3-scale-by-scalar up upwards)))))
    (define color (World-ray-trace world (Ray eye direction)))
    (define place (* 3 (+ x (* y width))))
    (flvector-set! film place (Float3-x color))
    (flvector-set! film (+ place 1) (Float3-y color))
    (flvector-set! film (+ place 2) (Float3-z color)))
  film)
