#lang racket/base
;; An Explanation as text: the pixel, where its light came from, and the tree of its paths.
(require racket/match racket/list racket/string
         (only-in "../base/float3.rkt" Float3?) "explain.rkt")

(provide write-explanation)

;; write-explanation : paths: how many of them are told, those that bring most light.
(define (write-explanation explanation out #:paths [count 4])
  (match-define (Explanation x y samples color standard-error rays sources depths paths) explanation)
  (define (line indent . parts)
    (write-string (make-string (* 2 indent) #\space) out)
    (for ([part (in-list parts)]) (display part out))
    (newline out))
  (define light (brightness color))
  (define (share part) (if (> light 0.0) (percent (/ (brightness part) light)) ""))
  (line 0 "pixel " x "," y ": " (color-text color) ", the mean of " (counted samples "sample")
        " of " (number-text rays) " rays")
  (line 0 "standard error "
        (if standard-error
            (format "~a (~a)" (color-text standard-error)
                    (share standard-error))
            "unknown with one sample"))
  (line 0 "where the light comes from")
  (when (null? sources) (line 1 "nowhere: no light arrives"))
  (for ([source (in-list sources)])
    (line 1 (padded (share (cdr source)) 8) (thing-text (car source)) ": "
          (color-text (cdr source))))
  (line 0 "by the bounces on its way")
  (for ([depth (in-list depths)])
    (line 1 (padded (share (cdr depth)) 8) (counted (car depth) "bounce")))
  (define told (take (sort paths > #:key (lambda (p) (brightness (Path-color p)))
                           #:cache-keys? #t)
                     (min count (length paths))))
  (when (< (length told) (length paths))
    (line 0 "the " (length told) " of " (length paths) " paths that bring most"))
  (for ([path (in-list told)]) (write-path path line)))

(define (write-path path line)
  (match-define (Path film-x film-y color rejected? steps) path)
  (line 0 "path through " (number-text film-x) "," (number-text film-y) " brings "
        (color-text color) (if rejected? ", no colour a picture can hold: left out" ""))
  (for ([step (in-list steps)])
    (match step
      [(Miss depth direction sky weight contribution)
       (line (+ depth 1) "hits nothing; background " (color-text sky)
             (weighted weight) " brings " (color-text contribution))]
      [(Within depth point lights onward)
       (if point
           (line (+ depth 1) "is scattered by a medium at " (vector-text point))
           (line (+ depth 1) "goes through a medium that is lit"))
       (for ([sample (in-list lights)]) (write-light sample (+ depth 2) line))
       (write-onward onward (+ depth 2) line)]
      [(Vertex depth shape material t point normal inside? throughput emitted weight ambient
               lights onward)
       (define indent (+ depth 1))
       (line indent "hits " (thing-text shape) " at t " (number-text t) (if inside? " from inside" ""))
       (line (+ indent 1) "material " (short-text material))
       (line (+ indent 1) "point " (vector-text point) ", normal " (vector-text normal))
       (line (+ indent 1) "part of its light that arrives " (color-text throughput))
       (when (bright? emitted)
         (line (+ indent 1) "shines" (weighted weight) ", brings " (color-text emitted)))
       (when (bright? ambient)
         (line (+ indent 1) "ambient light brings " (color-text ambient)))
       (for ([sample (in-list lights)]) (write-light sample (+ indent 1) line))
       (write-onward onward (+ indent 1) line)])))

(define (write-onward onward indent line)
  (when onward
    (line indent
          (if (bright? (Onward-weight onward))
              (format "goes on to ~a, pdf ~a, weight ~a"
                      (vector-text (Onward-direction onward))
                      (number-text (Onward-pdf onward)) (color-text (Onward-weight onward)))
              "ends here: nothing is reflected"))))

(define (write-light sample indent line)
  (match-define (LightSample light distance pdf weight outcome contribution) sample)
  (line indent "light " (thing-text light)
        (if (eq? outcome 'dark) ; then it may have left neither
            ""
            (string-append ", distance " (number-text distance) ", pdf " (number-text pdf)
                           (if weight (weighted weight) "")))
        ": "
        (case outcome
          [(lit) (string-append "brings " (color-text contribution))]
          [(shadowed) "in shadow"]
          [else "nothing arrives"])))

;; ----------------------------------------------------------------------------------------------

(define (parts v) (cdr (vector->list (struct->vector v))))
(define (brightness color) (apply + (parts color)))
(define (bright? color) (ormap (lambda (c) (not (= c 0.0))) (parts color)))

(define (color-text color) (string-join (map number-text (parts color)) " "))
(define (vector-text v) (format "(~a)" (color-text v)))

;; Four significant digits.
(define (number-text x)
  (cond
    [(eqv? x +inf.0) "infinite"]
    [(or (not (= x x)) (= (abs x) +inf.0)) "no number"]
    [(= x 0.0) "0"]
    [else
     (define exponent (- 3 (inexact->exact (floor (/ (log (abs x)) (log 10.0))))))
     (define unit (expt 10 exponent))
     (define rounded (/ (round (* (inexact->exact x) unit)) unit))
     (if (integer? rounded) (number->string rounded) (number->string (exact->inexact rounded)))]))

(define (percent part) (format "~a %" (number-text (/ (round (* 1000.0 part)) 10.0))))
(define (weighted weight) (if (= weight 1.0) "" (format ", weight ~a" (number-text weight))))
(define (counted n what) (format "~a ~a~a" n what (if (= n 1) "" "s")))
(define (padded text width)
  (string-append (make-string (max 0 (- width (string-length text) 1)) #\space) text " "))

(define (thing-text thing)
  (case thing
    [(background) "background"]
    [(ambient) "ambient light"]
    [else (short-text thing)]))

;; The expression, without what is deep inside it.
(define (short-text value)
  (define text (format "~v" value))
  (if (> (string-length text) 90) (string-append (substring text 0 87) "...") text))
