#lang racket/base
;; The flags of rendering. They may stand before and after the scene.
(require racket/cmdline "values.rkt")

(provide parse-render-flags parse-words)

;; parse-render-flags : the options that are set, a hash from symbols to checked values, and the
;; scene's name. Prints the help and exits where it is asked for.
(define (parse-render-flags program words)
  (parse-words program words render-flags '("scene")
               (lambda (settings scene) (values (make-immutable-hasheq settings) scene))))

(define (count-flag key check)
  (lambda (flag text) (cons key (check flag text (text->natural text)))))

(define (text-flag key)
  (lambda (flag text) (cons key text)))

(define (name-flag key)
  (lambda (flag text) (cons key (string->symbol text))))

(define (switch key)
  (lambda (flag) (cons key #t)))

(define render-flags
  `((usage-help
     "Renders <scene>: a Racket module that provides `world` and `camera`, and perhaps `settings`,"
     "given as a .rkt file or as the name of a scene of this package; or a mesh, .obj, .ply or .stl."
     "Or, in place of <scene> and options:"
     "  list           tells the scenes of this package"
     "  compare A B    tells how far picture A is from picture B"
     "  new FILE       writes a commented scene to start from"
     "  check SCENE    finds what is probably wrong with a scene"
     "  explain SCENE --pixel X,Y"
     "                 tells why a pixel looks as it does: paths, lights, where light comes from"
     "  view SCENE     shows a scene in a window, where the mouse moves the camera"
     "  merge PART...  joins the parts of a picture that --part rendered")
    (once-each
     [("-o" "--output") ,(text-flag 'output)
                        (("Write the picture to <file>: .ppm, .png, .pfm or .hdr (linear);"
                          "- is PPM to standard output; by default the scene's name with .ppm")
                         "file")]
     [("--size") ,(lambda (flag text)
                    (cons 'size (check-size flag text (text->naturals text #rx"x"))))
                 ("Width and height in pixels; by default the scene's, else 640x360" "WxH")]
     [("--samples") ,(count-flag 'samples check-samples)
                    (("Camera rays for a pixel; by default the scene's, else 16."
                      "With --error or --seconds the most for a pixel, by default 65536")
                     "n")]
     [("--error") ,(lambda (flag text) (cons 'error (check-error flag text (text->part text))))
                  (("Go on until the picture's estimated RMSE is this part of its mean,"
                    "such as 0.01 or 1%, with samples where they pay")
                   "e")]
     [("--seconds") ,(lambda (flag text)
                       (cons 'seconds (check-seconds flag text (text->positive text))))
                    ("The best picture in that time" "s")]
     [("--seed") ,(count-flag 'seed check-seed)
                 ("Another seed gives another noise; by default the scene's, else 0" "n")]
     [("--sampler") ,(name-flag 'sampler)
                    (("How samples are spread: owen-sobol (the default), independent,"
                      "stratified or r2")
                     "name")]
     [("--filter") ,(name-flag 'filter)
                   (("What a pixel sees of its neighbourhood: box (the default), tent,"
                     "gaussian or blackman-harris")
                    "name")]
     [("--integrator") ,(name-flag 'integrator)
                       (("What a pixel shows:"
                         "auto, path, naive-path, seed, ambient-occlusion, normals or depth; raster,"
                         "which draws at once; or what auto takes: cost, in rays, or error; in false"
                         "colours but to .pfm and .hdr")
                        "name")]
     [("--shading") ,(lambda (flag text)
                       (cons 'shading (map string->symbol (regexp-split #rx"," text))))
                    (("With --integrator raster: phong (the default), gouraud, flat, toon, wireframe,"
                      "hidden-lines, normals, depth or texture-coordinates; several, with commas between them,"
                      "give as many pictures side by side")
                     "name")]
     [("--max-depth") ,(count-flag 'max-depth check-max-depth)
                      ("Bounces of a path; by default the scene's, else without limit" "n")]
     [("--crop") ,(text-flag 'crop)
                 ("Render only this part of the picture" "X,Y,W,H")])
    (help-labels "" "These change how fast the picture comes, and not one bit of it:" "")
    (once-each
     [("--schedule") ,(name-flag 'schedule) (("sequential, futures (the default), places, or hosts:FILE: over ssh on the hosts of a file,"
                       "each line [user@]host[:port] [workers] [racket]")
                      "name")]
     [("--workers") ,(count-flag 'workers check-workers)
                    ("How many at a time; by default one for each processor" "n")]
     [("--tile") ,(count-flag 'tile check-tile)
                 ("Side of the squares that workers take, in pixels; by default 16" "n")])
    (help-labels "" "Long renders and many machines:" "")
    (once-each
     [("--resume") ,(switch 'resume)
                   ("Keep what is done in <output>.checkpoint, and go on from there")]
     [("--checkpoint-seconds") ,(lambda (flag text)
                                  (cons 'checkpoint-seconds
                                        (check-seconds flag text (text->positive text))))
                               ("At least this long between two checkpoints; by default 10" "s")]
     [("--keep-partial") ,(switch 'keep-partial)
                         ("After an interrupt write the picture as far as it got")]
     [("--part") ,(lambda (flag text)
                    (cons 'part (check-part flag text (text->naturals text #rx"/"))))
                 (("Render the I-th of N parts into a file that `raco raytrace merge` takes;"
                   "by default the scene's name with .I-of-N.part")
                  "I/N")])
    (help-labels "" "A pixel where a function of the scene raises twice is told and left magenta, (1, 0, 1):" "")
    (once-each
     [("--strict") ,(switch 'strict) ("Stop at such a pixel instead, with one line")])
    (help-labels "" "What is told on standard error:" "")
    (once-each
     [("--stats") ,(switch 'stats) ("Counts and times")]
     [("--stats-json") ,(text-flag 'stats-json) ("The same as JSON in <file>" "file")]
     [("--preview") ,(switch 'preview)
                    ("The picture as it forms, in a terminal of 24-bit colours")]
     [("--quiet") ,(switch 'quiet) ("No progress and no closing line")])))

;; ----------------------------------------------------------------------------------------------

;; parse-words : parse-command-line for a program with its words, where flags may follow other words
;; and errors do not start with the program's name. table: the flags as parse-command-line takes them.
;; names: what the other words stand for. finish: called with the list of flag values and those words.
(define (parse-words program words table names finish)
  (define prefix (string-append program ": "))
  (with-handlers ([exn:fail:user?
                   (lambda (e) (raise-user-error (without-prefix prefix (exn-message e))))])
    (parse-command-line program (flags-first words table) table finish names
                        (lambda (help) (display help) (exit 0))
                        (lambda (flag)
                          (raise-user-error
                           (format "~a: expected one of the flags that --help tells" flag))))))

(define (without-prefix prefix text)
  (if (and (> (string-length text) (string-length prefix))
           (string=? prefix (substring text 0 (string-length prefix))))
      (substring text (string-length prefix))
      text))

;; The same words with the flags and what belongs to them moved to the front.
(define (flags-first words table)
  (define with-argument
    (for*/list ([set (in-list table)] #:when (memq (car set) '(once-each once-any multi))
                [line (in-list (cdr set))] #:unless (null? (cdr (caddr line)))
                [flag (in-list (car line))])
      flag))
  (let sort ([words words] [flags '()] [others '()])
    (define (done others) (append (reverse flags) '("--") others))
    (cond
      [(null? words) (done (reverse others))]
      [(string=? (car words) "--") (done (append (reverse others) (cdr words)))]
      [(not (regexp-match? #rx"^-." (car words)))
       (sort (cdr words) flags (cons (car words) others))]
      [(member (car words) with-argument)
       (when (null? (cdr words))
         (raise-user-error (format "~a: expected a value after it, found none" (car words))))
       (sort (cddr words) (list* (cadr words) (car words) flags) others)]
      [else (sort (cdr words) (cons (car words) flags) others)])))
