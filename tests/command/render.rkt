#lang racket/base
;; Pictures by the command: the same bytes however they are made, formats by extension, parts, and
;; what is told on the side.
(module+ test
  (require file/sha1 json racket/file rackunit "support.rkt"
           "../../private/command/render.rkt" "../../private/image/image.rkt"
           "../../private/image/write.rkt")

  (define settings '("seed" "--size" "64x36" "--samples" "2"))

  (call-with-folder
   (lambda (folder)
     (define (sha256 file)
       (bytes->hex-string (sha256-bytes (file->bytes (build-path folder file)))))

     ;; the real command with 1, 2 and 7 workers, and once more
     (define sums
       (for/list ([workers (in-list '(1 2 7 7))])
         (define result
           (apply run-command folder (append settings (list "--workers" workers "-o" "a.ppm"))))
         (check-equal? (outcome-code result) 0)
         (check-equal? (outcome-output result) #"")
         (check-regexp-match #px"^a.ppm: 64x36, 2 samples a pixel, error [0-9.]+%, [0-9.]+ s\n$"
                             (outcome-errors result))
         (sha256 "a.ppm")))
     (check-equal? sums (list (car sums) (car sums) (car sums) (car sums)))
     (define whole (Image-read (build-path folder "a.ppm")))

     ;; to standard output: the same bytes and nothing else
     (define output (apply run-command folder (append settings '("-o" "-" "--quiet"))))
     (check-equal? (outcome-code output) 0)
     (check-equal? (outcome-errors output) "")
     (check-equal? (bytes->hex-string (sha256-bytes (outcome-output output))) (car sums))
     (check-equal? (subbytes (outcome-output output) 0 13) #"P6\n64 36\n255\n")
     (check-equal? (bytes-length (outcome-output output)) (+ 13 (* 3 64 36)))

     ;; the rest in this process; options as the flags make them
     (define (rendered file . options)
       (parameterize ([current-directory folder])
         (render-scene (hash-set* (apply hasheq options) 'quiet #t 'output file) "seed"))
       (build-path folder file))
     (define (rendered-sum . options)
       (apply rendered "b.ppm" 'size '(64 36) 'samples 2 options)
       (sha256 "b.ppm"))
     (check-equal? (rendered-sum) (car sums))
     (check-equal? (rendered-sum 'schedule 'sequential) (car sums))
     (for ([tile (in-list '(1 5 64 1000))])
       (check-equal? (rendered-sum 'tile tile) (car sums)))
     (check-equal? (rendered-sum 'schedule 'sequential 'tile 7) (car sums))
     (check-equal? (rendered-sum 'schedule 'places 'workers 2) (car sums))
     ;; what must change the picture does
     (check-not-equal? (rendered-sum 'seed 1) (car sums))
     (check-not-equal? (rendered-sum 'integrator 'normals) (car sums))

     ;; a part is the same part of the whole, exactly
     (define part
       (Image-read (rendered "c.ppm" 'size '(64 36) 'samples 2 'crop "30,11,17,9")))
     (check-equal? (list (Image-width part) (Image-height part)) '(17 9))
     (for* ([y (in-range 9)] [x (in-range 17)])
       (check-equal? (call-with-values (lambda () (Image-pixel part x y)) list)
                     (call-with-values (lambda () (Image-pixel whole (+ x 30) (+ y 11))) list)))

     ;; formats by extension; .PNG holds the same bytes a channel as .ppm
     (define (first-bytes path count) (call-with-input-file path (lambda (in) (read-bytes count in))))
     (define png (rendered "d.PNG" 'size '(64 36) 'samples 2))
     (check-equal? (first-bytes png 8) #"\211PNG\r\n\32\n")
     (check-equal? (Image-read png) whole)
     (check-equal? (first-bytes (rendered "e.pfm" 'size '(64 36) 'samples 2) 9) #"PF\n64 36\n")

     ;; a scene's settings count where no flag does; the file's name is the scene's
     (define scene
       (write-scene folder "small.rkt"
                    (scene-text #:provide "world camera settings"
                                "(display \"printed by the scene\\n\")"
                                "(define settings (hash 'size '(8 4) 'samples 3 'seed 7))")))
     (define result
       (run-command folder "small.rkt" "--stats" "--stats-json" "s.json" "--quiet" "--seed" "9"))
     (check-equal? (outcome-output result) #"")
     (check-equal? (first-bytes (build-path folder "small.ppm") 11) #"P6\n8 4\n255\n")
     (check-regexp-match
      #px"^printed by the scene\npixels +32\nsamples per pixel +3\npasses +1\nrelative error[^\n]+\nits standard error[^\n]+\nnearest-hit rays +[0-9]+\n"
      (outcome-errors result))
     (define statistics (call-with-input-file (build-path folder "s.json") read-json))
     (check-equal? (for/list ([key (in-list '(scene file width height samples seed pixels))])
                     (hash-ref statistics key))
                   '("small.rkt" "small.ppm" 8 4 3 9 32))
     (check-true (< 0 (hash-ref statistics 'peakMebibytes) 2000))
     (check-equal? (sort (files folder) string<?)
                   '("a.ppm" "b.ppm" "c.ppm" "d.PNG" "e.pfm" "s.json" "small.ppm" "small.rkt"))

     ;; statistics may go to standard output where the picture does not
     (define numbers (run-command folder scene "--quiet" "-o" "f.ppm" "--stats-json" "-"))
     (check-equal? (hash-ref (read-json (open-input-bytes (outcome-output numbers))) 'pixels) 32)
     (check-refused folder "--stats-json -: expected a file, standard output takes the picture"
                    scene "--quiet" "-o" "-" "--stats-json" "-"))))
