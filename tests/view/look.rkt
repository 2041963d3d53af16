#lang racket/base
;; What keys and mouse make of what is shown.
(module+ test
  (require rackunit raytrace "../../private/view/gestures.rkt" "../../private/view/look.rkt")

  (define camera (Camera-look-at (Float3 1 2 6) (Float3 0 0 0)))
  (define first (first-look camera))

  (test-case "a drag goes from where it started, however often it moves, and ends"
    (define pressed (look-press first 'orbit 100 50))
    (define moved
      (for/fold ([old pressed]) ([x '(110 190 130 160)] [y '(50 51 90 40)]) 
        (look-move old x y 320 200)))
    (check-equal? (look-camera moved) (Camera-dragged camera 'orbit 60 -10 320 200))
    (define released (look-release moved))
    (check-equal? (look-camera released) (look-camera moved))
    (check-equal? (look-move released 10 10 320 200) released)
    (check-equal? (look-move first 10 10 320 200) first))

  (test-case "the wheel, the focus, and home again"
    (define near (look-wheel first 2))
    (check-equal? (look-camera near) (Camera-wheeled camera 2))
    (define focused (look-focused near (Camera-with camera #:focus-distance 3)))
    (check-equal? (Camera-focus-distance (look-camera focused)) 3.0)
    (check-equal? (look-command (look-command focused 'brighter) 'home) first))

  (test-case "exposure in half stops; the keys are told and hidden"
    (define (after . commands) (for/fold ([old first]) ([c commands]) (look-command old c)))
    (check-equal? (look-stops (after 'brighter 'brighter 'darker)) 0.5)
    (check-equal? (look-stops (after 'darker)) -0.5)
    (check-true (look-keys? (after 'keys)))
    (check-false (look-keys? (after 'keys 'keys)))
    (for ([other '(print copy save save-as reload close)]) (check-equal? (after other) first)))

  (test-case "a scene that was read again moves the camera only where the scene's own has changed"
    (define moved (look-wheel first 1))
    (check-equal? (look-at-scene moved camera) moved)
    (define other (Camera-look-at (Float3 9 2 6) (Float3 0 0 0)))
    (check-equal? (look-camera (look-at-scene moved other)) other)
    (check-equal? (look-camera (look-command (look-at-scene moved other) 'home)) other))

  (test-case "every key that is told does something, and every button"
    (for* ([pair KEYS] [key (regexp-match* #px"(?<= |^)(?:\\S|Escape)(?= |$)" (car pair))]
           #:unless (regexp-match? #rx"drag|click|wheel" (car pair)))
      (check-not-false (key-command (if (string=? key "Escape") 'escape (string-ref key 0))) key))
    (check-false (key-command #\x))
    (check-false (key-command 'shift))
    (check-equal? (list (button-gesture 'left) (button-gesture 'middle) (button-gesture 'right)
                        (button-gesture 'left #:shift? #t) (button-gesture 'left #:control? #t))
                  '(orbit pan focus pan focus))))
