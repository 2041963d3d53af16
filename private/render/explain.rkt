#lang racket/base
;; Why a pixel looks as it does: its paths, what they hit, which lights were sampled, and where the
;; light came from. The pixel is rendered by the renderer's own worker over an observed world, so
;; that what is explained is the pixel of the picture to the bit.
(require racket/flonum racket/fixnum racket/lazy-require racket/list racket/match
         (only-in "../base/float3.rkt" make-Float3 Float3?)
         (only-in "../base/check.rkt" raise-expected)
         (only-in "../material/emitter.rkt" Emitter?)
         (only-in "../material/interior.rkt" Interior? Interior-surface)
         (only-in "../world/world.rkt" World? World-shapes World-lights World-background World-scene)
         (only-in "../world/camera.rkt" Camera?)
         (only-in "../world/scene.rkt" Scene-materials Scene-lights Scene-primitive-lights
                  Scene-background-light)
         (only-in "../integrate/observe.rkt" World-observed PLACES)
         (only-in "../integrate/integrators.rkt" check-integrator)
         (only-in "../sample/filter.rkt" check-filter)
         (only-in "../image/image.rkt" Image-pixels Image-standard-error)
         "job.rkt" "film.rkt" (only-in "pixel.rkt" Tiling))

(lazy-require ["explanation.rkt" (write-explanation)])

(provide explain (struct-out Explanation) (struct-out Path) (struct-out Vertex)
         (struct-out Within) (struct-out LightSample) (struct-out Onward) (struct-out Miss))

;; Places in the registers.
(define-syntax-rule (define-places name ...)
  (begin (define name (hash-ref PLACES 'name)) ...))
(define-places hit-t hit-material surface-point surface-normal surface-shading-normal surface-color
  ray-direction in-direction bsdf-weight bsdf-density light-distance light-density
  throughput radiance film-x film-y nearest-rays occlusion-rays looking)

;; color: the pixel of the picture. standard-error: of its channels, #f with one sample. rays: per
;; sample. sources: where the light came from, a list of pairs of a source (a shape that shines, a
;; light, 'background or 'ambient) and its part of the colour, brightest first. depths: the parts by
;; the number of bounces on the way. paths: all samples. They add up to the colour up to rounding.
(struct Explanation (x y samples color standard-error rays sources depths paths) #:transparent
  #:property prop:custom-write
  (lambda (explanation port mode) (write-explanation explanation port)))

;; film-x, film-y: where the sample is in the picture, in pixels. color: what it brings; rejected?:
;; whether that was no finite number of at least 0, so that 0 took its place. steps: Vertex and
;; Within ..., perhaps a Miss.
(struct Path (film-x film-y color rejected? steps) #:transparent)

;; depth: bounces so far. t: the ray's parameter. inside?: whether the ray came from inside.
;; throughput: the part of the light from here that reaches the pixel. emitted: what the surface's
;; own light brings, times emission-weight, that of multiple importance sampling. ambient: what the
;; article's ambient light brings. lights: LightSample ... onward: #f where nothing was sampled.
(struct Vertex (depth shape material t point normal inside? throughput emitted emission-weight
                ambient lights onward)
  #:transparent)

;; Inside a medium, between surfaces. point: where the path is scattered; #f where it is not, but lights
;; were sampled on the way. onward: #f where it is not, or ends.
(struct Within (depth point lights onward) #:transparent)

;; light: a shape that shines, a light, or 'background. pdf: of the sample, with the choice among
;; lights, per solid angle; infinite for lights without a size. weight: by multiple importance
;; sampling, #f where the article's shading has none. outcome: 'lit, 'shadowed, or 'dark where
;; nothing could arrive. contribution: to the sample.
(struct LightSample (light distance pdf weight outcome contribution) #:transparent)

;; direction: where the path goes on; pdf: of that choice, infinite for mirrors and glass; weight:
;; value times cosine over pdf.
(struct Onward (direction pdf weight) #:transparent)

;; A ray that hit nothing: what it sees there, its weight, and what that brings.
(struct Miss (depth direction color weight contribution) #:transparent)

;; explain : how the pixel in column x and row y comes about, in a picture of #:width x #:height
;; pixels; the other arguments as render takes them. Raises exn:fail:contract outside the picture.
(define (explain world camera x y #:width [width 640] #:height [height 360]
                 #:samples [samples 16] #:seed [seed 0] #:sampler [sampler 'owen-sobol]
                 #:filter [filter 'box] #:integrator [integrator 'auto]
                 #:max-depth [max-depth #f])
  (define (check-whole argument value low high)
    (unless (and (exact-integer? value) (<= low value high))
      (raise-expected 'explain argument (format "a whole number from ~a to ~a" low high) value)))
  (unless (World? world) (raise-expected 'explain "world" "a World" world))
  (unless (Camera? camera) (raise-expected 'explain "camera" "a Camera" camera))
  (check-whole "width" width 1 100000)
  (check-whole "height" height 1 100000)
  (check-whole "x" x 0 (- width 1))
  (check-whole "y" y 0 (- height 1))
  (check-whole "samples" samples 1 1000000)
  (check-whole "seed" seed 0 #xFFFFFFFF)
  (check-integrator integrator)
  (check-filter filter)
  (when max-depth (check-whole "max-depth" max-depth 0 1000000000))
  (define recorder (make-recorder world))
  (define job
    (Job (World-observed world (recorder-see recorder)) camera
         (Tiling width height 1 (list x y 1 1)) samples seed sampler filter integrator max-depth
         #f))
  (define target (Job-target job make-flvector))
  ((Job-worker job target #:observe (recorder-observe recorder)) 0 #f)
  (define image (Target-image target 1 1))
  (define paths ((recorder-paths recorder)))
  (define-values (sources depths) (summary paths))
  (Explanation x y samples (color-at (Image-pixels image) 0)
               (let ([errors (Image-standard-error image)]) (and errors (color-at errors 0)))
               (/ (+ (Target-total target tally-nearest-place) (Target-total target tally-occlusion-place))
                  (exact->inexact samples))
               sources depths paths))

(define (color-at v at)
  (make-Float3 (flvector-ref v at) (flvector-ref v (+ at 1)) (flvector-ref v (+ at 2))))

;; ----------------------------------------------------------------------------------------------
;; Recording. What is added to the radiance between two events belongs to the first of them.

;; see: what World-observed calls. observe: what Job-worker calls. paths: all so far, in order.
(struct recorder (see observe paths))

;; A step that is being put together, the newest light first.
(struct draft (kind facts lights onward) #:mutable)

(define (make-recorder world)
  (define scene (World-scene world))
  (define shapes (list->vector (World-shapes world)))
  (define materials (Scene-materials scene))
  (define light-of (light-names world scene))
  (define paths '())
  (define steps '())
  (define depth 0)
  (define before '(0.0 0.0 0.0))
  (define book void)
  (define occluded-before 0)
  (define obstacle? #f) ; whether the last shadow ray came upon one, where it looks at what it meets

  (define (radiance-now r) (places r radiance))
  ;; Books what was added since the last event, and says who is next.
  (define (turn! r next)
    (define now (radiance-now r))
    (book (map - now before))
    (set! before now)
    (set! book next))

  ;; Boundaries of media that are not seen are gone through, by shadow rays too.
  (define (see event number r i)
    (define surface? (eq? event 'surface))
    (cond
      [(and surface? (boundary? (vector-ref materials (fxvector-ref i hit-material)))) (void)]
      [(and surface? (fx= 1 (fxvector-ref i looking))) (set! obstacle? #t)]
      [(and surface? (seen-before? r)) (void)]
      [else (record event number r i)]))

  ;; Where there are media a surface is looked at once to know whether it is a boundary, and again.
  (define (seen-before? r)
    (and (pair? steps)
         (eq? 'vertex (draft-kind (car steps)))
         (open? (car steps))
         (null? (draft-lights (car steps)))
         (equal? (color-at r surface-point) (hash-ref (draft-facts (car steps)) 'point))))

  (define (record event number r i)
    (case event
      [(surface)
       (turn! r void)
       (define facts (make-hasheq))
       (hash-set*! facts 'depth depth 'shape (vector-ref shapes number)
                   'material (vector-ref materials (fxvector-ref i hit-material))
                   't (flvector-ref r hit-t) 'point (color-at r surface-point)
                   'normal (color-at r surface-shading-normal)
                   'inside? (positive? (apply + (map * (places r surface-normal)
                                                     (places r ray-direction))))
                   'throughput (color-at r throughput)
                   'weight (flvector-ref r light-density))
       (define vertex (draft 'vertex facts '() #f))
       (set! steps (cons vertex steps))
       (set! depth (+ depth 1))
       (set! book (lambda (light) (hash-set! facts 'emitted light)))]
      [(light)
       (turn! r void)
       (define sample (draft 'light (make-hasheq) '() #f))
       (define facts (draft-facts sample))
       (set! occluded-before (fxvector-ref i occlusion-rays))
       (hash-set*! facts 'light (light-of number) 'distance (flvector-ref r light-distance)
                   'pdf (flvector-ref r light-density) 'weight #f)
       (set! obstacle? #f)
       (unless (and (pair? steps) (open? (car steps)))
         (define facts (make-hasheq))
         (hash-set! facts 'depth depth)
         (set! steps (cons (draft 'within facts '() #f) steps)))
       (define vertex (car steps))
       (set-draft-lights! vertex (cons sample (draft-lights vertex)))
       (set! book (lambda (light)
                    (hash-set*! facts 'contribution light
                                'shadow? (or obstacle?
                                             (> (fxvector-ref i occlusion-rays) occluded-before)))))]
      [(evaluated)
       (define samples (draft-lights (car steps)))
       (unless (null? samples)
         (define pdf (flvector-ref r light-density))
         (define other (flvector-ref r bsdf-density))
         (hash-set*! (draft-facts (car samples)) 'pdf pdf
                     'weight (if (= pdf +inf.0) 1.0 (/ 1.0 (+ 1.0 (expt (/ other pdf) 2))))))]
      [(scattered)
       (turn! r void)
       (set-draft-onward! (car steps) (onward-now r))]
      [(within)
       (turn! r void)
       (unless (and (pair? steps) (open? (car steps)))
         (set! steps (cons (draft 'within (make-hasheq) '() #f) steps)))
       (hash-set*! (draft-facts (car steps)) 'depth depth 'point (color-at r surface-point))
       (set-draft-onward! (car steps) (onward-now r))
       (set! depth (+ depth 1))]
      [(background)
       (turn! r void)
       (define facts (make-hasheq))
       (hash-set*! facts 'depth depth 'direction (color-at r ray-direction)
                   'color (color-at r surface-color))
       (set! steps (cons (draft 'miss facts '() #f) steps))
       (set! book (lambda (light)
                    (hash-set*! facts 'contribution light
                                'weight (flvector-ref r light-density))))]))

  (define (onward-now r)
    (Onward (color-at r in-direction) (flvector-ref r bsdf-density) (color-at r bsdf-weight)))

  (define ((observe integrator) r i)
    (set! steps '())
    (set! depth 0)
    (set! before '(0.0 0.0 0.0))
    (set! book void)
    (integrator r i)
    (define color (radiance-now r))
    (turn! r void)
    (define rejected? (not (andmap (lambda (c) (and (>= c 0.0) (< c +inf.0))) color)))
    (set! paths (cons (Path (flvector-ref r film-x) (flvector-ref r film-y)
                            (list->color color) rejected? (map finished (reverse steps)))
                      paths)))
  (recorder see observe (lambda () (reverse paths))))

(define (places r at) (list (flvector-ref r at) (flvector-ref r (+ at 1)) (flvector-ref r (+ at 2))))
(define (list->color parts) (apply make-Float3 parts))

;; A vertex, or a medium, where more may happen.
(define (open? step) (not (or (draft-onward step) (eq? (draft-kind step) 'miss))))

(define (boundary? material) (and (Interior? material) (not (Interior-surface material))))

(define (finished step)
  (define (value key [default #f]) (hash-ref (draft-facts step) key default))
  (define (light key) (list->color (value key '(0.0 0.0 0.0))))
  (case (draft-kind step)
    [(miss) (Miss (value 'depth) (value 'direction) (value 'color) (value 'weight 1.0)
                  (light 'contribution))]
    [(within) (Within (value 'depth) (value 'point) (map finished (reverse (draft-lights step)))
                      (draft-onward step))]
    [(light)
     (LightSample (value 'light) (value 'distance) (value 'pdf) (value 'weight)
                  (cond [(ormap positive? (value 'contribution '(0.0))) 'lit]
                        [(value 'shadow?) 'shadowed]
                        [else 'dark])
                  (light 'contribution))]
    [else
     (define shines? (Emitter? (value 'material)))
     (define black (make-Float3 0 0 0))
     (Vertex (value 'depth) (value 'shape) (value 'material) (value 't) (value 'point)
             (value 'normal) (value 'inside?) (value 'throughput)
             (if shines? (light 'emitted) black) (value 'weight)
             (if shines? black (light 'emitted))
             (map finished (reverse (draft-lights step))) (draft-onward step))]))

;; A procedure from the number of a light in a compiled world to what it is there. Shapes that shine
;; come first, in order; the parts of a composite have as many numbers as they are.
(define (light-names world scene)
  (define-values (starts next)
    (for/fold ([starts '()] [next 0])
              ([number (in-fxvector (Scene-primitive-lights scene))]
               [shape (in-list (World-shapes world))] #:unless (= number -1))
      (define start (if (< number 0) next number))
      (values (cons (cons start shape) starts) (+ start 1))))
  (define count (vector-length (Scene-lights scene)))
  (define background (Scene-background-light scene))
  (define lights (World-lights world))
  (define first-light (- (if (< background 0) count background) (length lights)))
  (lambda (number)
    (cond
      [(= number background) 'background]
      [(>= number first-light) (list-ref lights (- number first-light))]
      [else (for/first ([start (in-list starts)] #:when (<= (car start) number)) (cdr start))])))

;; ----------------------------------------------------------------------------------------------

;; The pixel's light by source and by bounces, each the mean over the paths.
(define (summary paths)
  (define sources (make-hasheq))
  (define depths (make-hasheqv))
  (define count (length paths))
  (define (add! source depth color)
    (define light (map (lambda (c) (/ c count)) (Float3->list color)))
    (when (ormap (lambda (c) (> c 0.0)) light)
      (hash-update! sources source (lambda (sum) (map + sum light)) '(0.0 0.0 0.0))
      (hash-update! depths depth (lambda (sum) (map + sum light)) '(0.0 0.0 0.0))))
  (for* ([path (in-list paths)] #:unless (Path-rejected? path) [step (in-list (Path-steps path))])
    (match step
      [(Miss depth _ _ _ light) (add! 'background depth light)]
      [(Within depth _ lights _)
       (for ([sample (in-list lights)])
         (add! (LightSample-light sample) (+ depth 1) (LightSample-contribution sample)))]
      [(? Vertex?)
       (define depth (Vertex-depth step))
       (add! (Vertex-shape step) depth (Vertex-emitted step))
       (add! 'ambient (+ depth 1) (Vertex-ambient step))
       (for ([sample (in-list (Vertex-lights step))])
         (add! (LightSample-light sample) (+ depth 1) (LightSample-contribution sample)))]))
  (define (pairs table) (for/list ([(key sum) (in-hash table)]) (cons key (list->color sum))))
  (values (sort (pairs sources) > #:key (lambda (p) (apply + (Float3->list (cdr p)))))
          (sort (pairs depths) < #:key car)))

(define (Float3->list color) (cdr (vector->list (struct->vector color))))
