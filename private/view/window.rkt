#lang racket/base
;; The window: draws what the background finds, and tells the look what keys and mouse do. Only this
;; file loads racket/gui.
(require racket/class racket/gui/base "refine.rkt" "background.rkt" "look.rkt" "gestures.rkt"
         "screen.rkt" "watch.rkt" "../command/line.rkt" "../world/camera.rkt"
         "../image/write.rkt")

(provide window-loaded? look-around)

;; Whether racket/gui could be loaded, which takes a display.
(define (window-loaded?) #t)

;; look-around : as view-scene.
(define (look-around first #:name name #:reload reload #:files files)
  (define keeper (current-custodian))
  (define custodian (make-custodian))
  (define closed (make-semaphore 0))
  (define result (scene-camera first))
  (define (finish camera)
    (set! result camera)
    (semaphore-post closed))
  (define close!
    (parameterize ([current-custodian custodian])
      (parameterize ([current-eventspace (make-eventspace)])
        (open-window first name reload files finish keeper))))
  (dynamic-wind
   void
   (lambda ()
     (yield closed)
     result)
   (lambda ()
     (close!)
     (custodian-shutdown-all custodian))))

(define PICTURE-FILES
  '(("Portable network graphics" "*.png") ("Portable pixmap" "*.ppm")
    ("Linear floating point" "*.pfm") ("Radiance" "*.hdr")))

;; How long a message stays that is no error.
(define MESSAGE-SECONDS 5.0)

;; Opens the window in the current eventspace, calls finish with the last camera when the user closes
;; it, and returns a procedure that ends everything. All that is set here is set by the eventspace's
;; own thread.
(define (open-window first name reload files finish keeper)
  (define out (current-output-port))
  (define errors (current-error-port))
  (define eventspace (current-eventspace))
  (define (in-window act) (parameterize ([current-eventspace eventspace]) (queue-callback act)))

  (define given first)
  (define now-seen (first-look (scene-camera first)))
  (define newest 0)   ; the order that what is shown is of
  (define seen #f)    ; the shown
  (define bitmap #f)  ; of it
  (define message #f) ; told in place of the picture's status, until something else is done
  (define until #f)   ; or until then, in milliseconds

  ;; ------------------------------------------------------------------------------------------------
  ;; Pictures come

  (define (show number found)
    (define stops (look-stops now-seen))
    (define ready (shown-bitmap found (scene-integrator given) stops))
    (in-window
     (lambda ()
       (when (>= number newest)
         (set! newest number)
         (set! seen found)
         (if (= stops (look-stops now-seen))
             (set! bitmap ready)
             (draw-again!))
         (update!)))))

  (define (draw-again!)
    (when seen (set! bitmap (shown-bitmap seen (scene-integrator given) (look-stops now-seen)))))

  (define (fail number e) (in-window (lambda () (tell! (one-line (exn-message e)) +inf.0))))

  (define (tell! text [seconds MESSAGE-SECONDS])
    (set! message text)
    (set! until (+ (current-inexact-milliseconds) (* 1000.0 seconds)))
    (update!))

  (define (update!)
    (when (and message (> (current-inexact-milliseconds) until)) (set! message #f))
    (send frame set-status-text
          (or message (if seen (status-text seen (look-stops now-seen)) "")))
    (send canvas refresh))

  (define background (start-background show fail #:keeper keeper))
  (define (order-picture!)
    (order! background (struct-copy scene given [camera (look-camera now-seen)])))

  ;; A change of the look: another camera is another picture.
  (define (look! new)
    (define old now-seen)
    (set! now-seen new)
    (unless (equal? old new) (set! message #f))
    (unless (= (look-stops old) (look-stops new)) (draw-again!))
    (unless (equal? (look-camera old) (look-camera new)) (order-picture!))
    (update!))

  ;; ------------------------------------------------------------------------------------------------
  ;; The scene's file

  (define reading #f)
  (define (read-again!)
    (cond
      [(not reload) (tell! "there is no scene file to read again")]
      [else
       (when reading (kill-thread reading))
       (set! reading (thread (lambda () (read-scene reload))))]))

  (define (read-scene reload)
    (define found
      (with-handlers ([exn:fail? (lambda (e)
                                   (define text (one-line (exn-message e)))
                                   (fprintf errors "raytrace: ~a\n" text)
                                   (in-window (lambda () (tell! text +inf.0)))
                                   #f)])
        (reload)))
    (when found
      (in-window
       (lambda ()
         (set! given found)
         (set! now-seen (look-at-scene now-seen (scene-camera found)))
         (set! message #f)
         (order-picture!)))))

  ;; ------------------------------------------------------------------------------------------------
  ;; What keys ask for

  (define (act! command)
    (case command
      [(close) (close-now)]
      [(print) (print-camera!)]
      [(copy)
       (print-camera!)
       (send the-clipboard set-clipboard-string (camera-text) (current-milliseconds))
       (tell! "the camera is in the clipboard")]
      [(save) (when seen (save! (free-name name)))]
      [(save-as)
       (define path (put-file "Save the picture" frame #f (string-append name ".png") "png" '()
                              PICTURE-FILES))
       (when (and seen path) (save! path))]
      [(reload) (read-again!)]
      [else (look! (look-command now-seen command))]))

  (define (camera-text) (format "~v" (look-camera now-seen)))
  (define (print-camera!)
    (fprintf out "~a\n" (camera-text))
    (flush-output out)
    (tell! "the camera is printed"))

  ;; What is linear is saved as it was rendered, what is shown as it is shown.
  (define (save! path)
    (define image
      (if (regexp-match? #rx"[.](?i:pfm|hdr)$" (if (path? path) (path->string path) path))
          (shown-image seen)
          (visible seen (scene-integrator given) (look-stops now-seen))))
    (tell! (with-handlers ([exn:fail? (lambda (e) (one-line (exn-message e)))])
             (Image-write image path)
             (format "~a is written" path))))

  ;; ------------------------------------------------------------------------------------------------
  ;; The window

  (define (close-now)
    (send frame show #f)
    (finish (look-camera now-seen)))

  (define frame
    (new (class frame%
           (define/augment (on-close) (finish (look-camera now-seen)))
           (super-new))
         [label (string-append name " - raytrace")]))
  (send frame create-status-line)

  (define canvas
    (new (class canvas%
           (inherit get-client-size get-dc)
           (define/override (on-paint)
             (define-values (width height) (get-client-size))
             (draw-screen (get-dc) width height bitmap (scene-width given) (scene-height given)
                          (look-keys? now-seen)))
           (define/override (on-char event)
             (case (send event get-key-code)
               [(wheel-up) (look! (look-wheel now-seen 1))]
               [(wheel-down) (look! (look-wheel now-seen -1))]
               [else
                (define command (key-command (send event get-key-code)))
                (when command (act! command))]))
           (define/override (on-event event)
             (define-values (width height) (get-client-size))
             (on-mouse event width height))
           (super-new))
         [parent frame] [style '(no-autoclear)]))

  ;; As large as the picture, or as fits on the screen; smaller if the user wants so.
  (define-values (most-width most-height) (get-display-size))
  (define room
    (min 1 (/ (* 0.9 (or most-width 1024)) (scene-width first))
         (/ (* 0.8 (or most-height 768)) (scene-height first))))
  (define (fitting pixels) (max 1 (inexact->exact (floor (* room pixels)))))
  (send canvas min-client-width (fitting (scene-width first)))
  (send canvas min-client-height (fitting (scene-height first)))

  (define (on-mouse event width height)
    (define-values (left top scale)
      (place-picture (scene-width given) (scene-height given) width height))
    (define-values (x y) (values (send event get-x) (send event get-y)))
    (case (send event get-event-type)
      [(left-down middle-down right-down)
       (send canvas focus)
       (define gesture
         (button-gesture (case (send event get-event-type)
                           [(left-down) 'left] [(middle-down) 'middle] [else 'right])
                         #:shift? (send event get-shift-down)
                         #:control? (send event get-control-down)))
       (if (eq? gesture 'focus)
           (focus! (/ (- x left) scale) (/ (- y top) scale))
           (look! (look-press now-seen gesture x y)))]
      [(left-up middle-up right-up) (look! (look-release now-seen))]
      [(motion)
       (when (look-drag now-seen)
         (look! (look-move now-seen x y (* scale (scene-width given))
                           (* scale (scene-height given)))))]))

  ;; The world may have to be made ready first, which takes time.
  (define (focus! x y)
    (define camera (look-camera now-seen))
    (define-values (world width height)
      (values (scene-world given) (scene-width given) (scene-height given)))
    (when (and (<= 0 x width) (<= 0 y height))
      (define (find)
         (define focused (Camera-focused world camera (- x 0.5) (- y 0.5) width height))
         (in-window
          (lambda ()
            (cond
              [(not focused) (tell! "nothing is there to focus on")]
              [(equal? camera (look-camera now-seen))
               (look! (look-focused now-seen focused))
               (tell! (focus-text (Camera-focus-distance focused)
                                  (Camera-lens-radius focused)))]))))
      (parameterize ([current-custodian keeper]) (thread find))))

  (send frame show #t)
  (send canvas min-client-width 80)
  (send canvas min-client-height 45)
  (send canvas focus)
  (order-picture!)
  (define watcher (and reload (watch-files files (lambda () (in-window read-again!)))))
  (lambda ()
    (send frame show #f)
    (when watcher (kill-thread watcher))
    (stop-background! background)))
