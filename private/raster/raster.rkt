#lang typed/racket/base
;; A world drawn at once, by rasterization: its pieces go into a z-buffer, then every surface that is
;; seen in a pixel is shaded once.
(require "../base/unsafe.rkt" "../base/float3.rkt" "../base/check.rkt"
         "../world/camera.rkt" "../world/world.rkt" "../image/image.rkt" "../integrate/integrators.rkt"
         "scan.rkt" "tessellate.rkt" "cover.rkt" "shade.rkt" "resolve.rkt")

(provide preview coverage-offsets)

;; preview : the picture of a world through a camera at once, without shadows, reflections of other
;; surfaces, blur and noise. #:width and #:height in pixels. #:shading one of SHADINGS, or a list of
;; them for as many pictures side by side. #:samples at each of which it is decided what covers a
;; pixel, 1 to 64. #:tolerance how far in pixels triangles may be seen from a curved surface.
;; #:faces 'both, 'front for triangles seen from outside only, or 'back. #:fog-density: light from a
;; surface at distance d loses all but exp(-density d) of itself to #:fog-color. #:crop (list x y width
;; height) draws only that part. What moves is where it is when the shutter opens; a lens is taken as
;; a pinhole. Raises exn:fail:contract on numbers out of range.
(: preview (->* (World Camera)
                (#:width Integer #:height Integer #:shading (U Symbol (Listof Symbol))
                 #:samples Integer #:tolerance Real #:faces Symbol
                 #:fog-color Float3 #:fog-density Real
                 #:crop (U #f (List Integer Integer Integer Integer)))
                Image))
(define (preview world camera #:width [width 640] #:height [height 360] #:shading [shading 'phong]
                 #:samples [samples 4] #:tolerance [tolerance 0.2] #:faces [faces 'both]
                 #:fog-color [fog-color (make-Float3 1 1 1)] #:fog-density [fog-density 0.0]
                 #:crop [crop #f])
  (define columns (check-count 'preview "width" width 1 100000))
  (define rows (check-count 'preview "height" height 1 100000))
  (define offsets (coverage-offsets (check-count 'preview "samples" samples 1 64)
                                    (subpixels columns rows)))
  (define within (check-positive 'preview "tolerance" tolerance))
  (define density (check-between 'preview "fog-density" fog-density 0.0 1e300))
  (check-color 'preview "fog-color" fog-color)
  (define face-number : Fixnum
    (case faces
      [(both) 0] [(front) 1] [(back) 2]
      [else (raise-expected 'preview "faces" "'both, 'front or 'back" faces)]))
  (define shadings : (Listof Symbol) (if (symbol? shading) (list shading) shading))
  (define count (length shadings))
  (unless (and (<= 1 count columns)
               (for/and : Boolean ([name (in-list shadings)]) (and (memq name SHADINGS) #t)))
    (raise-expected 'preview "shading" (format "one of ~a, or a list of them" SHADINGS) shading))
  (define-values (x0 y0 across down)
    (if crop
        (values (check-count 'preview "crop's x" (car crop) 0 (- columns 1))
                (check-count 'preview "crop's y" (cadr crop) 0 (- rows 1))
                (check-count 'preview "crop's width" (caddr crop) 1 (- columns (car crop)))
                (check-count 'preview "crop's height" (cadddr crop) 1 (- rows (cadr crop))))
        (values 0 0 columns rows)))
  (define pixels (make-flvector (* 3 across down) 0.0))
  (for ([name (in-list shadings)] [k : Nonnegative-Fixnum (in-range 100000)])
    (define left (fxquotient (fx* columns k) count))
    (define right (fxquotient (fx* columns (fx+ k 1)) count))
    (define first-column (if (fx> left x0) left x0))
    (define end-column (if (fx< right (fx+ x0 across)) right (fx+ x0 across)))
    (when (fx< first-column end-column)
      (draw! (Film pixels across (fx- first-column x0))
             world (make-View camera (fx- right left) rows) name within face-number
             fog-color density offsets
             (fx- first-column left) y0 (fx- end-column first-column) down)))
  (make-Image across down pixels))

;; Parts of a pixel's side that corners are rounded to: as many as leave products of whole numbers
;; room in 60 bits.
(: subpixels (-> Fixnum Fixnum Fixnum))
(define (subpixels width height) (if (fx< (if (fx< width height) height width) 16384) 4096 256))

;; coverage-offsets : where the samples of a pixel are, two whole numbers of subpixels each: in every
;; row and column of an n by n grid one (Hammersley 1960). Their mean is the pixel's middle.
(: coverage-offsets (-> Fixnum Fixnum FxVector))
(define (coverage-offsets count parts)
  (define offsets (make-fxvector (fx* 2 count) 0))
  (define (mirrored [k : Integer]) ; of six bits
    (for/fold ([sum : Integer 0]) ([bit (in-range 6)])
      (if (bitwise-bit-set? k bit) (+ sum (arithmetic-shift 32 (- bit))) sum)))
  (define order
    (for/list : (Listof Integer) ([k (in-range count)]) (mirrored k)))
  (define (place [rank : Integer])
    (assert (quotient (* parts (+ 1 (* 2 rank))) (* 2 count)) fixnum?))
  (for ([key (in-list order)] [k : Nonnegative-Fixnum (in-range 64)])
    (define rank (for/sum : Integer ([other (in-list order)]) (if (< other key) 1 0)))
    (fxvector-set! offsets (fx* 2 k) (place k))
    (fxvector-set! offsets (fx+ 1 (fx* 2 k)) (place rank)))
  offsets)

(define MOST-SAMPLES-AT-ONCE : Fixnum 4000000)

(: draw! (-> Film World View Symbol Flonum Fixnum Float3 Flonum FxVector
             Fixnum Fixnum Fixnum Fixnum Void))
(define (draw! film world view shading tolerance faces fog-color fog-density offsets
               left top width height)
  (define hidden? (and (eq? shading 'hidden-lines) (View-linear? view)))
  (define wires? (and (memq shading '(wireframe hidden-lines)) #t))
  (define-values (pieces materials drawn)
    (world-pieces (World-shapes world) view tolerance wires?))
  (define corners
    (for/vector : (Vectorof FlVector) ([piece (in-vector drawn)])
      (define mesh (Piece-mesh piece))
      (if mesh (film-corners mesh (Piece-transform piece) view) (flvector))))
  ;; without what is seen through, where something is
  (define opaque : (U #f (Vectorof Piece))
    (and (memq shading '(phong gouraud flat toon))
         (View-linear? view)
         (for/or : Boolean ([material (in-vector materials)]) (Material-clear? material))
         (for/vector : (Vectorof Piece) ([piece (in-vector drawn)])
           (if (Material-clear? (vector-ref materials (Piece-material piece)))
               (struct-copy Piece piece [mesh #f] [kernel #f] [plane #f])
               piece))))
  (define shade! (make-shader world pieces materials shading (and opaque #t)))
  (define samples (fxquotient (fxvector-length offsets) 2))
  (define band-height
    (let ([rows (fxquotient MOST-SAMPLES-AT-ONCE (fx* width samples))]) (if (fx< rows 1) 1 rows)))
  (define resolve! (resolver film world view drawn corners shade! materials shading fog-color fog-density top))
  (let each-band ([y : Fixnum top])
    (when (fx< y (fx+ top height))
      (let* ([rest (fx- (fx+ top height) y)]
             [rows (if (fx< rest band-height) rest band-height)]
             [new-canvas (lambda ()
                           (make-Canvas (View-width view) (View-height view) left y width rows
                                        offsets (subpixels (View-width view) (View-height view))))]
             [canvas (new-canvas)]
             [behind (and opaque (new-canvas))])
        (when hidden?
          (draw-pieces! (struct-copy Canvas canvas [slack 1.0]) view drawn corners faces #f)
          (Canvas-forget-surfaces! canvas))
        (draw-pieces! canvas view drawn corners faces wires?)
        (when (and opaque behind) (draw-pieces! behind view opaque corners faces #f))
        (resolve! canvas behind))
      (each-band (fx+ y band-height)))))
