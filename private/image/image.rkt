#lang typed/racket/base
;; A picture: linear RGB flonums and, where known, their standard error. It prints short and shows
;; itself as a picture wherever values are asked for one (DrRacket, racket-mode, Scribble).
(provide (struct-out Image) make-Image Image-pixel)
(require racket/flonum (only-in file/convertible prop:convertible) "../base/unsafe-typed.rkt")

(unsafe-require/typed "convert.rkt"
  [image-png-bytes (-> Positive-Fixnum Positive-Fixnum FlVector Positive-Fixnum Bytes)])

;; pixels: linear RGB (Rec. 709 primaries), row 0 at the top; channel c of the pixel in column x
;; and row y is at 3*(y*width+x)+c. standard-error: laid out alike, the standard error of the mean
;; of each channel, or #f when unknown. The constructor checks nothing; make-Image does.
(struct Image ([width : Positive-Fixnum] [height : Positive-Fixnum] [pixels : FlVector]
               [standard-error : (U #f FlVector)])
  #:transparent
  #:property prop:custom-write
  (lambda ([self : Image] [out : Output-Port] [mode : (U Boolean 0 1)])
    (fprintf out "#<Image ~ax~a>" (Image-width self) (Image-height self)))
  #:property prop:convertible
  (lambda ([self : Image] [request : Symbol] [default : Any])
    (define (png [magnification : Positive-Fixnum])
      (image-png-bytes (Image-width self) (Image-height self) (Image-pixels self) magnification))
    (case request
      [(png-bytes) (png 1)]
      [(png@2x-bytes) (png 2)] ; hosts draw these dots at half size
      [else default])))

;; make-Image : an Image of width x height pixels, both positive, from 3*width*height flonums of
;; linear RGB and, optionally, as many standard errors. The flvectors are kept, not copied: do not
;; change them afterwards. Raises exn:fail:contract when a size or a length does not fit.
(: make-Image (->* (Integer Integer FlVector) ((U #f FlVector)) Image))
(define (make-Image width height pixels [standard-error #f])
  (define (check-length [name : String] [channels : FlVector])
    (unless (= (flvector-length channels) (* 3 width height))
      (raise-arguments-error 'make-Image "expected 3*width*height numbers"
                             "width" width "height" height
                             (string-append "length of " name) (flvector-length channels))))
  (unless (and (fixnum? width) (positive? width))
    (raise-argument-error 'make-Image "positive fixnum width" width))
  (unless (and (fixnum? height) (positive? height))
    (raise-argument-error 'make-Image "positive fixnum height" height))
  (check-length "pixels" pixels)
  (when standard-error (check-length "standard-error" standard-error))
  (Image width height pixels standard-error))

;; Image-pixel : the linear red, green and blue of the pixel in column x (0 at the left) and row y
;; (0 at the top). Raises exn:fail:contract outside the picture.
(: Image-pixel (-> Image Integer Integer (Values Flonum Flonum Flonum)))
(define (Image-pixel image x y)
  (unless (and (< -1 x (Image-width image)) (< -1 y (Image-height image)))
    (raise-arguments-error 'Image-pixel "outside the picture" "x" x "y" y "image" image))
  (define pixels (Image-pixels image))
  (define start (* 3 (+ (* y (Image-width image)) x)))
  (values (flvector-ref pixels start)
          (flvector-ref pixels (+ start 1))
          (flvector-ref pixels (+ start 2))))
