#lang racket/base
;; Picture files by name: writing whole files or none, checking a name before a long render, and
;; reading by content.
(provide Image-write Image-read check-output-path call-with-whole-file)
(require "image.rkt" "ppm.rkt" "source.rkt" racket/lazy-require)

(lazy-require ["pfm.rkt" (Image-write-pfm Image-read-pfm)]
              ["hdr.rkt" (Image-write-hdr Image-read-hdr)]
              ["png.rkt" (Image-write-png Image-read-png Image-read-jpeg)])

;; Image-write : writes the image to a file whose extension tells the format: .ppm (P6, sRGB), .pfm
;; (linear float), .hdr (linear, Radiance RGBE) or .png (sRGB), in either case; #:format 'ppm, 'pfm,
;; 'hdr or 'png overrides it. "-" is the current output port, PPM unless said otherwise. The file
;; appears whole or not at all: it is written under a temporary name beside it and renamed. Raises
;; exn:fail:user on failure.
(define (Image-write image path #:format [format #f])
  (unless (Image? image)
    (raise-argument-error 'Image-write "Image?" image))
  (define write-to (writer-of (format-of 'Image-write path format)))
  (define (write-image out)
    (write-to image out)
    (flush-output out))
  (cond [(standard-output? path)
         (with-handlers ([exn:fail? (lambda (e) (unwritable "standard output" e))])
           (write-image (current-output-port)))]
        [(special-file? path)
         (with-handlers ([exn:fail? (lambda (e) (unwritable path e))])
           (call-with-output-file path #:exists 'append write-image))]
        [else
         (call-with-whole-file path write-image)]))

;; call-with-whole-file : calls use with an output port to a file that appears whole or not at all: it is
;; written under a temporary name beside it and renamed. Raises exn:fail:user on failure.
(define (call-with-whole-file path use)
  (call-with-temporary-file
   path
   (lambda (out temporary target)
     (use out)
     (close-output-port out)
     (rename-file-or-directory temporary target #t))))

;; check-output-path : raises the error Image-write would raise for this path, as far as it can
;; be known beforehand (extension, folder, permission), leaving nothing behind.
(define (check-output-path path #:format [format #f])
  (format-of 'check-output-path path format)
  (unless (or (standard-output? path) (special-file? path))
    (call-with-temporary-file path (lambda (out temporary target)
                                     (close-output-port out)
                                     (delete-file temporary)))))

;; Image-read : the Image in a PPM (P3, P6), PFM, Radiance, PNG or JPEG file, told by its first bytes.
(define (Image-read path)
  (define bytes
    (read-picture-file path '(#"P6" #"P3" #"PF" #"Pf" #"#?" #"\211PNG" #"\377\330")
                       "a PPM (P6, P3), PFM, HDR, PNG or JPEG picture" #:only-start? #t))
  (define read-from
    (case (bytes-ref bytes 0)
      [(#x89) Image-read-png]
      [(#xFF) Image-read-jpeg]
      [(35) Image-read-hdr]
      [else (if (memv (bytes-ref bytes 1) '(51 54)) Image-read-ppm Image-read-pfm)]))
  (read-from path))

;; ----------------------------------------------------------------------------------------------

(define (writer-of format)
  (case format
    [(ppm) Image-write-ppm]
    [(pfm) Image-write-pfm]
    [(hdr) Image-write-hdr]
    [else Image-write-png]))

(define (standard-output? path)
  (equal? path "-"))

;; The format asked for, or the one the path's extension names.
(define (format-of who path requested)
  (unless (memq requested '(#f ppm pfm hdr png))
    (raise-argument-error who "(or/c #f 'ppm 'pfm 'hdr 'png)" requested))
  (unless (path-string? path)
    (picture-error (format "~s" path) "expected the name of a picture file"))
  (or requested
      (and (standard-output? path) 'ppm)
      (extension-format path)
      (picture-error path "expected a file name that ends with .ppm, .pfm, .hdr or .png")))

(define (extension-format path)
  (define name (path->bytes (if (path? path) path (string->path path))))
  (cond [(regexp-match? #rx#"[.][pP][pP][mM]$" name) 'ppm]
        [(regexp-match? #rx#"[.][pP][fF][mM]$" name) 'pfm]
        [(regexp-match? #rx#"[.][hH][dD][rR]$" name) 'hdr]
        [(regexp-match? #rx#"[.][pP][nN][gG]$" name) 'png]
        [else #f]))

(define (unwritable path failure)
  (picture-error path "cannot be written (~a)" (error-reason failure)))

;; A device or a pipe: written in place, for a rename would replace it.
(define (special-file? path)
  (and (file-exists? path)
       (let ([mode (hash-ref (file-or-directory-stat path) 'mode)])
         (not (= (bitwise-and mode #o170000) #o100000)))))

;; Calls use with an output port to a fresh file in the folder of the file that path stands for,
;; the fresh file's name, and the name that it is meant for. If that fails or is interrupted, the
;; fresh file is deleted, and failures become the one-line error that names path.
(define (call-with-temporary-file path use)
  (define target (resolve-links path))
  (define-values (folder name folder-name?) (split-path (path->complete-path target)))
  (cond [(or folder-name? (not (path? name)) (directory-exists? target))
         (picture-error path "expected the name of a file, found a folder")]
        [(not (directory-exists? folder))
         (picture-error path "cannot be written (there is no folder ~a)" folder)])
  (define-values (out temporary)
    (with-handlers ([exn:fail:filesystem? (lambda (e) (unwritable path e))])
      (open-fresh-file folder name)))
  (define (clean-up)
    (with-handlers ([exn:fail? void]) (close-output-port out))
    (with-handlers ([exn:fail? void]) (delete-file temporary)))
  (with-handlers ([exn:fail? (lambda (e) (clean-up) (unwritable path e))]
                  [exn:break? (lambda (e) (clean-up) (raise e))])
    (use out temporary target)))

;; Creates .NAME.N.part with the first N that is free.
(define (open-fresh-file folder name)
  (let try ([n 0])
    (define temporary
      (build-path folder (bytes->path (bytes-append #"." (path->bytes name) #"."
                                                    (string->bytes/latin-1 (number->string n))
                                                    #".part"))))
    (define out
      (with-handlers ([exn:fail:filesystem:exists? (lambda (e) #f)])
        (open-output-file temporary #:exists 'error)))
    (cond [out (values out temporary)]
          [else (try (+ n 1))])))

;; The file at the end of a chain of symbolic links, which a renaming must replace.
(define (resolve-links path)
  (let follow ([path (path->complete-path path)] [links-left 40])
    (if (and (link-exists? path) (positive? links-left))
        (let-values ([(folder name folder-name?) (split-path path)])
          (follow (path->complete-path (resolve-path path) folder) (- links-left 1)))
        path)))
