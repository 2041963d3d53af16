#lang typed/racket/base
;; Textures made of noise: plain, turbulent and marbled, between two colours.
(require (for-syntax racket/base)
         "../../base/unsafe.rkt" "../../base/registers.rkt" "../../base/float3.rkt"
         "../../base/check.rkt" "../../base/public.rkt" "texture.rkt" "noise.rkt")

(provide (struct-out Noise) make-Noise Noise-kernel
         (struct-out Turbulence) make-Turbulence Turbulence-kernel
         (struct-out Marble) make-Marble Marble-kernel)

;; Textures from first to second with a scale, octaves and a seed.
(define-syntax-rule (define-noise Name make-Name default-octaves)
  (begin
    (struct Name Texture
      ([first : Float3] [second : Float3] [scale : Flonum] [octaves : Fixnum] [seed : Fixnum])
      #:transparent)
    (: make-Name (->* (Float3 Float3)
                      (Real Integer Integer #:scale Real #:octaves Integer #:seed Integer)
                      Name))
    (define (make-Name first second [scale-by-place 1.0] [octaves-by-place default-octaves]
                       [seed-by-place 0]
                       #:scale [scale scale-by-place] #:octaves [octaves octaves-by-place]
                       #:seed [seed seed-by-place])
      (Name (check-color 'Name "first" first) (check-color 'Name "second" second)
            (check-positive 'Name "scale" scale)
            (check-octaves 'Name octaves) (check-seed 'Name seed)))
    (define-constructor Name make-Name (first second scale octaves seed))))

;; (Noise first second [scale 1] [octaves 1] [seed 0]): from first to second as the noise goes from its
;; least to its greatest value. scale: lattice points a unit of the space the shape is made in.
;; octaves: 1 is smooth, each more adds detail half as wide. seed: another seed, another pattern.
(define-noise Noise make-Noise 1)

;; (Turbulence first second [scale 1] [octaves 7] [seed 0]): the same with the magnitude of the noise,
;; from 0: dark creases in a bright stone.
(define-noise Turbulence make-Turbulence 7)

;; Layers across z, sin(bands z), their phase shifted by disorder times the turbulence; point and
;; turbulence are scaled alike. The book's marble is scale 1, bands 4, disorder 10, 7 octaves.
(struct Marble Texture
  ([first : Float3] [second : Float3] [scale : Flonum] [bands : Flonum] [disorder : Flonum]
   [octaves : Fixnum] [seed : Fixnum])
  #:transparent)

;; (Marble first second [scale 1] [bands 4] [disorder 10] [octaves 7] [seed 0]).
(: make-Marble (->* (Float3 Float3)
                    (Real Real Real Integer Integer
                     #:scale Real #:bands Real #:disorder Real #:octaves Integer #:seed Integer)
                    Marble))
(define (make-Marble first second [scale-by-place 1.0] [bands-by-place 4.0]
                     [disorder-by-place 10.0] [octaves-by-place 7] [seed-by-place 0]
                     #:scale [scale scale-by-place] #:bands [bands bands-by-place]
                     #:disorder [disorder disorder-by-place]
                     #:octaves [octaves octaves-by-place] #:seed [seed seed-by-place])
  (Marble (check-color 'Marble "first" first) (check-color 'Marble "second" second)
          (check-positive 'Marble "scale" scale)
          (check-finite 'Marble "bands" bands) (check-finite 'Marble "disorder" disorder)
          (check-octaves 'Marble octaves) (check-seed 'Marble seed)))

(define-constructor Marble make-Marble (first second scale bands disorder octaves seed))

;; A kernel that goes from first to second by a number, clamped to 0 .. 1, in which `sum` is what
;; the noise left.
(define-syntax-rule (blending-kernel r sum first second noise number)
  (let ([a first] [b second] [noise! noise])
    (lambda ([r : FlVector] [i : FxVector])
      (noise! r texture-point surface-roughness)
      (let* ([sum (flvector-ref r surface-roughness)]
             [s (flmax 0.0 (flmin 1.0 number))])
        (Float3-put! r surface-color (Float3-linear-interpolate a b s))))))

;; The sum of octaves is divided by the sum of their weights.
(: Noise-kernel (-> Noise TextureKernel))
(define (Noise-kernel texture)
  (define octaves (Noise-octaves texture))
  (define inverse (fl/ 1.0 (fl- 2.0 (flexpt 0.5 (fl- (fx->fl octaves) 1.0)))))
  (blending-kernel r sum (Noise-first texture) (Noise-second texture)
                   (make-noise (Noise-scale texture) octaves (Noise-seed texture))
                   (fl+ 0.5 (fl* 0.5 (fl* inverse sum)))))

(: Turbulence-kernel (-> Turbulence TextureKernel))
(define (Turbulence-kernel texture)
  (blending-kernel r sum (Turbulence-first texture) (Turbulence-second texture)
                   (make-noise (Turbulence-scale texture) (Turbulence-octaves texture)
                               (Turbulence-seed texture))
                   (flabs sum)))

(: Marble-kernel (-> Marble TextureKernel))
(define (Marble-kernel texture)
  (define bands (fl* (Marble-scale texture) (Marble-bands texture)))
  (define disorder (Marble-disorder texture))
  (blending-kernel r sum (Marble-first texture) (Marble-second texture)
                   (make-noise (Marble-scale texture) (Marble-octaves texture)
                               (Marble-seed texture))
                   (fl+ 0.5 (fl* 0.5 (flsin (fl+ (fl* bands (flvector-ref r (fx+ texture-point 2)))
                                                 (fl* disorder (flabs sum))))))))
