#lang racket/base
;; Pictures as textures: which way up, exact bilinear values, wrapping, sRGB.
(module+ test
  (require rackunit racket/class racket/file racket/flonum racket/list racket/math raytrace "support.rkt"
           (only-in "../../../private/image/image.rkt" make-Image))

  (define (make-picture width height colors)
    (make-Image width height (apply flvector (append* colors))))

  ;; red green / blue white
  (define turned-picture
    (make-picture 2 2 '((1.0 0.0 0.0) (0.0 1.0 0.0) (0.0 0.0 1.0) (1.0 1.0 1.0))))

  (define names (hash '(1.0 0.0 0.0) 'red '(0.0 1.0 0.0) 'green
                      '(0.0 0.0 1.0) 'blue '(1.0 1.0 1.0) 'white))
  (define (name color)
    (for/first ([(known name) names] #:when (same-color? known color 1e-12)) name))

  (test-case "orientation: a square's texture turns with its edges, by 0, 90, 180 and 270 degrees"
    ;; corner and edges of the unit square, turned; what is seen upper left, upper right, lower
    ;; left and lower right
    (for* ([turn '(((0 0) (1 0) (0 1)   red green blue white)
                   ((1 0) (0 1) (-1 0)  green white red blue)
                   ((1 1) (-1 0) (0 -1) white blue green red)
                   ((0 1) (0 -1) (1 0)  blue red white green))]
           [filter '(bilinear nearest)])
      (define (float3 l) (Float3 (car l) (cadr l) 0))
      (define look
        (looker (Quad (float3 (first turn)) (float3 (second turn)) (float3 (third turn))
                      (shining (ImageTexture turned-picture filter)))))
      (check-equal? (for/list ([at '((0.25 0.75) (0.75 0.75) (0.25 0.25) (0.75 0.25))])
                      (name (components (look (car at) (cadr at)))))
                    (list-tail turn 3))))

  (random-seed 2)
  (define width 5)
  (define height 3)
  (define colors
    (for/list ([k (* width height)]) (for/list ([c 3]) (/ (random 1024) 1024.0))))
  (define picture (make-picture width height colors))

  ;; A pixel's share of the value at a place: a tent one pixel wide, over the given copies of it.
  (define (tent d) (max 0.0 (- 1.0 (abs d))))
  (define (bilinear x y copies)
    (for/fold ([sum '(0.0 0.0 0.0)]) ([color colors] [k (in-naturals)])
      (define share
        (* (for/sum ([i copies])
             (tent (- (* width x) 0.5 (remainder k width) (* width i))))
           (for/sum ([i copies])
             (tent (- (* height (- 1 y)) 0.5 (quotient k width) (* height i))))))
      (for/list ([s sum] [c color]) (+ s (* share c)))))

  (test-case "bilinear and repeated: tents over the pixels and their copies, to 1e-12"
    (define look (seen (ImageTexture picture)))
    (for ([k 200])
      (define-values (x y) (values (random) (random)))
      (check-true (same-color? (look x y) (bilinear x y '(-1 0 1)) 1e-12))))

  (test-case "clamped: inside the pixels' middles the same, beyond them the border's colour"
    (define look (seen (ImageTexture picture #:wrap 'clamp)))
    (check-true (same-color? (look 0.37 0.61) (bilinear 0.37 0.61 '(0)) 1e-12))
    (check-true (same-color? (look 0.02 0.98) (first colors) 1e-12))
    (check-true (same-color? (look 0.98 0.02) (last colors) 1e-12)))

  (test-case "nearest and repeated over a plane"
    (define look
      (looker (Plane (Float3 0 0 0) (Float3 0 0 1) (shining (ImageTexture picture 'nearest)))))
    ;; a plane's u and v are coordinates, along directions of its own
    (for* ([x '(-2.3 0.1 4.7)] [y '(-1.9 0.2 3.3)])
      (define here (components (look x y)))
      (check-not-false (member here colors))
      (check-equal? (components (look (+ x 1) (- y 2))) here)))

  (define (linear byte)
    (define s (/ byte 255.0))
    (if (<= s 0.04045) (/ s 12.92) (expt (/ (+ s 0.055) 1.055) 2.4)))

  (test-case "8-bit pictures are decoded from sRGB"
    (define file (make-temporary-file "texture~a.ppm"))
    (call-with-output-file file #:exists 'truncate
      (lambda (out) (write-bytes #"P6 1 1 255\n\200\12\377" out)))
    (define shown ((seen (ImageTexture (Image-read file))) 0.4 0.6))
    (delete-file file)
    (check-true (same-color? shown (map linear '(128 10 255)) 1e-12)))

  (test-case "a JPEG as a texture: its quarters upright and in their colours, to 0.03"
    (define file (make-temporary-file "texture~a.jpg"))
    (define bitmap ((dynamic-require 'racket/draw 'make-bitmap) 32 16 #f))
    ;; red green / blue grey
    (define bytes-of-pixels
      (apply bytes-append
             (for*/list ([y 16] [x 32])
               (bytes-append #"\377" (if (< y 8)
                                         (if (< x 16) #"\310\24\36" #"\24\264\50")
                                         (if (< x 16) #"\24\36\322" #"\200\200\200"))))))
    (send bitmap set-argb-pixels 0 0 32 16 bytes-of-pixels)
    (check-true (send bitmap save-file file 'jpeg 95))
    (define look (seen (ImageTexture (Image-read file) 'nearest)))
    (delete-file file)
    (for ([at '((0.27 0.77) (0.77 0.77) (0.27 0.27) (0.77 0.27))]
          [color '((200 20 30) (20 180 40) (20 30 210) (128 128 128))])
      (define shown (look (car at) (cadr at)))
      (check-true (same-color? shown (map linear color) 0.03) (format "~a: ~a" at shown))))

  (test-case "a picture of a square with a picture on it has the picture's mean"
    (define world
      (World (list (Quad (Float3 -8 -8 0) (Float3 16 0 0) (Float3 0 16 0)
                         (Lambertian (ImageTexture picture))))
             '() (Float3 1 1 1)))
    (define camera
      (Camera-look-at (Float3 0 0 9) (Float3 0 0 0)
                      #:vertical-field-of-view-degrees (* 2 (/ 180 pi) (atan 8/9))))
    (define image (render world camera #:width 24 #:height 24 #:samples 16))
    (for ([channel 3])
      (define expected (/ (for/sum ([c colors]) (list-ref c channel)) (length colors)))
      (define mean
        (/ (for/sum ([k 576]) (flvector-ref (Image-pixels image) (+ channel (* 3 k)))) 576))
      (check-= mean expected 2e-3))))
