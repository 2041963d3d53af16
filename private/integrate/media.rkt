#lang typed/racket/base
;; Rays through participating media: where one is scattered before it meets a surface, what is left of
;; a shadow ray's light, and which media are around. Boundaries that are not seen are gone through on
;; the way; what a ray finds is the next thing that matters.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt"
         "../sample/sampler.rkt" "../shape/kernel.rkt"
         "../medium/media.rkt" "../medium/scattering.rkt"
         "../world/scene.rkt" "../world/trace.rkt")

(provide NOTHING SURFACE MEDIUM start-in-media! travel! cross-surface! light-left?
         keep-hit! restore-hit! keep-segment! restore-segment! collision-density)

;; What a ray may come to.
(define-syntax-rule (NOTHING) 0)
(define-syntax-rule (SURFACE) 1)
(define-syntax-rule (MEDIUM) 2)

;; The distances of a vertex have sample dimensions of their own, as many as they may need.
(define-syntax-rule (medium-dimension depth) (fx* 65536 (fx+ depth 1)))

;; More collisions than this on one segment make no picture: the sample is rejected, and counted so.
(define-syntax-rule (MOST-COLLISIONS) 1000000)

;; --- the way to the next vertex ---

;; travel! : from the ray in the scratch to the next vertex. MEDIUM: it is a point in the scratch as
;; put-medium-vertex! leaves it. SURFACE: the hit in the scratch, before Scene-surface!, while the
;; last vertex is still there. `throughput` is what is left, over the chance of what happened.
;; add-lit!: called for each segment along which nothing varies, with its media and their sums in the
;; scratch, before a distance is chosen; it may use all of the scratch but what keep! keeps.
(: travel! (-> Media Scene (U #f (-> FlVector FxVector Void)) Fixnum FlVector FxVector Fixnum))
(define (travel! media scene add-lit! depth r i)
  (flvector-set! r travelled 0.0)
  (copy-places! r surface-point kept-vertex 6)
  (flvector-set! r (fx+ kept-vertex 6) (flvector-ref r surface-error))
  (fxvector-set! i sampler-dimension (medium-dimension depth))
  (let segment ()
    (flvector-set! r ray-limit +inf.0)
    (define hit? (Scene-nearest! scene r i))
    (start-segment! hit? r)
    (define scattered?
      (and (fx> (fxvector-ref i media-count) 0)
           (scatters? media add-lit! r i)))
    (cond
      [scattered?
       (put-medium-vertex! r i)
       (put-densities! media r i)
       (copy-places! r segment-origin last-segment 9)
       (MEDIUM)]
      [(not hit?)
       (restore-vertex! r)
       (NOTHING)]
      [(go-through? media scene r i) (segment)]
      [else
       (restore-vertex! r)
       (SURFACE)])))

(: restore-vertex! (-> FlVector Void))
(define (restore-vertex! r)
  (copy-places! r kept-vertex surface-point 6)
  (flvector-set! r surface-error (flvector-ref r (fx+ kept-vertex 6))))

;; The segment from the ray's origin to its hit.
(: start-segment! (-> Boolean FlVector Void))
(define (start-segment! hit? r)
  (let-float3 ([d (Float3-in r ray-direction)])
    (let ([length (Float3-length d)])
      (Float3-put! r segment-origin (Float3-in r ray-origin))
      (Float3-put! r segment-direction (Float3-scale-by-scalar d (fl/ 1.0 length)))
      (flvector-set! r segment-length
                     (if hit? (fl* length (flvector-ref r hit-t)) +inf.0))
      (flvector-set! r segment-density 0.0))))

;; Whether the hit is a boundary of a medium that is not seen: then the ray goes on behind it, and
;; the media around it are those there.
(: go-through? (-> Media Scene FlVector FxVector Boolean))
(define (go-through? media scene r i)
  (and (Media-boundaries? media)
       (begin
         (Scene-surface! scene r i)
         (and (Media-boundary-only? media (fxvector-ref i hit-material))
              (begin
                (cross-boundary! media media-count r i)
                (flvector-set! r travelled
                               (fl+ (flvector-ref r travelled) (flvector-ref r segment-length)))
                (start-behind! r)
                #t)))))

;; The ray goes on from the surface in the scratch, whose normals still point outwards.
(define-syntax-rule (start-behind! r)
  (let-float3 ([n (Float3-in r surface-normal)] [d (Float3-in r ray-direction)])
    (let ([away (if (fl< (Float3-dot n d) 0.0) -1.0 1.0)])
      (Float3-put! r ray-origin
                   (Float3-multiply-add (Float3-in r surface-point)
                                        (fl* away (flvector-ref r surface-error)) n)))))

;; The same surface's medium, entered or left by the ray.
(: cross-boundary! (-> Media Fixnum FlVector FxVector Void))
(define (cross-boundary! media list r i)
  (define medium (Media-interior media (fxvector-ref i hit-material)))
  (when (fx>= medium 0)
    (if (fl< (Float3-dot (Float3-in r surface-normal) (Float3-in r ray-direction)) 0.0)
        (enter-medium! i list medium)
        (leave-medium! i list medium))))

;; At a surface that was turned to the ray's side: in-direction may lead to its other side.
(: cross-surface! (-> Media Fixnum FlVector FxVector Void))
(define (cross-surface! media list r i)
  (define medium (Media-interior media (fxvector-ref i hit-material)))
  (when (and (fx>= medium 0)
             (fl< (Float3-dot (Float3-in r surface-normal) (Float3-in r in-direction)) 0.0))
    (if (fx= 0 (fxvector-ref i surface-inside))
        (enter-medium! i list medium)
        (leave-medium! i list medium))))

;; --- distances ---

;; Whether the ray is scattered on the segment; then segment-t has the distance.
(: scatters? (-> Media (U #f (-> FlVector FxVector Void)) FlVector FxVector Boolean))
(define (scatters? media add-lit! r i)
  (cond
    [(put-sums! media media-count r i)
     (and (fl< (flvector-ref r segment-length) +inf.0) ; a shape that is not closed
          (tracked? media r i))]
    [(fl= 0.0 (Float3-largest-component (Float3-in r scattering)))
     (put-attenuation! r throughput (flvector-ref r segment-length))
     #f]
    [else
     (when add-lit!
       (add-lit! r i)
       (put-sums! media media-count r i))
     (chosen? r i)]))

;; Where nothing varies: exponential in the extinction of a colour chosen in proportion to what is
;; carried of it, weighted by the balance of the colours' densities; so the sum of what is carried
;; never grows.
(: chosen? (-> FlVector FxVector Boolean))
(define (chosen? r i)
  (sample-next-pair! r i)
  (let-float3 ([carried (Float3-in r throughput)] [e (Float3-in r extinction)])
    (let* ([place (fl* (sum carried) (flvector-ref r sample-u))]
           [own (cond
                  [(fl< place (Float3-x carried)) (Float3-x e)]
                  [(fl< place (fl+ (Float3-x carried) (Float3-y carried))) (Float3-y e)]
                  [else (Float3-z e)])]
           [length (flvector-ref r segment-length)]
           [t (if (fl> own 0.0)
                  (fl/ (fl* -1.0 (fllog (fl- 1.0 (flvector-ref r sample-v)))) own)
                  +inf.0)]
           [end (if (fl< t length) t length)])
      (let-float3 ([left (Float3 (attenuation (Float3-x e) end) (attenuation (Float3-y e) end)
                                 (attenuation (Float3-z e) end))])
        (cond
          [(fl< t length)
           (let ([density (collision-density carried e t)])
             (flvector-set! r segment-t t)
             (flvector-set! r segment-density density)
             (put-throughput! r (fl/ 1.0 density)
                              (Float3-scale-by-vector left (Float3-in r scattering)))
             #t)]
          [else
           (put-throughput! r (fl/ (sum carried)
                                   (sum (Float3-scale-by-vector carried left)))
                            left)
           #f])))))

(define-syntax-rule (sum v0)
  (let-float3 ([v v0]) (fl+ (Float3-x v) (fl+ (Float3-y v) (Float3-z v)))))

;; The density of that choice at a distance t, by what is carried and the extinctions.
(define-syntax-rule (collision-density carried e t0)
  (let ([t t0])
    (fl/ (fl+ (fl* (Float3-x carried) (fl* (Float3-x e) (attenuation (Float3-x e) t)))
              (fl+ (fl* (Float3-y carried) (fl* (Float3-y e) (attenuation (Float3-y e) t)))
                   (fl* (Float3-z carried) (fl* (Float3-z e) (attenuation (Float3-z e) t)))))
         (sum carried))))

(define-syntax-rule (put-throughput! r scale color)
  (Float3-put! r throughput
               (Float3-scale-by-vector (Float3-in r throughput)
                                       (Float3-scale-by-scalar color scale))))

;; Where a density varies: collisions as dense as the majorant, each real or null by chance (Kutz et
;; al., "Spectral and Decomposition Tracking", 2017: chances in proportion to what is carried). While
;; it goes on segment-density has the majorant of all colours.
(: tracked? (-> Media FlVector FxVector Boolean))
(define (tracked? media r i)
  (flvector-set! r segment-t 0.0)
  (flvector-set! r segment-density (Float3-largest-component (Float3-in r extinction)))
  (let collide : Boolean ([count : Fixnum 0])
    (cond
      [(not (next-collision? r i)) (flvector-set! r segment-density 0.0) #f]
      [(fx= count (MOST-COLLISIONS))
       (Float3-put! r radiance (Float3 +nan.0 +nan.0 +nan.0))
       (Float3-put! r throughput (Float3 0.0 0.0 0.0))
       #t]
      [else
       (put-sums-at! media media-count r i)
       (or (real-collision? r) (collide (fx+ count 1)))])))

;; One step further, to surface-point; whether that is still on the segment. The pair's other number
;; is left in sample-v.
(: next-collision? (-> FlVector FxVector Boolean))
(define (next-collision? r i)
  (sample-next-pair! r i)
  (let ([t (fl- (flvector-ref r segment-t)
                (fl/ (fllog (fl- 1.0 (flvector-ref r sample-u)))
                     (flvector-ref r segment-density)))])
    (flvector-set! r segment-t t)
    (and (fl< t (flvector-ref r segment-length))
         (begin
           (Float3-put! r surface-point
                        (Float3-multiply-add (Float3-in r segment-origin) t
                                             (Float3-in r segment-direction)))
           #t))))

(: real-collision? (-> FlVector Boolean))
(define (real-collision? r)
  (let-float3 ([carried (Float3-in r throughput)] [e (Float3-in r extinction)]
               [lost (Float3-scale-by-vector carried e)])
    (let* ([majorant (flvector-ref r segment-density)]
           [all (fl* majorant (sum carried))]
           [chance (if (fl> all 0.0) (fl/ (sum lost) all) 0.0)])
      (cond
        [(fl< (flvector-ref r sample-v) chance)
         (put-throughput! r (fl/ 1.0 (fl* majorant chance)) (Float3-in r scattering))
         (flvector-set! r segment-density 0.0)
         #t]
        [else
         (put-throughput! r (fl/ 1.0 (fl* majorant (fl- 1.0 chance)))
                          (Float3 (fl- majorant (Float3-x e)) (fl- majorant (Float3-y e))
                                  (fl- majorant (Float3-z e))))
         #f]))))

;; --- shadow rays ---

;; light-left? : whether any light comes along the ray in the scratch, from the vertex in the scratch
;; towards in-direction as far as ray-limit; light-radiance is dimmed by what the media take. The
;; vertex and its hit are kept.
(: light-left? (-> Media Scene FlVector FxVector Boolean))
(define (light-left? media scene r i)
  (Float3-put! r transmittance (Float3 1.0 1.0 1.0))
  (define left?
    (cond
      [(Media-boundaries? media)
       (define dimension (fxvector-ref i sampler-dimension))
       (keep-hit! r i)
       (copy-media! i media-count shadow-media-count)
       (cross-surface! media shadow-media-count r i)
       (fxvector-set! i looking 1)
       (define left? (reaches-light? media scene r i))
       (fxvector-set! i looking 0)
       (restore-hit! r i)
       (fxvector-set! i sampler-dimension dimension)
       left?]
      [(Scene-occluded? scene r i) #f]
      [else
       (put-sums! media media-count r i)
       (put-attenuation! r transmittance (flvector-ref r light-distance))
       #t]))
  (and left?
       (let-float3 ([light (Float3-scale-by-vector (Float3-in r light-radiance)
                                                   (Float3-in r transmittance))])
         (Float3-put! r light-radiance light)
         (fl> (Float3-largest-component light) 0.0))))

;; From boundary to boundary.
(: reaches-light? (-> Media Scene FlVector FxVector Boolean))
(define (reaches-light? media scene r i)
  (define limit-place kept-light-limit)
  (flvector-set! r limit-place (flvector-ref r ray-limit))
  (let segment : Boolean ()
    (flvector-set! r ray-limit (flvector-ref r limit-place))
    (define hit? (Scene-nearest! scene r i))
    (start-segment! hit? r)
    (unless hit? (flvector-set! r segment-length (flvector-ref r limit-place)))
    (define light? (or (not hit?)
                       (fx= (fxvector-ref i hit-primitive) (fxvector-ref i ignored-primitive))))
    (define through?
      (or light?
          (begin
            (Scene-surface! scene r i)
            (Media-boundary-only? media (fxvector-ref i hit-material)))))
    (cond
      [(not through?) #f]
      [else
       (attenuate! media r i)
       (or light?
           (begin
             (cross-boundary! media shadow-media-count r i)
             (start-behind! r)
             (flvector-set! r limit-place
                            (fl- (flvector-ref r limit-place) (flvector-ref r segment-length)))
             (segment)))])))

;; Times what the media along the segment leave, into `transmittance`; where a density varies, an
;; estimate of it by ratio tracking (Novak, Selle and Jarosz 2014).
(: attenuate! (-> Media FlVector FxVector Void))
(define (attenuate! media r i)
  (cond
    [(fx= 0 (fxvector-ref i shadow-media-count)) (void)]
    [(not (put-sums! media shadow-media-count r i))
     (put-attenuation! r transmittance (flvector-ref r segment-length))]
    [(fl< (flvector-ref r segment-length) +inf.0)
     (flvector-set! r segment-t 0.0)
     (flvector-set! r segment-density (Float3-largest-component (Float3-in r extinction)))
     (let collide ([count : Fixnum 0])
       (when (and (next-collision? r i) (fx< count (MOST-COLLISIONS)))
         (put-sums-at! media shadow-media-count r i)
         (let-float3 ([e (Float3-in r extinction)])
           (let ([part (fl/ 1.0 (flvector-ref r segment-density))])
             (Float3-put! r transmittance
                          (Float3-scale-by-vector
                           (Float3-in r transmittance)
                           (Float3 (fl- 1.0 (fl* part (Float3-x e)))
                                   (fl- 1.0 (fl* part (Float3-y e)))
                                   (fl- 1.0 (fl* part (Float3-z e))))))))
         (collide (fx+ count 1))))]))

;; --- where the camera is ---

;; start-in-media! : puts the media around the ray's origin on the list: those of shapes that a ray
;; from there leaves without having entered them. Rays from the same point at the same time ask once.
(: start-in-media! (-> Media Scene FlVector FxVector Void))
(define (start-in-media! media scene r i)
  (cond
    [(not (Media-boundaries? media)) (clear-media! media i media-count)]
    [else
     (unless (and (fx>= (fxvector-ref i known-media-count) 0) (same-start? r))
       (clear-media! media i known-media-count)
       (fxvector-set! i shadow-media-count 0)
       (copy-places! r ray-origin kept-for-shadow (SEGMENT-PLACES))
       (copy-places! r ray-origin known-origin 3)
       (flvector-set! r (fx+ known-origin 3) (flvector-ref r ray-time))
       (fxvector-set! i looking 1)
       (find-around! media scene r i)
       (fxvector-set! i looking 0)
       (copy-places! r kept-for-shadow ray-origin (SEGMENT-PLACES)))
     (copy-media! i known-media-count media-count)]))

(define-syntax-rule (same-start? r)
  (and (fl= (flvector-ref r ray-origin) (flvector-ref r known-origin))
       (fl= (flvector-ref r (fx+ ray-origin 1)) (flvector-ref r (fx+ known-origin 1)))
       (fl= (flvector-ref r (fx+ ray-origin 2)) (flvector-ref r (fx+ known-origin 2)))
       (fl= (flvector-ref r ray-time) (flvector-ref r (fx+ known-origin 3)))))

;; A direction along nothing in particular; what was entered is on the shadow ray's list.
(: find-around! (-> Media Scene FlVector FxVector Void))
(define (find-around! media scene r i)
  (Float3-put! r ray-direction (Float3 0.4386198 0.7236743 0.5328871))
  (let segment ()
    (flvector-set! r ray-limit +inf.0)
    (when (Scene-nearest! scene r i)
      (Scene-surface! scene r i)
      (let ([medium (Media-interior media (fxvector-ref i hit-material))])
        (when (fx>= medium 0)
          (let ([pending (fxvector-ref i shadow-media-count)])
            (cond
              [(fl< (Float3-dot (Float3-in r surface-normal) (Float3-in r ray-direction)) 0.0)
               (enter-medium! i shadow-media-count medium)]
              [else
               (leave-medium! i shadow-media-count medium)
               (when (fx= pending (fxvector-ref i shadow-media-count))
                 (enter-medium! i known-media-count medium))]))))
      (start-behind! r)
      (segment))))

;; --- what is kept while other rays are traced ---

;; From ray-origin to surface-error, and from hit-primitive to surface-inside.
(define-syntax-rule (SEGMENT-PLACES) 26)
(define-syntax-rule (HIT-PLACES) 11)

(define-syntax-rule (define-copy name Registers ref set)
  (begin
    (: name (-> Registers Fixnum Fixnum Fixnum Void))
    (define (name registers from to count)
      (let copy ([k : Fixnum 0])
        (when (fx< k count)
          (set registers (fx+ to k) (ref registers (fx+ from k)))
          (copy (fx+ k 1)))))))
(define-copy copy-places! FlVector flvector-ref flvector-set!)
(define-copy copy-numbers! FxVector fxvector-ref fxvector-set!)

;; keep-hit! and restore-hit! : the ray, its hit and its surface, for who looks elsewhere in between.
(: keep-hit! (-> FlVector FxVector Void))
(define (keep-hit! r i)
  (copy-places! r ray-origin kept-for-shadow (SEGMENT-PLACES))
  (copy-numbers! i hit-primitive kept-hit-for-shadow (HIT-PLACES)))

(: restore-hit! (-> FlVector FxVector Void))
(define (restore-hit! r i)
  (copy-places! r kept-for-shadow ray-origin (SEGMENT-PLACES))
  (copy-numbers! i kept-hit-for-shadow hit-primitive (HIT-PLACES)))

;; keep-segment! and restore-segment! : for who lights points of the segment.
(: keep-segment! (-> FlVector FxVector Void))
(define (keep-segment! r i)
  (copy-places! r ray-origin kept-for-segment (SEGMENT-PLACES))
  (copy-places! r segment-origin kept-segment 9)
  (copy-numbers! i hit-primitive kept-hit-for-segment (HIT-PLACES)))

(: restore-segment! (-> FlVector FxVector Void))
(define (restore-segment! r i)
  (copy-places! r kept-for-segment ray-origin (SEGMENT-PLACES))
  (copy-places! r kept-segment segment-origin 9)
  (copy-numbers! i kept-hit-for-segment hit-primitive (HIT-PLACES)))
