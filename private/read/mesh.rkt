#lang racket/base
;; Reads a mesh file of any known kind, by its extension.

(provide read-mesh
         (struct-out mesh-data)
         (struct-out mesh-material))

(require racket/path
         "file.rkt"
         "mesh-data.rkt"
         "obj.rkt"
         "ply.rkt"
         "stl.rkt")

(define readers
  (hash #".obj" read-obj #".ply" read-ply #".stl" read-stl))

;; The mesh-data of a file .obj, .ply or .stl (letters of either case). progress, if given, is called
;; now and then with the fraction read, from 0 to 1. Raises a one-line user error that names the file
;; and the line or byte offset, and says what was expected there.
(define (read-mesh path #:progress [progress #f])
  (define extension (path-get-extension path))
  (define read
    (and extension
         (hash-ref readers (string->bytes/latin-1 (string-downcase (bytes->string/latin-1 extension)))
                   #f)))
  (unless read
    (raise-user-error
     (format "~a: expected a mesh file whose name ends in .obj, .ply or .stl" (path-label path))))
  (read path #:progress progress))
