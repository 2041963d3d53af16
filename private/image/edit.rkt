#lang racket/base
;; Pictures from pictures: parts, sizes, exposure and tone, false colours, and several side by side.
(provide Image-crop Image-scale Image-exposed Image-tone Image-false-color Image-error-map
         Images-side-by-side)
(require racket/flonum racket/lazy-require racket/math
         "image.rkt" "tone.rkt" "false-color.rkt")

(lazy-require ["draw.rkt" (draw-label)])

;; Image-crop : the part of width x height pixels whose upper left pixel is in column x and row y,
;; with its standard errors. Raises exn:fail:contract where that is not inside the picture.
(define (Image-crop image x y width height)
  (check-image 'Image-crop image)
  (check-whole 'Image-crop "x" x 0 (- (Image-width image) 1))
  (check-whole 'Image-crop "y" y 0 (- (Image-height image) 1))
  (check-whole 'Image-crop "width" width 1 (- (Image-width image) x))
  (check-whole 'Image-crop "height" height 1 (- (Image-height image) y))
  (define (crop channels)
    (define part (make-flvector (* 3 width height)))
    (for ([row (in-range height)])
      (copy-channels! part (* 3 width row)
                      channels (* 3 (+ x (* (+ y row) (Image-width image)))) (* 3 width)))
    part)
  (make-Image width height (crop (Image-pixels image))
              (and (Image-standard-error image) (crop (Image-standard-error image)))))

;; Image-scale : the picture factor times as large, or of the #:width and #:height given in pixels
;; (one of them keeps the shape). Pixels are weighted by a tent as wide as two of the coarser
;; grid's, in linear light. Standard errors are lost, for pixels are no longer independent.
(define (Image-scale image [factor #f] #:width [width #f] #:height [height #f])
  (check-image 'Image-scale image)
  (define-values (old-width old-height) (values (Image-width image) (Image-height image)))
  (define (size value) (max 1 (exact-round value)))
  (when factor
    (unless (and (real? factor) (< 0 factor +inf.0))
      (raise-argument-error 'Image-scale "a positive factor" factor))
    (when (or width height)
      (raise-arguments-error 'Image-scale "expected a factor or a size, given both"
                             "factor" factor "width" width "height" height)))
  (unless (or factor width height)
    (raise-arguments-error 'Image-scale "expected a factor, #:width or #:height" "image" image))
  (define new-width (or width (size (* old-width (or factor (/ height old-height))))))
  (define new-height (or height (size (* old-height (or factor (/ width old-width))))))
  (check-whole 'Image-scale "width" new-width 1 100000)
  (check-whole 'Image-scale "height" new-height 1 100000)
  (define across
    (scale-lines (Image-pixels image) old-width new-width old-height
                 (lambda (x y) (* 3 (+ x (* y old-width))))
                 (lambda (x y) (* 3 (+ x (* y new-width))))))
  (make-Image new-width new-height
              (scale-lines across old-height new-height new-width
                           (lambda (y x) (* 3 (+ x (* y new-width))))
                           (lambda (y x) (* 3 (+ x (* y new-width)))))))

;; Every line of old pixels becomes one of new pixels; from, to: where pixel k of a line is.
(define (scale-lines pixels old new lines from to)
  (define target (make-flvector (* 3 new lines)))
  (define step (/ (exact->inexact old) new))
  (define radius (max 1.0 step))
  (for ([k (in-range new)])
    (define center (- (* step (+ k 0.5)) 0.5))
    (define taken
      (for*/list ([j (in-range (exact-ceiling (- center radius))
                               (+ 1 (exact-floor (+ center radius))))]
                  [weight (in-value (- 1.0 (/ (abs (- j center)) radius)))]
                  #:when (> weight 0.0))
        (cons (min (- old 1) (max 0 j)) weight)))
    (define total (for/fold ([sum 0.0]) ([pair (in-list taken)]) (+ sum (cdr pair))))
    (for ([line (in-range lines)])
      (define at (to k line))
      (for* ([pair (in-list taken)] [channel (in-range 3)])
        (flvector-set! target (+ at channel)
                       (fl+ (flvector-ref target (+ at channel))
                            (fl* (fl/ (cdr pair) total)
                                 (flvector-ref pixels (+ channel (from (car pair) line)))))))))
  target)

;; Image-exposed : 2^stops times as bright, errors too: +1 is one stop more.
(define (Image-exposed image stops)
  (check-image 'Image-exposed image)
  (define factor (stops->factor 'Image-exposed stops))
  (define (expose channels) (flvector-map (lambda (x) (fl* factor x)) channels))
  (make-Image (Image-width image) (Image-height image) (expose (Image-pixels image))
              (and (Image-standard-error image) (expose (Image-standard-error image)))))

;; Image-tone : the picture as a display shows it best, after #:exposure stops. #:curve 'sRGB
;; clips at white, which is what files and screens do anyway; 'filmic rolls highlights off and
;; deepens shadows (Narkowicz's fit to the ACES curve, 2016); 'linear shows the numbers themselves,
;; 0 black and 1 white, without the display's own curve, as data. The result is a picture for
;; display: linear light from 0 to 1 that a file encodes as sRGB as ever, its errors unknown.
(define (Image-tone image #:curve [curve 'filmic] #:exposure [stops 0])
  (check-image 'Image-tone image)
  (define factor (stops->factor 'Image-tone stops))
  (define (clamped x) (flmax 0.0 (flmin 1.0 x)))
  (define tone
    (case curve
      [(sRGB) clamped]
      [(linear) (lambda (x) (sRGB-decode (clamped x)))]
      [(filmic) (lambda (x)
                  (let ([x (flmax 0.0 (flmin 1e6 x))])
                    (clamped (fl/ (fl* x (fl+ (fl* 2.51 x) 0.03))
                                  (fl+ (fl* x (fl+ (fl* 2.43 x) 0.59)) 0.14)))))]
      [else (raise-argument-error 'Image-tone "(or/c 'linear 'sRGB 'filmic)" curve)]))
  (make-Image (Image-width image) (Image-height image)
              (flvector-map (lambda (x) (tone (fl* factor x))) (Image-pixels image))))

;; Image-false-color : the luminance of every pixel as a colour: black for 0, pale yellow for #:scale
;; or more, by default what 99 of 100 pixels do not exceed, so that a few bright ones hide nothing.
(define (Image-false-color image #:scale [scale #f])
  (check-image 'Image-false-color image)
  (unless (or (not scale) (and (real? scale) (< 0 scale +inf.0)))
    (raise-argument-error 'Image-false-color "a positive finite scale" scale))
  (define full (exact->inexact (or scale (usual-luminance image))))
  (define pixels (make-flvector (flvector-length (Image-pixels image))))
  (for ([at (in-range 0 (flvector-length pixels) 3)])
    (define value (luminance-at image at))
    (define-values (red green blue) (false-color (if (= value 0.0) 0.0 (/ value full))))
    (flvector-set! pixels at red)
    (flvector-set! pixels (+ at 1) green)
    (flvector-set! pixels (+ at 2) blue))
  (make-Image (Image-width image) (Image-height image) pixels))

(define (luminance-at image at)
  (define pixels (Image-pixels image))
  (luminance (flvector-ref pixels at) (flvector-ref pixels (+ at 1)) (flvector-ref pixels (+ at 2))))

;; What 99 of 100 pixels do not exceed, or the largest where that is 0; positive and finite.
(define (usual-luminance image)
  (define sorted
    (sort (for*/list ([at (in-range 0 (flvector-length (Image-pixels image)) 3)]
                      [value (in-value (luminance-at image at))]
                      #:when (< -inf.0 value +inf.0))
            value)
          <))
  (define (place part) (list-ref sorted (- (exact-ceiling (* part (length sorted))) 1)))
  (cond
    [(null? sorted) 1.0]
    [(> (place 99/100) 0.0) (place 99/100)]
    [else (max 1e-300 (place 1))]))

;; Image-error-map : the standard error of every pixel, the root of the mean square of its channels,
;; as a grey. Raises exn:fail:contract where no errors are known.
(define (Image-error-map image)
  (check-image 'Image-error-map image)
  (define errors (Image-standard-error image))
  (unless errors
    (raise-argument-error 'Image-error-map "a picture with known standard errors" image))
  (define pixels (make-flvector (flvector-length errors)))
  (define (squared at) (let ([x (flvector-ref errors at)]) (* x x)))
  (for ([at (in-range 0 (flvector-length errors) 3)])
    (define error (sqrt (/ (+ (squared at) (squared (+ at 1)) (squared (+ at 2))) 3.0)))
    (for ([channel (in-range 3)]) (flvector-set! pixels (+ at channel) error)))
  (make-Image (Image-width image) (Image-height image) pixels))

;; Images-side-by-side : the pictures in a row, their upper edges level, black around them. #:labels:
;; a list of as many strings, written below. #:gap: pixels between two.
(define (Images-side-by-side images #:labels [labels #f] #:gap [gap 8])
  (unless (and (pair? images) (list? images) (andmap Image? images))
    (raise-argument-error 'Images-side-by-side "a list of at least one Image" images))
  (unless (or (not labels)
              (and (list? labels) (andmap string? labels) (= (length labels) (length images))))
    (raise-argument-error 'Images-side-by-side "a list of as many strings as images" labels))
  (check-whole 'Images-side-by-side "gap" gap 0 10000)
  (define label-height (if labels 24 0))
  (define width (+ (apply + (map Image-width images)) (* gap (- (length images) 1))))
  (define picture-height (apply max (map Image-height images)))
  (define pixels (make-flvector (* 3 width (+ picture-height label-height))))
  (for/fold ([x 0]) ([image (in-list images)] [k (in-naturals)])
    (define own (Image-width image))
    (for ([row (in-range (Image-height image))])
      (copy-channels! pixels (* 3 (+ x (* row width))) (Image-pixels image) (* 3 row own) (* 3 own)))
    (when labels
      (define grey (draw-label (list-ref labels k) own label-height))
      (for* ([row (in-range label-height)] [column (in-range own)])
        (define value (sRGB-decode (/ (bytes-ref grey (+ column (* row own))) 255.0)))
        (for ([channel (in-range 3)])
          (flvector-set! pixels (+ channel (* 3 (+ x column (* width (+ picture-height row)))))
                         value))))
    (+ x own gap))
  (make-Image width (+ picture-height label-height) pixels))

;; ----------------------------------------------------------------------------------------------

(define (flvector-map change v)
  (for/flvector #:length (flvector-length v) ([x (in-flvector v)]) (change x)))

(define (copy-channels! target to source from count)
  (for ([k (in-range count)])
    (flvector-set! target (+ to k) (flvector-ref source (+ from k)))))

(define (check-image who image)
  (unless (Image? image) (raise-argument-error who "an Image" image)))

(define (check-whole who argument value low high)
  (unless (and (exact-integer? value) (<= low value high))
    (raise-arguments-error who (format "expected a whole number from ~a to ~a" low high)
                           argument value)))

(define (stops->factor who stops)
  (unless (and (real? stops) (<= -1000 stops 1000))
    (raise-argument-error who "a number of stops from -1000 to 1000" stops))
  (expt 2.0 (exact->inexact stops)))
