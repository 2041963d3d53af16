#lang racket/base
;; Looking at a world in a window: what is asked is checked here; the window itself, and racket/gui
;; with it, is loaded only when there is a display.
(require racket/lazy-require "refine.rkt" "../world/world.rkt" "../world/camera.rkt"
         "../integrate/integrators.rkt")

(provide view view-scene check-display)

(lazy-require ["window.rkt" (window-loaded? look-around)])

;; view : opens a window on the world through the camera and returns, when it is closed, the Camera
;; one looked through last. The picture is drawn at once by rasterization, then traced with more and
;; more samples; the mouse moves the camera and keys do more (h shows them). #:width and #:height in
;; pixels. #:samples the most a pixel gets, or #f; #:error the relative RMSE that is good enough, or
;; #f. #:integrator, #:seed, #:max-depth and #:shading as for render. Raises exn:fail:user where there
;; is no display.
(define (view world camera #:width [width 640] #:height [height 360] #:samples [samples #f]
              #:error [error #f] #:integrator [integrator 'auto] #:seed [seed 0]
              #:max-depth [max-depth #f] #:shading [shading 'phong])
  (define (check ok? name expected value)
    (unless ok? (raise-arguments-error 'view (string-append "expected " expected) name value)))
  (define (whole? value low high) (and (exact-integer? value) (<= low value high)))
  (check (World? world) "world" "a World" world)
  (check (Camera? camera) "camera" "a Camera" camera)
  (check (whole? width 1 100000) "width" "a whole number from 1 to 100000" width)
  (check (whole? height 1 100000) "height" "a whole number from 1 to 100000" height)
  (check (or (not samples) (whole? samples 1 1000000000))
         "samples" "#f or a whole number from 1 to 1000000000" samples)
  (check (or (not error) (and (real? error) (< 0 error +inf.0)))
         "error" "#f or a positive number" error)
  (check (memq integrator INTEGRATORS) "integrator" (format "one of ~a" INTEGRATORS) integrator)
  (check (whole? seed 0 #xFFFFFFFF) "seed" "a whole number of 32 bits" seed)
  (check (or (not max-depth) (whole? max-depth 0 1000000000))
         "max-depth" "#f or a whole number from 0 to 1000000000" max-depth)
  (check (andmap (lambda (name) (memq name SHADINGS)) (if (pair? shading) shading (list shading)))
         "shading" (format "one or more of ~a" SHADINGS) shading)
  (view-scene (scene world camera width height integrator samples error seed max-depth shading)))

;; view-scene : the same for a scene. #:name is the window's, and that of pictures it saves. #:reload:
;; #f, or a procedure that returns the scene read again or raises exn:fail:user. #:files: a procedure
;; that returns the paths of files after a change of which it is read again.
(define (view-scene first #:name [name "view"] #:reload [reload #f] #:files [files (lambda () '())])
  (check-display)
  (look-around first #:name name #:reload reload #:files files))

;; check-display : raises exn:fail:user with one line where no window can be opened.
(define (check-display)
  (when (and (eq? 'unix (system-type)) (not (variable? "DISPLAY"))
             (not (variable? "WAYLAND_DISPLAY")))
    (raise-user-error "view needs a display: neither DISPLAY nor WAYLAND_DISPLAY is set"))
  (with-handlers ([exn:missing-module?
                   (lambda (e) (raise-user-error "view needs racket/gui: the package gui-lib"))]
                  [exn:fail? (lambda (e)
                               (raise-user-error
                                (string-append "view needs a display: " (exn-message e))))])
    (window-loaded?)))

(define (variable? name)
  (define value (getenv name))
  (and value (not (string=? value ""))))
