#lang typed/racket/base
;; The media of a scene, packed, and what a worker knows of those around its ray: lists of numbers in
;; the scratch, their sums, and the light that is left behind a length of them.
(require "../base/unsafe.rkt" "../base/registers.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../material/material.rkt" "../material/interior.rkt" "medium.rkt")

(provide (struct-out Media) pack-media Media-interior Media-boundary-only?
         clear-media! copy-media! enter-medium! leave-medium!
         put-sums! put-sums-at! put-densities! put-attenuation! attenuation medium-place)

;; packed: of every medium extinction and scattering at density 1, anisotropy and majorant.
;; densities: by medium, #f for the same everywhere. interiors: by material the medium inside the
;; shape, or -1; seen?: 1 where the boundary is a surface too. world: the medium everywhere, or -1.
;; boundaries?: whether any shape has a medium inside.
(struct Media
  ([packed : FlVector] [densities : (Vectorof (U #f Density))]
   [interiors : FxVector] [seen? : FxVector] [world : Fixnum] [boundaries? : Boolean]))

(define-syntax-rule (MEDIUM-PLACES) 8)
(define-syntax-rule (medium-place medium) (fx* (MEDIUM-PLACES) medium))

;; So many may overlap at one place.
(define-syntax-rule (MOST-MEDIA) 8)

;; pack-media : the media that materials and the world have; #f where there are none, so that paths
;; need not ask.
(: pack-media (-> (Vectorof Material) (U #f Medium) (U #f Media)))
(define (pack-media materials world)
  (define interiors (make-fxvector (vector-length materials) -1))
  (define seen? (make-fxvector (vector-length materials) 1))
  (define shapes-media
    (for/fold ([media : (Listof Medium) '()])
              ([material (in-vector materials)]
               [k : Nonnegative-Fixnum (in-range (vector-length materials))]
               #:when (Interior? material))
      (fxvector-set! interiors k (length media))
      (fxvector-set! seen? k (if (Interior-surface material) 1 0))
      (cons (Interior-medium material) media)))
  (define all (append (reverse shapes-media) (if world (list world) '())))
  (and (pair? all)
       (Media (pack all)
              (for/vector : (Vectorof (U #f Density)) ([medium (in-list all)])
                (Medium-density medium))
              interiors seen? (if world (- (length all) 1) -1) (pair? shapes-media))))

(: pack (-> (Listof Medium) FlVector))
(define (pack media)
  (define packed (make-flvector (* (MEDIUM-PLACES) (length media)) 0.0))
  (for ([medium (in-list media)] [k : Nonnegative-Fixnum (in-range (length media))])
    (define at (medium-place k))
    (Float3-put! packed at (Medium-extinction medium))
    (Float3-put! packed (fx+ at 3)
                 (Float3-scale-by-vector (Medium-extinction medium) (Medium-albedo medium)))
    (flvector-set! packed (fx+ at 6) (Medium-anisotropy medium))
    (flvector-set! packed (fx+ at 7) (if (Medium-density medium) (Medium-majorant medium) 1.0)))
  packed)

;; The medium inside shapes of that material number, or -1; a point in a medium has number -1.
(: Media-interior (-> Media Fixnum Fixnum))
(define (Media-interior media material)
  (if (fx< material 0) -1 (fxvector-ref (Media-interiors media) material)))

;; Whether shapes of that material are nothing but the boundary of a medium.
(: Media-boundary-only? (-> Media Fixnum Boolean))
(define (Media-boundary-only? media material)
  (fx= 0 (fxvector-ref (Media-seen? media) material)))

;; --- lists of media in the scratch: a count, then numbers ---

(: clear-media! (-> Media FxVector Fixnum Void))
(define (clear-media! media i list)
  (define world (Media-world media))
  (cond
    [(fx< world 0) (fxvector-set! i list 0)]
    [else (fxvector-set! i list 1)
          (fxvector-set! i (fx+ list 1) world)]))

(: copy-media! (-> FxVector Fixnum Fixnum Void))
(define (copy-media! i from to)
  (let copy ([k : Fixnum (fxvector-ref i from)])
    (fxvector-set! i (fx+ to k) (fxvector-ref i (fx+ from k)))
    (when (fx> k 0) (copy (fx- k 1)))))

(: enter-medium! (-> FxVector Fixnum Fixnum Void))
(define (enter-medium! i list medium)
  (define count (fx+ 1 (fxvector-ref i list)))
  (when (fx> count (MOST-MEDIA))
    (raise-expected 'World "media" (format "at most ~a that overlap" (MOST-MEDIA)) count))
  (fxvector-set! i list count)
  (fxvector-set! i (fx+ list count) medium))

;; The latest of that number goes; none where the shape was not closed.
(: leave-medium! (-> FxVector Fixnum Fixnum Void))
(define (leave-medium! i list medium)
  (define count (fxvector-ref i list))
  (let find ([k : Fixnum count])
    (cond
      [(fx= k 0) (void)]
      [(fx= medium (fxvector-ref i (fx+ list k)))
       (fxvector-set! i (fx+ list k) (fxvector-ref i (fx+ list count)))
       (fxvector-set! i list (fx- count 1))]
      [else (find (fx- k 1))])))

;; The sum of extinctions at most, into `extinction`, and of scattering; whether a density varies.
(: put-sums! (-> Media Fixnum FlVector FxVector Boolean))
(define (put-sums! media list r i)
  (define packed (Media-packed media))
  (define densities (Media-densities media))
  (Float3-put! r extinction (Float3 0.0 0.0 0.0))
  (Float3-put! r scattering (Float3 0.0 0.0 0.0))
  (let each ([k : Fixnum 1] [varies? : Boolean #f])
    (cond
      [(fx<= k (fxvector-ref i list))
       (define medium (fxvector-ref i (fx+ list k)))
       (add-medium! packed (medium-place medium)
                    (flvector-ref packed (fx+ 7 (medium-place medium))) r)
       (each (fx+ k 1) (or varies? (and (vector-ref densities medium) #t)))]
      [else varies?])))

(define-syntax-rule (add-medium! packed at density0 r)
  (let ([density density0])
    (Float3-put! r extinction
                 (Float3-multiply-add (Float3-in r extinction) density (Float3-in packed at)))
    (Float3-put! r scattering
                 (Float3-multiply-add (Float3-in r scattering) density
                                      (Float3-in packed (fx+ at 3))))))

;; The sums as they are at surface-point.
(: put-sums-at! (-> Media Fixnum FlVector FxVector Void))
(define (put-sums-at! media list r i)
  (define packed (Media-packed media))
  (define densities (Media-densities media))
  (Float3-put! r extinction (Float3 0.0 0.0 0.0))
  (Float3-put! r scattering (Float3 0.0 0.0 0.0))
  (let each ([k : Fixnum 1])
    (when (fx<= k (fxvector-ref i list))
      (let* ([medium (fxvector-ref i (fx+ list k))]
             [at (medium-place medium)]
             [relative (density-at (vector-ref densities medium) packed at r)])
        (add-medium! packed at relative r))
      (each (fx+ k 1)))))

;; The density of each medium around the ray, at surface-point, into medium-densities.
(: put-densities! (-> Media FlVector FxVector Void))
(define (put-densities! media r i)
  (define packed (Media-packed media))
  (define densities (Media-densities media))
  (let each ([k : Fixnum 1])
    (when (fx<= k (fxvector-ref i media-count))
      (let ([medium (fxvector-ref i (fx+ media-count k))])
        (flvector-set! r (fx+ medium-densities (fx- k 1))
                       (density-at (vector-ref densities medium) packed (medium-place medium) r)))
      (each (fx+ k 1)))))

(define-syntax-rule (density-at density0 packed at r)
  (let ([density density0])
    (if density
        (clamped (density (Float3-in r surface-point)) (flvector-ref packed (fx+ at 7)))
        1.0)))

;; From 0 to `most`; NaN is 0.
(: clamped (-> Real Flonum Flonum))
(define (clamped density most)
  (define x (real->double-flonum density))
  (if (fl> x 0.0) (flmin x most) 0.0))

;; Times what is left behind a length of the extinctions in the scratch, in the place `to`.
(define-syntax-rule (put-attenuation! r to length0)
  (let ([length length0])
    (let-float3 ([e (Float3-in r extinction)])
      (Float3-put! r to
                   (Float3-scale-by-vector (Float3-in r to)
                                           (Float3 (attenuation (Float3-x e) length)
                                                   (attenuation (Float3-y e) length)
                                                   (attenuation (Float3-z e) length)))))))

;; exp(-extinction length), 1 where nothing is lost however long the way.
(define-syntax-rule (attenuation extinction length)
  (if (fl= extinction 0.0) 1.0 (flexp (fl* -1.0 (fl* extinction length)))))
