#lang racket/base
;; Writing by name: formats, whole files or none, one-line errors before and after; reading by
;; content; what loading the writer loads.
(module+ test
  (require racket/file racket/flonum racket/runtime-path rackunit "support.rkt"
           "../../private/image/image.rkt" "../../private/image/write.rkt")

  (define ppm #"P6\n2 2\n255\n\377\0\0\0\377\0\0\0\377\377\377\377")
  (define (files folder) (map path->string (directory-list folder)))
  ;; an image whose numbers end too soon: every writer fails in the middle of its file
  (define broken (Image 200 200 (make-flvector 30) #f))

  (call-with-folder
   (lambda (folder)
     (define (in name) (build-path folder name))

     ;; the extension tells the format, in either case; reading goes by content
     (for ([name (in-list '("a.ppm" "b.PPM" "c.pfm" "d.Pfm" "e.png" "f.PNG" "g.hdr" "h.HDR"
                                "two.dots.ppm"))]
           [start (in-list '(#"P6" #"P6" #"PF" #"PF" #"\211P" #"\211P" #"#?" #"#?" #"P6"))])
       (Image-write small-image (in name))
       (check-equal? (subbytes (file->bytes (in name)) 0 2) start name)
       (check-equal? (Image-read (in name)) small-image name))
     (check-equal? (file->bytes (in "a.ppm")) ppm)
     (Image-write small-image (path->string (in "named")) #:format 'ppm)
     (check-equal? (file->bytes (in "named")) ppm)
     (Image-write small-image (in "named.png") #:format 'pfm)
     (check-equal? (Image-read (in "named.png")) small-image)

     ;; an existing file is replaced, through a link too
     (write-file (in "old.ppm") (make-bytes 1000 1))
     (make-file-or-directory-link (in "old.ppm") (in "link.ppm"))
     (Image-write small-image (in "link.ppm"))
     (check-true (link-exists? (in "link.ppm")))
     (check-equal? (file->bytes (in "old.ppm")) ppm)

     ;; relative names
     (parameterize ([current-directory folder])
       (check-output-path "near.ppm")
       (check-false (file-exists? "near.ppm"))
       (Image-write small-image "near.ppm")
       (check-equal? (file->bytes "near.ppm") ppm)
       ;; standard output
       (check-output-path "-")
       (for ([format (in-list '(#f pfm))] [start (in-list '(#"P6" #"PF"))])
         (define out (open-output-bytes))
         (parameterize ([current-output-port out])
           (Image-write small-image "-" #:format format))
         (check-equal? (subbytes (get-output-bytes out) 0 2) start))
       (check-false (file-exists? "-")))
     (define-values (in-end out-end) (make-pipe))
     (close-output-port out-end)
     (check-one-line (lambda ()
                       (parameterize ([current-output-port out-end])
                         (Image-write small-image "-")))
                     "standard output: cannot be written")

     ;; the same errors before and after rendering, and nothing left behind
     (define before (files folder))
     (define (refused path . parts)
       (define (check thunk) (apply check-one-line thunk parts))
       (check (lambda () (check-output-path path)))
       (check (lambda () (Image-write small-image path))))
     (refused (in "a.jpg") "a.jpg" ".ppm, .pfm, .hdr or .png")
     (refused (in "ppm") ".ppm, .pfm, .hdr or .png")
     (refused (in "a.ppm.gz") ".ppm, .pfm, .hdr or .png")
     (refused "" "name of a picture file")
     (refused (in "absent/a.ppm") "absent/a.ppm" "no folder")
     (refused (in "a.ppm/b.ppm") "a.ppm/b.ppm" "cannot be written")
     (refused (in (string-append (make-string 300 #\x) ".ppm")) "cannot be written")
     (make-directory (in "folder.ppm"))
     (refused (in "folder.ppm") "folder.ppm" "found a folder")
     (delete-directory (in "folder.ppm"))
     (check-one-line (lambda () (check-output-path folder #:format 'ppm)) "found a folder")
     (refused (in "two\nlines.gif") "two?lines.gif")
     (check-exn exn:fail:contract? (lambda () (Image-write small-image (in "a.ppm") #:format 'gif)))
     (check-exn exn:fail:contract? (lambda () (Image-write 7 (in "a.ppm"))))
     ;; a name that passes the check is free afterwards
     (check-output-path (in "new.ppm"))
     (check-equal? (files folder) before)

     ;; a failure in the middle leaves the old file, and no other
     (for ([name (in-list '("a.ppm" "c.pfm" "e.png" "new.ppm" "new.pfm" "new.png"))])
       (check-one-line (lambda () (Image-write broken (in name))) name "cannot be written"))
     (check-equal? (files folder) before)
     (check-equal? (file->bytes (in "a.ppm")) ppm)

     ;; a break in the middle: the whole picture or none, and no other file
     (define large (random-image 900 900 5))
     (for ([wait (in-list '(0.0 0.005 0.02 0.05))])
       (define writer
         (thread (lambda ()
                   (with-handlers ([exn:break? void]) (Image-write large (in "broken-off.pfm"))))))
       (sleep wait)
       (break-thread writer)
       (thread-wait writer)
       (when (file-exists? (in "broken-off.pfm"))
         (check-equal? (file-size (in "broken-off.pfm")) (+ 16 (* 12 900 900)))
         (delete-file (in "broken-off.pfm"))))
     (check-equal? (files folder) before)

     ;; a device is written in place, and a full one says so
     (when (file-exists? "/dev/full")
       (define message
         (one-line-error (lambda () (Image-write large "/dev/full" #:format 'ppm))))
       (check-true (regexp-match? #rx"^/dev/full: cannot be written [(].*space" message) message)
       (check-output-path "/dev/null" #:format 'ppm)
       (Image-write small-image "/dev/null" #:format 'ppm)
       (check-true (file-exists? "/dev/null"))
       (check-equal? (file-size "/dev/null") 0))

     ;; reading what is no picture
     (define (unreadable bytes . parts)
       (apply check-one-line (lambda () (Image-read (write-file (in "unreadable.ppm") bytes))) parts))
     (unreadable #"" "unreadable.ppm: byte 0" "end of the file")
     (unreadable #"GIF89a" "unreadable.ppm: byte 0" "PPM (P6, P3), PFM, HDR, PNG or JPEG" "GIF8")
     (unreadable #"P" "byte 0")
     (unreadable #"P6\n" "byte 3" "width")
     (check-one-line (lambda () (Image-read (in "absent.ppm"))) "absent.ppm" "no such file")
     (check-one-line (lambda () (Image-read folder)) "a folder")
     (check-one-line (lambda () (Image-read "a\0b.ppm")) "no such file")))

  ;; loading the writer loads no drawing, mathematics or compression, nor the type checker
  (define-runtime-path writer "../../private/image/write.rkt")
  (parameterize ([current-namespace (make-base-empty-namespace)])
    (dynamic-require writer #f)
    (for ([heavy (in-list '(racket/draw racket/gui/base math math/flonum plot pict file/gzip
                                        typed/racket/unsafe
                                        typed-racket/typecheck/tc-toplevel))])
      (check-false (module-declared? heavy #f) (format "~a is loaded" heavy)))
    (check-true (module-declared? writer #f))))
