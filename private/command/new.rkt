#lang racket/base
;; raco raytrace new: a scene to start from.
(require "flags.rkt")

(provide new-scene)

(define flags
  '((usage-help "Writes a commented scene to <file>, a new .rkt file, to start from.")))

(define (new-scene program words)
  (define file (parse-words program words flags '("file") (lambda (settings file) file)))
  (unless (and (path-string? file) (regexp-match? #rx"[^/][.]rkt$" file))
    (raise-user-error (format "~a: expected a name that ends with .rkt, as my-scene.rkt" file)))
  (when (or (file-exists? file) (directory-exists? file) (link-exists? file))
    (raise-user-error (format "~a: expected a file that does not exist yet" file)))
  (define picture (regexp-replace #rx"[.]rkt$" file ".png"))
  (with-handlers ([exn:fail:filesystem?
                   (lambda (e) (raise-user-error (format "~a: cannot be written" file)))])
    (call-with-output-file file #:exists 'error
      (lambda (out) (write-string (scene-text file picture) out))))
  (printf "~a is written. Its picture: raco raytrace ~a -o ~a\n" file file picture))

(define (scene-text file picture)
  (regexp-replaces template `([#rx"FILE" ,(regexp-replace-quote file)]
                              [#rx"PICTURE" ,(regexp-replace-quote picture)])))

(define template #<<SCENE
#lang racket/base
;; Three balls on a checkered floor, under a lamp and the sky.
;;   raco raytrace FILE -o PICTURE              renders it
;;   raco raytrace FILE -o PICTURE --error 1%   until its error is 1 %
;;   raco raytrace check FILE                   finds mistakes
;;   raco raytrace explain FILE --pixel 320,180 tells why a pixel looks as it does
(require raytrace)

(provide world camera settings)

;; Places are x to the right, y up and z towards you. Colours are red, green and blue from 0 to 1,
;; in linear light. A shape is where it is and what it is made of.
(define floor
  (Disk (Float3 0 0 0) (Float3 0 1 0) 40                ; middle, direction upwards, radius
        (Lambertian (Checker (Float3 0.55 0.55 0.52) (Float3 0.12 0.14 0.16)))))

(define balls
  (list (Sphere (Float3 -2.1 1 0) 1 (gold 0.15))        ; middle, radius, roughness of the gold
        (Sphere (Float3 0 1 0.4) 1 (Dielectric 1.5))    ; glass, by its index of refraction
        (Sphere (Float3 2.1 1 0) 1 (Plastic (Float3 0.6 0.04 0.03)))))

;; A shape with an Emitter is a lamp: this one is a square that shines down to the balls.
(define lamp
  (Quad (Float3 -4 6 1) (Float3 0 0 3) (Float3 3 0.8 0) ; a corner and two edges
        #:material (Emitter (Float3 12 10.5 8.5) #:two-sided? #t)))

;; What rays see that hit nothing: below, and straight up.
(define sky (GradientSky (Float3 0.75 0.8 0.85) (Float3 0.2 0.35 0.7)))

;; Shapes, lights that are no shapes (as a DistantLight, the sun), and the sky.
(define world (World (list* floor lamp balls) '() sky))

;; From where to what, how wide the view is, and how large the lens: 0 is sharp everywhere.
(define camera
  (Camera-look-at (Float3 1.5 2.6 8.5) (Float3 0 0.9 0)
                  #:vertical-field-of-view-degrees 30
                  #:lens-radius 0.05))

;; What to render unless the command says otherwise.
(define settings (hash 'size '(640 360) 'samples 64))

SCENE
  )
