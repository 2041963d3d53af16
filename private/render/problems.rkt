#lang racket/base
;; What is probably a mistake in a world and its camera, found by looking at it as a person would.
(require racket/flonum racket/list
         (only-in "../base/float3.rkt" make-Float3 Float3-dot/function Float3-x/function
                  Float3-y/function Float3-z/function)
         (only-in "../base/check.rkt" raise-expected)
         (only-in "../shape/kernel.rkt" ShapeKernel-bounds)
         (only-in "../shape/kernels.rkt" Shape-kernel Shape-material)
         (only-in "../material/kernel.rkt" MaterialKernel-transmits?)
         (only-in "../material/kernels.rkt" Material-kernel)
         (only-in "../material/emitter.rkt" Emitter?)
         (only-in "../light/point.rkt" PointLight? PointLight-point)
         (only-in "../light/spot.rkt" SpotLight? SpotLight-point)
         (only-in "../world/ray.rkt" make-Ray Intersection-t Intersection-normal)
         (only-in "../world/world.rkt" World? World-shapes World-lights World-background
                  World-background-color World-scene World-shading Shading-ambient-color)
         (only-in "../world/scene.rkt" Scene-materials)
         (only-in "../world/background.rkt" GradientSky? GradientSky-bottom GradientSky-top)
         (only-in "../world/camera.rkt" Camera? Camera-eye)
         (only-in "../integrate/query.rkt" Shape-intersect)
         (only-in "../image/image.rkt" Image-pixels)
         "render.rkt" "statistics.rkt")

(provide World-problems)

;; World-problems : a list of strings, each one thing that is probably wrong and what to do about it;
;; empty where nothing looks wrong. A small picture is rendered to see: #:integrator, #:max-depth
;; as render takes them, #:aspect its width for a height of 1.
(define (World-problems world camera #:integrator [integrator 'auto] #:max-depth [max-depth #f]
                        #:aspect [aspect 16/9])
  (unless (World? world) (raise-expected 'World-problems "world" "a World" world))
  (unless (Camera? camera) (raise-expected 'World-problems "camera" "a Camera" camera))
  (unless (and (real? aspect) (< 0 aspect +inf.0))
    (raise-expected 'World-problems "aspect" "a positive finite number" aspect))
  (define bodies (for/list ([shape (in-list (World-shapes world))]) (body shape (shape-box shape))))
  (define dark (no-light world))
  (define enclosed (append (enclosed-camera bodies camera) (enclosed-lights bodies world camera)))
  (define unseen (unseen-shapes bodies world camera aspect))
  (append dark enclosed unseen
          (strange-picture world camera integrator max-depth aspect
                           (or (pair? dark) (pair? enclosed) (pair? unseen)))))

;; A shape with the flvector of its box.
(struct body (shape box))

(define (shape-box shape) (ShapeKernel-bounds (Shape-kernel shape)))
(define (bounded? box) (for/and ([x (in-flvector box)]) (< (abs x) +inf.0)))

(define (coordinates v) (list (Float3-x/function v) (Float3-y/function v) (Float3-z/function v)))
(define (box-low box) (for/list ([k (in-range 3)]) (flvector-ref box k)))
(define (box-high box) (for/list ([k (in-range 3 6)]) (flvector-ref box k)))
(define (box-middle box)
  (for/list ([low (in-list (box-low box))] [high (in-list (box-high box))]) (/ (+ low high) 2.0)))
(define (box-holds? box point)
  (for/and ([low (in-list (box-low box))] [high (in-list (box-high box))] [x (in-list point)])
    (< low x high)))
(define (box-holds-box? outer inner)
  (and (andmap <= (box-low outer) (box-low inner)) (andmap >= (box-high outer) (box-high inner))))

;; ----------------------------------------------------------------------------------------------

;; Directions along no edge or diagonal of what people build.
(define directions
  (for*/list ([x (in-list '(-1 0 1))] [y (in-list '(-1 0 1))] [z (in-list '(-1 0 1))]
              #:unless (= 0 x y z))
    (make-Float3 (+ x 0.0123) (+ y 0.0271) (+ z -0.0317))))

;; Whether every ray from the point meets the shape from inside.
(define (inside? body point)
  (and (bounded? (body-box body))
       (box-holds? (body-box body) point)
       (for/and ([direction (in-list directions)])
         (define hit (Shape-intersect (body-shape body) (make-Ray (apply make-Float3 point) direction)))
         (and (< (Intersection-t hit) 1e299)
              (> (Float3-dot/function direction (Intersection-normal hit)) 0.0)))))

(define (opaque? body)
  (not (MaterialKernel-transmits? (Material-kernel (Shape-material (body-shape body))))))
(define (shines? body) (Emitter? (Shape-material (body-shape body))))

;; A room is no mistake: there the camera and all else are in the same shape.
(define (enclosed-camera bodies camera)
  (define eye (coordinates (Camera-eye camera)))
  (for/list ([it (in-list bodies)]
             #:when (and (inside? it eye) (not (shines? it)) (opaque? it)
                         (for/or ([other (in-list bodies)])
                           (and (not (eq? other it)) (bounded? (body-box other))
                                (not (box-holds-box? (body-box it) (body-box other)))))))
    (format "the camera is inside ~a and sees nothing but its inside; move the eye out of it"
            (short-text (body-shape it)))))

(define (enclosed-lights bodies world camera)
  (define eye (coordinates (Camera-eye camera)))
  (define places
    (append
     (for*/list ([light (in-list (World-lights world))]
                 [point (in-value (cond [(PointLight? light) (PointLight-point light)]
                                        [(SpotLight? light) (SpotLight-point light)]
                                        [else #f]))]
                 #:when point)
       (list light (coordinates point) #f))
     (for/list ([it (in-list bodies)] #:when (and (shines? it) (bounded? (body-box it))))
       (list (body-shape it) (box-middle (body-box it)) (body-box it)))))
  (for*/list ([place (in-list places)] [it (in-list bodies)]
              #:unless (eq? (body-shape it) (car place))
              ;; a lamp inside a lamp is not missed
              #:when (and (or (not (caddr place))
                              (and (not (shines? it)) (box-holds-box? (body-box it) (caddr place))))
                          (inside? it (cadr place))
                          (opaque? it)
                          (not (inside? it eye))))
    (format "the light ~a is inside ~a, and none of its light gets out; move it, or let the shape shine"
            (short-text (car place)) (short-text (body-shape it)))))

;; ----------------------------------------------------------------------------------------------

(define (black? color) (andmap (lambda (c) (= c 0.0)) (coordinates color)))

(define (no-light world)
  (define background (World-background world))
  (if (and (null? (World-lights world))
           (not (for/or ([material (in-vector (Scene-materials (World-scene world)))])
                  (Emitter? material)))
           (if (GradientSky? background)
               (and (black? (GradientSky-bottom background)) (black? (GradientSky-top background)))
               (black? (World-background-color world)))
           (black? (Shading-ambient-color (World-shading world))))
      (list (string-append "there is no light: no light is listed, no shape has an Emitter, and the "
                           "background is black; add a light or brighten the background"))
      '()))

(define ROWS 60)
(define (columns aspect) (max 1 (min 600 (inexact->exact (round (* ROWS aspect))))))

(define (unseen-shapes bodies world camera aspect)
  (define depths
    (Image-pixels (render world camera #:width (columns aspect) #:height ROWS #:samples 4
                          #:integrator 'depth #:schedule 'sequential)))
  (cond
    [(null? bodies) (list "there are no shapes: the picture shows the background alone")]
    [(for/or ([t (in-flvector depths)]) (> t 0.0)) '()]
    [else
     (define boxes (filter bounded? (map body-box bodies)))
     (define middle
       (and (pair? boxes)
            (for/list ([low (in-list (apply map min (map box-low boxes)))]
                       [high (in-list (apply map max (map box-high boxes)))])
              (/ (+ low high) 2.0))))
     (list (string-append
            "the camera sees no shape: it looks away from all of them, or they are too small or far"
            (if middle
                (format "; their middle is at ~v" (apply make-Float3 middle))
                "")))]))

;; What a render shows. Black and white are told where no reason for them has been found already.
(define (strange-picture world camera integrator max-depth aspect explained?)
  (define-values (image statistics)
    (render/statistics world camera #:width (columns aspect) #:height ROWS #:samples 4
                       #:integrator integrator #:max-depth max-depth))
  (define pixels (Image-pixels image))
  (define brightest
    (for/list ([at (in-range 0 (flvector-length pixels) 3)])
      (max (flvector-ref pixels at) (flvector-ref pixels (+ at 1)) (flvector-ref pixels (+ at 2)))))
  (define darkest
    (for/list ([at (in-range 0 (flvector-length pixels) 3)])
      (min (flvector-ref pixels at) (flvector-ref pixels (+ at 1)) (flvector-ref pixels (+ at 2)))))
  (define pixel-count (length brightest))
  (define median (list-ref (sort darkest <) (quotient pixel-count 2)))
  (define rejected (Statistics-first-rejected statistics))
  (append
   (cond
     [explained? '()]
     [(> BLACK (apply max brightest))
      (list (string-append "the picture is black: light does not reach what the camera sees, or it "
                           "is too weak; turn lights towards the scene, or make them brighter"))]
     [(> (count-above darkest WHITE) (* 0.99 pixel-count))
      (list (format (string-append "the picture is white: half of its pixels are above ~a, where 1 is "
                                   "white; divide the lights and the background by about that")
                    (/ (round (* 10.0 median)) 10.0)))]
     [else '()])
   (if rejected
       (list (format "~a of its samples are no numbers of at least 0, as at column ~a and row ~a of ~ax~a"
                     (Statistics-rejected-samples statistics) (car rejected) (cadr rejected)
                     (columns aspect) ROWS))
       '())))

;; Below half a step of an 8-bit file; and above white even where an even background of 1 is seen.
(define BLACK (/ 0.5 255.0 12.92))
(define WHITE 1.1)

(define (count-above values limit) (count (lambda (x) (> x limit)) values))

(define (short-text value)
  (define text (format "~v" value))
  (if (> (string-length text) 100) (string-append (substring text 0 97) "...") text))
