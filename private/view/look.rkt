#lang racket/base
;; What a window shows beside the picture itself: from where, how bright, whether the keys are told;
;; and what keys and mouse make of it. All of it is pure.
(require "gestures.rkt")

(provide (struct-out look) first-look look-at-scene look-focused look-press look-move look-release
         look-wheel look-command button-gesture key-command KEYS)

;; camera: where one looks from. home: the scene's camera. vertical: what one orbits about. stops: the
;; exposure. keys?: whether the keys are told. drag: #f, or what a drag started from.
(struct look (camera home vertical stops keys? drag) #:transparent)
(struct drag (gesture x y camera) #:transparent)

;; first-look : through a scene's camera.
(define (first-look camera) (look camera camera (Camera-vertical camera) 0.0 #f #f))

;; look-at-scene : through the camera of a scene that was read again. Where the scene has not changed
;; it, the camera that was found by hand stays.
(define (look-at-scene old camera)
  (if (equal? camera (look-home old))
      old
      (struct-copy look old [camera camera] [home camera] [vertical (Camera-vertical camera)]
                   [drag #f])))

;; look-focused : through the same camera with another focus.
(define (look-focused old camera) (struct-copy look old [camera camera] [drag #f]))

;; ----------------------------------------------------------------------------------------------
;; The mouse

;; button-gesture : what starts where a button goes down: 'orbit, 'pan, 'focus, or #f.
(define (button-gesture button #:shift? [shift? #f] #:control? [control? #f])
  (case button
    [(left) (cond [control? 'focus] [shift? 'pan] [else 'orbit])]
    [(middle) 'pan]
    [(right) 'focus]
    [else #f]))

;; look-press, look-move, look-release : 'orbit or 'pan starts at a place in the window, goes on to
;; another while the picture is shown that wide and high, and ends.
(define (look-press old gesture x y)
  (struct-copy look old [drag (drag gesture x y (look-camera old))]))

(define (look-move old x y width height)
  (define from (look-drag old))
  (if from
      (struct-copy look old
                   [camera (Camera-dragged (drag-camera from) (drag-gesture from)
                                           (- x (drag-x from)) (- y (drag-y from)) width height
                                           #:vertical (look-vertical old))])
      old))

(define (look-release old) (struct-copy look old [drag #f]))

;; look-wheel : the wheel turned by so many notches, forward where they are positive.
(define (look-wheel old notches)
  (struct-copy look old [camera (Camera-wheeled (look-camera old) notches)] [drag #f]))

;; ----------------------------------------------------------------------------------------------
;; The keys

;; What is told of them: the key, and what it does.
(define KEYS
  '(("left drag" "orbit around what is in focus")
    ("middle or shift drag" "move sideways")
    ("wheel" "nearer, farther")
    ("right or control click" "focus on what is there")
    ("+  -" "half a stop brighter, darker")
    ("0" "the scene's own camera and exposure")
    ("p  c" "print the camera, copy it")
    ("s  S" "save the picture, save it as ...")
    ("r" "read the scene again")
    ("h  ?" "show or hide this")
    ("q  Escape" "close")))

;; key-command : what a key asks for, a symbol, or #f. key: a character, or a symbol as racket/gui's
;; key codes are.
(define (key-command key)
  (case key
    [(#\+ #\= add) 'brighter]
    [(#\- #\_ subtract) 'darker]
    [(#\0 home) 'home]
    [(#\p) 'print]
    [(#\c) 'copy]
    [(#\s) 'save]
    [(#\S) 'save-as]
    [(#\r #\R f5) 'reload]
    [(#\h #\H #\? f1) 'keys]
    [(#\q #\Q escape) 'close]
    [else #f]))

(define HALF-STOP 0.5)
(define MOST-STOPS 30.0)

;; look-command : what is shown after a command that changes that; others leave it as it is.
(define (look-command old command)
  (define (exposed by)
    (struct-copy look old [stops (max (- MOST-STOPS) (min MOST-STOPS (+ (look-stops old) by)))]))
  (case command
    [(brighter) (exposed HALF-STOP)]
    [(darker) (exposed (- HALF-STOP))]
    [(home) (struct-copy look old [camera (look-home old)] [stops 0.0] [drag #f])]
    [(keys) (struct-copy look old [keys? (not (look-keys? old))])]
    [else old]))
