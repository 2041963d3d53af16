#lang typed/racket/base
;; Solids: union, intersection and difference of closed shapes, by classifying where a ray is in
;; each of them (Roth, "Ray Casting for Modeling Solids", 1982).
(require (for-syntax racket/base)
         "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/public.rkt"
         "../base/check.rkt" "../material/material.rkt"
         "kernel.rkt" "shape.rkt" "composite.rkt" "plane.rkt" "disk.rkt" "quad.rkt" "triangle.rkt"
         "cylinder.rkt" "cone.rkt" "instance.rkt" "moving.rkt" "group.rkt")

(provide (struct-out Solid) (struct-out SolidUnion) (struct-out SolidIntersection)
         (struct-out SolidDifference)
         make-SolidUnion make-SolidIntersection make-SolidDifference Solid-kernel)

;; a, b: closed shapes; solids and instances of solids too. material: instead of theirs, or #f.
(struct Solid Composite ([a : Shape] [b : Shape] [material : (U #f Material)]) #:transparent)
(struct SolidUnion Solid () #:transparent)
(struct SolidIntersection Solid () #:transparent)
(struct SolidDifference Solid () #:transparent)

;; SolidUnion : what is in a or in b; no surface of one is left inside the other.
;; SolidIntersection : what is in a and in b. SolidDifference : what is in a and not in b; the
;; surface where b was taken away looks out of a. Each part of the surface has the material of the
;; shape it comes from; #:material, if given, takes the place of all of them. The shapes of a group
;; must not overlap. Surfaces nearer to each other than the errors of their points count as one, so
;; shapes that touch join without a seam. A part that shines is found by scattered rays alone.
;; Raises for a shape that is known to be open and where composites nest too deep; solids of solids
;; are one level, of up to 48 shapes.
(: make-SolidUnion (->* (Shape Shape) (#:material (U #f MaterialOrColor)) SolidUnion))
(define (make-SolidUnion a b #:material [material #f])
  (SolidUnion (check-parts 'SolidUnion a b) a b (and material (->material material))))

(: make-SolidIntersection (->* (Shape Shape) (#:material (U #f MaterialOrColor)) SolidIntersection))
(define (make-SolidIntersection a b #:material [material #f])
  (SolidIntersection (check-parts 'SolidIntersection a b) a b
                     (and material (->material material))))

(: make-SolidDifference (->* (Shape Shape) (#:material (U #f MaterialOrColor)) SolidDifference))
(define (make-SolidDifference a b #:material [material #f])
  (SolidDifference (check-parts 'SolidDifference a b) a b (and material (->material material))))

(define-constructor SolidUnion make-SolidUnion (a b material) #:struct (_ a b material))
(define-constructor SolidIntersection make-SolidIntersection (a b material)
  #:struct (_ a b material))
(define-constructor SolidDifference make-SolidDifference (a b material) #:struct (_ a b material))

;; The nesting of the solid.
(: check-parts (-> Symbol Shape Shape Fixnum))
(define (check-parts who a b)
  (unless (closed? a) (raise-expected who "a" "a closed shape" a))
  (unless (closed? b) (raise-expected who "b" "a closed shape" b))
  (define shapes (append (solid-shapes a) (solid-shapes b)))
  (unless (<= (length shapes) (SHAPE-LIMIT))
    (raise-expected who "b" (format "solids of at most ~a shapes together" (SHAPE-LIMIT))
                    (length shapes)))
  (check-nesting who shapes))

(define-syntax-rule (SHAPE-LIMIT) 48)

;; #f for a shape that has no inside for sure.
(: closed? (-> Shape Boolean))
(define (closed? shape)
  (cond
    [(or (Plane? shape) (Disk? shape) (Quad? shape) (Triangle? shape)) #f]
    [(Cylinder? shape) (Cylinder-caps? shape)]
    [(Cone? shape) (Cone-caps? shape)]
    [(Instance? shape) (closed? (Instance-shape shape))]
    [(Moving? shape) (closed? (Moving-shape shape))]
    [(Group? shape) (andmap closed? (Group-shapes shape))]
    [else #t]))

;; The shapes a tree of solids is made of, from left to right.
(: solid-shapes (-> Shape (Listof Shape)))
(define (solid-shapes shape)
  (if (Solid? shape)
      (append (solid-shapes (Solid-a shape)) (solid-shapes (Solid-b shape)))
      (list shape)))

;; --- a tree of solids as its kernel needs it ---

;; One shape of the tree. turned?: whether an odd number of differences take it away. own: the
;; number of its material; instead: that of the solid's, which covers whatever the shape says.
(struct Part ([kernel : ShapeKernel] [turned? : Boolean] [own : Fixnum] [instead : Fixnum]))

(: solid-parts
   (-> Shape CompileShape NumberMaterial (-> Shape Material) Boolean (U #f Material)
       (Listof Part)))
(define (solid-parts shape compile number material-of turned? outer)
  (cond
    [(Solid? shape)
     (define material (or outer (Solid-material shape)))
     (append (solid-parts (Solid-a shape) compile number material-of turned? material)
             (solid-parts (Solid-b shape) compile number material-of
                          (if (SolidDifference? shape) (not turned?) turned?) material))]
    [else
     (list (Part (compile shape) turned? (number (material-of shape))
                 (if outer (number outer) -1)))]))

;; Whether a place is in the solid, from the records of its parts, which start at a place of the
;; scratch; this shape's is the one with number `first`.
(define-type Membership (-> FlVector Fixnum Boolean))
(: membership (-> Shape Fixnum Membership))
(define (membership shape first)
  (cond
    [(Solid? shape)
     (define in-a? (membership (Solid-a shape) first))
     (define in-b?
       (membership (Solid-b shape)
                   (fx+ first (assert (length (solid-shapes (Solid-a shape))) fixnum?))))
     (cond
       [(SolidUnion? shape)
        (lambda ([r : FlVector] [records : Fixnum]) (or (in-a? r records) (in-b? r records)))]
       [(SolidIntersection? shape)
        (lambda ([r : FlVector] [records : Fixnum]) (and (in-a? r records) (in-b? r records)))]
       [else
        (lambda ([r : FlVector] [records : Fixnum])
          (and (in-a? r records) (not (in-b? r records))))])]
    [else
     (define place (fx* (RECORD-SIZE) first))
     (lambda ([r : FlVector] [records : Fixnum])
       (fl= 1.0 (flvector-ref r (inside (fx+ records place)))))]))

(: solid-bounds (-> Shape CompileShape FlVector))
(define (solid-bounds shape compile)
  (cond
    [(Solid? shape)
     (define a (solid-bounds (Solid-a shape) compile))
     (define b (solid-bounds (Solid-b shape) compile))
     (cond
       [(SolidUnion? shape) (merged-boxes a b flmin flmax)]
       [(SolidIntersection? shape) (merged-boxes a b flmax flmin)]
       [else a])]
    [else (ShapeKernel-bounds (compile shape))]))

;; The box of the lows and highs that are chosen; flat where it would be inside out.
(: merged-boxes
   (-> FlVector FlVector (-> Flonum Flonum Flonum) (-> Flonum Flonum Flonum) FlVector))
(define (merged-boxes a b choose-low choose-high)
  (define box (make-flvector 6 0.0))
  (for ([axis : Nonnegative-Fixnum (in-range 3)])
    (define above (fx+ 3 axis))
    (define low (choose-low (flvector-ref a axis) (flvector-ref b axis)))
    (flvector-set! box axis low)
    (flvector-set! box above
                   (flmax low (choose-high (flvector-ref a above) (flvector-ref b above)))))
  box)

;; --- the walk along a ray ---

;; This level's places of the flonum stack: the registers from the ray to the surface as they were,
;; the parameter where the walk ends, the one up to which events count as one, and a record a part.
;; The fixnum registers of the hit are kept in the same places of the other stack.
(define-syntax-rule (KEPT-FLONUMS) (fx- (fx+ surface-error 1) ray-origin))
(define-syntax-rule (KEPT-FIXNUMS) (fx- (fx+ accept-ties 1) hit-primitive))
(define-syntax-rule (walk-end frame) (fx+ frame (KEPT-FLONUMS)))
(define-syntax-rule (horizon frame) (fx+ (walk-end frame) 1))
(define-syntax-rule (record frame part) (fx+ (fx+ (horizon frame) 1) (fx* (RECORD-SIZE) part)))
(define-syntax-rule (frame-of i) (fx+ flonum-stack (fxvector-ref i stack-base)))

;; A part's next event, where the ray meets its surface: its parameter, infinite for none; how far
;; around it others are not told from it; where a ray goes on behind it; the ray that found it, by
;; its origin and the parameter there; 1.0 where the ray is in the part before the event.
(define-syntax-rule (RECORD-SIZE) 10)
(define-syntax-rule (event at) at)
(define-syntax-rule (reach at) (fx+ at 1))
(define-syntax-rule (behind at) (fx+ at 2))
(define-syntax-rule (origin at) (fx+ at 5))
(define-syntax-rule (started at) (fx+ at 8))
(define-syntax-rule (inside at) (fx+ at 9))

;; No ray is followed through more surfaces than this.
(define-syntax-rule (EVENT-LIMIT) 1000)

;; So many places of the stack are left to the hierarchies above.
(define-syntax-rule (STACK-LIMIT) 560)

(: Solid-kernel (-> Solid CompileShape NumberMaterial (-> Shape Material) ShapeKernel))
(define (Solid-kernel solid compile number material-of)
  (define parts : (Vectorof Part)
    (list->vector (solid-parts solid compile number material-of #f #f)))
  (define count : Fixnum (vector-length parts))
  (define room : Fixnum (record 0 count))
  (define member? (membership solid 0))
  (define stack-size : Fixnum
    (fx+ room (for/fold ([most : Fixnum 0]) ([part (in-vector parts)])
                (greater most (ShapeKernel-stack (Part-kernel part))))))
  (when (fx> stack-size (STACK-LIMIT))
    (raise-expected 'World "shapes" "solids in solids of fewer shapes" solid))

  ;; Looks for the part's next event from the origin in its record; leaves its surface there.
  (: search! (-> Fixnum Fixnum FlVector FxVector Void))
  (define (search! part at r i)
    (define kernel (Part-kernel (vector-ref parts part)))
    (Float3-put! r ray-origin (Float3-in r (origin at)))
    (flvector-set! r ray-limit +inf.0)
    (fxvector-set! i accept-ties 0)
    (cond
      [(in-part i room : Boolean ((ShapeKernel-nearest kernel) r i))
       (in-part i room : Void ((ShapeKernel-surface kernel) r i))
       (put-event! at r)]
      [else
       (flvector-set! r (event at) +inf.0)
       (flvector-set! r (reach at) 0.0)
       (flvector-set! r (inside at) 0.0)]))

  ;; Follows the ray in the scratch, which is kept in the frame, to the first event at which the
  ;; membership changes; the number of its part, or -1.
  (: walk! (-> FlVector FxVector Fixnum))
  (define (walk! r i)
    (define frame (frame-of i))
    (define records (record frame 0))
    (let start ([part : Fixnum 0])
      (when (fx< part count)
        (let ([at (record frame part)])
          (Float3-put! r (origin at) (Float3-in r frame))
          (flvector-set! r (started at) 0.0)
          (search! part at r i))
        (start (fx+ part 1))))
    (let next ([events : Fixnum 0])
      (let* ([nearest (nearest-event frame count r)]
             [at (record frame nearest)])
        (cond
          [(or (fx= events (EVENT-LIMIT))
               (fl= (flvector-ref r (event at)) +inf.0)
               (fl> (flvector-ref r (event at)) (flvector-ref r (walk-end frame))))
           -1]
          [else
           (flvector-set! r (horizon frame)
                          (fl+ (flvector-ref r (event at)) (flvector-ref r (reach at))))
           (let ([changing (cross-events! member? frame count r)])
             (cond
               [(fx>= changing 0) changing]
               [else
                (let go-on ([part : Fixnum 0])
                  (when (fx< part count)
                    (let ([at (record frame part)])
                      (when (up-to-horizon? r frame at)
                        (put-next-start! frame at r)
                        (search! part at r i)))
                    (go-on (fx+ part 1))))
                (next (fx+ events 1))]))]))))

  (: nearest (-> FlVector FxVector Boolean))
  (define (nearest r i)
    (define frame (frame-of i))
    (keep! r i)
    (flvector-set! r (walk-end frame) (flvector-ref r ray-limit))
    (let ([part (walk! r i)])
      (restore! r i (KEPT-FLONUMS) (KEPT-FIXNUMS))
      (and (fx>= part 0)
           (let ([t (flvector-ref r (event (record frame part)))])
             (and (closer? r i t)
                  (begin (flvector-set! r hit-t t) #t))))))

  ;; Walks again: only the event's parameter is kept with a hit.
  (: surface! (-> FlVector FxVector Void))
  (define (surface! r i)
    (define frame (frame-of i))
    (keep! r i)
    (flvector-set! r (walk-end frame) +inf.0)
    (let ([part (walk! r i)])
      (when (fx>= part 0)
        (put-material! i (Part-own (vector-ref parts part)))
        (search! part (record frame part) r i)
        (put-material! i (Part-instead (vector-ref parts part)))
        (when (Part-turned? (vector-ref parts part)) (turn-normals! r))
        (fxvector-set! i (fx+ hit-path (fxvector-ref i nest-level)) part)))
    ;; the ray and hit-t; what else the part knows of its hit is for its texture coordinates
    (restore! r i (fx- (fx+ hit-t 1) ray-origin) 0)
    (fxvector-set! i accept-ties
                   (fxvector-ref i (fx+ (fx+ stack (fxvector-ref i stack-base))
                                        (fx- accept-ties hit-primitive)))))

  (: uv! (-> FlVector FxVector Void))
  (define (uv! r i)
    (define part (vector-ref parts (fxvector-ref i (fx+ hit-path (fxvector-ref i nest-level)))))
    (define part-uv! (ShapeKernel-uv (Part-kernel part)))
    (when (Part-turned? part) (turn-normals! r))
    (in-part i room : Void (part-uv! r i))
    (when (Part-turned? part) (turn-normals! r)))

  (ShapeKernel (solid-bounds solid compile) nearest nearest surface! uv!
               (fx+ 1 (for/fold ([most : Fixnum 0]) ([part (in-vector parts)])
                        (greater most (ShapeKernel-nesting (Part-kernel part)))))
               stack-size))

(define-syntax-rule (greater a b) (let ([x a] [y b]) (if (fx> x y) x y)))

;; The body's value, at the next level of nesting, with this level's places of the stack left alone.
(define-syntax-rule (in-part i room colon type body)
  (let ([base (fxvector-ref i stack-base)])
    (fxvector-set! i stack-base (fx+ base room))
    (let ([result colon type (with-next-level i colon type body)])
      (fxvector-set! i stack-base base)
      result)))

;; Keeps the registers that the walk uses for its own rays, and brings back the first of them.
(define-syntax-rule (keep! r i)
  (let ([frame (frame-of i)] [base (fx+ stack (fxvector-ref i stack-base))])
    (copy-places! flvector-ref flvector-set! r frame ray-origin (KEPT-FLONUMS))
    (copy-places! fxvector-ref fxvector-set! i base hit-primitive (KEPT-FIXNUMS))))
(define-syntax-rule (restore! r i flonums fixnums)
  (let ([frame (frame-of i)] [base (fx+ stack (fxvector-ref i stack-base))])
    (copy-places! flvector-ref flvector-set! r ray-origin frame flonums)
    (copy-places! fxvector-ref fxvector-set! i hit-primitive base fixnums)))
(define-syntax-rule (copy-places! ref set v to from count)
  (let copy ([k : Fixnum 0])
    (when (fx< k count)
      (set v (fx+ to k) (ref v (fx+ from k)))
      (copy (fx+ k 1)))))

;; The record of the event whose surface is in the scratch. A ray goes on from its point moved by
;; the point's error to the side the ray goes to. Along the ray that error is longer by the cosine,
;; but no more than 1024 times.
(: put-event! (-> Fixnum FlVector Void))
(define (put-event! at r)
  (let-float3 ([n (Float3-in r surface-normal)] [d (Float3-in r ray-direction)]
               [point (Float3-in r surface-point)])
    (let* ([along (Float3-dot n d)]
           [error (flvector-ref r surface-error)]
           [t (fl+ (flvector-ref r (started at)) (flvector-ref r hit-t))]
           [leaving? (fl> along 0.0)])
      (flvector-set! r (event at) t)
      (flvector-set! r (reach at)
                     (fl+ (fl/ error (flmax (flabs along)
                                            (fl* 0.0009765625 (Float3-length d))))
                          (fl* (fl* 4.0 (ROUNDING)) t)))
      (Float3-put! r (behind at)
                   (Float3-multiply-add point (if leaving? error (fl* -1.0 error)) n))
      (flvector-set! r (inside at) (if leaving? 1.0 0.0)))))

;; The part goes on behind its event: where the point there is along the kept ray, so that no
;; roundings of the earlier steps add up.
(: put-next-start! (-> Fixnum Fixnum FlVector Void))
(define (put-next-start! frame at r)
  (let-float3 ([point (Float3-in r (behind at))] [d (Float3-in r ray-direction)]
               [from (Float3-in r frame)])
    (let* ([t (fl/ (Float3-dot (Float3-subtract point from) d) (Float3-length-squared d))])
      (Float3-put! r (origin at) point)
      (flvector-set! r (started at) (flmax t (flvector-ref r (event at)))))))

;; The part with the nearest event, the first of several.
(: nearest-event (-> Fixnum Fixnum FlVector Fixnum))
(define (nearest-event frame count r)
  (let scan ([part : Fixnum 1] [best : Fixnum 0])
    (if (fx= part count)
        best
        (scan (fx+ part 1)
              (if (fl< (flvector-ref r (event (record frame part)))
                       (flvector-ref r (event (record frame best))))
                  part
                  best)))))

(define-syntax-rule (up-to-horizon? r frame at)
  (fl<= (flvector-ref r (event at))
        (fl+ (flvector-ref r (horizon frame)) (flvector-ref r (reach at)))))

;; Takes the membership across all events up to the horizon. Where it changes, the part that did
;; it; else -1.
(: cross-events! (-> Membership Fixnum Fixnum FlVector Fixnum))
(define (cross-events! member? frame count r)
  (define records (record frame 0))
  (define before (member? r records))
  (let cross ([part : Fixnum 0] [now : Boolean before] [changing : Fixnum -1])
    (if (fx= part count)
        (if (eq? now before) -1 changing)
        (let ([at (record frame part)])
          (cond
            [(up-to-horizon? r frame at)
             (flvector-set! r (inside at) (fl- 1.0 (flvector-ref r (inside at))))
             (let ([then (member? r records)])
               (cross (fx+ part 1) then (if (eq? then now) changing part)))]
            [else (cross (fx+ part 1) now changing)])))))

(define-syntax-rule (turn-normals! r)
  (begin
    (Float3-put! r surface-normal (Float3-negate (Float3-in r surface-normal)))
    (Float3-put! r surface-shading-normal (Float3-negate (Float3-in r surface-shading-normal)))))
