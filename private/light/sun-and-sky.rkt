#lang racket/base
;; A clear sky by day and its sun: Preetham, Shirley and Smits, "A Practical Analytic Model for
;; Daylight" (1999). Luminances in thousands of candela a square metre, illuminances in thousands of
;; lux, both times `scale`, as linear RGB.
(require racket/flonum racket/math
         (only-in "../base/float3.rkt" Float3? make-Float3 Float3-x/function Float3-y/function
                  Float3-z/function Float3-normalized/checked)
         (only-in "../base/check.rkt" check-color check-direction raise-expected)
         (only-in "../image/image.rkt" make-Image)
         (only-in "environment.rkt" make-EnvironmentMap)
         (only-in "distant.rkt" make-DistantLight))

(provide daylight-sky daylight-sun sky-luminance)

;; What makes a picture of this sky come out about as bright as one of a white background.
(define DEFAULT-SCALE 0.06)

;; daylight-sky : the sky as an EnvironmentMap, without the sun's disk. sun-direction: towards the sun,
;; any length, above the horizon (y). turbidity: haze, from 2 (clear) to 10 (hazy). ground: the
;; radiance of what lies below the horizon. width: of its picture, twice the height. Raises where a
;; number is out of range.
(define (daylight-sky sun-direction #:turbidity [turbidity 3.0] #:scale [scale DEFAULT-SCALE]
                      #:ground [ground (make-Float3 0.12 0.11 0.1)] #:width [width 256])
  (define sun (checked-sun 'daylight-sky sun-direction turbidity scale))
  (unless (Float3? ground) (raise-expected 'daylight-sky "ground" "a colour, a Float3," ground))
  (check-color 'daylight-sky "ground" ground)
  (unless (and (exact-integer? width) (even? width) (<= 8 width 8192))
    (raise-expected 'daylight-sky "width" "an even whole number from 8 to 8192" width))
  (define height (quotient width 2))
  (define pixels (make-flvector (* 3 width height)))
  (define color-of (sky-color (Float3-y/function sun) (exact->inexact turbidity)))
  (for* ([y (in-range height)] [x (in-range width)])
    (define latitude (* pi (- 0.5 (/ (+ y 0.5) height))))
    (define longitude (* 2.0 pi (- (/ (+ x 0.5) width) 0.5)))
    (define level (cos latitude))
    (define up (sin latitude))
    (define to-sun
      (+ (* level (sin longitude) (Float3-x/function sun)) (* up (Float3-y/function sun))
         (* -1.0 level (cos longitude) (Float3-z/function sun))))
    (define-values (red green blue)
      (if (> up 0.0)
          (let-values ([(r g b) (color-of up (max -1.0 (min 1.0 to-sun)))])
            (values (* scale r) (* scale g) (* scale b)))
          (values (Float3-x/function ground) (Float3-y/function ground) (Float3-z/function ground))))
    (define at (* 3 (+ x (* y width))))
    (flvector-set! pixels at (fl red))
    (flvector-set! pixels (+ at 1) (fl green))
    (flvector-set! pixels (+ at 2) (fl blue)))
  (make-EnvironmentMap (make-Image width height pixels)))

(define (fl x) (real->double-flonum x))

;; daylight-sun : the sun of that sky as a DistantLight, reddened by the air that its light has passed
;; (Rayleigh scattering and haze, as in the paper's appendix, at three wavelengths).
(define (daylight-sun sun-direction #:turbidity [turbidity 3.0] #:scale [scale DEFAULT-SCALE])
  (define sun (checked-sun 'daylight-sun sun-direction turbidity scale))
  (define from-zenith (acos (min 1.0 (Float3-y/function sun))))
  (define air-mass
    (/ (+ (cos from-zenith) (* 0.15 (expt (- 93.885 (radians->degrees from-zenith)) -1.253)))))
  (define haze (- (* 0.04608 turbidity) 0.04586))
  ;; illuminance before the atmosphere, in thousands of lux
  (define (through wavelength) ; in micrometres
    (fl (* scale 133.3
           (exp (* -0.008735 (expt wavelength -4.08) air-mass))
           (exp (* -1.0 haze (expt wavelength -1.3) air-mass)))))
  (make-DistantLight sun (make-Float3 (through 0.612) (through 0.549) (through 0.465))))

(define (checked-sun who direction turbidity scale)
  (unless (and (real? turbidity) (<= 2 turbidity 10))
    (raise-expected who "turbidity" "a number from 2 to 10" turbidity))
  (unless (and (real? scale) (<= 0 scale 1e9))
    (raise-expected who "scale" "a number from 0 to 1e9" scale))
  (unless (Float3? direction) (raise-expected who "sun-direction" "a Float3" direction))
  (define sun (Float3-normalized/checked (check-direction who "sun-direction" direction)))
  (unless (> (Float3-y/function sun) 0.0)
    (raise-expected who "sun-direction" "a direction above the horizon" direction))
  sun)

;; ----------------------------------------------------------------------------------------------

;; Perez's function with the coefficients of luminance Y and chromaticities x and y, each a + b T.
(define COEFFICIENTS
  '(((0.1787 . -1.4630) (-0.3554 . 0.4275) (-0.0227 . 5.3251) (0.1206 . -2.5771) (-0.0670 . 0.3703))
    ((-0.0193 . -0.2592) (-0.0665 . 0.0008) (-0.0004 . 0.2125) (-0.0641 . -0.8989)
     (-0.0033 . 0.0452))
    ((-0.0167 . -0.2608) (-0.0950 . 0.0092) (-0.0079 . 0.2102) (-0.0441 . -1.6537)
     (-0.0109 . 0.0529))))

;; Chromaticity at the zenith: rows for T^2, T and 1, columns for the cube, square and first power of
;; the sun's angle from the zenith, and 1.
(define ZENITH-X
  '((0.00166 -0.00375 0.00209 0.0) (-0.02903 0.06377 -0.03202 0.00394)
    (0.11693 -0.21196 0.06052 0.25886)))
(define ZENITH-Y
  '((0.00275 -0.00610 0.00317 0.0) (-0.04214 0.08970 -0.04153 0.00516)
    (0.15346 -0.26756 0.06670 0.26688)))

;; A procedure from the cosines of the angles to the zenith and to the sun to linear RGB.
(define (sky-color sun-up turbidity)
  (define-values (luminance x-of y-of) (sky-functions sun-up turbidity))
  (lambda (up to-sun)
    (define big-y (luminance up to-sun))
    (define x (x-of up to-sun))
    (define y (y-of up to-sun))
    (define big-x (* big-y (/ x y)))
    (define big-z (* big-y (/ (- 1.0 x y) y)))
    ;; CIE XYZ to linear RGB with the primaries of Rec. 709
    (values (max 0.0 (+ (* 3.2404542 big-x) (* -1.5371385 big-y) (* -0.4985314 big-z)))
            (max 0.0 (+ (* -0.9692660 big-x) (* 1.8760108 big-y) (* 0.0415560 big-z)))
            (max 0.0 (+ (* 0.0556434 big-x) (* -0.2040259 big-y) (* 1.0572252 big-z))))))

;; sky-luminance : in thousands of candela a square metre, for cosines of the angles from the zenith to
;; the sun, from the zenith to the point of the sky, and from there to the sun.
(define (sky-luminance sun-up turbidity up to-sun)
  (define-values (luminance x y) (sky-functions sun-up turbidity))
  (luminance up to-sun))

(define (sky-functions sun-up turbidity)
  (define angle (acos (min 1.0 sun-up)))
  (define tilt (* (- 4/9 (/ turbidity 120.0)) (- pi (* 2.0 angle))))
  (define zenith-luminance
    (- (* (- (* 4.0453 turbidity) 4.9710) (tan tilt)) (* 0.2155 turbidity) -2.4192))
  (define (zenith rows)
    (for/sum ([row (in-list rows)] [power (in-list (list (* turbidity turbidity) turbidity 1.0))])
      (* power (+ (* angle (+ (* angle (+ (* angle (car row)) (cadr row))) (caddr row)))
                  (cadddr row)))))
  (define (function zenith-value coefficients)
    (define-values (a b c d e)
      (apply values (for/list ([pair (in-list coefficients)])
                      (+ (* (car pair) turbidity) (cdr pair)))))
    (define (perez up to-sun)
      (define away (acos to-sun))
      (* (+ 1.0 (* a (exp (/ b (max up 0.001)))))
         (+ 1.0 (* c (exp (* d away))) (* e to-sun to-sun))))
    (define at-zenith (perez 1.0 (min 1.0 sun-up)))
    (lambda (up to-sun) (* zenith-value (/ (perez up to-sun) at-zenith))))
  (values (function (max 0.0 zenith-luminance) (car COEFFICIENTS))
          (function (zenith ZENITH-X) (cadr COEFFICIENTS))
          (function (zenith ZENITH-Y) (caddr COEFFICIENTS))))
