#lang racket/base
;; raco raytrace new, check and explain, as typed.
(module+ test
  (require racket/file racket/flonum racket/string rackunit raytrace "support.rkt")

  (define (output-text result) (bytes->string/utf-8 (outcome-output result)))

  (test-case "new: a scene that checks, renders, and is never written over another file"
    (call-with-folder
     (lambda (folder)
       (define made (run-command folder "new" "my-scene.rkt"))
       (check-equal? (outcome-code made) 0 (outcome-errors made))
       (check-equal? (output-text made)
                     (string-append "my-scene.rkt is written. Its picture: "
                                    "raco raytrace my-scene.rkt -o my-scene.png\n"))
       (check-equal? (files folder) '("my-scene.rkt"))
       (define checked (run-command folder "check" "my-scene.rkt"))
       (check-equal? (list (outcome-code checked) (output-text checked))
                     '(0 "my-scene.rkt: nothing looks wrong\n"))
       (check-equal? (outcome-code (run-command folder "my-scene.rkt" "-o" "a.png" "--size" "32x18"
                                                "--samples" "4" "--quiet"))
                     0)
       ;; a picture of many brightnesses: neither flat nor burnt out
       (define image (Image-read (build-path folder "a.png")))
       (define values (for/list ([x (in-flvector (Image-pixels image))]) x))
       (check-true (< 0.1 (/ (apply + values) (length values)) 0.8))
       (check-true (> (length (filter (lambda (x) (< x 0.05)) values)) 20))
       (define text (file->string (build-path folder "my-scene.rkt")))
       (check-refused folder "my-scene.rkt: expected a file that does not exist yet" "new" "my-scene.rkt")
       (check-equal? (file->string (build-path folder "my-scene.rkt")) text)
       (check-refused folder "scene.txt: expected a name that ends with .rkt, as my-scene.rkt"
                      "new" "scene.txt")
       (check-refused folder "no/a.rkt: cannot be written" "new" "no/a.rkt"))))

  (test-case "check: problems are told a line each, with code 1"
    (call-with-folder
     (lambda (folder)
       (write-scene folder "away.rkt"
                    (scene-text #:camera "(Camera-look-at (Float3 0 0 5) (Float3 0 0 9))"))
       (define result (run-command folder "check" "away.rkt"))
       (check-equal? (outcome-code result) 1)
       (check-equal? (outcome-errors result) "")
       (check-regexp-match #rx"^away.rkt: the camera sees no shape: [^\n]+\n$" (output-text result))
       (check-one-line-error (run-command folder "check" "nowhere.rkt") "nowhere.rkt"))))

  (test-case "check and explain of a mesh file; the shading that is asked for; no parts to merge"
    (call-with-folder
     (lambda (folder)
       (write-scene folder "roof.obj" "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
       (define checked (run-command folder "check" "roof.obj"))
       (check-equal? (list (outcome-code checked) (outcome-errors checked)) '(0 ""))
       (define told (run-command folder "explain" "roof.obj" "--pixel" "5,5" "--size" "16x9" "--samples" 2))
       (check-equal? (outcome-code told) 0 (outcome-errors told))
       (write-scene folder "ball.rkt" (scene-text))
       (define (drawn shading)
         (define file (string-append shading ".pfm"))
         (check-equal? (outcome-code (run-command folder "ball.rkt" "-o" file "--size" "20x20" "--quiet"
                                                  "--integrator" "raster" "--shading" shading))
                       0)
         (file->bytes (build-path folder file)))
       (check-false (equal? (drawn "phong") (drawn "normals")))
       (check-one-line-error (run-command folder "merge") "merge: expected the files of all parts"))))

  (test-case "explain: the pixel of the render with the same flags"
    (call-with-folder
     (lambda (folder)
       (write-scene folder "ball.rkt" (scene-text))
       (define flags '("--size" "20x20" "--samples" "4" "--seed" "3" "--integrator" "path"))
       (define told (apply run-command folder "explain" "ball.rkt" "--pixel" "10,9" "--paths" "2" flags))
       (check-equal? (outcome-code told) 0 (outcome-errors told))
       (define text (output-text told))
       (check-regexp-match #rx"^pixel 10,9: .*, the mean of 4 samples of " text)
       (check-equal? (length (regexp-match* #rx"\npath through " text)) 2)
       (define flags-of (list* "ball.rkt" "-o" "a.pfm" "--quiet" flags))
       (check-equal? (outcome-code (apply run-command folder flags-of)) 0)
       (define-values (red green blue) (Image-pixel (Image-read (build-path folder "a.pfm")) 10 9))
       ;; four digits are told, seven are in the file
       (define told-red (string->number (cadr (regexp-match #rx"^pixel 10,9: ([^ ]+) " text))))
       (check-= told-red red (* 1e-3 red))
       (check-refused folder "--pixel: expected the pixel to explain, as in --pixel 200,100"
                      "explain" "ball.rkt")
       (check-refused folder "--pixel 20,0: expected X,Y, two whole numbers that tell a pixel of 20x20"
                      "explain" "ball.rkt" "--pixel" "20,0" "--size" "20x20"))))

  (test-case "cost and error: false colours in a display's file, numbers in a linear one"
    (call-with-folder
     (lambda (folder)
       (write-scene folder "ball.rkt" (scene-text))
       (define (picture integrator file)
         (define result (run-command folder "ball.rkt" "-o" file "--size" "16x9" "--samples" "4"
                                     "--integrator" integrator "--quiet"))
         (check-equal? (outcome-code result) 0 (outcome-errors result))
         (Image-read (build-path folder file)))
       (define rays (picture "cost" "rays.pfm"))
       (define-values (r g b) (Image-pixel rays 8 4))
       (check-true (and (= r g b) (> r 1.0)))
       ;; where the ball is not, a sample is one ray
       (check-equal? (call-with-values (lambda () (Image-pixel rays 0 0)) list) '(1.0 1.0 1.0))
       (define-values (fr fg fb) (Image-pixel (picture "cost" "rays.png") 8 4))
       (check-true (and (<= fr 1.0) (not (= fr fb))))
       (picture "error" "error.png")
       (check-one-line-error (run-command folder "ball.rkt" "-o" "e.png" "--integrator" "error"
                                          "--samples" "1")
                             "at least 2"))))

  (test-case "help tells of them"
    (define help (bytes->string/utf-8 (outcome-output (run-command (find-system-path 'temp-dir) "--help"))))
    (for ([part (in-list '("new FILE" "check SCENE" "explain SCENE --pixel X,Y"))])
      (check-true (string-contains? help part) part))
    (for ([word (in-list '("new" "check" "explain"))])
      (define result (run-command (find-system-path 'temp-dir) word "--help"))
      (check-equal? (outcome-code result) 0)
      (check-true (string-contains? (output-text result) (string-append word " [ <option>"))))))
