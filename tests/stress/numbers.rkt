#lang racket/base
;; S12: zero, denormal, infinite and NaN input, through constructors, kernels and pictures.

(provide cases)

(require racket/flonum racket/list "case.rkt" "../../main.rkt"
         (only-in "../../private/render/render.rkt" render/statistics)
         (only-in "../../private/render/statistics.rkt" Statistics-rejected-samples)
         (prefix-in probe: "../shape/probe.rkt") (only-in "../shape/mesh-examples.rkt" icosphere))

(define black (Float3 0 0 0))
(define (grey x) (Float3 x x x))

(define shapes
  (list (Sphere black 1) (Box (grey -1) (grey 1)) (Cylinder (Float3 0 -1 0) (Float3 0 1 0) 1)
        (Cone (Float3 0 -1 0) 1 (Float3 0 1 0)) (Torus black (Float3 0 0 1) 1 0.4)
        (Plane black (Float3 0 0 1)) (Disk black (Float3 0 0 1) 1)
        (Quad (Float3 -1 -1 0) (Float3 2 0 0) (Float3 0 2 0))
        (Triangle (Float3 -1 -1 0) (Float3 1 -1 0) (Float3 0 1 0)) (icosphere 1)))

;; Hits of rays no one can shoot: a direction that is zero, or any number infinite or NaN.
(define (impossible-hits)
  (for*/sum ([shape (in-list shapes)] [bad (in-list '(+nan.0 +inf.0 -inf.0))]
             [place (in-range 7)] [o (in-list '((0.0 0.0 3.0) (0.1 0.2 0.3)))])
    (define (put l at) (for/list ([x l] [k (in-naturals at)]) (if (= k place) bad x)))
    (define-values (origin direction)
      (if (= place 6)
          (values o '(0.0 -0.0 0.0))
          (values (put o 0) (put '(0.1 0.05 -1.0) 3))))
    (define p (probe:probe shape))
    (if (or (probe:shoot p origin direction +inf.0)
            (probe:shoot-occluded p origin direction +inf.0))
        1
        0)))

;; Of rays with directions from 5e-324 to 1e308 long: hits that are no finite numbers or lie where
;; the shape is not, all rays, and the shapes and lengths whose rays do not end within 5 seconds.
(define (strange-hits size)
  (define uniform (seeded 12))
  (for*/fold ([strange 0] [all 0] [hanging '()])
             ([shape (in-list shapes)]
              [reach (in-list '(5e-324 1e-320 1e-308 1e-200 1e-150 1.0 1e150 1e200 1e308))])
    (define world (World (list shape)))
    (define shot
      (for*/list ([k (in-range (amount 1000 size 20))]
                  [o (in-value (scale 3.0 (random-unit uniform)))]
                  [d (in-value (scale reach (unit (subtract (random-in-ball uniform) o))))]
                  #:unless (andmap zero? d))
        (Ray (point o) (point d))))
    (define found #f)
    (define shooting
      (thread (lambda () (set! found (count (lambda (ray) (strange? world ray)) shot)))))
    (cond
      [(sync/timeout 5 shooting) (values (+ strange found) (+ all (length shot)) hanging)]
      [else
       (kill-thread shooting)
       (values strange all
               (cons (list (object-name shape) reach) hanging))])))

(define (strange? world ray)
  (define found (World-nearest-hit world ray))
  (define t (Intersection-t found))
  (define p (numbers (Intersection-point found)))
  (not (and (> t 0.0) (< t +inf.0) (finite-numbers? (Intersection-point found))
            (finite-numbers? (Intersection-normal found))
            (or (= t INTERSECTION-T-MAX)
                (if (Plane? (car (World-shapes world)))
                    (< (abs (third p)) 1e-12)
                    (< (norm p) 3.0))))))

;; How many of the arguments that no scene can use are taken.
(define (accepted)
  (define bad-points (list (Float3 +nan.0 0 0) (Float3 0 +inf.0 0) (Float3 0 0 -inf.0)))
  (define bad-directions (append bad-points (list black (Float3 0 -0.0 0))))
  (define makers
    (append*
     (append
      (for/list ([bad (in-list bad-points)])
        (list (lambda () (Ray bad (grey 1))) (lambda () (Sphere bad 1)) (lambda () (Box bad (grey 1)))
              (lambda () (Triangle bad black (grey 1))) (lambda () (PointLight bad (grey 1)))
              (lambda () (Plane bad (grey 1))) (lambda () (Emitter bad))
              (lambda () (Mesh (apply flvector (numbers bad)) (fxvector-of-none)))))
      (for/list ([bad (in-list bad-directions)])
        (list (lambda () (Ray black bad)) (lambda () (Plane black bad))
              (lambda () (DistantLight bad (grey 1))) (lambda () (Torus black bad 1 0.4))
              (lambda () (Camera-look-at black bad))))
      (for/list ([bad (in-list '(0 -1 +nan.0 +inf.0))])
        (list (lambda () (Sphere black bad)) (lambda () (Disk black (grey 1) bad)))))))
  (for/sum ([make (in-list makers)])
    (with-handlers ([exn:fail? (lambda (e) (if (regexp-match? #rx"\n" (exn-message e)) 1 0))])
      (make)
      1)))

(define (fxvector-of-none) (Mesh-triangles (icosphere 0)))

;; Lights so strong that sums overflow: NaN or infinite places of the film, and rejected samples.
(define (overflow)
  (define strong (PointLight (Float3 0 0 2) (grey 1e308)))
  (define world (World (list (Sphere black 1.9 (Phong (grey 1)))) (list strong strong) (grey 0.5)
                       #:ambient-samples 0))
  (define-values (image statistics)
    (render/statistics world (Camera-look-at (Float3 0 0 9) black) #:width 64 #:height 36
                       #:samples 4 #:schedule 'sequential))
  (values (for/sum ([x (in-flvector (Image-pixels image))]) (if (< -inf.0 x +inf.0) 0 1))
          (Statistics-rejected-samples statistics)))

(define (unusual size)
  (define-values (strange all hanging) (strange-hits size))
  (define-values (impossible taken) (values (impossible-hits) (accepted)))
  (define-values (bad-pixels rejected) (overflow))
  (values (format (string-append "~a strange of ~a rays, without end: ~a; ~a hits of impossible "
                                 "rays, ~a bad arguments taken, "
                                 "~a bad film values, ~a samples rejected")
                  strange all hanging impossible taken bad-pixels rejected)
          (and (null? hanging) (= 0 strange impossible taken bad-pixels) (> rejected 0))))

(define cases
  (list (stress-case "S12 zero, denormal, infinite and NaN input"
                     "misses or one-line errors, no NaN in the film, rejections counted" unusual)))
